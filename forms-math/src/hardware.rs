//! `f32` and `f64` as numbers of a kernel.
//!
//! The elementary functions of `f64` are those of [`float`]; `f32` computes in `f64`
//! wherever an intermediate rounding to `f32` would reduce accuracy.

use crate::composed::{Widen, special_functions};
use crate::error_free;
use crate::float;
use crate::quadrature::{Kind, double_exponential};
use crate::scalar::{Scalar, choices};
use crate::special::{complementary_error_function_of_double, error_function_of_double};
use crate::wide::quadrant_of_words;
use crate::{DoubleDouble, Real};

/// Functions that a hardware type takes unchanged from [`float`].
macro_rules! standard_functions {
    ($type:ident: $($name:ident),*) => { $(
        #[inline(always)]
        fn $name(self) -> Self {
            float::$type::$name(self)
        }
    )* };
}

impl Widen<DoubleDouble> for f64 {
    fn widened(self) -> DoubleDouble {
        DoubleDouble::from_f64(self)
    }
    fn narrowed(wider: DoubleDouble) -> Self {
        wider.to_f64()
    }
}

impl Widen<f64> for f32 {
    fn widened(self) -> f64 {
        f64::from(self)
    }
    fn narrowed(wider: f64) -> Self {
        wider as f32
    }
}

impl Real for f64 {
    #[inline(always)]
    fn constant(words: &[f64]) -> Self {
        words.first().copied().unwrap_or(0.0)
    }
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        self
    }
    #[inline(always)]
    fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self {
        error_free::difference_of_products(a, b, c, d)
    }
    #[inline(always)]
    fn power(self, numerator: i64, denominator: i64) -> Self {
        power(self, numerator, denominator)
    }
    choices!();
    standard_functions!(f64: sqrt, abs, sin, cos, tan, asin, acos, atan, exp, exp_m1, ln, ln_1p, sinh, cosh, tanh);
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        float::f64::atan2(self, x)
    }
    #[inline]
    fn erf(self) -> Self {
        error_function_of_double(self)
    }
    #[inline]
    fn erfc(self) -> Self {
        complementary_error_function_of_double(self)
    }
    #[inline]
    fn hypot(self, y: Self) -> Self {
        hypotenuse_of_doubles(self, y)
    }
    #[inline(always)]
    fn cbrt(self) -> Self {
        float::f64::cbrt(self)
    }
    special_functions!(DoubleDouble, 60);
    fn quadrature(from: Self, to: Self, integrand: impl Fn(Self) -> Self) -> Self {
        let kind = Kind { of: |node| node, number: |value: f64| value, bits: Self::PRECISION };
        double_exponential(from, to, integrand, &kind).0
    }
}

/// Computes x^(n/d). No library has a function with a quotient as exponent:
/// n/d = p + r with p rounded, and x^p x^r = x^p (1 + r ln x) with an error far below an ulp.
#[inline(always)]
fn power(x: f64, numerator: i64, denominator: i64) -> f64 {
    match (numerator, denominator) {
        (0, _) => 1.0,
        (1, 1) => x,
        (2, 1) => x * x,
        (-1, 1) => 1.0 / x,
        (1, 2) => float::f64::sqrt(x),
        (-1, 2) => 1.0 / float::f64::sqrt(x),
        (1, 3) if x >= 0.0 => float::f64::cbrt(x),
        (_, 0) => f64::NAN,
        (n, d) => {
            let exponent = n as f64 / d as f64;
            let (product, rest) = error_free::two_product(exponent, d as f64);
            let left = ((n as f64 - product) - rest) / d as f64;
            let value = float::f64::powf(x, exponent);
            if left == 0.0 || value == 0.0 || !value.is_finite() {
                value
            } else {
                value + value * (left * float::f64::ln(x))
            }
        }
    }
}

/// √(x² + y²): both numbers are multiplied by a power of two where a square would leave the range.
/// If one of them is NaN, so is the result. Half of the rounding errors of the squares and of their
/// sum, and that of the root: at most 1.01 ulp.
#[inline]
fn hypotenuse_of_doubles(x: f64, y: f64) -> f64 {
    const LARGEST: f64 = f64::from_bits((1023 + 1000) << 52);
    const LEAST: f64 = f64::from_bits((1023 - 800) << 52);
    let sum = x * x + y * y;
    if sum > LEAST && sum < LARGEST { float::f64::sqrt(sum) } else { scaled_hypotenuse(x, y) }
}

