//! Enclosures of definite integrals, by Taylor polynomials on intervals that are halved until the
//! remainders are small.
//!
//! ```text
//! ∫ f over [m − h, m + h] ∈ Σ fₖ(m) 2hᵏ⁺¹/(k + 1) + fₙ([m − h, m + h])·2hⁿ⁺¹/(n + 1)      k < n even
//! ```
//! with fₖ(x) the k-th Taylor coefficient of f at x. The remainder contains the integral of f − Σ
//! fₖ(m)(x − m)ᵏ by Taylor's theorem, and the odd powers vanish. An integrand with a singularity at
//! an end stays undecided.

use super::bounds::{Enclosure, Precision, Undecided};
use super::taylor::{Series, Taylor, linear};
use crate::expression::{FunctionId, Pool, Quadrature, Rational, Symbol};
use num_traits::{One, Signed, Zero};
use rustc_hash::FxHashMap;

/// Guard places that absorb the rounding of a few hundred intervals.
const GUARD: u32 = 32;

/// Limit on the number of intervals.
const MOST_INTERVALS: usize = 200;

/// Largest number of places to which an integral is computed. An agreement to 50 digits has a
/// reason that a proof has to find, and the work grows with the third power of the places.
const MOST_PLACES: u32 = 208;

/// Integrands smaller than 2⁻ⁿ are computed to fewer digits.
const MOST_SMALLER: i32 = 1024;

/// Places at which the size of the integrand is estimated, in eighths of the range.
const LOOKED_AT: [i64; 4] = [1, 3, 5, 7];

/// Encloses a quadrature at its arguments; `None` for another function.
pub(super) fn quadrature(
    pool: &Pool,
    function: FunctionId,
    arguments: &[Enclosure],
    precision: Precision,
) -> Option<Result<Enclosure, Undecided>> {
    let quadrature = pool.quadrature_of(function)?;
    let [from, to, parameters @ ..] = arguments else { return Some(Err(Undecided::Unknown)) };
    let places = precision.0.min(MOST_PLACES);
    let working = Precision(places + GUARD);
    // even, and close to the order that minimises its square times the number of intervals, which
    // shrink as 2^(-places/order)
    let order = 8 + 2 * (places as usize / 8);
    let integral = |working: Precision| Integral {
        pool,
        quadrature,
        from: from.at(working),
        length: to.at(working).sub(&from.at(working)),
        parameters: parameters.iter().map(|parameter| parameter.at(working)).collect(),
        order,
        precision: working,
    };
    // places are counted from the binary point: a small integrand needs more of them
    let size = integral(working).size();
    let smaller = (-size).clamp(0, MOST_SMALLER) as u32;
    let value = integral(Precision(working.0 + smaller)).enclosed(size, places);
    Some(value.map(|value| value.at(precision)))
}

/// The integral ∫ f(from + length·x)·length dx over 0 ≤ x ≤ 1.
struct Integral<'a> {
    pool: &'a Pool,
    quadrature: &'a Quadrature,
    from: Enclosure,
    length: Enclosure,
    parameters: Vec<Enclosure>,
    order: usize,
    precision: Precision,
}

impl Integral<'_> {
    /// Encloses the integral of a function of size 2ˢ to `places` binary places relative to that
    /// size.
    fn enclosed(&self, size: i32, places: u32) -> Result<Enclosure, Undecided> {
        let tolerance = Rational::from_integer(2.into()).pow(size - places as i32);
        let mut sum = Enclosure::integer(0, self.precision);
        let mut open = vec![(Rational::zero(), Rational::one())];
        let mut looked_at = 0;
        while let Some((lower, upper)) = open.pop() {
            looked_at += 1;
            if looked_at > MOST_INTERVALS {
                return Err(Undecided::Unknown);
            }
            let width = &upper - &lower;
            match self.on(&lower, &upper) {
                Ok((part, remainder)) if remainder.width() <= &tolerance * &width => {
                    sum = sum.add(&part).add(&remainder);
                }
                _ => {
                    let middle = (&lower + &upper) / Rational::from_integer(2.into());
                    open.push((middle.clone(), upper));
                    open.push((lower, middle));
                }
            }
        }
        Ok(sum.mul(&self.length))
    }

    /// Returns the exponent of a power of two of about the size of the integrand, to which the
    /// tolerance is relative. Its value affects the work but not the validity of an enclosure.
    fn size(&self) -> i32 {
        let at = |eighths: i64| {
            let place = Rational::new(eighths.into(), 8.into());
            let value = self.expanded(Enclosure::exact(&place, self.precision), 0).ok()?;
            Some(value[0].lower().abs().max(value[0].upper().abs()))
        };
        let largest = LOOKED_AT.into_iter().filter_map(at).max().filter(|largest| !largest.is_zero());
        largest.map_or(0, |largest| largest.numer().bits() as i32 - largest.denom().bits() as i32)
    }

    /// Returns the integral of the polynomial over an interval, and the contribution of the
    /// remainder.
    fn on(&self, lower: &Rational, upper: &Rational) -> Result<(Enclosure, Enclosure), Undecided> {
        let two = Rational::from_integer(2.into());
        let (middle, half) = ((lower + upper) / &two, (upper - lower) / &two);
        let at_middle = self.coefficients(Enclosure::exact(&middle, self.precision))?;
        let over_all = self.coefficients(Enclosure::between(lower, upper, self.precision))?;
        let mut part = Enclosure::integer(0, self.precision);
        let mut power = half.clone();
        let (square, mut remainder) = (&half * &half, part.clone());
        for k in (0..=self.order).step_by(2) {
            let weight = &two * &power / Rational::from_integer((k + 1).into());
            let weight = Enclosure::exact(&weight, self.precision);
            if k < self.order {
                part = part.add(&at_middle[k].mul(&weight));
            } else {
                remainder = over_all[k].mul(&weight);
            }
            power *= &square;
        }
        Ok((part, remainder))
    }

    /// Returns the Taylor coefficients of f(from + length·x) about a point or over an interval.
    fn coefficients(&self, place: Enclosure) -> Result<Series, Undecided> {
        self.expanded(place, self.order)
    }

    /// Returns the Taylor coefficients up to an order.
    fn expanded(&self, place: Enclosure, order: usize) -> Result<Series, Undecided> {
        let Quadrature { integrand, variable, parameters } = self.quadrature;
        let mut values: FxHashMap<Symbol, Series> = FxHashMap::default();
        let zero = Enclosure::integer(0, self.precision);
        let series = |first: Enclosure, second: &Enclosure| linear(first, second, order, self.precision);
        values.insert(*variable, series(self.from.add(&self.length.mul(&place)), &self.length));
        for (&symbol, value) in parameters.iter().zip(&self.parameters) {
            values.insert(symbol, series(value.clone(), &zero));
        }
        let taylor = Taylor { pool: self.pool, values: &values, order, precision: self.precision };
        taylor.of(*integrand)
    }
}
