//! Rules for roots of sums of squares that avoid intermediate overflow and underflow.

use super::Rewriting;
use super::factors::{factors, quotient};
use crate::expression::{Expr, Operation, Relation, Seam};

/// Maximum number of terms of a root that is written as a hypotenuse.
const MOST_LEGS: usize = 4;

/// Applies √(c a² + d b² + …) = hypot(√c a, √d b, …), where no square leaves the range.
pub(super) fn hypotenuse(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let Some(radicand) = rewriting.radicand(expression) else { return Vec::new() };
    let terms = rewriting.terms(radicand);
    if !(2..=MOST_LEGS).contains(&terms.len()) {
        return Vec::new();
    }
    let legs: Option<Vec<Expr>> = terms.iter().map(|&term| leg(rewriting, term)).collect();
    let Some((&first, others)) = legs.as_deref().and_then(<[Expr]>::split_first) else { return Vec::new() };
    let mut length = first;
    for &other in others {
        length = rewriting.pool.apply(Operation::Hypot, &[length, other]);
    }
    vec![length]
}

/// Returns √c a for a term c a² with a factor that is a square.
fn leg(rewriting: &mut Rewriting<'_>, term: Expr) -> Option<Expr> {
    if let Some(a) = rewriting.squared(term) {
        return Some(a);
    }
    let (above, below, negative) = factors(rewriting.pool, term);
    let place = above.iter().position(|&factor| rewriting.squared(factor).is_some());
    let (place, false) = (place?, negative) else { return None };
    let mut others = above;
    let a = others.remove(place);
    let a = rewriting.squared(a)?;
    let c = quotient(rewriting.pool, &others, &below);
    let root = rewriting.pool.sqrt(c);
    Some(rewriting.pool.multiply(root, a))
}

/// Applies √(a² ± b²) = |a| √(1 ± (b/a)²) where |a| ≥ |b|, and vice versa.
pub(super) fn scaled_root(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let Some(radicand) = rewriting.radicand(expression) else { return Vec::new() };
    let Some((first, second)) = rewriting.two_terms(radicand) else { return Vec::new() };
    let (Some(a), Some(b)) = (rewriting.squared(first), rewriting.squared(second)) else {
        return Vec::new();
    };
    let (size_a, size_b) = (rewriting.size(a), rewriting.size(b));
    let one = rewriting.pool.integer(1);
    let scaled = |rewriting: &mut Rewriting<'_>, large: Expr, size: Expr, small: Expr| {
        let ratio = rewriting.pool.divide(small, large);
        let square = rewriting.square(ratio);
        let sum = rewriting.pool.add(one, square);
        let root = rewriting.pool.sqrt(sum);
        rewriting.pool.multiply(size, root)
    };
    let by_a = scaled(rewriting, a, size_a, b);
    let by_b = scaled(rewriting, b, size_b, a);
    let relation = (size_a, Relation::Greater, size_b);
    vec![rewriting.pool.select(relation, by_a, by_b, Seam::Agrees), by_a, by_b]
}

/// Applies √(a² + p q) = |a| √(1 + (p/a)(q/a)), where the other term is not a square.
pub(super) fn beside_a_square(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let Some(radicand) = rewriting.radicand(expression) else { return Vec::new() };
    let Some((first, second)) = rewriting.two_terms(radicand) else { return Vec::new() };
    let mut found = Vec::new();
    for (square, other) in [(first, second), (second, first)] {
        let Some(a) = rewriting.squared(square) else { continue };
        let (above, below, negative) = factors(rewriting.pool, other);
        let Some((&last, rest)) = above.split_last() else { continue };
        let rest = quotient(rewriting.pool, rest, &below);
        let (p, q) = (rewriting.pool.divide(rest, a), rewriting.pool.divide(last, a));
        let ratio = rewriting.pool.multiply(p, q);
        let ratio = if negative { rewriting.pool.negate(ratio) } else { ratio };
        let one = rewriting.pool.integer(1);
        let sum = rewriting.pool.add(one, ratio);
        let (size, root) = (rewriting.size(a), rewriting.pool.sqrt(sum));
        found.push(rewriting.pool.multiply(size, root));
    }
    found
}
