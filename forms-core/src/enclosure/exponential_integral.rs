//! The error function and the exponential integrals E₁, E₂, E₃, by their entire series.

use super::bounds::{Enclosure, Undecided};
use super::constants::{self, KEPT, Kept, constant, pi};
use super::exponential::logarithm_of;
use super::range::Range;
use super::series::{Divisors, entire_series};
use crate::expression::Rational;
use num_bigint::BigInt;
use num_traits::ToPrimitive;
use std::sync::OnceLock;

/// Guard places that absorb the rounding of a few thousand steps and of factors below 2¹².
const GUARD: u32 = 48;

/// Returns an integer above p log 2: e⁻ˣ < 2⁻ᵖ for larger x.
fn negligible_from(precision: u32) -> u32 {
    7 * precision / 10 + 2
}

/// Returns the number of places that a sum of size 1 loses if its terms are as large as eᵃ: log₂ e
/// < 3/2.
fn lost_to_terms(a: u32) -> u32 {
    3 * a / 2 + 1
}

/// Σ (−x)ᵏ/(k k!) for k ≥ 1, which is −γ − log x − E₁(x).
fn entire_part(x: &Range) -> Range {
    let negated = x.negate();
    entire_series(negated.clone(), &negated, |k| Divisors { step: k + 2, term: k + 1 })
}

/// Euler's γ = −log n − Σ (−n)ᵏ/(k k!) − E₁(n), with 0 < E₁(n) < 2⁻ᵖ for n above p log 2
fn euler(precision: u32) -> Range {
    static KEPT_EULER: Kept = [const { OnceLock::new() }; KEPT.len()];
    constant(precision, &KEPT_EULER, |p| {
        let n = negligible_from(p);
        let fine = p + lost_to_terms(n) + constants::GUARD;
        let n = Range::integer(n.into(), fine);
        let sum = logarithm_of(&n).add(&entire_part(&n)).negate().rescaled(p);
        sum.subtract(&Range::new(0.into(), 1.into(), p))
    })
}

impl Enclosure {
    /// erf a = 2/√π Σ (−1)ᵏ a²ᵏ⁺¹/(k! (2k + 1)), and 1 − erf a < e^(−a²) for a > 0
    pub fn erf(&self) -> Enclosure {
        if self.is_zero() {
            return self.clone();
        }
        let precision = self.precision().0;
        let largest = negligible_from(precision);
        let square = self.abs().upper().pow(2).ceil().to_integer().to_u32().unwrap_or(largest).min(largest);
        self.increasing(GUARD + lost_to_terms(square), |x| error_function(x, precision))
    }

    /// erfc a = 1 − erf a
    pub fn erfc(&self) -> Enclosure {
        Enclosure::integer(1, self.precision()).sub(&self.erf())
    }

    /// E₁(a) for a > 0
    pub fn expint1(&self) -> Result<Enclosure, Undecided> {
        if self.is_nonpositive() {
            return Err(Undecided::Undefined);
        }
        if !self.is_positive() {
            return Err(Undecided::Unknown);
        }
        self.decaying(first_integral)
    }

    /// E₂(a) = e⁻ᵃ − a E₁(a) for a ≥ 0
    pub fn expint2(&self) -> Result<Enclosure, Undecided> {
        self.check_not_negative()?;
        self.decaying(second_integral)
    }

    /// E₃(a) = (e⁻ᵃ − a E₂(a))/2 for a ≥ 0
    pub fn expint3(&self) -> Result<Enclosure, Undecided> {
        self.check_not_negative()?;
        self.decaying(third_integral)
    }

    fn check_not_negative(&self) -> Result<(), Undecided> {
        match self {
            _ if self.is_negative() => Err(Undecided::Undefined),
            _ if self.is_nonnegative() => Ok(()),
            _ => Err(Undecided::Unknown),
        }
    }

    /// Returns {f(x)} for a decreasing f with 0 < f(x) < e⁻ˣ for x ≥ 1, given by its values at
    /// points.
    fn decaying(
        &self,
        value: impl Fn(&Enclosure) -> Result<Enclosure, Undecided>,
    ) -> Result<Enclosure, Undecided> {
        let precision = self.precision().0;
        let largest = negligible_from(precision);
        self.through_ends(GUARD + lost_to_terms(largest), |x| {
            if x.lower() > Rational::from_integer(largest.into()) {
                return Ok(Enclosure::from_range(Range::new(0.into(), 1.into(), precision)));
            }
            value(x)
        })
    }

    /// Returns the hull of the values at both ends, which are computed with `guard` additional
    /// places.
    pub(super) fn through_ends(
        &self,
        guard: u32,
        value: impl Fn(&Enclosure) -> Result<Enclosure, Undecided>,
    ) -> Result<Enclosure, Undecided> {
        let (precision, mut working) = (self.precision(), self.precision());
        working.0 += guard;
        let lower = value(&Enclosure::exact(&self.lower(), working))?;
        if self.is_exact() {
            return Ok(lower.at(precision));
        }
        Ok(lower.hull(&value(&Enclosure::exact(&self.upper(), working))?).at(precision))
    }
}

fn error_function(x: &Range, precision: u32) -> Range {
    if x.upper < BigInt::from(0) {
        return error_function(&x.negate(), precision).negate();
    }
    let square = x.square();
    if square.lower > BigInt::from(negligible_from(precision)) << x.precision {
        let one = BigInt::from(1) << x.precision;
        return Range::new(&one - (BigInt::from(1) << (x.precision - precision)), one, x.precision);
    }
    let sum = entire_series(x.clone(), &square.negate(), |k| Divisors { step: k + 1, term: 2 * k + 1 });
    sum.doubled(1).divide(&pi(x.precision).sqrt()).within_unit()
}

/// E₁(x) = −γ − log x − Σ (−x)ᵏ/(k k!)
fn first_integral(x: &Enclosure) -> Result<Enclosure, Undecided> {
    let precision = x.precision().0;
    let rest = entire_part(&x.to_range(precision)).add(&euler(precision));
    Ok(x.log()?.add(&Enclosure::from_range(rest)).neg())
}

/// E₂(x) = e⁻ˣ − x E₁(x), and E₂(0) = 1
fn second_integral(x: &Enclosure) -> Result<Enclosure, Undecided> {
    if x.is_zero() {
        return Ok(Enclosure::integer(1, x.precision()));
    }
    Ok(x.neg().exp()?.sub(&x.mul(&first_integral(x)?)))
}

/// E₃(x) = (e⁻ˣ − x E₂(x))/2
fn third_integral(x: &Enclosure) -> Result<Enclosure, Undecided> {
    let half = Enclosure::exact(&Rational::new(1.into(), 2.into()), x.precision());
    Ok(x.neg().exp()?.sub(&x.mul(&second_integral(x)?)).mul(&half))
}
