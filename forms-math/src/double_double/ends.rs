//! Products, quotients and roots near the ends of the range of exponents, where the words of a
//! product would underflow or overflow: they are computed with factors of about one and scaled back
//! by a power of two.

use super::DoubleDouble;
use crate::Real;
use crate::float;

/// 2⁻⁹⁰⁰: above it no word of an exact product of two `f64`s underflows.
const LEAST: f64 = f64::from_bits((1023 - 900) << 52);
/// 2⁹⁹⁰: below it no intermediate result of such a product overflows.
const MOST: f64 = f64::from_bits((1023 + 990) << 52);

/// Whether a value is near an end of the range; also true for zero, infinities and NaN.
#[inline(always)]
pub(super) const fn is_near_an_end(value: f64) -> bool {
    !(value.abs() >= LEAST && value.abs() <= MOST)
}

/// Returns 2ᵉ, if it is a normal number.
const fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}

const fn is_ordinary(value: f64) -> bool {
    value.is_finite() && value != 0.0
}

impl DoubleDouble {
    /// Returns m and e such that the number is m 2ᵉ with 1 ≤ |m| < 2, for a finite non-zero number.
    pub(super) const fn mantissa_and_exponent(self) -> (Self, i64) {
        let biased = ((self.high.to_bits() >> 52) & 0x7ff) as i64;
        if biased == 0 {
            let (mantissa, exponent) = self.by_power_of_two(power_of_two(64)).mantissa_and_exponent();
            return (mantissa, exponent - 64);
        }
        (self.times_two_to(1023 - biased), biased - 1023)
    }

    /// Multiplies by 2ᵉ, |e| ≤ 3000; exact if both words stay normal.
    pub(super) const fn times_two_to(self, exponent: i64) -> Self {
        let third = exponent / 3;
        self.by_power_of_two(power_of_two(third))
            .by_power_of_two(power_of_two(third))
            .by_power_of_two(power_of_two(exponent - 2 * third))
    }

    #[cold]
    pub(super) const fn times_near_an_end(self, other: Self) -> Self {
        if !is_ordinary(self.high) || !is_ordinary(other.high) {
            return Self { high: self.high * other.high, low: 0.0 };
        }
        let ((a, i), (b, j)) = (self.mantissa_and_exponent(), other.mantissa_and_exponent());
        a.times(b).times_two_to(i + j)
    }

    #[cold]
    pub(super) const fn over_near_an_end(self, other: Self) -> Self {
        if !is_ordinary(self.high) || !is_ordinary(other.high) {
            return Self { high: self.high / other.high, low: 0.0 };
        }
        let ((a, i), (b, j)) = (self.mantissa_and_exponent(), other.mantissa_and_exponent());
        a.over(b).times_two_to(i - j)
    }

    #[cold]
    pub(super) fn root_near_an_end(self) -> Self {
        if !is_ordinary(self.high) || self.high < 0.0 {
            return Self { high: float::f64::sqrt(self.high), low: 0.0 };
        }
        let (mantissa, exponent) = self.mantissa_and_exponent();
        let odd = exponent & 1;
        mantissa.times_two_to(odd).square_root().times_two_to((exponent - odd) / 2)
    }

    /// Computes a b − c d with all factors scaled to about one; `None` if a factor is zero or not
    /// finite, or if one product is negligible compared with the other.
    #[cold]
    pub(super) fn difference_near_an_end([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Option<Self> {
        if ![a, b, c, d].iter().all(|factor| is_ordinary(factor.high)) {
            return None;
        }
        let [(a, i), (b, j), (c, k), (d, l)] = [a, b, c, d].map(Self::mantissa_and_exponent);
        let (first, second) = (i + j, k + l);
        let common = first.max(second);
        if (first - second).abs() > 300 {
            return None;
        }
        let (a, c) = (a.times_two_to(first - common), c.times_two_to(second - common));
        Some(Self::difference_of_products(a, b, c, d).times_two_to(common))
    }
}
