//! Definitions of the names in a statement: the items on which it rests, directly or through
//! others.

use super::scribe::{Formula, Scribe};
use super::{Line, Step};
use crate::notation::latex_of_name;
use crate::syntax::ast::{Argument, Condition, Expr, ExprKind, File, ItemKind};
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
        | ItemKind::Form { value, .. }
        | ItemKind::Field { value, .. }
        | ItemKind::Metric { value, .. } => vec![value],
        ItemKind::Map { components, .. } => components.iter().collect(),
        ItemKind::Statement { left, right, conditions, .. } => {
            [left, right].into_iter().chain(conditions.iter().flat_map(sides)).collect()
        }
        _ => vec![],
    }
}

fn sides(condition: &Condition) -> impl Iterator<Item = &Expr> {
    std::iter::once(&condition.first).chain(condition.rest.iter().map(|(_, side)| side))
}

/// Returns the parts of an expression, in the order in which they are evaluated.
pub(super) fn parts(expression: &Expr) -> Vec<&Expr> {
    match &*expression.kind {
        ExprKind::Number(_) | ExprKind::Name(_) | ExprKind::Basis(_) => vec![],
        ExprKind::Negate(inner) => vec![inner],
        ExprKind::Binary(_, _, left, right) => vec![left, right],
        ExprKind::Call { index, arguments, .. } => {
            let arguments = arguments.iter().flat_map(|argument| match argument {
                Argument::Value(value) => vec![value],
                Argument::Range { from, to, .. } => vec![from, to],
            });
            index.iter().chain(arguments).collect()
        }
        ExprKind::Index { base, index } => vec![base, index],
        ExprKind::Select { condition, then, otherwise, .. } => {
            sides(condition).chain([then, otherwise]).collect()
        }
    }
}

fn names(expression: &Expr, found: &mut BTreeSet<String>) {
    let mut pending = vec![expression];
    while let Some(expression) = pending.pop() {
        if let ExprKind::Name(name) = &*expression.kind {
            found.insert(name.clone());
        }
        pending.extend(parts(expression));
    }
}
