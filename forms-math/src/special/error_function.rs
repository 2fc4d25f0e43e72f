//! erf x = 2/√π e^(−x²) Σ 2ⁿ x^(2n+1)/(2n+1)!!, a sum of positive terms.
//!
//! Source: NIST Digital Library of Mathematical Functions, 7.6.2.

use crate::scalar::Scalar;

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
