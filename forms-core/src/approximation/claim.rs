//! The claim of an approximation: what form and formula have in common is taken off, and the tolerance
//! is divided among the parts in which they differ.
//!
//! ```text
//! a b ≈ a c within ε   if  b ≈ c within ε             a/b ≈ c/d, a b ≈ c d within ε   if both parts are within ε(1 − ε)/2
//! aⁿ ≈ bⁿ within ε     if  a ≈ b within ε/(2|n|)      for ε < 1/2
//! ```
//! For the last two: (1 + δ)² ≤ 1 + ε and (1 + δ)/(1 − δ) ≤ 1 + ε with δ = ε(1 − ε)/2, and
//! (1 + ε/2n)ⁿ ≤ e^(ε/2) ≤ 1 + ε.

use super::quantity::in_one_variable;
use crate::expression::{Condition, Expr, Node, Pool, Rational};
use num_traits::{One, Signed};

/// Whether a form without `if` has a value within `tolerance` of that of a formula without `if`,
/// relative to it, wherever the conditions hold and the formula has a value.
pub(crate) fn is_within(
    pool: &mut Pool,
    (form, formula): (Expr, Expr),
    known: &[Condition],
    tolerance: &Rational,
) -> bool {
    let half = Rational::new(1.into(), 2.into());
    if form == formula {
        return true;
    }
    if !tolerance.is_positive() || *tolerance >= half {
        return false;
    }
    let shared = half * tolerance * (Rational::one() - tolerance);
    let by_parts = match (pool.node(form).clone(), pool.node(formula).clone()) {
        (Node::Negate(a), Node::Negate(b)) => is_within(pool, (a, b), known, tolerance),
        (Node::Multiply(a, b), Node::Multiply(c, d)) | (Node::Divide(a, b), Node::Divide(c, d)) => {
            let part = if a == c || b == d { tolerance } else { &shared };
            is_within(pool, (a, c), known, part) && is_within(pool, (b, d), known, part)
        }
        (Node::Power(a, p), Node::Power(b, q)) if p == q && p.is_integer() => {
            let part = tolerance / Rational::from_integer((2 * p.numer().abs()).into());
            is_within(pool, (a, b), known, &part)
        }
        _ => false,
    };
    by_parts || {
        let found = in_one_variable(pool, (form, formula), known);
        found.iter().any(|comparison| comparison.is_within(pool, tolerance))
    }
}
