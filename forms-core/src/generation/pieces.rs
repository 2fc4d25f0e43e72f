//! Pieces: splits expressions with `if` into expressions without, each under the conditions that
//! lead to it.

use crate::expression::{Condition, Expr, Node, Pool, Relation};
use rustc_hash::FxHashSet;

/// Largest number of pieces that are examined.
pub(super) const MOST_PIECES: usize = 64;

/// Expressions without `if`, valid where the conditions on the path to them hold.
pub(super) struct Piece {
    pub(super) path: Vec<Condition>,
    pub(super) expressions: Vec<Expr>,
}

/// Splits expressions together into pieces, unless there are too many. Conditions that are `alike`
/// are one condition.
pub(super) fn pieces(
    pool: &mut Pool,
    expressions: &[Expr],
    mut alike: impl FnMut(&mut Pool, &Condition, &Condition) -> bool,
) -> Option<Vec<Piece>> {
    let mut pieces = Vec::new();
    let mut open = vec![Piece { path: Vec::new(), expressions: expressions.to_vec() }];
    while let Some(piece) = open.pop() {
        let Some(choice) = choice(pool, &piece.expressions) else {
            pieces.push(piece);
            continue;
        };
        if pieces.len() + open.len() + 2 > MOST_PIECES {
            return None;
        }
        let choices: Vec<Condition> = choices(pool, &piece.expressions)
            .into_iter()
            .filter(|other| choice == *other || alike(pool, &choice, other))
            .collect();
        for (holds, conditions) in [(false, negated(&choice)), (true, vec![choice])] {
            let expressions = pool.replace_all(&piece.expressions, |node, images| match node {
                Node::Select { left, relation, right, then, otherwise, .. } => {
                    let condition = Condition { left: *left, relation: *relation, right: *right };
                    let branch = if holds { then } else { otherwise };
                    choices.contains(&condition).then(|| images[branch])
                }
                _ => None,
            });
            let path = piece.path.iter().copied().chain(conditions).collect();
            open.push(Piece { path, expressions });
        }
    }
    Some(pieces)
}

/// Negates a condition: the result is one condition, or a = b as a ≤ b and a ≥ b.
pub(super) fn negated(condition: &Condition) -> Vec<Condition> {
    let with = |relation: Relation| Condition { relation, ..*condition };
    match condition.relation.complement() {
        Some(complement) => vec![with(complement)],
        None => vec![with(Relation::LessEqual), with(Relation::GreaterEqual)],
    }
}

/// Returns the conditions of every `if` that contain no `if` themselves, operands before results.
fn choices(pool: &Pool, expressions: &[Expr]) -> Vec<Condition> {
    let mut piecewise: FxHashSet<Expr> = FxHashSet::default();
    let mut choices = Vec::new();
    for expression in pool.reachable(expressions) {
        let node = pool.node(expression);
        let mut is_piecewise = matches!(node, Node::Select { .. });
        node.for_each_operand(|operand| is_piecewise |= piecewise.contains(&operand));
        if is_piecewise {
            piecewise.insert(expression);
        }
        if let Node::Select { left, relation, right, .. } = node
            && !piecewise.contains(left)
            && !piecewise.contains(right)
        {
            choices.push(Condition { left: *left, relation: *relation, right: *right });
        }
    }
    choices
}

/// Returns the condition to split on first: the outermost that contains no `if`.
fn choice(pool: &Pool, expressions: &[Expr]) -> Option<Condition> {
    choices(pool, expressions).pop()
}
