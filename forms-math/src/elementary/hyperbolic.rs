//! Hyperbolic functions from m = e^|x| − 1, which preserves their relative accuracy near zero.

use crate::scalar::Scalar;

/// Whether e^(−2|x|) is too small to change 1 + e^(−2|x|).
fn dominant<T: Scalar>(x: T) -> bool {
    x.to_f64().abs() > f64::from(T::PRECISION)
}

/// sinh x = (m + m/(m + 1))/2, with the sign of x
pub(crate) fn hyperbolic_sine<T: Scalar>(x: T) -> T {
    let size = x.abs();
    let value = if dominant(x) {
        half_exponential(size)
    } else {
        let grown = size.exp_m1();
        (grown + grown / (grown + T::from_f64(1.0))).scaled(-1)
    };
    if x < T::from_f64(0.0) { -value } else { value }
}

/// cosh x = (e^|x| + e^(−|x|))/2
pub(crate) fn hyperbolic_cosine<T: Scalar>(x: T) -> T {
    let size = x.abs();
    if dominant(x) {
        return half_exponential(size);
    }
    let grown = size.exp();
    (grown + T::from_f64(1.0) / grown).scaled(-1)
}

/// tanh x = m/(m + 2) with m = e^(2|x|) − 1, with the sign of x
pub(crate) fn hyperbolic_tangent<T: Scalar>(x: T) -> T {
    let value = if dominant(x) {
        T::from_f64(1.0)
    } else {
        let grown = x.abs().scaled(1).exp_m1();
        grown / (grown + T::from_f64(2.0))
    };
    if x < T::from_f64(0.0) { -value } else { value }
}

/// Computes eˣ/2, even if eˣ is out of range: (e^(x/2)/2) e^(x/2).
fn half_exponential<T: Scalar>(x: T) -> T {
    let root = x.scaled(-1).exp();
    root.scaled(-1) * root
}
