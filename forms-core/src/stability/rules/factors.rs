//! Products taken apart and put together.

use crate::expression::{Expr, Node, Pool};
use num_traits::Signed;

/// The factors above and below the line, and whether a sign is in front. Integer powers stay whole, with the sign of
/// their exponent telling where they go.
pub(super) fn factors(pool: &mut Pool, expression: Expr) -> (Vec<Expr>, Vec<Expr>, bool) {
    let (mut above, mut below, mut negative) = (Vec::new(), Vec::new(), false);
    let mut pending = vec![(expression, false)];
    while let Some((part, inverted)) = pending.pop() {
        match pool.node(part).clone() {
            Node::Negate(a) => {
                negative = !negative;
                pending.push((a, inverted));
            }
            Node::Multiply(a, b) => pending.extend([(b, inverted), (a, inverted)]),
            Node::Divide(a, b) => pending.extend([(b, !inverted), (a, inverted)]),
            Node::Power(base, exponent) if exponent.is_negative() => {
                pending.push((pool.power(base, -exponent), !inverted));
            }
            Node::Number(value) if value.is_negative() => {
                negative = !negative;
                pending.push((pool.number(-value), inverted));
            }
            _ if inverted => below.push(part),
            _ => above.push(part),
        }
    }
    let one = pool.integer(1);
    above.retain(|&factor| factor != one);
    below.retain(|&factor| factor != one);
    (above, below, negative)
}

/// The product of factors, from the first to the last.
pub(super) fn product(pool: &mut Pool, factors: &[Expr]) -> Expr {
    let mut product = pool.integer(1);
    for &factor in factors {
        product = pool.multiply(product, factor);
    }
    product
}

/// The product of some factors over that of others.
pub(super) fn quotient(pool: &mut Pool, above: &[Expr], below: &[Expr]) -> Expr {
    let (above, below) = (product(pool, above), product(pool, below));
    pool.divide(above, below)
}
