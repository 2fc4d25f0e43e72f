//! Elementary functions of any precision, from a few functions of the type:
//! +, −, ×, ÷, √, e^x, e^x − 1, sin and cos.
//!
//! The inverse functions take their first 50 bits from `f64` and all others from one evaluation of
//! the function and a short series for the remainder.

mod angle;
mod hyperbolic;
mod logarithm;
mod power;

pub(crate) use angle::{angle, arc_cosine, arc_sine, arc_tangent};
pub(crate) use hyperbolic::{hyperbolic_cosine, hyperbolic_sine, hyperbolic_tangent};
pub(crate) use logarithm::{logarithm, logarithm_of_one_plus};
pub(crate) use power::{LARGEST_BY_SQUARING, rational_power};

use crate::scalar::Scalar;

/// √(x² + y²) from numbers below 1: no square overflows, and the square of a number that matters
/// does not underflow.
pub(crate) fn hypotenuse<T: Scalar>(x: T, y: T) -> T {
    let exponent = x.exponent().into_iter().chain(y.exponent()).max().unwrap_or(0);
    let (x, y) = (x.scaled(-exponent), y.scaled(-exponent));
    (x * x + y * y).sqrt().scaled(exponent)
}

/// Evaluates s + c s³/3 + c² s⁵/5 + …: artanh s with c = 1, arctan s with c = −1, for |s| < 2⁻⁴⁹.
fn odd_series<T: Scalar>(s: T, sign: f64) -> T {
    let square = s * s * T::from_f64(sign);
    // The first omitted term is below 2^(−98 (terms + 1)) of the sum.
    let terms = (T::PRECISION + 8).div_ceil(98) - 1;
    let mut sum = T::from_f64(0.0);
    for term in (1..=terms).rev() {
        sum = (sum + T::from_f64(1.0) / T::from_f64(f64::from(2 * term + 1))) * square;
    }
    s + s * sum
}
