//! The dilogarithm and Clausen's function.

use super::bounds::{Enclosure, Undecided, Value};
use super::constants::pi;
use super::exponential::{logarithm_of, rounded_quotient};
use super::range::Range;
use super::series::{Divisors, series};
use crate::expression::Rational;
use num_bigint::BigInt;
use num_traits::{Signed, Zero};

/// Guard places that absorb the rounding of a few hundred steps.
const GUARD: u32 = 32;

/// Angles beyond 2⁴⁰⁹⁶ are not reduced.
const LARGEST_ANGLE_BITS: u64 = 4096;

impl Enclosure {
    /// Li₂(a) for a ≤ 1, where it increases
    pub fn dilog(&self) -> Result<Enclosure, Undecided> {
        let rest = Enclosure::integer(1, self.precision()).sub(self);
        if rest.is_negative() {
            return Err(Undecided::Undefined);
        }
        if !rest.is_nonnegative() {
            return Err(Undecided::Unknown);
        }
        self.through_ends(GUARD, dilogarithm)
    }

    /// Cl₂(a)
    pub fn clausen(&self) -> Enclosure {
        if self.is_zero() {
            return self.clone();
        }
        let precision = self.precision().0;
        let working = precision + GUARD;
        let image = match &self.0 {
            _ if self.magnitude_bits() > LARGEST_ANGLE_BITS => whole_clausen(working),
            Value::Exact(value, _) => clausen_function(&Range::rational(value, working)),
            Value::Range(range) => clausen_of_range(&range.rescaled(working)),
        };
        Enclosure::from_range(image.rescaled(precision))
    }
}

/// Li₂(x) = Σ xᵏ/k² for |x| ≤ ½; π²/6 − log x log(1 − x) − Li₂(1 − x) for x > ½; −Li₂(x/(x − 1)) −
/// ½ log²(1 − x) for x < −½
fn dilogarithm(x: &Enclosure) -> Result<Enclosure, Undecided> {
    let precision = x.precision();
    let (one, half) = (Enclosure::integer(1, precision), Rational::new(1.into(), 2.into()));
    let rest = one.sub(x);
    if x.lower() > half {
        let basel = Enclosure::pi(precision).mul(&Enclosure::pi(precision));
        let basel = basel.mul(&Enclosure::exact(&Rational::new(1.into(), 6.into()), precision));
        if rest.is_zero() {
            return Ok(basel);
        }
        return Ok(basel.sub(&x.log()?.mul(&rest.log()?)).sub(&dilogarithm(&rest)?));
    }
    if x.lower() < -&half {
        let logarithm = rest.log()?;
        let square = logarithm.mul(&logarithm).mul(&Enclosure::exact(&half, precision));
        return Ok(dilogarithm(&x.neg().div(&rest)?)?.add(&square).neg());
    }
    let range = x.to_range(precision.0);
    let ratio = range.clone();
    let sum = series(range, &ratio, |k| Divisors { step: 1, term: (k + 1) * (k + 1) });
    Ok(Enclosure::from_range(sum))
}

/// Returns a range of all values of Cl₂: |Cl₂| is at most Cl₂(π/3) = 1.0149…
fn whole_clausen(precision: u32) -> Range {
    let largest = Range::quotient(&BigInt::from(1015), &BigInt::from(1000), precision);
    largest.negate().hull(largest)
}

/// Encloses {Cl₂(x)}: for a narrow range about its midpoint, otherwise by the hull of the values at
/// both ends and of the extrema between them, at ±π/3 and whole turns from there.
fn clausen_of_range(x: &Range) -> Range {
    if x.narrow_ball().is_some() {
        return clausen_function(x);
    }
    let mut image = clausen_function(&x.lower_end()).hull(clausen_function(&x.upper_end()));
    let turn = pi(x.precision).doubled(1);
    let sixth = pi(x.precision).divided_by_count(3);
    for extremum in [sixth.negate(), sixth] {
        let turns = x.subtract(&extremum).divide(&turn);
        if turns.lower <= floor(&turns.upper, x.precision) {
            image = image.hull(clausen_function(&extremum));
        }
    }
    image
}

/// ⌊x⌋ in units of 2⁻ᵖ
fn floor(x: &BigInt, precision: u32) -> BigInt {
    (x >> precision) << precision
}

