//! Logarithms with small relative errors, also near 1.

use super::odd_series;
use crate::float;
use crate::scalar::Scalar;

/// Computes ln x = e ln 2 + ln(1 + (m − 1)) for x = m 2ᵉ with √½ ≤ m < √2.
pub(crate) fn logarithm<T: Scalar>(x: T) -> T {
    let zero = T::from_f64(0.0);
    if x == zero {
        return T::from_f64(f64::NEG_INFINITY);
    }
    let Some(exponent) = x.exponent() else {
        return if x > zero { x } else { T::nan() };
    };
    if x < zero {
        return T::nan();
    }
    let mantissa = x.scaled(-exponent);
    let (mantissa, exponent) = if mantissa.to_f64() < core::f64::consts::FRAC_1_SQRT_2 {
        (mantissa.scaled(1), exponent - 1)
    } else {
        (mantissa, exponent)
    };
    let near_one = near_one(mantissa - T::from_f64(1.0));
    if exponent == 0 { near_one } else { T::from_integer(exponent) * T::ln_2() + near_one }
}

/// ln(1 + x)
pub(crate) fn logarithm_of_one_plus<T: Scalar>(x: T) -> T {
    if x.to_f64().abs() <= 0.4 { near_one(x) } else { logarithm(T::from_f64(1.0) + x) }
}

/// Computes ln(1 + x) for |x| ≤ ½ as a + ln(1 + d): a is the value in `f64`,
/// d = (x − m)/(1 + m), m = e^a − 1, and ln(1 + d) = 2 artanh(d/(2 + d)).
fn near_one<T: Scalar>(x: T) -> T {
    let start = T::from_f64(float::f64::ln_1p(x.to_f64()));
    let reached = start.exp_m1();
    let left = (x - reached) / (T::from_f64(1.0) + reached);
    start + odd_series(left / (T::from_f64(2.0) + left), 1.0).scaled(1)
}
