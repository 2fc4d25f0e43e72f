//! Criteria for the sufficient accuracy of a value with an error bound, and the rounding of such
//! values.

use crate::guarded::{Bound, Guardable, Guarded};
use crate::{DoubleDouble, Real};

/// State of knowledge of a result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Outcome<N> {
    /// The result is this number.
    Known(N),
    /// More precision can decide.
    Open,
    /// No number of the type is near enough to the exact value.
    Never,
}

/// Number type to which results are rounded, with the required accuracy.
pub(super) trait Rounding: Copy {
    /// Number type.
    type Number: Copy;
    /// Value for undefined or unknown results.
    const NAN: Self::Number;
    /// Rounds a value; an additional error of `slack` units is allowed.
    fn round<T: Guardable>(self, value: Guarded<T>, slack: f64) -> Outcome<Self::Number>;
}

/// Additional error allowed for the last precision, in units: on the boundary of two roundings no
/// precision decides.
pub(super) const LEAST_SLACK: f64 = 1.0 / (1_u64 << 28) as f64;

/// Binary format: half an ulp is at most 2^−`precision` of a normal number.
struct Format {
    precision: i64,
    /// Least normal number, and largest number.
    normal: f64,
    largest: f64,
    /// Exponent of two of half the least positive number.
    half_of_least: i64,
}

const SINGLE: Format =
    Format { precision: 24, normal: f32::MIN_POSITIVE as f64, largest: f32::MAX as f64, half_of_least: -150 };
const DOUBLE: Format =
    Format { precision: 53, normal: f64::MIN_POSITIVE, largest: f64::MAX, half_of_least: -1075 };

impl Format {
    /// Whether `nearest` is within this number of units of the exact value, relative to it, or
    /// within half an ulp if it is not a normal number.
    fn accepts<T: Guardable>(
        &self,
        value: Guarded<T>,
        nearest: f64,
        (units, slack): (f64, f64),
    ) -> Outcome<f64> {
        let (number, error) = (value.value(), value.error());
        if number.is_nan() || !error.is_finite() {
            return Outcome::Open;
        }
        let least = number.size_down().minus_down(error);
        let unit = |units: f64| T::Bound::of(units).shifted(-self.precision);
        if !nearest.is_finite() {
            // The value is certainly beyond the largest number, and its error is tiny.
            let known = least >= T::Bound::of(self.largest) && error <= unit(LEAST_SLACK).times_down(least);
            return if known { Outcome::Known(nearest) } else { Outcome::Open };
        }
        let (left, rounding) = number.sum(-T::from_f64(nearest));
        let beyond = rounding.plus(error);
        let distance = left.size().plus(beyond);
        if nearest.abs() < self.normal {
            // Scaled up, since the bounds of `f64` do not reach that far down.
            let scale = -self.half_of_least / 2;
            let half = T::Bound::of(1.0 + slack).shifted(self.half_of_least + scale);
            return if distance.shifted(scale) <= half { Outcome::Known(nearest) } else { Outcome::Open };
        }
        if distance <= unit(units + slack).times_down(least) {
            return Outcome::Known(nearest);
        }
        let most = unit(units + 2.0 * LEAST_SLACK).times(number.size().plus(error));
        if left.size_down().minus_down(beyond) > most { Outcome::Never } else { Outcome::Open }
    }
}

/// Rounding to `f64`, within this number of units of 2⁻⁵³.
#[derive(Clone, Copy)]
pub(super) struct ToDouble {
    pub(super) units: f64,
}

impl Rounding for ToDouble {
    type Number = f64;
    const NAN: f64 = f64::NAN;
    fn round<T: Guardable>(self, value: Guarded<T>, slack: f64) -> Outcome<f64> {
        if value.is_undefined() {
            return Outcome::Known(f64::NAN);
        }
        DOUBLE.accepts(value, value.value().to_f64(), (self.units, slack))
    }
}

/// Rounding to `f32`, within this number of units of 2⁻²⁴.
#[derive(Clone, Copy)]
pub(super) struct ToSingle {
    pub(super) units: f64,
}

impl Rounding for ToSingle {
    type Number = f32;
    const NAN: f32 = f32::NAN;
    fn round<T: Guardable>(self, value: Guarded<T>, slack: f64) -> Outcome<f32> {
        if value.is_undefined() {
            return Outcome::Known(f32::NAN);
        }
        let nearest = value.value().to_f64() as f32;
        match SINGLE.accepts(value, nearest.into(), (self.units, slack)) {
            Outcome::Known(_) => Outcome::Known(nearest),
            Outcome::Open => Outcome::Open,
            Outcome::Never => Outcome::Never,
        }
    }
}

/// Rounding to two words: within 2⁻⁹⁸ down to 2⁻⁹⁰⁰, and within the least positive number below.
#[derive(Clone, Copy)]
pub(super) struct ToTwoWords;

impl ToTwoWords {
    /// Exponent of two of the relative error bound: 29 decimal digits.
    const PLACES: i64 = -98;
    /// 2⁻⁹⁰⁰: below this, the exponents are insufficient for the second word.
    const LEAST: f64 = f64::from_bits((1023 - 900) << 52);
}

impl Rounding for ToTwoWords {
    type Number = DoubleDouble;
    const NAN: DoubleDouble = DoubleDouble::NAN;
    fn round<T: Guardable>(self, value: Guarded<T>, _: f64) -> Outcome<DoubleDouble> {
        if value.is_undefined() {
            return Outcome::Known(DoubleDouble::NAN);
        }
        let (number, error) = (value.value(), value.error());
        if number.is_nan() || !error.is_finite() {
            return Outcome::Open;
        }
        let rounded = in_two_words(number);
        let scale = -DOUBLE.half_of_least / 2;
        let absolute = T::Bound::of(1.0).shifted(DOUBLE.half_of_least + scale);
        let places = T::Bound::of(1.0).shifted(Self::PLACES);
        let is_small = rounded.high().abs() < Self::LEAST && error.shifted(scale) <= absolute;
        let is_large = number.size_down() >= T::Bound::of(f64::MAX) || rounded.high().is_finite();
        if is_small || is_large && error <= number.size_down().minus_down(error).times_down(places) {
            return Outcome::Known(rounded);
        }
        Outcome::Open
    }
}

/// Returns the nearest `f64` and the `f64` nearest to the remainder.
fn in_two_words<T: Guardable>(value: T) -> DoubleDouble {
    let high = value.to_f64();
    if !high.is_finite() {
        return DoubleDouble::from_f64(high);
    }
    DoubleDouble::new(high, (value - T::from_f64(high)).to_f64())
}
