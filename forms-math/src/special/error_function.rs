//! erf x = 2/√π e^(−x²) Σ 2ⁿ x^(2n+1)/(2n+1)!!, a sum of positive terms; in `f64` polynomials take
//! its place. erfc x = 1 − erf x where little cancels, and beyond
//! e^(−x²) x/√π / (x² + ½ − ½/(x² + 5/2 − 3/(x² + 9/2 − …))), with the terms k (k − ½).
//!
//! Source: NIST Digital Library of Mathematical Functions, 7.6.2, 8.9.2 (its even part, for Γ(½, x²)).

mod coefficients;

use super::exponential_integral::continued_fraction;
use crate::error_free::two_product;
use crate::float;
use crate::scalar::Scalar;
pub(crate) use coefficients::{ERF, ERF_IS_ONE, ERFC, ERFC_IS_ZERO, LN_ERFC, TWO_OVER_ROOT_PI};

/// Numbers below this are so small that x³ does not count, and that the rounding error of a product
/// can underflow.
const SMALL: f64 = 1e-150;

/// erf x: a polynomial of x up to 1, and 1 − e^(ln erfc x) with a polynomial of x − 1 beyond. The
/// same as in lanes.
pub(crate) fn error_function_of_double(x: f64) -> f64 {
    let size = x.abs();
    if size < SMALL {
        return x * TWO_OVER_ROOT_PI[0];
    }
    if size < 1.0 {
        let square = size * size;
        let [slope, rest] = TWO_OVER_ROOT_PI;
        let (linear, error) = two_product(size, slope);
        let series = size * square * polynomial(&ERF, square) + size * rest;
        return (linear + (error + series)).copysign(x);
    }
    // NaN stays NaN
    let beyond = if size > ERF_IS_ONE { ERF_IS_ONE } else { size } - 1.0;
    (1.0 - float::f64::exp(polynomial(&LN_ERFC, beyond))).copysign(x)
}

/// erfc x: 1 − erf x where little cancels, and beyond e^(−x²) p/(|x| + 2) with a polynomial p of
/// (|x| − 2)/(|x| + 2), which is subtracted from 2 for negative x.
pub(crate) fn complementary_error_function_of_double(x: f64) -> f64 {
    let size = x.abs();
    if size <= LARGEST_DIFFERENCE {
        return 1.0 - error_function_of_double(x);
    }
    let (square, rest) = two_product(size, size);
    let decay = float::f64::exp(-square);
    let quotient = polynomial(&ERFC, (size - 2.0) / (size + 2.0)) / (size + 2.0);
    // NaN stays NaN
    let tail = if size > ERFC_IS_ZERO { 0.0 } else { (decay - decay * rest) * quotient };
    if x < 0.0 { 2.0 - tail } else { tail }
}

/// Evaluates c₀ + c₁ x + …: the even and the odd terms in parallel.
#[inline(always)]
fn polynomial(coefficients: &[f64], x: f64) -> f64 {
    let square = x * x;
    let (pairs, rest) = coefficients.as_chunks::<2>();
    let last = rest.first().copied().unwrap_or(0.0);
    let step = |[even, odd]: [f64; 2], &[a, b]: &[f64; 2]| [even * square + a, odd * square + b];
    let [even, odd] = pairs.iter().rev().fold([last, 0.0], step);
    odd * x + even
}

/// erf x
pub(crate) fn error_function<T: Scalar>(x: T, bits: u32) -> T {
    let one = T::from_f64(1.0);
    let size = x.to_f64().abs();
    if size.is_nan() {
        return T::nan();
    }
    // 1 − erf x < e^(−x²), which no longer changes 1.
    if size * size > f64::from(bits + 1) * core::f64::consts::LN_2 {
        return if x.to_f64() < 0.0 { -one } else { one };
    }
    let square = x * x;
    let step = square.scaled(1);
    let (mut term, mut sum) = (one, one);
    let mut odd = 1.0;
    let negligible = one.scaled(-i64::from(bits) - 2);
    // The terms grow until 2n + 1 > 2 x², and fall by at least half beyond twice that index.
    while term > sum * negligible {
        odd += 2.0;
        term = term * step / T::from_f64(odd);
        sum = sum + term;
    }
    x.scaled(1) * ((-square).exp() * sum / T::pi().sqrt())
}

/// erfc x = 1 − erf x, with a small relative error
pub(crate) fn complementary_error_function<T: Scalar>(x: T, bits: u32) -> T {
    let one = T::from_f64(1.0);
    let size = x.to_f64();
    if size.is_nan() {
        return T::nan();
    }
    if size <= 0.0 {
        return one - error_function(x, bits);
    }
    if size.is_infinite() {
        return T::from_f64(0.0);
    }
    // erfc x > e^(−x²)/(1 + 2x), so that at most this number of bits cancels in 1 − erf x
    let lost = size * size / core::f64::consts::LN_2 + float::f64::log2(1.0 + 2.0 * size);
    let spare = f64::from(T::PRECISION.saturating_sub(bits + 8));
    if size <= LARGEST_DIFFERENCE || lost <= spare {
        return one - error_function(x, bits + lost as u32 + 1);
    }
    by_fraction(x, bits)
}

/// Up to here erfc x is more than 0.47.
const LARGEST_DIFFERENCE: f64 = 0.5;

fn by_fraction<T: Scalar>(x: T, bits: u32) -> T {
    let decay = bell(x);
    if decay == T::from_f64(0.0) {
        return decay;
    }
    let square = x * x;
    decay * (x / (continued_fraction(0.5, square, bits) * T::pi().sqrt()))
}

/// Computes e^(−x²) = e^(−h²) e^(−(x − h)(x + h)), where h has so few digits that its square is
/// exact: the error of x² would be multiplied by x².
fn bell<T: Scalar>(x: T) -> T {
    let leading = T::from_f64(f64::from_bits(x.to_f64().to_bits() & (u64::MAX << 27)));
    let rest = (x - leading) * (x + leading);
    (-(leading * leading)).exp() * (-rest).exp()
}
