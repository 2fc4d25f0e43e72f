//! Closeness of two expressions of one variable on a range, by Taylor expansions of P D − N Q and of
//! N Q on parts of the range.
//!
//! ```text
//! E = xᵠ (Σ eₖ xᵏ),  M = xᵠ (Σ mₖ xᵏ),  |x| ≤ h:   Σ |eₖ| hᵏ ≤ ε (|m₀| − Σ |mₖ| hᵏ, k > 0)  ⟹  |E| ≤ ε |M|
//! ```

use super::fraction::{Fraction, fraction};
use crate::enclosure::{Enclosure, Place, Precision, expansion};
use crate::expression::{Expr, Node, Pool, Rational, Symbol};
use crate::kernel::nearest_f64;

/// Binary places of the enclosures, and order of the expansions.
const PRECISION: Precision = Precision(128);
const ORDER: usize = 28;

/// Largest number of parts of the range that are examined.
const MOST_PARTS: usize = 400;

/// Points at which a zero is looked for, in addition to the ends and to the zeros of linear terms.
const SIMPLE: [i64; 5] = [0, 1, -1, 2, -2];

/// A form and a formula of one variable, on a range that contains both ends.
pub(super) struct OneVariable {
    pub(super) variable: Symbol,
    pub(super) form: Expr,
    pub(super) formula: Expr,
    pub(super) range: [Rational; 2],
}

impl OneVariable {
    /// Whether the form has a value within `tolerance` of that of the formula, relative to it,
    /// wherever the formula has a value on the range.
    pub(super) fn is_within(&self, pool: &mut Pool, tolerance: &Rational) -> bool {
        let (Some(form), Some(formula)) = (fraction(pool, self.form), fraction(pool, self.formula)) else {
            return false;
        };
        let crossed = [pool.multiply(form.above, formula.below), pool.multiply(formula.above, form.below)];
        let error = pool.subtract(crossed[0], crossed[1]);
        let comparison = Comparison { pool, variable: self.variable, error, size: crossed[1], tolerance };
        let zeros = comparison.zeros(&[form, formula], &self.range);
        // at a zero of N Q the form has a value if Q does not vanish there
        zeros.iter().all(|zero| comparison.is_nonzero(form.below, zero))
            && comparison.holds(&self.range, &zeros)
    }
}

/// The claim |E| ≤ ε |M|.
struct Comparison<'a> {
    pool: &'a Pool,
    variable: Symbol,
    error: Expr,
    size: Expr,
    tolerance: &'a Rational,
}

impl Comparison<'_> {
    /// Returns the points of the range at which the size is known to be exactly zero.
    fn zeros(&self, fractions: &[Fraction], [lower, upper]: &[Rational; 2]) -> Vec<Rational> {
        let mut candidates: Vec<Rational> = vec![lower.clone(), upper.clone()];
        candidates.extend(SIMPLE.map(|value| Rational::from_integer(value.into())));
        let parts: Vec<Expr> =
            fractions.iter().flat_map(|fraction| [fraction.above, fraction.below]).collect();
        candidates.extend(self.pool.reachable(&parts).into_iter().filter_map(
            |part| match self.pool.node(part) {
                Node::Add(a, b) if *self.pool.node(*a) == Node::Symbol(self.variable) => {
                    self.pool.as_number(*b).map(|number| -number)
                }
                _ => None,
            },
        ));
        candidates.retain(|value| lower <= value && value <= upper);
        candidates.sort();
        candidates.dedup();
        candidates.retain(|value| self.at(self.size, value).is_some_and(|size| size.is_zero()));
        candidates
    }

    fn at(&self, expression: Expr, value: &Rational) -> Option<Enclosure> {
        let place = Place {
            variable: self.variable,
            about: Enclosure::exact(value, PRECISION),
            range: [value, value],
        };
        Some(expansion(self.pool, expression, &place, 2, PRECISION).ok()?.swap_remove(0))
    }

    fn is_nonzero(&self, expression: Expr, value: &Rational) -> bool {
        self.at(expression, value).is_some_and(|value| !value.contains_zero())
    }

    /// Whether the claim holds on a range in which the size vanishes at these points only.
    fn holds(&self, [lower, upper]: &[Rational; 2], zeros: &[Rational]) -> bool {
        let mut open = vec![[lower.clone(), upper.clone()]];
        let mut examined = 0;
        while let Some([lower, upper]) = open.pop() {
            examined += 1;
            if examined + open.len() > MOST_PARTS {
                return false;
            }
            let zero = zeros.iter().find(|&zero| lower <= *zero && *zero <= upper);
            let middle = middle(&lower, &upper);
            // only at a zero are coefficients that vanish exactly of use
            let about = zero.map_or_else(
                || Enclosure::near(&middle, PRECISION),
                |zero| Enclosure::exact(zero, PRECISION),
            );
            if self.holds_about(zero.unwrap_or(&middle), about, [&lower, &upper]) {
                continue;
            }
            let cuts = match zero {
                Some(zero) if lower < *zero && *zero < upper => {
                    vec![self::middle(&lower, zero), self::middle(zero, &upper)]
                }
                _ => vec![middle],
            };
            let ends: Vec<&Rational> = [&lower].into_iter().chain(&cuts).chain([&upper]).collect();
            open.extend(ends.windows(2).map(|part| [part[0].clone(), part[1].clone()]));
        }
        true
    }

    /// Whether expansions about a point, as enclosed, show the claim on a range that contains it.
    fn holds_about(&self, point: &Rational, about: Enclosure, range: [&Rational; 2]) -> bool {
        let place = Place { variable: self.variable, about, range };
        let of = |expression: Expr| expansion(self.pool, expression, &place, ORDER, PRECISION).ok();
        let (Some(error), Some(size)) = (of(self.error), of(self.size)) else { return false };
        let Some(order) = size.iter().position(|coefficient| !coefficient.is_zero()) else { return false };
        if !error[..order].iter().all(Enclosure::is_zero) || size[order].contains_zero() {
            return false;
        }
        let width = nearest_f64(&(range[1] - point).max(point - range[0])).next_up();
        let errors = weighted(&error[order..], width);
        let (lower, upper) = size[order].to_f64_range();
        let least = if lower > 0.0 { lower } else { -upper };
        let rest = (weighted(&size[order + 1..], width) * width).next_up();
        let size = (least - rest).next_down();
        size > 0.0 && errors <= (nearest_f64(self.tolerance).next_down() * size).next_down()
    }
}

/// Returns an upper bound of Σ |cₖ| hᵏ.
fn weighted(coefficients: &[Enclosure], width: f64) -> f64 {
    let largest = |enclosure: &Enclosure| {
        let (lower, upper) = enclosure.to_f64_range();
        upper.max(-lower)
    };
    // by Horner's rule, rounded upward
    coefficients
        .iter()
        .rev()
        .fold(0.0, |sum: f64, coefficient| ((sum * width).next_up() + largest(coefficient)).next_up())
}

fn middle(lower: &Rational, upper: &Rational) -> Rational {
    (lower + upper) / Rational::from_integer(2.into())
}
