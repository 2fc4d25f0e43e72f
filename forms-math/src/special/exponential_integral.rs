//! Eₙ(x) = ∫₁^∞ e^(−xt)/tⁿ dt: a series about 0, a continued fraction beyond.
//!
//! E₁(x) = −γ − ln x − Σ (−x)ᵏ/(k k!), and n Eₙ₊₁(x) = e^(−x) − x Eₙ(x);
//! Eₙ(x) = e^(−x) / (x + n − 1·n/(x + n + 2 − 2(n+1)/(x + n + 4 − …))).
//!
//! Source: NIST Digital Library of Mathematical Functions, 6.6.2, 8.19.12, 8.19.17 (its even part).

use crate::float;
use crate::scalar::Scalar;

/// Eₙ(x), n from 1 to 3
pub(crate) fn exponential_integral<T: Scalar>(order: u32, x: T, bits: u32) -> T {
    let size = x.to_f64();
    if size.is_nan() || x < T::from_f64(0.0) {
        return T::nan();
    }
    if x == T::from_f64(0.0) {
        return match order {
            1 => T::from_f64(f64::INFINITY),
            _ => T::from_f64(1.0) / T::from_f64(f64::from(order - 1)),
        };
    }
    // The terms of the series reach eˣ where the value is about e^(−x), so 2 x/ln 2 bits cancel.
    let spare = f64::from(T::PRECISION.saturating_sub(bits + 8));
    let border = (spare * core::f64::consts::LN_2 / 2.0 - 2.0).max(1.0);
    if size <= border { by_series(order, x, bits + (2.9 * size) as u32) } else { by_fraction(order, x, bits) }
}

fn by_series<T: Scalar>(order: u32, x: T, bits: u32) -> T {
    let negligible = T::from_f64(1.0).scaled(-i64::from(bits) - 2);
    let (mut power, mut sum, mut count) = (T::from_f64(-1.0), T::from_f64(0.0), 0.0);
    loop {
        count += 1.0;
        power = -(power * x) / T::from_f64(count);
        let term = power / T::from_f64(count);
        sum = sum + term;
        if term.abs() <= sum.abs() * negligible || term == T::from_f64(0.0) {
            break;
        }
    }
    let mut value = sum - (T::euler_gamma() + x.ln());
    if order == 1 {
        return value;
    }
    let decay = (-x).exp();
    for lower in 1..order {
        value = (decay - x * value) / T::from_f64(f64::from(lower));
    }
    value
}

fn by_fraction<T: Scalar>(order: u32, x: T, bits: u32) -> T {
    let decay = (-x).exp();
    if decay == T::from_f64(0.0) {
        return decay;
    }
    decay / continued_fraction(f64::from(order), x, bits)
}

/// Evaluates e^(−x)/Eₙ(x) = x + n − 1·n/(x + n + 2 − …) from its end, for any n > 0, with the number
/// of steps that leaves a negligible remainder.
pub(super) fn continued_fraction<T: Scalar>(n: f64, x: T, bits: u32) -> T {
    let partial = |count: f64| x + T::from_f64(n + 2.0 * count);
    let mut count = steps(x.to_f64(), bits);
    let mut value = partial(count);
    while count >= 1.0 {
        let numerator = T::from_f64(count * (n - 1.0 + count));
        count -= 1.0;
        value = partial(count) - numerator / value;
    }
    value
}

/// Returns the number of steps. Step k multiplies the error by (b − s)/(b + s), with b = x + 2k and
/// s = √(b² − 4k²): the ratio of the two solutions of the recurrence of the denominators.
fn steps(x: f64, bits: u32) -> f64 {
    let (mut left, mut count) = (f64::from(bits + 8) * core::f64::consts::LN_2, 0.0);
    while left > 0.0 {
        count += 1.0;
        let part = x + 2.0 * count;
        let root = float::f64::sqrt(x * (x + 4.0 * count));
        left -= float::f64::ln((part + root) / (part - root));
    }
    count
}
