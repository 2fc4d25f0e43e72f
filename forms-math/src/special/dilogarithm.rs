//! Li₂(x) from its series in u = −ln(1 − x), on −1 ≤ x ≤ ½.
//!
//! Li₂(x) = u − u²/4 − 2u Σ ζ(2k)/(2k + 1) (−(u/2π)²)ᵏ, |u| < 2π, which is Debye's function with
//! Bernoulli's numbers written as values of ζ. Elsewhere
//! Li₂(x) = π²/6 − ln x ln(1 − x) − Li₂(1 − x) and
//! Li₂(x) = −π²/6 − ½ ln²(−x) − Li₂(1/x).
//!
//! Source: L. Lewin, Polylogarithms and associated functions (1981), §1; NIST Digital Library
//! 25.12.

use super::zeta::zeta_of_even;
use crate::scalar::Scalar;

/// Li₂(x), for x ≤ 1
pub(crate) fn dilogarithm<T: Scalar>(x: T, bits: u32) -> T {
    let (zero, one) = (T::from_f64(0.0), T::from_f64(1.0));
    let basel = || zeta_of_even::<T>()[0];
    if x > one || x.to_f64().is_nan() {
        T::nan()
    } else if x == zero {
        x
    } else if x == one {
        basel()
    } else if x > T::from_f64(0.5) {
        let complement = one - x;
        basel() - x.ln() * complement.ln() - by_series(complement, bits)
    } else if x >= -one {
        by_series(x, bits)
    } else {
        let logarithm = (-x).ln();
        -(basel() + (logarithm * logarithm).scaled(-1)) - by_series(one / x, bits)
    }
}

fn by_series<T: Scalar>(x: T, bits: u32) -> T {
    let one = T::from_f64(1.0);
    let u = -(-x).ln_1p();
    let turn = T::pi().scaled(1);
    let ratio = u / turn;
    let step = -(ratio * ratio);
    let negligible = one.scaled(-i64::from(bits) - 4);
    let (mut power, mut sum) = (one, T::from_f64(0.0));
    let mut odd = 1.0;
    for &zeta in zeta_of_even::<T>() {
        odd += 2.0;
        power = power * step;
        sum = sum + power * zeta / T::from_f64(odd);
        if power.abs() < negligible {
            break;
        }
    }
    u * (one - u.scaled(-2) - sum.scaled(1))
}
