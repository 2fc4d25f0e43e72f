//! Rational powers and roots, from roots of integers.

use super::bounds::{Enclosure, Precision, Undecided, Value, exact_bits};
use super::range::Range;
use crate::expression::Rational;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::Ratio;
use num_traits::{One, Signed, Zero};

/// Limit on the length in bits of the intermediate integers of a power.
const LONGEST_POWER_BITS: u64 = 1 << 18;

/// The precision at which a power is first estimated.
const ROUGH_PRECISION: u32 = 64;

/// Roots of a higher degree are computed by the logarithm.
const LARGEST_DEGREE: u64 = 64;

/// |a/b| with small a and b, and whether a/b is negative.
#[derive(Clone, Copy)]
struct Exponent {
    numerator: u64,
    degree: u64,
    inverted: bool,
}

impl Enclosure {
    /// √a for a ≥ 0
    pub fn sqrt(&self) -> Result<Enclosure, Undecided> {
        self.power(Ratio::new(1, 2))
    }

    /// aʳ; with a fraction r for a > 0, or a ≥ 0 if r > 0
    pub fn power(&self, exponent: Ratio<i64>) -> Result<Enclosure, Undecided> {
        if exponent.is_zero() {
            return Ok(Enclosure::integer(1, self.precision()));
        }
        if exponent.is_negative() && self.contains_zero() {
            let certain = self.is_zero() || (!exponent.is_integer() && self.is_nonpositive());
            return Err(if certain { Undecided::Undefined } else { Undecided::Unknown });
        }
        let odd = exponent.numer().is_odd();
        if !exponent.is_integer() {
            return match () {
                () if self.is_negative() => Err(Undecided::Undefined),
                () if self.is_nonnegative() => self.nonnegative_power(exponent),
                () => Err(Undecided::Unknown),
            };
        }
        if !odd {
            return self.abs().nonnegative_power(exponent);
        }
        if self.is_nonnegative() {
            return self.nonnegative_power(exponent);
        }
        if self.is_nonpositive() {
            return Ok(self.neg().nonnegative_power(exponent)?.neg());
        }
        let (below, above) = self.halves_about_zero();
        Ok(below.nonnegative_power(exponent)?.neg().hull(&above.nonnegative_power(exponent)?))
    }

    /// √(a² + b²)
    pub fn hypot(a: &Enclosure, b: &Enclosure) -> Result<Enclosure, Undecided> {
        let square = Ratio::from_integer(2);
        a.power(square)?.add(&b.power(square)?).sqrt()
    }

    /// ∛a for every a
    pub fn cbrt(&self) -> Result<Enclosure, Undecided> {
        let third = Ratio::new(1, 3);
        if self.is_nonnegative() {
            return self.power(third);
        }
        if self.is_nonpositive() {
            return Ok(self.neg().power(third)?.neg());
        }
        let (below, above) = self.halves_about_zero();
        Ok(below.power(third)?.neg().hull(&above.power(third)?))
    }

    /// [0, −lower] and [0, upper], for an enclosure with 0 inside
    fn halves_about_zero(&self) -> (Enclosure, Enclosure) {
        let range = self.to_range(self.precision().0);
        let part = |end: BigInt| Enclosure::from_range(Range::new(BigInt::zero(), end, range.precision));
        (part(-&range.lower), part(range.upper.clone()))
    }

