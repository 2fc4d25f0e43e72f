//! x^(n/d): the root by Newton's iteration, starting from `f64`, and the power by squaring.

use crate::float;
use crate::scalar::Scalar;

/// Largest exponent for powers by squaring; larger ones use the logarithm.
pub(crate) const LARGEST_BY_SQUARING: u64 = 64;

/// Computes x^(n/d); for x < 0 only if d = ±1.
pub(crate) fn rational_power<T: Scalar>(x: T, numerator: i64, denominator: i64) -> T {
    let (zero, one) = (T::from_f64(0.0), T::from_f64(1.0));
    if denominator < 0 {
        return match (numerator.checked_neg(), denominator.checked_neg()) {
            (Some(numerator), Some(denominator)) => rational_power(x, numerator, denominator),
            _ => T::nan(),
        };
    }
    let size = numerator.unsigned_abs();
    if denominator == 0 || x.to_f64().is_nan() || (x < zero && denominator != 1) {
        T::nan()
    } else if numerator == 0 {
        one
    } else if x.exponent().is_none() {
        T::from_f64(float::f64::powf(x.to_f64(), numerator as f64 / denominator as f64))
    } else if size <= LARGEST_BY_SQUARING && denominator.unsigned_abs() <= LARGEST_BY_SQUARING {
        let power = by_squaring(root(x, denominator), size);
        if numerator < 0 { one / power } else { power }
    } else {
        let exponent = T::from_integer(numerator) / T::from_integer(denominator);
        let value = (exponent * x.abs().ln()).exp();
        if x < zero && numerator % 2 != 0 { -value } else { value }
    }
}

/// Refines a root r: with e = (x − rᵈ)/x,
/// x^(1/d) = r (1 − e)^(−1/d) ≈ r (1 + e/d + (d + 1)/(2d²) e²), which triples the number of digits.
fn root<T: Scalar>(x: T, degree: i64) -> T {
    match degree {
        1 => return x,
        2 => return x.sqrt(),
        _ => (),
    }
    let Some(exponent) = x.exponent() else { return T::nan() };
    let shift = exponent.div_euclid(degree);
    let x = x.scaled(-shift * degree);
    let mut root = T::from_f64(float::f64::powf(x.to_f64(), 1.0 / degree as f64));
    let divisor = T::from_integer(degree);
    let second = T::from_integer(degree + 1) / (divisor * divisor).scaled(1);
    let mut bits = 50;
    while bits < T::PRECISION + 8 {
        let left = (x - by_squaring(root, degree.unsigned_abs())) / x;
        root = root + root * (left / divisor + second * left * left);
        // d² 2^(−3 bits), d ≤ 64
        bits = 3 * bits - 12;
    }
    root.scaled(shift)
}

fn by_squaring<T: Scalar>(base: T, exponent: u64) -> T {
    let (mut base, mut left, mut value) = (base, exponent, None);
    loop {
        if left & 1 == 1 {
            value = Some(value.map_or(base, |value| value * base));
        }
        left >>= 1;
        if left == 0 {
            return value.unwrap_or(T::from_f64(1.0));
        }
        base = base * base;
    }
}
