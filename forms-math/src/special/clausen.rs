//! Cl₂ from its series about 0 and about π.
//!
//! Cl₂(θ) = θ (1 − ln|θ| + Σ ζ(2k)/(k (2k + 1)) (θ/2π)²ᵏ),
//! Cl₂(π − θ) = θ (ln 2 − Σ (4ᵏ − 1) ζ(2k)/(k (2k + 1)) (θ/2π)²ᵏ):
//! the first is used up to 2π/3, the second beyond, so that each term is at most a ninth of the
//! previous one.
//!
//! Source: L. Lewin, Polylogarithms and associated functions (1981), §4.

use super::zeta::zeta_of_even;
use crate::scalar::Scalar;

/// Cl₂(x)
pub(crate) fn clausen<T: Scalar>(x: T, bits: u32) -> T {
    let zero = T::from_f64(0.0);
    let (quadrant, rest) = x.quadrant();
    if rest.to_f64().is_nan() {
        return T::nan();
    }
    let half_turn = T::pi();
    let angle = match quadrant {
        0 => rest,
        1 => half_turn.scaled(-1) + rest,
        2 => return about_half_turn(-rest, bits),
        _ => rest - half_turn.scaled(-1),
    };
    if angle == zero {
        angle
    } else if angle.abs() * T::from_f64(3.0) <= half_turn.scaled(1) {
        about_zero(angle, bits)
    } else if angle > zero {
        about_half_turn(half_turn - angle, bits)
    } else {
        about_half_turn(-half_turn - angle, bits)
    }
}

fn about_zero<T: Scalar>(angle: T, bits: u32) -> T {
    let one = T::from_f64(1.0);
    angle * ((one - angle.abs().ln()) + series(angle, bits, |zeta, _| zeta))
}

fn about_half_turn<T: Scalar>(angle: T, bits: u32) -> T {
    let two = T::from_f64(2.0);
    angle * (two.ln() - series(angle, bits, |zeta, count| zeta.scaled(2 * count) - zeta))
}

/// Σ c(ζ(2k), k)/(k (2k + 1)) (θ/2π)²ᵏ
fn series<T: Scalar>(angle: T, bits: u32, coefficient: impl Fn(T, i64) -> T) -> T {
    let ratio = angle / T::pi().scaled(1);
    let step = ratio * ratio;
    let negligible = T::from_f64(1.0).scaled(-i64::from(bits) - 4);
    let (mut power, mut sum) = (T::from_f64(1.0), T::from_f64(0.0));
    for (&zeta, count) in zeta_of_even::<T>().iter().zip(1..) {
        power = power * step;
        let term = coefficient(zeta, count) * power / T::from_f64((count * (2 * count + 1)) as f64);
        sum = sum + term;
        if term < negligible {
            break;
        }
    }
    sum
}
