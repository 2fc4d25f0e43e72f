//! Double-double as a number of a kernel.

use super::DoubleDouble;
use super::ends::is_near_an_end;
use crate::composed::composed_functions;
use crate::error_free::{mantissa_and_exponent, two_product};
use crate::scalar::Scalar;
use crate::{Real, Wide};

impl Real for DoubleDouble {
    fn constant(words: &[f64]) -> Self {
        words.iter().take(3).rev().fold(Self::ZERO, |sum, &word| sum.plus_f64(word))
    }
    fn from_f64(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }
    fn to_f64(self) -> f64 {
        self.high
    }
    /// Uses exact products of the words: the error is within 8 units of the larger of the value and
    /// 2⁻¹⁰⁰ times the products.
    fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self {
        let partial = |a: Self, b: Self| {
            let (product, rest) = two_product(a.high, b.high);
            let (first, first_rest) = two_product(a.high, b.low);
            let (second, second_rest) = two_product(a.low, b.high);
            [product, rest, first, second, first_rest + second_rest + a.low * b.low]
        };
        let direct = a * b - c * d;
        let (first, second) = (a.high * b.high, c.high * d.high);
        if is_near_an_end(first) || is_near_an_end(second) {
            return Self::difference_near_an_end([a, b], [c, d]).unwrap_or(direct);
        }
        if !direct.high.is_finite() || direct.high.abs() > 0.125 * first.abs().max(second.abs()) {
            return direct;
        }
        let (first, second) = (partial(a, b), partial(c, d));
        first
            .into_iter()
            .zip(second)
            .map(|(first, second)| Self::new(first, -second))
            .rev()
            .fold(Self::ZERO, Self::plus)
    }
    fn sqrt(self) -> Self {
        self.square_root()
    }
    fn abs(self) -> Self {
        if self.high < 0.0 { self.negated() } else { self }
    }
    fn exp(self) -> Self {
        self.exponential()
    }
    fn exp_m1(self) -> Self {
        self.exponential_minus_one()
    }
    fn erf(self) -> Self {
        self.error_function()
    }
    fn erfc(self) -> Self {
        self.complementary_error_function()
    }
    composed_functions!();
}

impl Scalar for DoubleDouble {
    const PRECISION: u32 = 106;
    type Wider = Self;
    fn rounded(wider: Self) -> Self {
        wider
    }

    fn pi() -> Self {
        Self { high: core::f64::consts::PI, low: 1.224_646_799_147_353_2e-16 }
    }
    fn ln_2() -> Self {
        Self { high: core::f64::consts::LN_2, low: 2.319_046_813_846_299_6e-17 }
    }
    fn euler_gamma() -> Self {
        Self { high: 0.577_215_664_901_532_9, low: -4.942_915_152_430_645e-18 }
    }
    fn from_integer(value: i64) -> Self {
        // Two halves, each exact.
        Self::new((value >> 32) as f64 * 4_294_967_296.0, (value & 0xffff_ffff) as f64)
    }
    fn exponent(self) -> Option<i64> {
        (self.high.is_finite() && self.high != 0.0).then(|| mantissa_and_exponent(self.high).1)
    }
    fn scaled(self, exponent: i64) -> Self {
        self.by_exponent(exponent)
    }
    fn quadrant(self) -> (u8, Self) {
        self.to_quadrant()
    }
    fn sine_and_cosine(self) -> (Self, Self) {
        self.sine_cosine()
    }
}

impl core::fmt::Display for DoubleDouble {
    /// Writes 36 digits.
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        // 2176 bits hold every sum of two f64.
        let sum = Wide::<34>::from_f64(self.high) + Wide::<34>::from_f64(self.low);
        sum.fmt(formatter)
    }
}
