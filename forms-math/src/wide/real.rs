//! Wide floating point as a number of a kernel.

use alloc::vec;

use super::{Class, Wide};
use crate::composed::composed_functions;
use crate::scalar::Scalar;
use crate::table::table;
use crate::{Number, Real};

impl<const LIMBS: usize> Real for Wide<LIMBS> {
    fn constant(words: &[f64]) -> Self {
        words.iter().rev().fold(Self::ZERO, |sum, &word| sum + Self::of_f64(word))
    }
    fn number(number: Number<'_>) -> Self {
        let quotient = Self::from_words(number.numerator()) / Self::from_words(number.denominator());
        let value = match i64::from(number.pi_exponent()) {
            0 => quotient,
            exponent => quotient * Self::pi().power(exponent, 1),
        };
        if number.is_negative() { -value } else { value }
    }
    fn from_f64(value: f64) -> Self {
        Self::of_f64(value)
    }
    fn to_f64(self) -> f64 {
        self.nearest_f64()
    }
    fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self {
        a * b - c * d
    }
    fn sqrt(self) -> Self {
        self.square_root()
    }
    fn abs(self) -> Self {
        Self { negative: false, ..self }
    }
    fn exp(self) -> Self {
        self.exponential()
    }
    fn exp_m1(self) -> Self {
        self.exponential_minus_one()
    }
    fn erf(self) -> Self {
        crate::special::error_function(self, Self::PRECISION)
    }
    fn erfc(self) -> Self {
        crate::special::complementary_error_function(self, Self::PRECISION)
    }
    composed_functions!();
}

struct EulerGamma;

impl<const LIMBS: usize> Scalar for Wide<LIMBS> {
    const PRECISION: u32 = 64 * LIMBS as u32 - 8;
    type Wider = Self;
    fn rounded(wider: Self) -> Self {
        wider
    }

    fn pi() -> Self {
        Self::constants()[0]
    }
    fn ln_2() -> Self {
        Self::constants()[1]
    }
    fn euler_gamma() -> Self {
        table::<EulerGamma, Self>(0, || vec![Self::compute_euler_gamma()])[0]
    }
    fn from_integer(value: i64) -> Self {
        Self::from_natural(value < 0, &[value.unsigned_abs()], 0)
    }
    fn exponent(self) -> Option<i64> {
        (self.class == Class::Finite).then_some(self.exponent)
    }
    fn scaled(self, exponent: i64) -> Self {
        self.by_power_of_two(exponent)
    }
    fn quadrant(self) -> (u8, Self) {
        self.to_quadrant()
    }
    fn sine_and_cosine(self) -> (Self, Self) {
        self.sine_cosine()
    }
}
