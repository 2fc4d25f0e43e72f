//! Definitions of the names in a statement: the items on which it rests, directly or through
//! others.

use super::scribe::{Formula, Scribe};
use super::{Line, Step};
use crate::notation::latex_of_name;
use crate::syntax::ast::{Condition, Expr, ExprKind, File, ItemKind};
use std::collections::BTreeSet;

/// Returns the items of a file on which a statement rests, in the order of the file.
pub(super) fn needed<'a>(file: &'a File, claim: &ItemKind) -> Vec<&'a ItemKind> {
    let mut wanted: BTreeSet<String> = BTreeSet::new();
    expressions(claim).into_iter().for_each(|expression| names(expression, &mut wanted));
    let mut found: Vec<&ItemKind> = Vec::new();
    for item in file.items.iter().rev() {
        if name(&item.kind).is_some_and(|name| wanted.contains(name)) {
            expressions(&item.kind).into_iter().for_each(|expression| names(expression, &mut wanted));
            found.push(&item.kind);
        }
    }
    found.reverse();
    found
}

/// Returns the step of the definitions, with one line for each item.
pub(super) fn step(scribe: &Scribe, items: &[&ItemKind]) -> Option<Step> {
    let lines: Vec<Line> = items.iter().filter_map(|item| line(scribe, item)).map(Line::Formula).collect();
    (!lines.is_empty()).then(|| Step::new("Definitions", lines))
}

fn line(scribe: &Scribe, item: &ItemKind) -> Option<Formula> {
    let named = |name: &str| Formula::new(name, latex_of_name(name));
    match item {
        ItemKind::Let { name, value, .. }
        | ItemKind::Form { name, value, .. }
        | ItemKind::Field { name, value, .. }
        | ItemKind::Metric { name, value, .. } => Some(named(&name.text).equals(scribe.written(value))),
        ItemKind::Definition { name, arguments, value } => {
            let arguments: Vec<Formula> = arguments.iter().map(|argument| named(&argument.text)).collect();
            let (head, list) = (named(&name.text), Formula::list(&arguments, ", "));
            let text = format!("{}({})", head.text, list.text);
            let latex = format!("{}\\left({}\\right)", head.latex, list.latex);
            Some(Formula::new(text, latex).equals(scribe.written(value)))
        }
        ItemKind::Map { name, source, target, components } => {
            let parts: Vec<Formula> = components.iter().map(|part| scribe.written(part)).collect();
            let list = Formula::list(&parts, ", ");
            let list = match list.text.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')) {
                Some(inner) if components.len() == 1 => Formula { text: inner.to_owned(), ..list },
                _ => list,
            };
            let text = format!("{}: {} -> {} = ({})", name.text, source.text, target.text, list.text);
            let [name, source, target] = [name, source, target].map(|name| latex_of_name(&name.text));
            let latex = format!("{name}\\colon {source}\\to {target} = \\left({}\\right)", list.latex);
            Some(Formula::new(text, latex))
        }
        _ => None,
    }
}

/// Returns the name of an item that has a value.
pub(super) fn name(item: &ItemKind) -> Option<&str> {
    match item {
        ItemKind::Let { name, .. }
        | ItemKind::Definition { name, .. }
        | ItemKind::Form { name, .. }
        | ItemKind::Field { name, .. }
        | ItemKind::Metric { name, .. }
        | ItemKind::Map { name, .. } => Some(&name.text),
        _ => None,
    }
}

/// Returns the expressions in the definition of an item.
pub(super) fn expressions(item: &ItemKind) -> Vec<&Expr> {
    match item {
        ItemKind::Let { value, .. }
        | ItemKind::Definition { value, .. }
        | ItemKind::Form { value, .. }
        | ItemKind::Field { value, .. }
        | ItemKind::Metric { value, .. } => vec![value],
        ItemKind::Map { components, .. } => components.iter().collect(),
        ItemKind::Statement { left, right, conditions, .. } => {
            [left, right].into_iter().chain(conditions.iter().flat_map(Condition::sides)).collect()
        }
        _ => vec![],
    }
}

fn names(expression: &Expr, found: &mut BTreeSet<String>) {
    let mut pending = vec![expression];
    while let Some(expression) = pending.pop() {
        match &*expression.kind {
            ExprKind::Name(name) => found.insert(name.clone()),
            ExprKind::Call { function, .. } => found.insert(function.text.clone()),
            _ => false,
        };
        pending.extend(expression.parts());
    }
}
