//! Numbers beyond the exponents of words: of one sign and at least 2^e in size, with nothing known above.
//!
//! They come from e^x with x beyond 2⁵⁰, from infinite arguments, and from what is computed of these. A value that does not
//! depend on how large they are is known all the same: 1/(e^x − 1), tanh x, a choice. They are infinite values with an
//! error of zero; `f64` and double-double have none, since wider numbers follow.

use super::{Bound, Guardable, Guarded};

/// e^x is beyond 2^(2⁵⁰) from x = 2⁵⁰ on.
const OF_EXPONENTIAL: i64 = 1 << 50;

/// A number of this sign, at least 2^`exponent` in size.
#[derive(Clone, Copy, Debug)]
pub(super) struct Beyond {
    negative: bool,
    exponent: i64,
}

impl Beyond {
    fn guarded<T: Guardable>(self) -> Guarded<T> {
        // larger exponents say less than they could, and never overflow
        let exponent = self.exponent.clamp(-(1 << 60), 1 << 60);
        Guarded { value: T::beyond(self.negative, exponent), error: T::Bound::ZERO }
    }

    fn with_exponent(self, exponent: i64) -> Self {
        Self { exponent, ..self }
    }
}

/// 2^exponent is above a size.
fn exponent_above<B: Bound>(size: B) -> i64 {
    size.exponent().unwrap_or(i64::MIN / 4)
}

impl<T: Guardable> Guarded<T> {
    /// What is known of a number beyond the range.
    #[inline(always)]
    pub(super) fn is_beyond(self) -> Option<Beyond> {
        let (negative, exponent) = self.value.is_beyond()?;
        self.error.is_zero().then_some(Beyond { negative, exponent })
    }

    /// 0 ± a size
    fn about_zero(error: T::Bound) -> Self {
        Self { value: T::from_f64(0.0), error }
    }

    fn unknown() -> Self {
        Self::undecided(T::nan())
    }

    /// Something of this value that is at most 2^(−2⁴⁹) off.
    fn nearly(value: Self) -> Self {
        let error = value.error.plus(T::Bound::of(1.0).shifted(-(1 << 49)));
        Self { error, ..value }
    }

    fn is_negative(self) -> bool {
        self.value < T::from_f64(0.0)
    }

    /// a + b, of which one is beyond.
    pub(super) fn sum_beyond(a: Self, b: Self) -> Self {
        let (large, other) = match (a.is_beyond(), b.is_beyond()) {
            (Some(a), Some(b)) if a.negative == b.negative => {
                return a.with_exponent(a.exponent.max(b.exponent)).guarded();
            }
            (Some(large), None) => (large, b),
            (None, Some(large)) => (large, a),
            _ => return Self::unknown(),
        };
        if other.is_undefined() {
            return Self::undefined();
        }
        let size = other.value.size().plus(other.error);
        if size.is_finite() && exponent_above(size) < large.exponent {
            return large.with_exponent(large.exponent - 1).guarded();
        }
        Self::unknown()
    }

    /// a b, of which one is beyond.
    pub(super) fn product_beyond(a: Self, b: Self) -> Self {
        let (large, other) = match (a.is_beyond(), b.is_beyond()) {
            (Some(a), Some(b)) => {
                let negative = a.negative != b.negative;
                return Beyond { negative, exponent: a.exponent.saturating_add(b.exponent) }.guarded();
            }
            (Some(large), None) => (large, b),
            (None, Some(large)) => (large, a),
            _ => return Self::unknown(),
        };
        if other.is_undefined() || other.is_exact_zero() {
            return other;
        }
        let least = other.least_size();
        match least.exponent().filter(|_| other.error.is_finite()) {
            // 2^(exponent − 1) ≤ least
            Some(exponent) => {
                let negative = large.negative != other.is_negative();
                Beyond { negative, exponent: large.exponent.saturating_add(exponent - 1) }.guarded()
            }
            None => Self::unknown(),
        }
    }

    /// a/b, of which one is beyond.
    pub(super) fn quotient_beyond(a: Self, b: Self) -> Self {
        if a.is_undefined() || b.is_undefined() {
            return Self::undefined();
        }
        match (a.is_beyond(), b.is_beyond()) {
            (None, Some(divisor)) if a.error.is_finite() => {
                Self::about_zero(a.value.size().plus(a.error).shifted(-divisor.exponent))
            }
            (Some(large), None) if b.error.is_finite() && !b.least_size().is_zero() => {
                let above = exponent_above(b.value.size().plus(b.error));
                let negative = large.negative != b.is_negative();
                Beyond { negative, exponent: large.exponent.saturating_sub(above) }.guarded()
            }
            _ => Self::unknown(),
        }
    }
}

impl Beyond {
    /// e^x, and e^x − 1 with another limit.
    pub(super) fn exponential<T: Guardable>(self, limit: f64) -> Guarded<T> {
        if self.exponent < 50 {
            return Guarded::unknown();
        }
        if self.negative {
            return Guarded::nearly(Guarded::from_limit(limit));
        }
        self.with_exponent(OF_EXPONENTIAL - 1).guarded()
    }

