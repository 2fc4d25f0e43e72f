//! Series about removable singularities: polynomials that are proved to be close to an expression.
//!
//! ```text
//! N/D at a zero s of D (or of N and D) ─ expansions with exact coefficients ─▶ xᵛ Σ cₖ xᵏ, x = w − s
//!     ─ as many terms as the tolerance needs on |x| < r, proved ─▶ `if abs(x) < r { series } else { expression }`
//! ```

use super::fraction::{Fraction, fraction};
use super::one_variable::OneVariable;
use super::quantity::{Quantity, quantities};
use crate::enclosure::{Enclosure, Place, Precision, expansion};
use crate::expression::{Expr, Operation, Pool, Rational, Relation, Seam};
use num_rational::Ratio;
use num_traits::{One, Signed, Zero};

/// Binary places of the expansions, and the number of coefficients.
const PRECISION: Precision = Precision(512);
const TERMS: usize = 44;

/// Largest number of coefficients of a polynomial that are not zero.
const LONGEST: usize = 16;

/// Largest size in bits of an exact coefficient.
const LONGEST_COEFFICIENT: u64 = 400;

/// Returns forms of an expression that are computed by a series near a removable singularity and as
/// written elsewhere, each within `tolerance` of the expression.
pub(crate) fn about_singularities(pool: &mut Pool, expression: Expr, tolerance: &Rational) -> Vec<Expr> {
    for quantity in quantities(pool, expression) {
        let Some(parts) = fraction(pool, quantity.expression) else { continue };
        let mut forms = Vec::new();
        for point in singularities(pool, &quantity, parts) {
            let Some(series) = Series::about(pool, &quantity, parts, &point) else { continue };
            for radius in radii() {
                forms.extend(near(pool, &quantity, expression, &series, (&point, &radius), tolerance));
            }
        }
        if !forms.is_empty() {
            return forms;
        }
    }
    Vec::new()
}

/// Returns the distances from a singularity up to which a series is tried.
fn radii() -> [Rational; 3] {
    [Rational::new(1.into(), 2.into()), Rational::one(), Rational::from_integer(2.into())]
}

/// Returns the simple points at which numerator and denominator of an expression are exactly zero.
fn singularities(pool: &Pool, quantity: &Quantity, parts: Fraction) -> Vec<Rational> {
    let is_zero_at = |expression: Expr, point: &Rational| {
        coefficients(pool, expression, quantity, point, 1).is_some_and(|found| found[0].is_zero())
    };
    let points = [0, 1, -1].map(|value| Rational::from_integer(value.into()));
    points
        .into_iter()
        .filter(|point| !quantity.is_root || point.is_zero())
        .filter(|point| is_zero_at(parts.above, point) && is_zero_at(parts.below, point))
        .collect()
}

/// Returns the exact coefficients of an expansion about a point.
fn coefficients(
    pool: &Pool,
    expression: Expr,
    quantity: &Quantity,
    about: &Rational,
    count: usize,
) -> Option<Vec<Rational>> {
    let place = Place {
        variable: quantity.variable,
        about: Enclosure::exact(about, PRECISION),
        range: [about, about],
    };
    let found = expansion(pool, expression, &place, count + 1, PRECISION).ok()?;
    let exact = |value: &Enclosure| value.as_exact().filter(|value| is_short(value)).cloned();
    let known: Vec<Rational> = found.iter().take(count).map_while(exact).collect();
    (!known.is_empty()).then_some(known)
}

fn is_short(value: &Rational) -> bool {
    value.numer().bits().max(value.denom().bits()) <= LONGEST_COEFFICIENT
}

/// Returns the form that is a series for |w − s| < r.
fn near(
    pool: &mut Pool,
    quantity: &Quantity,
    expression: Expr,
    series: &Series,
    (point, radius): (&Rational, &Rational),
    tolerance: &Rational,
) -> Option<Expr> {
    let polynomial = shortest(pool, quantity, series, (point, radius), tolerance)?;
    let (is_near, polynomial) = quantity.written(pool, &polynomial, (point, radius));
    Some(pool.select(is_near, polynomial, expression, Seam::Jumps))
}

/// The beginning of a series xᵛ Σ cₖ xᵏ in x = w − s; a polynomial where it ends there.
struct Series {
    order: usize,
    coefficients: Vec<Rational>,
}

