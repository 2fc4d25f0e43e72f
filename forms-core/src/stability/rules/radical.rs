//! Roots: conjugates, and roots of products.

use super::Rewriting;
use super::factors::{factors, product, quotient};
use crate::expression::{Expr, Node};
use num_rational::Ratio;

/// a + b = (a² − b²)/(a − b) where one has a square root, and a − b = (a³ − b³)/(a² + ab + b²) for cube roots, with the
/// numerator simplified
pub(super) fn conjugate(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let Some((a, b)) = rewriting.two_terms(expression) else { return Vec::new() };
    let mut found = Vec::new();
    if has_root(rewriting, a, 2) || has_root(rewriting, b, 2) {
        let (a2, b2) = (rewriting.square(a), rewriting.square(b));
        let (a2, b2) = (rewriting.simplified(a2), rewriting.simplified(b2));
        let numerator = rewriting.difference(a2, b2);
        let denominator = rewriting.pool.subtract(a, b);
        found.push(rewriting.pool.divide(numerator, denominator));
    }
    if has_root(rewriting, a, 3) || has_root(rewriting, b, 3) {
        let cube = |rewriting: &mut Rewriting<'_>, x: Expr| {
            let cube = rewriting.pool.power(x, 3.into());
            rewriting.simplified(cube)
        };
        let (a3, b3) = (cube(rewriting, a), cube(rewriting, b));
        let numerator = rewriting.sum(a3, b3);
        let (a2, ab, b2) = (rewriting.square(a), rewriting.pool.multiply(a, b), rewriting.square(b));
        let denominator = rewriting.pool.subtract(a2, ab);
        let denominator = rewriting.pool.add(denominator, b2);
        found.push(rewriting.pool.divide(numerator, denominator));
    }
    found
}

/// Whether a factor is a root of this degree.
fn has_root(rewriting: &mut Rewriting<'_>, term: Expr, degree: i64) -> bool {
    let (above, below, _) = factors(rewriting.pool, term);
    above.iter().chain(&below).any(
        |&factor| matches!(rewriting.pool.node(factor), Node::Power(_, exponent) if *exponent.denom() == degree),
    )
}

/// p/(a + b) = p (a − b)/(a² − b²) where a or b has a square root
pub(super) fn rationalised(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let Node::Divide(p, q) = *rewriting.pool.node(expression) else { return Vec::new() };
    let Some((a, b)) = rewriting.two_terms(q) else { return Vec::new() };
    if !has_root(rewriting, a, 2) && !has_root(rewriting, b, 2) {
        return Vec::new();
    }
    let (a2, b2) = (rewriting.square(a), rewriting.square(b));
    let norm = rewriting.pool.subtract(a2, b2);
    let norm = rewriting.simplified(norm);
    let conjugate = rewriting.pool.subtract(a, b);
    let quotient = rewriting.pool.divide(p, norm);
    let quotient = rewriting.simplified(quotient);
    vec![rewriting.pool.multiply(quotient, conjugate)]
}

/// √(p/q) = √p/√q, √(p q) = √p √q, √(p² q) = |p| √q, and with a simplified radicand
pub(super) fn of_quotients_and_products(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let Some(radicand) = rewriting.radicand(expression) else { return Vec::new() };
    let mut found = Vec::new();
    let simple = rewriting.simplified(radicand);
    found.push(rewriting.pool.sqrt(simple));
    let (above, below, negative) = factors(rewriting.pool, radicand);
    if negative || above.len() + below.len() < 2 {
        return found;
    }
    let (p, q) = (product(rewriting.pool, &above), product(rewriting.pool, &below));
    let (p, q) = (rewriting.pool.sqrt(p), rewriting.pool.sqrt(q));
    found.push(rewriting.pool.divide(p, q));
    let roots = |rewriting: &mut Rewriting<'_>, list: &[Expr]| -> Vec<Expr> {
        list.iter().map(|&factor| root_of_factor(rewriting, factor)).collect()
    };
    let (above, below) = (roots(rewriting, &above), roots(rewriting, &below));
    found.push(quotient(rewriting.pool, &above, &below));
    found
}

/// |a| for a², a|a|… for higher powers, √a otherwise
fn root_of_factor(rewriting: &mut Rewriting<'_>, factor: Expr) -> Expr {
    if let Some(base) = rewriting.squared(factor) {
        return rewriting.size(base);
    }
    match *rewriting.pool.node(factor) {
        Node::Power(base, exponent) if exponent.is_integer() && exponent.numer() % 4 == 0 => {
            rewriting.pool.power(base, exponent / Ratio::from_integer(2))
        }
        _ => rewriting.pool.sqrt(factor),
    }
}