#[cold]
fn scaled_hypotenuse(x: f64, y: f64) -> f64 {
    const DOWN: f64 = f64::from_bits((1023 - 600) << 52);
    const UP: f64 = f64::from_bits((1023 + 600) << 52);
    if x.is_nan() || y.is_nan() || x.is_infinite() || y.is_infinite() {
        return x.abs() + y.abs();
    }
    let (scale, back) = if x.abs() > 1.0 || y.abs() > 1.0 { (DOWN, UP) } else { (UP, DOWN) };
    let (x, y) = (x * scale, y * scale);
    float::f64::sqrt(x * x + y * y) * back
}

impl Scalar for f64 {
    const PRECISION: u32 = 53;
    type Wider = DoubleDouble;
    fn rounded(wider: DoubleDouble) -> Self {
        wider.to_f64()
    }

    fn pi() -> Self {
        core::f64::consts::PI
    }
    fn ln_2() -> Self {
        core::f64::consts::LN_2
    }
    fn from_integer(value: i64) -> Self {
        value as f64
    }
    fn exponent(self) -> Option<i64> {
        (self.is_finite() && self != 0.0).then(|| error_free::mantissa_and_exponent(self).1)
    }
    fn sine_and_cosine(self) -> (Self, Self) {
        float::f64::sin_cos(self)
    }
    fn euler_gamma() -> Self {
        0.577_215_664_901_532_9
    }
    fn scaled(self, exponent: i64) -> Self {
        error_free::scaled(self, exponent)
    }
    fn quadrant(self) -> (u8, Self) {
        // π/2 in three words, the first two of 33 bits: exact products for quotients below 2²⁰.
        const QUARTER_TURN: [f64; 3] =
            [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_795_950_6e-21];
        let quotient = float::f64::round(self / core::f64::consts::FRAC_PI_2);
        if quotient.abs() >= 1_048_576.0 {
            let (quadrant, rest) = quadrant_of_words(self, 0.0);
            return (quadrant, rest.to_f64());
        }
        let rest =
            ((self - quotient * QUARTER_TURN[0]) - quotient * QUARTER_TURN[1]) - quotient * QUARTER_TURN[2];
        (float::f64::rem_euclid(quotient, 4.0) as u8, rest)
    }
}

/// Functions of one `f32`, computed in `f64` and rounded once.
macro_rules! by_f64 {
    ($($name:ident),*) => { $(
        #[inline(always)]
        fn $name(self) -> Self {
            Real::$name(f64::from(self)) as f32
        }
    )* };
}

impl Real for f32 {
    #[inline(always)]
    fn constant(words: &[f64]) -> Self {
        f64::constant(words) as f32
    }
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        value as f32
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        f64::from(self)
    }
    #[inline(always)]
    fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self {
        // Both products are exact in f64.
        (f64::from(a) * f64::from(b) - f64::from(c) * f64::from(d)) as f32
    }
    #[inline(always)]
    fn power(self, numerator: i64, denominator: i64) -> Self {
        power(f64::from(self), numerator, denominator) as f32
    }
    choices!();
    standard_functions!(f32: sqrt, abs, sin, cos, tan, asin, acos, atan, exp, exp_m1, ln, ln_1p);
    by_f64!(sinh, cosh, tanh, erf, erfc, cbrt);
    /// Computes in `f64`, where the squares are exact.
    #[inline(always)]
    fn hypot(self, y: Self) -> Self {
        let [x, y] = [self, y].map(f64::from);
        float::f64::sqrt(x * x + y * y) as f32
    }
    special_functions!(f64, 32);
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        float::f32::atan2(self, x)
    }
    /// Evaluates the integrand in `f32`, so that it is the kernel's integrand in this precision.
    fn quadrature(from: Self, to: Self, integrand: impl Fn(Self) -> Self) -> Self {
        let integrand = |place: f64| f64::from(integrand(place as f32));
        let kind = Kind { of: |node| node, number: |value: f64| value, bits: f32::MANTISSA_DIGITS };
        double_exponential(f64::from(from), f64::from(to), integrand, &kind).0 as f32
    }
}