    /// ln x and ln(1 + x): at least 2^e ln 2 > 2^(e' − 1) with e of e' bits.
    pub(super) fn logarithm<T: Guardable>(self) -> Guarded<T> {
        if self.exponent < 4 {
            return Guarded::unknown();
        }
        if self.negative {
            return Guarded::undefined();
        }
        self.with_exponent(i64::from(self.exponent.ilog2()) - 1).guarded()
    }

    /// √x
    pub(super) fn root<T: Guardable>(self) -> Guarded<T> {
        if self.negative && self.exponent > 0 {
            return Guarded::undefined();
        }
        if self.negative {
            Guarded::unknown()
        } else {
            self.with_exponent(self.exponent.div_euclid(2)).guarded()
        }
    }

    /// x^(n/d)
    pub(super) fn power<T: Guardable>(self, numerator: i64, denominator: i64) -> Guarded<T> {
        if denominator <= 0 || self.exponent < 1 {
            return Guarded::unknown();
        }
        if self.negative && denominator != 1 {
            return Guarded::undefined();
        }
        let exponent = i128::from(self.exponent) * i128::from(numerator);
        let exponent = exponent.div_euclid(i128::from(denominator)).clamp(-(1 << 60), 1 << 60) as i64;
        let negative = self.negative && numerator % 2 != 0;
        match numerator {
            0 => Guarded::from_limit(1.0),
            1.. => Beyond { negative, exponent }.guarded(),
            _ => Guarded::about_zero(T::Bound::of(1.0).shifted(exponent + 1)),
        }
    }

    /// sin x and cos x
    pub(super) fn oscillation<T: Guardable>(self) -> Guarded<T> {
        Guarded::about_zero(T::Bound::of(1.0))
    }

    /// arctan x: 1/|x| and less from the quarter turn.
    pub(super) fn arc_tangent<T: Guardable>(self) -> Guarded<T> {
        let quarter = T::pi().scaled(-1);
        let error = quarter.rounding(1.0).plus(T::Bound::of(1.0).shifted(-self.exponent));
        Guarded { value: if self.negative { -quarter } else { quarter }, error }
    }

    /// sinh x and cosh x, of this sign.
    pub(super) fn hyperbolic<T: Guardable>(self, negative: bool) -> Guarded<T> {
        if self.exponent < 50 {
            return Guarded::unknown();
        }
        Beyond { negative, exponent: OF_EXPONENTIAL - 2 }.guarded()
    }

    /// tanh x and erf x
    pub(super) fn step<T: Guardable>(self) -> Guarded<T> {
        if self.exponent < 50 {
            return Guarded::unknown();
        }
        Guarded::nearly(Guarded::from_limit(if self.negative { -1.0 } else { 1.0 }))
    }

    /// Eₙ(x)
    pub(super) fn exponential_integral<T: Guardable>(self) -> Guarded<T> {
        if self.exponent < 50 {
            return Guarded::unknown();
        }
        if self.negative { Guarded::undefined() } else { Guarded::nearly(Guarded::from_limit(0.0)) }
    }

    /// Whether it is below zero.
    pub(super) fn is_negative(self) -> bool {
        self.negative
    }

    /// What is defined in |x| ≤ 1 alone.
    pub(super) fn outside_of_one<T: Guardable>(self) -> Guarded<T> {
        if self.exponent > 0 { Guarded::undefined() } else { Guarded::unknown() }
    }
}

impl<T: Guardable> Guarded<T> {
    fn from_limit(value: f64) -> Self {
        Self::exact(T::from_f64(value))
    }

    /// The angle of (x, y), of which one is beyond: the other over its size away from an axis.
    pub(super) fn angle_beyond(y: Self, x: Self) -> Self {
        let size = |side: Self| side.value.size().plus(side.error);
        match (y.is_beyond(), x.is_beyond()) {
            (Some(up), None) if x.error.is_finite() => {
                let mut quarter: Self = up.arc_tangent();
                quarter.error = quarter.error.plus(size(x).shifted(-up.exponent));
                quarter
            }
            (None, Some(right)) if y.error.is_finite() => {
                let error = size(y).shifted(-right.exponent);
                if !right.negative {
                    return Self::about_zero(error);
                }
                let certain = y.value.size_down() > y.error || y.is_exact();
                if !certain {
                    return Self::unknown();
                }
                let half = T::pi();
                let value = if y.is_negative() { -half } else { half };
                Self { value, error: error.plus(half.rounding(1.0)) }
            }
            _ => Self::unknown(),
        }
    }

    /// Whether e^x is beyond the range of words, by the sign of x.
    pub(super) fn exponential_beyond(self) -> Option<Beyond> {
        if let Some(beyond) = self.is_beyond() {
            return Some(beyond);
        }
        let is_large = T::HAS_BEYOND
            && self.error.is_finite()
            && self.least_size() >= T::Bound::of(1.0).shifted(OF_EXPONENTIAL.ilog2().into());
        is_large.then(|| Beyond { negative: self.is_negative(), exponent: 50 })
    }
}