    /// aʳ for a ≥ 0, or a > 0 if r < 0: monotone, so the values at the ends are sufficient
    fn nonnegative_power(&self, exponent: Ratio<i64>) -> Result<Enclosure, Undecided> {
        let precision = self.precision().0;
        let short = Exponent {
            numerator: exponent.numer().unsigned_abs(),
            degree: exponent.denom().unsigned_abs(),
            inverted: exponent.is_negative(),
        };
        if let Value::Exact(value, _) = &self.0
            && let Some(power) = exact_power(value, short, exact_bits(precision))
        {
            return Ok(Enclosure::from_rational(power, precision));
        }
        let unit = BigInt::one() << precision;
        let image = match &self.0 {
            Value::Exact(value, _) => power_of_quotient(value.numer(), value.denom(), short, precision),
            Value::Range(range) if exponent == Ratio::from_integer(2) => Some(range.square()),
            Value::Range(range) if exponent == Ratio::new(1, 2) => Some(range.sqrt()),
            Value::Range(range) => power_of_quotient(&range.lower, &unit, short, precision)
                .and_then(|a| power_of_quotient(&range.upper, &unit, short, precision).map(|b| a.hull(b))),
        };
        match image {
            Some(range) => Ok(Enclosure::from_range(range)),
            None => self.power_by_logarithm(exponent),
        }
    }

    /// aʳ = e^(r log a), at a low precision first, which shows whether the power is too large or
    /// rounds to zero.
    fn power_by_logarithm(&self, exponent: Ratio<i64>) -> Result<Enclosure, Undecided> {
        if !self.is_positive() {
            return Err(Undecided::Unknown);
        }
        let exponent = Rational::new((*exponent.numer()).into(), (*exponent.denom()).into());
        let power = |working: Precision| {
            self.at(working).log().and_then(|log| log.mul(&Enclosure::exact(&exponent, working)).exp())
        };
        let precision = self.precision();
        let rough = power(Precision(ROUGH_PRECISION.min(precision.0)));
        match rough {
            Err(Undecided::TooLarge) => Err(Undecided::TooLarge),
            _ => Ok(power(Precision(precision.0.saturating_mul(2).saturating_add(64)))?.at(precision)),
        }
    }
}

/// Returns the exact power, if it is rational and short.
fn exact_power(value: &Rational, exponent: Exponent, longest: u64) -> Option<Rational> {
    let Exponent { numerator, degree, inverted } = exponent;
    if value.is_zero() || value.is_one() {
        return (!(inverted && value.is_zero())).then(|| value.clone());
    }
    let bits = value.numer().bits().max(value.denom().bits());
    if bits.checked_mul(numerator)? > longest.checked_mul(degree)? || degree > LARGEST_DEGREE {
        return None;
    }
    let degree = degree as u32;
    let root = Rational::new_raw(exact_root(value.numer(), degree)?, exact_root(value.denom(), degree)?);
    let power = num_traits::pow(root, usize::try_from(numerator).ok()?);
    Some(if inverted { power.recip() } else { power })
}

fn exact_root(n: &BigInt, degree: u32) -> Option<BigInt> {
    if degree == 1 {
        return Some(n.clone());
    }
    let root = n.nth_root(degree);
    (root.pow(degree) == *n).then_some(root)
}

/// (n/d)^(a/b)·2ᵖ = (nᵃ 2ᵇᵖ/dᵃ)^(1/b), rounded down and up; `None` if the integers become too long
fn power_of_quotient(n: &BigInt, d: &BigInt, exponent: Exponent, precision: u32) -> Option<Range> {
    let Exponent { numerator: a, degree: b, inverted } = exponent;
    let length = n.bits().max(d.bits()).checked_mul(a)?.checked_add(b.checked_mul(precision.into())?)?;
    if length > LONGEST_POWER_BITS || b > LARGEST_DEGREE || (n.is_zero() && inverted) {
        return None;
    }
    let (a, b) = (u32::try_from(a).ok()?, b as u32);
    let (top, bottom) = if inverted { (d, n) } else { (n, d) };
    let (top, bottom) = (top.pow(a) << (b * precision), bottom.pow(a));
    let (lower, radicand) = (top.div_floor(&bottom), Integer::div_ceil(&top, &bottom));
    if b == 1 {
        return Some(Range::new(lower, radicand, precision));
    }
    let root = radicand.nth_root(b);
    let upper = if root.pow(b) < radicand { root + 1 } else { root };
    Some(Range::new(lower.nth_root(b), upper, precision))
}
