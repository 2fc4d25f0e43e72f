//! Fractions: an expression as a quotient of two expressions that contain no quotients outside of
//! functions, so that both can be expanded at a zero of the denominator.

use crate::expression::{Expr, Node, Pool};
use num_rational::Ratio;
use num_traits::Signed;
use rustc_hash::FxHashMap;

/// Largest power that is taken apart.
const LARGEST_POWER: i64 = 64;

/// A quotient; equal to the expression that it was made of wherever that has a value.
#[derive(Clone, Copy)]
pub(super) struct Fraction {
    pub(super) above: Expr,
    pub(super) below: Expr,
}

/// Returns an expression without `if` as a fraction.
pub(super) fn fraction(pool: &mut Pool, expression: Expr) -> Option<Fraction> {
    let mut known: FxHashMap<Expr, Fraction> = FxHashMap::default();
    let one = pool.integer(1);
    for part in pool.reachable(&[expression]) {
        let found = match pool.node(part).clone() {
            Node::Add(a, b) => sum(pool, known[&a], known[&b]),
            Node::Negate(a) => Fraction { above: pool.negate(known[&a].above), ..known[&a] },
            Node::Multiply(a, b) => product(pool, known[&a], known[&b]),
            Node::Divide(a, b) => {
                let Fraction { above, below } = known[&b];
                product(pool, known[&a], Fraction { above: below, below: above })
            }
            Node::Power(a, exponent) if exponent.is_integer() => power(pool, known[&a], exponent)?,
            Node::Select { .. } | Node::Jet { .. } => return None,
            Node::Number(_) | Node::Pi | Node::Symbol(_) | Node::Power(..) | Node::Apply(..) => {
                Fraction { above: part, below: one }
            }
        };
        known.insert(part, found);
    }
    known.remove(&expression)
}

fn sum(pool: &mut Pool, a: Fraction, b: Fraction) -> Fraction {
    if a.below == b.below {
        return Fraction { above: pool.add(a.above, b.above), below: a.below };
    }
    let (left, right) = (pool.multiply(a.above, b.below), pool.multiply(b.above, a.below));
    Fraction { above: pool.add(left, right), below: pool.multiply(a.below, b.below) }
}

fn product(pool: &mut Pool, a: Fraction, b: Fraction) -> Fraction {
    Fraction { above: pool.multiply(a.above, b.above), below: pool.multiply(a.below, b.below) }
}

fn power(pool: &mut Pool, a: Fraction, exponent: Ratio<i64>) -> Option<Fraction> {
    if exponent.abs() > Ratio::from_integer(LARGEST_POWER) {
        return None;
    }
    let (above, below) = if exponent.is_positive() { (a.above, a.below) } else { (a.below, a.above) };
    Some(Fraction { above: pool.power(above, exponent.abs()), below: pool.power(below, exponent.abs()) })
}
