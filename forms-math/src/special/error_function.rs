//! erf x = 2/√π e^(−x²) Σ 2ⁿ x^(2n+1)/(2n+1)!!, a sum of positive terms; in `f64` polynomials take
//! its place.
//!
//! Source: NIST Digital Library of Mathematical Functions, 7.6.2.

mod coefficients;

use crate::error_free::two_product;
use crate::scalar::Scalar;
pub(crate) use coefficients::{ERF, ERF_IS_ONE, LN_ERFC, TWO_OVER_ROOT_PI};

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
    (1.0 - polynomial(&LN_ERFC, beyond).exp()).copysign(x)
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
    if size * size > f64::from(bits + 1) * std::f64::consts::LN_2 {
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
