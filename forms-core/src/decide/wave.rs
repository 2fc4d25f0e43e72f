//! What the conditions say of sines and cosines: the signs that the ranges of their angles give them.
//!
//! ```text
//! α ≤ A ≤ β, β − α ≤ π  ─▶  sin(A − α) ≥ 0,  sin(β − A) ≥ 0;   sin A, cos A of one sign where A keeps within half a turn
//! ```
//! They are conditions on points like those that are stated, and are looked at where the stated ones leave a sign open.

use super::angle::occur_in;
use crate::assume::range_of;
use crate::expression::{Condition, Expr, Node, Operation, Pool};
use crate::syntax::ast::Relation;

/// Angles beyond these are left alone.
const MOST_ANGLES: usize = 6;

/// The signs that follow for the sines, cosines and tangents in expressions.
pub(super) fn signs_of_waves(pool: &mut Pool, expressions: &[Expr], given: &[Condition]) -> Vec<Condition> {
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

/// The terms of a multiple of a sum in which no inverse function occurs.
fn without_arcs(pool: &mut Pool, angle: Expr) -> Expr {
    if !occur_in(pool, &[angle]) {
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

/// wave ≥ 0 or wave ≤ 0
fn signed(pool: &mut Pool, wave: Expr, positive: bool) -> Condition {
    let relation = if positive { Relation::GreaterEqual } else { Relation::LessEqual };
    Condition { left: wave, relation, right: pool.integer(0) }
}
