//! Open domains: each point that meets the conditions has a neighbourhood of such points.
//!
//! **Lemma.** Let every condition be `<`, `>` or `!=` between functions that are continuous where
//! they are defined. Conditions a ≤ b are allowed if a ≤ b follows from some of the former
//! conditions that contain no roots or inverse trigonometric functions, or if another condition
//! states a ≠ b. Then the points that meet all conditions form an open set.
//!
//! A point p of the set has a neighbourhood in which each operation is defined, by induction over
//! its operands: a divisor that is not zero at p, or an argument of a logarithm that is positive
//! there, stays so nearby; and a radicand is not negative wherever certain conditions hold, which
//! are open and hold near p. Without its hypotheses the lemma fails: `x <= 0, x >= 0` leaves a
//! point, and so does the domain of √(−x²).

use super::is_at_most;
use crate::expression::{Condition, Expr, Node, Operation, Pool, Relation};

/// Whether the points that meet the conditions are known to form an open set on which some
/// expressions are continuous. `conditions` has to include the conditions under which these
/// expressions and the sides of the conditions are defined.
pub(crate) fn is_open(pool: &mut Pool, conditions: &[Condition], expressions: &[Expr]) -> bool {
    let (strict, weak): (Vec<Condition>, Vec<Condition>) = conditions.iter().partition(|c| is_strict(c));
    let sides = conditions.iter().flat_map(|condition| [condition.left, condition.right]);
    if may_jump(pool, &sides.chain(expressions.iter().copied()).collect::<Vec<_>>()) {
        return false;
    }
    let plain: Vec<Condition> =
        strict.into_iter().filter(|condition| is_defined_on_an_open_set(pool, condition)).collect();
    let not_zero: Vec<Expr> = conditions
        .iter()
        .filter(|condition| is_strict(condition) && pool.is_zero(condition.right))
        .flat_map(|condition| pool.factors_that_may_vanish(condition.left))
        .collect();
    weak.into_iter().all(|Condition { left, relation, right }| {
        let is_strict_here = pool.is_zero(right) && not_zero.contains(&left);
        let (smaller, larger) = if relation == Relation::LessEqual { (left, right) } else { (right, left) };
        is_strict_here || is_at_most(pool, smaller, larger, &plain)
    })
}

fn is_strict(condition: &Condition) -> bool {
    !matches!(condition.relation, Relation::GreaterEqual | Relation::LessEqual)
}

/// Whether every operation of the condition is defined on an open set, without boundary points of
/// its own.
fn is_defined_on_an_open_set(pool: &Pool, condition: &Condition) -> bool {
    pool.reachable(&[condition.left, condition.right]).into_iter().all(|part| match pool.node(part) {
        Node::Power(_, exponent) => exponent.is_integer(),
        Node::Apply(operation, _) => !matches!(
            operation,
            Operation::Asin | Operation::Acos | Operation::Dilog | Operation::Expint2 | Operation::Expint3
        ),
        _ => true,
    })
}

/// Whether an expression may be defined but not continuous, as is possible for a choice or an
/// integral by quadrature.
fn may_jump(pool: &Pool, expressions: &[Expr]) -> bool {
    pool.reachable(expressions).into_iter().any(|part| match pool.node(part) {
        Node::Select { .. } => true,
        Node::Jet { function, .. } => pool.quadrature_of(*function).is_some(),
        _ => false,
    })
}
