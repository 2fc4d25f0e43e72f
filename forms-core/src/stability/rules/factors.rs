//! Factorisation of products, and products of factors.

use crate::expression::{Expr, Node, Pool};
use num_traits::Signed;

/// Returns the factors of the numerator, the factors of the denominator, and whether the product is
/// negated. Integer powers are one factor; the sign of their exponent decides on which side they
/// are.
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

/// Multiplies factors from the first to the last.
pub(super) fn product(pool: &mut Pool, factors: &[Expr]) -> Expr {
    let mut product = pool.integer(1);
    for &factor in factors {
        product = pool.multiply(product, factor);
    }
    product
}

/// Returns the product of `above` divided by the product of `below`.
pub(super) fn quotient(pool: &mut Pool, above: &[Expr], below: &[Expr]) -> Expr {
    let (above, below) = (product(pool, above), product(pool, below));
    pool.divide(above, below)
}
