//! ζ(2), ζ(4), …: the coefficients of the series of the dilogarithm and of Clausen's function.
//!
//! ζ(2) = π²/6 and (n + ½) ζ(2n) = Σ ζ(2j) ζ(2n − 2j) over 0 < j < n, a sum of positive terms.
//!
//! Source: NIST Digital Library of Mathematical Functions, 25.6.1 and 24.14.2 with Bernoulli's numbers as values of ζ.

use alloc::vec;

use crate::scalar::Scalar;
use crate::table::table;

struct ZetaOfEven;

/// Returns ζ(2k + 2) at index k, with the number of entries that a series in (1/3)^(2k) needs for
/// the type's precision.
pub(crate) fn zeta_of_even<T: Scalar>() -> &'static [T] {
    table::<ZetaOfEven, T>(0, || {
        let mut values = vec![T::pi() * T::pi() / T::from_f64(6.0)];
        for n in 2..=(T::PRECISION / 3 + 4) as usize {
            let sum = (1..n).fold(T::from_f64(0.0), |sum, j| sum + values[j - 1] * values[n - j - 1]);
            values.push(sum / T::from_f64(n as f64 + 0.5));
        }
        values
    })
}
