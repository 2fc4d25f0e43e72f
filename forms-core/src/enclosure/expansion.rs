//! Expansions of an expression of one variable about a point, with the remainder over a range.
//!
//! ```text
//! f(c + x) = f₀ + f₁x + … + fₙ₋₁xⁿ⁻¹ + fₙ(ξ) xⁿ      for a ξ between c and c + x (Taylor's theorem)
//! ```
//! The coefficients at an exact c are exact where those of the parts are; the last one encloses fₙ at every
//! point of the range, which has to contain c.

use super::bounds::{Enclosure, Precision, Undecided};
use super::taylor::{Series, Taylor, linear};
use crate::expression::{Expr, Pool, Rational, Symbol};
use rustc_hash::FxHashMap;

/// A variable, the point about which it is expanded, and the range of the remainder.
pub(crate) struct Place<'a> {
    pub(crate) variable: Symbol,
    pub(crate) about: Enclosure,
    pub(crate) range: [&'a Rational; 2],
}

/// Returns f₀, …, fₙ₋₁ at the point and fₙ over the range, for n ≥ 2.
pub(crate) fn expansion(
    pool: &Pool,
    expression: Expr,
    place: &Place<'_>,
    n: usize,
    precision: Precision,
) -> Result<Vec<Enclosure>, Undecided> {
    let [lower, upper] = place.range;
    let mut coefficients = series(pool, expression, place.variable, place.about.clone(), n - 1, precision)?;
    let everywhere = Enclosure::between(lower, upper, precision);
    coefficients.extend(series(pool, expression, place.variable, everywhere, n, precision)?.pop());
    Ok(coefficients)
}

/// Returns the coefficients up to an order, at each value in an enclosure.
fn series(
    pool: &Pool,
    expression: Expr,
    variable: Symbol,
    at: Enclosure,
    order: usize,
    precision: Precision,
) -> Result<Series, Undecided> {
    let argument = linear(at, &Enclosure::integer(1, precision), order, precision);
    let values: FxHashMap<Symbol, Series> = [(variable, argument)].into_iter().collect();
    Taylor { pool, values: &values, order, precision }.of(expression)
}
