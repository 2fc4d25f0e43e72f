//! eˣ and eˣ − 1.

use super::DoubleDouble;
use crate::error_free::{scaled, two_sum};
use crate::float;

/// 1/n! for n from 0.
const RECIPROCAL_FACTORIALS: [DoubleDouble; 30] = {
    let mut values = [DoubleDouble::ONE; 30];
    let mut n = 1;
    while n < 30 {
        values[n] = values[n - 1].over(DoubleDouble::new(n as f64, 0.0));
        n += 1;
    }
    values
};

/// 2⁻¹⁶⁰: below this, e^x − 1 equals x to the last bit.
const SMALL: f64 = f64::from_bits((1023 - 160) << 52);

/// Returns 1/n!.
pub(super) const fn reciprocal_factorial(n: usize) -> DoubleDouble {
    RECIPROCAL_FACTORIALS[n]
}

impl DoubleDouble {
    /// Returns (k, eˣ 2⁻ᵏ − 1) with k = round(x/ln 2), for |x| < 1100.
    ///
    /// x = k ln 2 + 16 s, with Taylor's series for e^s − 1; then four times e^(2s) − 1 = p (2 + p)
    /// with p = e^s − 1.
    fn reduced_exponential(self) -> (f64, Self) {
        // ln 2 as words of 40 bits, whose products with k are exact, and a remainder.
        const WORDS: [f64; 3] =
            [0.693_147_180_559_208_2, 7.371_002_565_161_996e-13, 5.802_988_983_595_690_5e-25];
        let count = float::f64::round(self.high / core::f64::consts::LN_2);
        let (first, rest) = two_sum(self.high, -count * WORDS[0]);
        let reduced =
            Self::new(first, rest).plus(Self::new(-count * WORDS[1], self.low)).plus_f64(-count * WORDS[2]);
        let step = reduced.by_power_of_two(0.0625);
        // |s| < 0.022: the terms from the eighth are below 2⁻⁵⁵ of the first.
        let tail = (8..15).rev().fold(0.0, |sum, n| sum * step.high + reciprocal_factorial(n).high);
        let mut sum = Self::new(tail, 0.0);
        for n in (2..8).rev() {
            sum = sum.times(step).plus(reciprocal_factorial(n));
        }
        let mut value = step.plus(step.times(step).times(sum));
        for _ in 0..4 {
            value = value.by_power_of_two(2.0).plus(value.times(value));
        }
        (count, value)
    }

    /// Computes eˣ, within 32 units.
    pub(super) fn exponential(self) -> Self {
        if self.high.is_nan() || self.high > 710.0 {
            return Self { high: float::f64::exp(self.high), low: 0.0 };
        }
        if self.high < -760.0 {
            return Self::ZERO;
        }
        let (count, value) = self.reduced_exponential();
        let value = Self::ONE.plus(value);
        value.by_exponent(count as i64)
    }

    /// Computes eˣ − 1, within 32 units.
    pub(super) fn exponential_minus_one(self) -> Self {
        if self.high == 0.0 || self.high.is_nan() || self.high > 710.0 {
            return Self { high: float::f64::exp_m1(self.high), low: 0.0 };
        }
        if self.high.abs() < SMALL {
            return self;
        }
        if self.high < -80.0 {
            return Self::ONE.negated();
        }
        let (count, value) = self.reduced_exponential();
        if count == 0.0 {
            return value;
        }
        if count > 200.0 {
            return Self::ONE.plus(value).by_exponent(count as i64);
        }
        let power = scaled(1.0, count as i64);
        value.by_power_of_two(power).plus(Self::new(power, -1.0))
    }

    /// Multiplies by 2ᵉ.
    pub(super) fn by_exponent(self, exponent: i64) -> Self {
        let high = scaled(self.high, exponent);
        if high.is_finite() {
            Self { high, low: scaled(self.low, exponent) }
        } else {
            Self { high, low: 0.0 }
        }
    }
}