/// Returns Cl₂ of an angle reduced to [−π, π], evaluated about the midpoint of its range.
fn clausen_function(x: &Range) -> Range {
    let precision = x.precision + x.magnitude_bits() as u32 + GUARD;
    let turn = pi(precision).doubled(1);
    let fine = x.rescaled(precision);
    let turns = rounded_quotient(&fine.lower, &turn.lower);
    let r = fine.subtract(&turn.scaled(&turns.into())).rescaled(x.precision + GUARD);
    let middle: BigInt = (&r.lower + &r.upper) >> 1;
    let radius = &r.upper - &middle;
    let Some(reach) = modulus_of_continuity(&radius, r.precision) else {
        return whole_clausen(x.precision);
    };
    let point = |value: BigInt| Range::new(value.clone(), value, r.precision);
    let value = match &middle {
        _ if middle.is_zero() => Range::integer(0, r.precision),
        _ if middle.is_negative() => clausen_of_angle(&point(-&middle)).negate(),
        _ => clausen_of_angle(&point(middle)),
    };
    value.widened(&reach).rescaled(x.precision)
}

/// Returns an upper bound of |Cl₂(x) − Cl₂(y)| for |x − y| ≤ δ, in units of 2⁻ᵖ; `None` for δ above
/// ¼.
///
/// The difference is an integral of |log|2 sin(t/2)|| over a length δ, which is largest around t =
/// 0, where 2 sin(t/2) ≥ 0.99 t: at most δ (1.01 + log(2/δ)). For 2⁻ᵇ⁻¹ ≤ δ < 2⁻ᵇ that is below δ
/// (b + 4).
fn modulus_of_continuity(delta: &BigInt, precision: u32) -> Option<BigInt> {
    let places = u64::from(precision).checked_sub(delta.bits()).filter(|&places| places >= 2)?;
    Some(delta * (places + 4))
}

/// Cl₂(θ) = θ (1 − log θ) + Σ Tₙ θ²ⁿ⁺¹/(4ⁿ (4ⁿ − 1) (2n + 1)!) for θ up to 2π/3, and Cl₂(π − θ) = θ
/// log 2 − Σ Tₙ θ²ⁿ⁺¹/(4ⁿ (2n + 1)!) for θ below π/3, with the tangent numbers Tₙ.
///
/// The n-th term of the first sum is ζ(2n) θ (θ/2π)²ⁿ/(n (2n + 1)); in the second sum (θ/2π)²ⁿ is
/// replaced by at most (θ/π)²ⁿ. So the terms of both are bounded by 2·2.2·8⁻ⁿ/3, and the remainder
/// after the N-th term by 2·8⁻ᴺ.
fn clausen_of_angle(angle: &Range) -> Range {
    let precision = angle.precision;
    let half_turn = pi(precision);
    let from_half_turn = half_turn.subtract(angle);
    let near_half_turn = &from_half_turn.lower * 3 < half_turn.lower;
    let count = precision as usize / 3 + 1;
    let theta = if near_half_turn { &from_half_turn } else { angle };
    let square = theta.square();
    let mut power = theta.clone();
    let mut sum = Range::integer(0, precision);
    let mut divisor = BigInt::from(1);
    for (n, tangent) in (1_u64..).zip(tangent_numbers(count)) {
        power = power.multiply(&square);
        divisor *= 8 * n * (2 * n + 1);
        let rest = if near_half_turn { BigInt::from(1) } else { (BigInt::from(1) << (2 * n)) - 1 };
        sum.accumulate(&power.scaled(&Rational::new_raw(tangent, &divisor * rest)));
    }
    let sum = sum.widened(&2.into());
    if near_half_turn {
        return theta.multiply(&super::constants::log_two(precision)).subtract(&sum);
    }
    let factor = Range::integer(1, precision).subtract(&logarithm_of(theta));
    theta.multiply(&factor).add(&sum)
}

/// Returns the tangent numbers T₁, T₂, … = 1, 2, 16, 272, …, the derivatives of odd order of the
/// tangent at 0.
fn tangent_numbers(count: usize) -> Vec<BigInt> {
    let mut numbers = vec![BigInt::from(1); count];
    for n in 1..count {
        numbers[n] = &numbers[n - 1] * n;
    }
    for n in 1..count {
        for k in n..count {
            numbers[k] = &numbers[k - 1] * (k - n) + &numbers[k] * (k - n + 2);
        }
    }
    numbers
}
