//! The exponential, the logarithm and the hyperbolic functions.

use super::bounds::{Enclosure, Undecided, Value};
use super::constants::log_two;
use super::range::Range;
use super::series::{Divisors, odd_reciprocals, series};
use num_bigint::BigInt;
use num_integer::{Integer, Roots};
use num_traits::{Signed, ToPrimitive};

/// Arguments of exp up to 2¹¹ are computed. Beyond that the result would have more than 2900 bits,
/// and a search that evaluates hundreds of such values would take minutes.
const LARGEST_EXPONENT_BITS: u64 = 11;

/// Guard places that absorb the rounding of a computation of a few hundred steps.
const GUARD: u32 = 16;

impl Enclosure {
    /// eᵃ; undecided where the result may be absurdly large
    pub fn exp(&self) -> Result<Enclosure, Undecided> {
        if self.is_zero() {
            return Ok(Enclosure::integer(1, self.precision()));
        }
        Ok(self.increasing(self.growth()?, exponential))
    }

    /// log a for a > 0
    pub fn log(&self) -> Result<Enclosure, Undecided> {
        if self.is_nonpositive() {
            return Err(Undecided::Undefined);
        }
        if !self.is_positive() {
            return Err(Undecided::Unknown);
        }
        if self.is_integer(1) {
            return Ok(Enclosure::integer(0, self.precision()));
        }
        let precision = self.precision().0;
        let range = match &self.0 {
            Value::Exact(value, _) => logarithm(value.numer(), value.denom(), precision),
            Value::Range(range) => logarithm_of(range),
        };
        Ok(Enclosure::from_range(range))
    }

    /// eᵃ − 1
    pub fn expm1(&self) -> Result<Enclosure, Undecided> {
        Ok(self.exp()?.sub(&Enclosure::integer(1, self.precision())))
    }

    /// log(1 + a) for a > −1
    pub fn log1p(&self) -> Result<Enclosure, Undecided> {
        self.add(&Enclosure::integer(1, self.precision())).log()
    }

    /// sinh a
    pub fn sinh(&self) -> Result<Enclosure, Undecided> {
        if self.is_zero() {
            return Ok(self.clone());
        }
        Ok(self.increasing(self.abs().growth()?, hyperbolic_sine))
    }

    /// cosh a = cosh |a|, which increases with |a|
    pub fn cosh(&self) -> Result<Enclosure, Undecided> {
        if self.is_zero() {
            return Ok(Enclosure::integer(1, self.precision()));
        }
        let magnitude = self.abs();
        Ok(magnitude.increasing(magnitude.growth()?, |x| {
            let e = exponential(x);
            e.add(&reciprocal(&e)).halved(1)
        }))
    }

    /// tanh a
    pub fn tanh(&self) -> Enclosure {
        if self.is_zero() {
            return self.clone();
        }
        self.increasing(GUARD, hyperbolic_tangent)
    }

    /// Returns the guard places with which eᵃ < 2ⁿ is as accurate as if it were below 1: log₂ e <
    /// 3/2, so n = ⌈3a/2⌉ is enough.
    fn growth(&self) -> Result<u32, Undecided> {
        if self.is_nonpositive() {
            return Ok(GUARD);
        }
        if self.magnitude_bits() > LARGEST_EXPONENT_BITS {
            let certain = self.least_magnitude_bits() > LARGEST_EXPONENT_BITS;
            return Err(if certain { Undecided::TooLarge } else { Undecided::Unknown });
        }
        let bits = self.upper().ceil().to_integer().to_u32().ok_or(Undecided::Unknown)?;
        Ok(GUARD + 3 * bits / 2 + 1)
    }
}

/// eˣ = 2ᵏ (e^(r/2ˢ))^(2ˢ) with r = x − k log 2, |r| < 1, and eᵗ = Σ tⁿ/n!
fn exponential(x: &Range) -> Range {
    let halvings = (x.precision.sqrt() / 2).max(1);
    let underflow: BigInt = -(BigInt::from(i64::from(x.precision) + 1) << x.precision);
    if x.upper < underflow {
        return Range::new(BigInt::from(0), BigInt::from(1), x.precision);
    }
    let inner = x.precision + halvings + GUARD;
    let log_two = log_two(inner);
    let x_fine = x.rescaled(inner);
    let k = rounded_quotient(&x_fine.lower, &log_two.lower);
    let r = x_fine.subtract(&log_two.scaled(&k.clone().into()));
    let mut power =
        series(Range::integer(1, inner), &r.halved(halvings), |k| Divisors { step: k + 1, term: 1 });
    for _ in 0..halvings {
        power = power.square();
    }
    let shift = k.magnitude().to_u32().expect("the exponent has been bounded");
    let scaled = if k.is_negative() { power.halved(shift) } else { power.doubled(shift) };
    scaled.rescaled(x.precision)
}

/// Returns the integer nearest to a/b, for b > 0.
pub(super) fn rounded_quotient(a: &BigInt, b: &BigInt) -> BigInt {
    let doubled: BigInt = a * 2 + b;
    doubled.div_floor(&(b * 2))
}

/// {log x} of a positive range
pub(super) fn logarithm_of(range: &Range) -> Range {
    let unit = BigInt::from(1) << range.precision;
    let end = |end: &BigInt| logarithm(end, &unit, range.precision);
    end(&range.lower).hull(end(&range.upper))
}

/// log(n/d) = k log 2 + 2 artanh((m − 1)/(m + 1)) with m = n/(2ᵏ d) in [3/4, 3/2]
fn logarithm(n: &BigInt, d: &BigInt, precision: u32) -> Range {
    let mut k = n.bits() as i64 - d.bits() as i64;
    let scaled = |k: i64| if k < 0 { (n << -k, d.clone()) } else { (n.clone(), d << k) };
    let (mut a, mut b) = scaled(k);
    if &a * 2 > &b * 3 {
        k += 1;
        (a, b) = scaled(k);
    } else if &a * 4 < &b * 3 {
        k -= 1;
        (a, b) = scaled(k);
    }
    let inner = precision + GUARD + (64 - k.unsigned_abs().leading_zeros());
    let z = Range::quotient(&(&a - &b), &(&a + &b), inner);
    let ratio = z.square();
    let logarithm = odd_reciprocals(z, &ratio).doubled(1);
    logarithm.add(&log_two(inner).scaled(&BigInt::from(k).into())).rescaled(precision)
}

/// 1/x for a positive range
fn reciprocal(x: &Range) -> Range {
    Range::integer(1, x.precision).divide(x)
}

/// sinh x = (eˣ − e⁻ˣ)/2 = −sinh(−x)
fn hyperbolic_sine(x: &Range) -> Range {
    if x.upper.is_negative() {
        return hyperbolic_sine(&x.negate()).negate();
    }
    let e = exponential(x);
    e.subtract(&reciprocal(&e)).halved(1)
}

/// tanh x = 2/(1 + e⁻²ˣ) − 1 = −tanh(−x)
fn hyperbolic_tangent(x: &Range) -> Range {
    if x.upper.is_negative() {
        return hyperbolic_tangent(&x.negate()).negate();
    }
    let one = Range::integer(1, x.precision);
    let quotient = Range::integer(2, x.precision).divide(&one.add(&exponential(&x.doubled(1).negate())));
    quotient.subtract(&one).within_unit()
}
