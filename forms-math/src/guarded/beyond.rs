//! Numbers beyond the exponents of words: their sign and a lower bound 2^e of their magnitude are
//! known, but no upper bound.
//!
//! They result from e^x with x beyond 2⁵⁰, from infinite arguments, and from operations on such
//! numbers. A value that does not depend on their magnitude is still known: 1/(e^x − 1), tanh x, a
//! choice. They are infinite values with an error of zero. `f64` and double-double have no such
//! values, since wider numbers follow.

use super::{Bound, Guardable, Guarded};

/// Threshold of x: e^x is beyond 2^(2⁵⁰) from x = 2⁵⁰ on.
const OF_EXPONENTIAL: i64 = 1 << 50;

/// Number of this sign with a magnitude of at least 2^`exponent`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Beyond {
    negative: bool,
    exponent: i64,
}

impl Beyond {
    fn guarded<T: Guardable>(self) -> Guarded<T> {
        // A clamped exponent is a weaker bound, and never overflows.
        let exponent = self.exponent.clamp(-(1 << 60), 1 << 60);
        Guarded { value: T::beyond(self.negative, exponent), error: T::Bound::ZERO }
    }

    fn with_exponent(self, exponent: i64) -> Self {
        Self { exponent, ..self }
    }
}

/// Returns an exponent with 2^exponent above a magnitude.
fn exponent_above<B: Bound>(size: B) -> i64 {
    size.exponent().unwrap_or(i64::MIN / 4)
}

impl<T: Guardable> Guarded<T> {
    /// Returns the sign and the lower bound of a number beyond the range.
    #[inline(always)]
    pub(super) fn is_beyond(self) -> Option<Beyond> {
        let (negative, exponent) = self.value.is_beyond()?;
        self.error.is_zero().then_some(Beyond { negative, exponent })
    }

    /// Returns 0 with this error.
    fn about_zero(error: T::Bound) -> Self {
        Self { value: T::from_f64(0.0), error }
    }

    fn unknown() -> Self {
        Self::undecided(T::nan())
    }

    /// Returns a value with an additional error of 2^(−2⁴⁹).
    fn nearly(value: Self) -> Self {
        let error = value.error.plus(T::Bound::of(1.0).shifted(-(1 << 49)));
        Self { error, ..value }
    }

    fn is_negative(self) -> bool {
        self.value < T::from_f64(0.0)
    }

    /// Computes a + b, where at least one number is beyond the range.
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

    /// Computes a b, where at least one number is beyond the range.
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

    /// Computes a/b, where at least one number is beyond the range.
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
    /// Computes e^x, or e^x − 1 with another limit.
    pub(super) fn exponential<T: Guardable>(self, limit: f64) -> Guarded<T> {
        if self.exponent < 50 {
            return Guarded::unknown();
        }
        if self.negative {
            return Guarded::nearly(Guarded::from_limit(limit));
        }
        self.with_exponent(OF_EXPONENTIAL - 1).guarded()
    }

    /// Computes ln x or ln(1 + x): at least e ln 2 > 2^(b − 2), where e has b bits.
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

    /// Computes sin x or cos x.
    pub(super) fn oscillation<T: Guardable>(self) -> Guarded<T> {
        Guarded::about_zero(T::Bound::of(1.0))
    }

    /// Computes arctan x, which is within 1/|x| of ±π/2.
    pub(super) fn arc_tangent<T: Guardable>(self) -> Guarded<T> {
        let quarter = T::pi().scaled(-1);
        let error = quarter.rounding(1.0).plus(T::Bound::of(1.0).shifted(-self.exponent));
        Guarded { value: if self.negative { -quarter } else { quarter }, error }
    }

    /// Computes sinh x or cosh x, with this sign.
    pub(super) fn hyperbolic<T: Guardable>(self, negative: bool) -> Guarded<T> {
        if self.exponent < 50 {
            return Guarded::unknown();
        }
        Beyond { negative, exponent: OF_EXPONENTIAL - 2 }.guarded()
    }

    /// Computes tanh x or erf x.
    pub(super) fn step<T: Guardable>(self) -> Guarded<T> {
        if self.exponent < 50 {
            return Guarded::unknown();
        }
        Guarded::nearly(Guarded::from_limit(if self.negative { -1.0 } else { 1.0 }))
    }

    /// erfc x
    pub(super) fn step_down<T: Guardable>(self) -> Guarded<T> {
        if self.exponent < 50 {
            return Guarded::unknown();
        }
        Guarded::nearly(Guarded::from_limit(if self.negative { 2.0 } else { 0.0 }))
    }

    /// Eₙ(x)
    pub(super) fn exponential_integral<T: Guardable>(self) -> Guarded<T> {
        if self.exponent < 50 {
            return Guarded::unknown();
        }
        if self.negative { Guarded::undefined() } else { Guarded::nearly(Guarded::from_limit(0.0)) }
    }

    /// Whether the number is negative.
    pub(super) fn is_negative(self) -> bool {
        self.negative
    }

    /// Returns the value of a function that is defined only for |x| ≤ 1.
    pub(super) fn outside_of_one<T: Guardable>(self) -> Guarded<T> {
        if self.exponent > 0 { Guarded::undefined() } else { Guarded::unknown() }
    }
}

impl<T: Guardable> Guarded<T> {
    fn from_limit(value: f64) -> Self {
        Self::exact(T::from_f64(value))
    }

    /// Computes the angle of (x, y), where at least one is beyond the range: its distance from an
    /// axis is at most the coordinate within the range divided by the magnitude of the one beyond
    /// it.
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

    /// Returns the sign of x if e^x is beyond the range of words.
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
