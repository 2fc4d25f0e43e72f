//! Trigonometric signs: the signs of sines and cosines that follow from the ranges of their angles
//! under the conditions.
//!
//! ```text
//! α ≤ A ≤ β, β − α ≤ π  ─▶  sin(A − α) ≥ 0,  sin(β − A) ≥ 0;   sin A, cos A of one sign where A stays in a half turn
//! ```
//! They are conditions on points like the stated ones, and are used where the stated ones leave a
//! sign open.

use crate::assume::range_of;
use crate::expression::{Condition, Expr, Node, Operation, Pool, Relation};
use crate::normal::arcs_occur_in;

/// Limit on the number of angles; further ones are skipped.
const MOST_ANGLES: usize = 6;

/// Returns the signs that follow for the sines and cosines of the angles in expressions.
pub(super) fn trigonometric_signs(
    pool: &mut Pool,
    expressions: &[Expr],
    given: &[Condition],
) -> Vec<Condition> {
    let mut angles: Vec<Expr> = Vec::new();
    for part in pool.reachable(expressions) {
        let Node::Apply(Operation::Sin | Operation::Cos | Operation::Tan, of) = pool.node(part).clone()
        else {
            continue;
        };
        let angle = without_arcs(pool, of[0]);
        if !angles.contains(&angle) {
            angles.push(angle);
        }
    }
    angles.truncate(MOST_ANGLES);
    let mut found: Vec<Condition> = Vec::new();
    for angle in angles {
        let range = range_of(pool, angle, given);
        let (sine, cosine) = (pool.apply(Operation::Sin, &[angle]), pool.apply(Operation::Cos, &[angle]));
        let signs = [(sine, range.sign_of_sine()), (cosine, range.sign_of_cosine())];
        for (wave, sign) in signs {
            let Some((positive, _)) = sign else { continue };
            found.push(signed(pool, wave, positive));
        }
        if let Some((lower, upper)) = range.within_half_a_turn() {
            for (end, sign) in [(lower, 1), (upper, -1)] {
                let (end, pi, sign) = (pool.number(end), pool.pi(), pool.integer(sign));
                let place = pool.multiply(end, pi);
                let distance = pool.subtract(angle, place);
                let distance = pool.multiply(sign, distance);
                let wave = pool.apply(Operation::Sin, &[distance]);
                found.push(signed(pool, wave, true));
            }
        }
    }
    found.retain(|condition| !given.contains(condition));
    found
}

/// Returns the terms of a multiple of a sum that contain no inverse function.
fn without_arcs(pool: &mut Pool, angle: Expr) -> Expr {
    if !arcs_occur_in(pool, &[angle]) {
        return angle;
    }
    match *pool.node(angle) {
        Node::Add(a, b) => {
            let (a, b) = (without_arcs(pool, a), without_arcs(pool, b));
            pool.add(a, b)
        }
        Node::Negate(a) => {
            let a = without_arcs(pool, a);
            pool.negate(a)
        }
        Node::Multiply(a, b) if pool.as_number(a).is_some() => without_arcs(pool, b),
        _ => pool.integer(0),
    }
}

/// Returns the condition wave ≥ 0 or wave ≤ 0.
fn signed(pool: &mut Pool, wave: Expr, positive: bool) -> Condition {
    let relation = if positive { Relation::GreaterEqual } else { Relation::LessEqual };
    Condition { left: wave, relation, right: pool.integer(0) }
}