impl Series {
    /// Expands a fraction about a point: Σ aₖ xᵏ = xᵛ (Σ cₖ xᵏ)(Σ bₖ xᵏ), v ≥ 0.
    fn about(pool: &Pool, quantity: &Quantity, parts: Fraction, point: &Rational) -> Option<Series> {
        let above = coefficients(pool, parts.above, quantity, point, TERMS)?;
        let below = coefficients(pool, parts.below, quantity, point, TERMS)?;
        let start = |list: &[Rational]| list.iter().position(|value| !value.is_zero());
        let (first, second) = (start(&above)?, start(&below)?);
        let order = first.checked_sub(second)?;
        let (above, below) = (&above[first..], &below[second..]);
        let mut coefficients: Vec<Rational> = Vec::new();
        for k in 0..above.len().min(below.len()) {
            let known: Rational = (0..k).map(|j| &coefficients[j] * &below[k - j]).sum();
            let next = (&above[k] - known) / &below[0];
            if !is_short(&next) {
                break;
            }
            coefficients.push(next);
        }
        Some(Series { order, coefficients })
    }
}

/// Returns the shortest beginning of the series that is proved to be within the tolerance.
fn shortest(
    pool: &mut Pool,
    quantity: &Quantity,
    Series { order, coefficients: quotient }: &Series,
    (point, radius): (&Rational, &Rational),
    tolerance: &Rational,
) -> Option<Series> {
    let size = |k: usize| quotient[k].abs() * radius.pow(k as i32);
    let limit = tolerance * size(0);
    let first = (1..quotient.len()).find(|&k| (k..quotient.len()).all(|k| size(k) <= limit))?;
    let range = [if quantity.is_root { Rational::zero() } else { point - radius }, point + radius];
    for count in first..quotient.len().min(first + 6) {
        let mut coefficients = quotient[..count].to_vec();
        while coefficients.last().is_some_and(Zero::is_zero) {
            coefficients.pop();
        }
        if coefficients.iter().filter(|value| !value.is_zero()).count() > LONGEST {
            return None;
        }
        let polynomial = Series { order: *order, coefficients };
        let variable = pool.symbol(quantity.variable);
        let form = polynomial.written(pool, variable, None, point);
        let comparison = OneVariable {
            variable: quantity.variable,
            form,
            formula: quantity.expression,
            range: range.clone(),
        };
        if comparison.is_within(pool, tolerance) {
            return Some(polynomial);
        }
    }
    None
}

impl Series {
    /// Writes the polynomial by Horner's rule, in x² if all exponents have the same parity; `square`
    /// is x² where it is known.
    fn written(&self, pool: &mut Pool, variable: Expr, square: Option<Expr>, point: &Rational) -> Expr {
        let shift = pool.number(-point);
        let x = pool.add(variable, shift);
        let is_even = self.coefficients.iter().skip(1).step_by(2).all(Zero::is_zero);
        let (step, base) = if is_even { (2, square.unwrap_or_else(|| pool.multiply(x, x))) } else { (1, x) };
        let mut sum = pool.integer(0);
        for coefficient in self.coefficients.iter().step_by(step).rev() {
            let product = pool.multiply(base, sum);
            let coefficient = pool.number(coefficient.clone());
            sum = pool.add(coefficient, product);
        }
        let factor = match (square, self.order) {
            (Some(square), order) if order % 2 == 0 => {
                pool.power(square, Ratio::from_integer(order as i64 / 2))
            }
            (_, order) => pool.power(x, Ratio::from_integer(order as i64)),
        };
        pool.multiply(factor, sum)
    }
}

impl Quantity {
    /// Writes the condition |w − s| < r and the polynomial in terms of the part that w stands for.
    fn written(
        &self,
        pool: &mut Pool,
        polynomial: &Series,
        (point, radius): (&Rational, &Rational),
    ) -> ((Expr, Relation, Expr), Expr) {
        if self.is_root {
            let bound = pool.number(radius * radius);
            let root = pool.power(self.part, Ratio::new(1, 2));
            let series = polynomial.written(pool, root, Some(self.part), point);
            return ((self.part, Relation::Less, bound), series);
        }
        let bound = pool.number(radius.clone());
        let shift = pool.number(-point);
        let distance = pool.add(self.part, shift);
        let distance = pool.apply(Operation::Abs, &[distance]);
        let series = polynomial.written(pool, self.part, None, point);
        ((distance, Relation::Less, bound), series)
    }
}
