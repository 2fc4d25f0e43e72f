//! Lagrange's identity (Σ aᵢ²)(Σ bᵢ²) − (Σ aᵢ bᵢ)² = Σ (aᵢ bⱼ − aⱼ bᵢ)², i < j: a sum of squares
//! instead of a difference.
//!
//! The differences of products on the right are compensated when they are computed, so that the sum
//! is accurate for nearly parallel vectors, too.

use super::Rewriting;
use super::factors::{factors, product};
use super::radical::without;
use super::sums::root_of;
use crate::expression::{Expr, Operation};

/// Maximum number of dimensions of the vectors.
const MOST_DIMENSIONS: usize = 4;

/// Applies (Σ aᵢ bᵢ)² − (Σ aᵢ²)(Σ bᵢ² + r) = −r Σ aᵢ² − Σ (aᵢ bⱼ − aⱼ bᵢ)², also among the terms of a
/// longer sum and with both signs changed.
pub(super) fn identity(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let terms = rewriting.terms(expression);
    let mut found = Vec::new();
    for (place, &first) in terms.iter().enumerate() {
        let (_, _, is_negative) = factors(rewriting.pool, first);
        let positive = if is_negative { rewriting.pool.negate(first) } else { first };
        let Some(dot) = rewriting.squared(positive) else { continue };
        for (other, &second) in terms.iter().enumerate().filter(|(other, _)| *other != place) {
            let (above, below, other_is_negative) = factors(rewriting.pool, second);
            let [p, q] = above[..] else { continue };
            if !below.is_empty() || other_is_negative == is_negative {
                continue;
            }
            for (squares, sum) in [(p, q), (q, p)] {
                let Some(Parallelogram { area, rest }) = parallelogram(rewriting, dot, squares, sum) else {
                    continue;
                };
                // (Σ aᵢ²)(Σ bᵢ² + r) − (Σ aᵢ bᵢ)²
                let rest = rewriting.pool.multiply(rest, squares);
                let difference = rewriting.pool.add(rest, area);
                let mut all = vec![if is_negative { difference } else { rewriting.pool.negate(difference) }];
                all.extend((0..terms.len()).filter(|at| ![place, other].contains(at)).map(|at| terms[at]));
                found.push(rewriting.total(&all));
            }
        }
    }
    found
}

/// Applies acos(p/√q) = atan2(√(q − p²), p) and asin(p/√q) = atan2(p, √(q − p²)).
pub(super) fn angle(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let cosine = rewriting.argument_of(Operation::Acos, expression);
    let sine = rewriting.argument_of(Operation::Asin, expression);
    let Some(ratio) = cosine.or(sine) else { return Vec::new() };
    let Some((p, other)) = legs(rewriting, ratio) else { return Vec::new() };
    let point = |other| if sine.is_some() { [p, other] } else { [other, p] };
    other.into_iter().map(|other| rewriting.pool.apply(Operation::Atan2, &point(other))).collect()
}

/// Returns p and the ways to write √(q − p²) for a quotient p/√q whose divisor has a root.
fn legs(rewriting: &mut Rewriting<'_>, ratio: Expr) -> Option<(Expr, Vec<Expr>)> {
    let (above, below, negative) = factors(rewriting.pool, ratio);
    if !below.iter().any(|&factor| rewriting.radicand(factor).is_some()) {
        return None;
    }
    let p = product(rewriting.pool, &above);
    let mut squares = Vec::new();
    for &factor in &below {
        match rewriting.radicand(factor) {
            Some(radicand) => squares.extend(factors(rewriting.pool, radicand).0),
            None => squares.push(rewriting.square(factor)),
        }
    }
    let mut found = Vec::new();
    if let [a, b] = squares[..]
        && let Some(Parallelogram { area, .. }) =
            parallelogram(rewriting, p, a, b).filter(|parallelogram| parallelogram.is_whole(rewriting))
    {
        found.push(rewriting.pool.sqrt(area));
    }
    let (q, p2) = (product(rewriting.pool, &squares), rewriting.square(p));
    let difference = rewriting.difference(q, p2);
    found.push(rewriting.pool.sqrt(difference));
    Some((if negative { rewriting.pool.negate(p) } else { p }, found))
}

/// Parts of (Σ aᵢ²)(Σ bᵢ² + r) − (Σ aᵢ bᵢ)².
struct Parallelogram {
    /// Σ (aᵢ bⱼ − aⱼ bᵢ)²
    area: Expr,
    /// r
    rest: Expr,
}

impl Parallelogram {
    fn is_whole(&self, rewriting: &mut Rewriting<'_>) -> bool {
        self.rest == rewriting.pool.integer(0)
    }
}

/// Reads a sum of products of a's and b's, the sum of squares of the a's, and a sum that contains
/// the squares of the b's.
fn parallelogram(
    rewriting: &mut Rewriting<'_>,
    dot: Expr,
    squares: Expr,
    sum: Expr,
) -> Option<Parallelogram> {
    let products = rewriting.terms(dot);
    let a: Option<Vec<Expr>> =
        rewriting.terms(squares).into_iter().map(|term| root_of(rewriting, term)).collect();
    let a = a?;
    if !(2..=MOST_DIMENSIONS).contains(&a.len()) || products.len() != a.len() {
        return None;
    }
    let mut b = vec![None; a.len()];
    for &term in &products {
        let (place, other) = a.iter().enumerate().find_map(|(place, &a)| {
            let (other, ()) = without(rewriting, term, |_, factor| (factor == a).then_some(()))?;
            b[place].is_none().then_some((place, other))
        })?;
        b[place] = Some(other);
    }
    let b: Vec<Expr> = b.into_iter().collect::<Option<_>>()?;
    let mut rest = rewriting.terms(sum);
    for &b in &b {
        let is_its_square =
            |&term: &Expr| root_of(rewriting, term).is_some_and(|base| is_plus_or_minus(rewriting, base, b));
        rest.remove(rest.iter().position(is_its_square)?);
    }
    let mut areas = Vec::new();
    for i in 0..a.len() {
        for j in i + 1..a.len() {
            let (first, second) = (rewriting.pool.multiply(a[i], b[j]), rewriting.pool.multiply(a[j], b[i]));
            let area = rewriting.pool.subtract(first, second);
            areas.push(rewriting.pool.power(area, 2.into()));
        }
    }
    Some(Parallelogram { area: rewriting.total(&areas), rest: rewriting.total(&rest) })
}

/// Whether two expressions are equal or opposite.
fn is_plus_or_minus(rewriting: &mut Rewriting<'_>, a: Expr, b: Expr) -> bool {
    a == b || rewriting.pool.negate(a) == b
}
