//! Definitions and kernels that call themselves, directly or through others.
//!
//! A name can be used only below its declaration, so a cycle of calls is always an error. It is
//! found before the items are resolved, to be reported as a cycle and not as an unknown name.

use crate::syntax::ast::{Condition, Expr, ExprKind, File, ItemKind, Name};
use rustc_hash::FxHashMap;

/// Longest cycle that is written out.
const LONGEST: usize = 8;

/// Names on cycles of calls: with the description of the cycle for its first name in the file, and
/// with nothing for the others.
pub(super) type Cycles = FxHashMap<String, Option<String>>;

/// Finds a cycle of calls through each group of items that call each other.
pub(super) fn cycles(file: &File) -> Cycles {
    let items: Vec<(&Name, &ItemKind)> = file.items.iter().filter_map(|item| callable(&item.kind)).collect();
    let mut places: FxHashMap<&str, usize> = FxHashMap::default();
    for (place, (name, _)) in items.iter().enumerate() {
        places.entry(&name.text).or_insert(place);
    }
    let calls = |place: usize| -> Vec<usize> { called(items[place].1, &places) };
    let mut found = Cycles::default();
    let mut states = vec![State::New; items.len()];
    for start in 0..items.len() {
        let mut path: Vec<(usize, Vec<usize>)> = Vec::new();
        let mut next = Some(start);
        loop {
            match next.take() {
                Some(place) if states[place] == State::New => {
                    states[place] = State::Open;
                    path.push((place, calls(place)));
                }
                Some(place) if states[place] == State::Open => {
                    let from = path.iter().position(|(on_path, _)| *on_path == place).unwrap_or(0);
                    let cycle: Vec<usize> = path[from..].iter().map(|(on_path, _)| *on_path).collect();
                    record(&cycle, &items, &mut found);
                }
                _ => {}
            }
            let Some((place, rest)) = path.last_mut() else { break };
            match rest.pop() {
                Some(callee) => next = Some(callee),
                None => {
                    states[*place] = State::Closed;
                    path.pop();
                }
            }
        }
    }
    found
}

/// Progress of the search at an item.
#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    New,
    Open,
    Closed,
}

fn callable(item: &ItemKind) -> Option<(&Name, &ItemKind)> {
    match item {
        ItemKind::Definition { name, .. } | ItemKind::Kernel { name, .. } => Some((name, item)),
        _ => None,
    }
}

/// Returns the items that an item calls.
fn called(item: &ItemKind, places: &FxHashMap<&str, usize>) -> Vec<usize> {
    let mut pending: Vec<&Expr> = match item {
        ItemKind::Definition { value, .. } => vec![value],
        ItemKind::Kernel { outputs, computed, target_forms, conditions, within, .. } => {
            let sides = conditions.iter().flat_map(Condition::sides);
            let forms = target_forms.iter().flat_map(|form| &form.computed);
            outputs.iter().chain(computed).chain(forms).chain(sides).chain(within).collect()
        }
        _ => vec![],
    };
    let mut found = Vec::new();
    while let Some(expression) = pending.pop() {
        if let ExprKind::Call { function, .. } = &*expression.kind {
            found.extend(places.get(function.text.as_str()));
        }
        pending.extend(expression.parts());
    }
    found
}

/// Records a cycle, described from its first item in the file on.
fn record(cycle: &[usize], items: &[(&Name, &ItemKind)], found: &mut Cycles) {
    let names: Vec<&str> = cycle.iter().map(|&place| items[place].0.text.as_str()).collect();
    if names.iter().any(|name| found.contains_key(*name)) {
        return;
    }
    let first = (0..cycle.len()).min_by_key(|&at| cycle[at]).unwrap_or(0);
    let around: Vec<&str> = names[first..].iter().chain(&names[..first]).copied().collect();
    let text = match around.as_slice() {
        [own] => format!("`{own}` calls itself"),
        [own, ..] => {
            let mut calls: Vec<String> =
                around[1..].iter().take(LONGEST).map(|name| format!("`{name}`")).collect();
            if around.len() > LONGEST {
                calls.push("…".to_owned());
            }
            calls.push(format!("`{own}`"));
            format!("`{own}` calls {}", calls.join(", which calls "))
        }
        [] => return,
    };
    found.extend(around[1..].iter().map(|name| ((*name).to_owned(), None)));
    found.insert(around[0].to_owned(), Some(text));
}
