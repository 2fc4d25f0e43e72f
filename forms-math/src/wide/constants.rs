//! π, ln 2 and γ with the number of bits of a type, computed once.

use alloc::vec;
use alloc::vec::Vec;

use super::Wide;
use super::natural::{add, divide_by_word, multiply_by_word, subtract};
use crate::Real;
use crate::float;
use crate::scalar::Scalar;
use crate::table::table;

struct HalfPi;
struct Ln2;
struct Constants;

/// Number of words that rounding can affect in a sum of fixed-point numbers.
const SPARE: usize = 1;

/// Computes Σ 1/((2k + 1) n^(2k+1)) in fixed point with one word before the point, with or without
/// alternating signs.
fn arc_tangent_of_reciprocal(n: u64, words: usize, alternating: bool) -> Vec<u64> {
    let mut power = vec![0; words + 1];
    power[words] = 1;
    divide_by_word(&mut power, n);
    let mut sum = power.clone();
    let mut odd = 1;
    loop {
        divide_by_word(&mut power, n * n);
        odd += 2;
        let mut term = power.clone();
        divide_by_word(&mut term, odd);
        if term.iter().all(|&word| word == 0) {
            return sum;
        }
        if alternating && odd % 4 == 3 { subtract(&mut sum, &term) } else { add(&mut sum, &term) }
    }
}

/// Returns π/2 in fixed point: `words` words after the point, one before it.
///
/// π/4 = 4 arctan 1/5 − arctan 1/239 (J. Machin, 1706).
pub(super) fn half_pi(words: usize) -> &'static [u64] {
    table::<HalfPi, u64>(words, || {
        let inner = words + SPARE;
        let mut value = arc_tangent_of_reciprocal(5, inner, true);
        multiply_by_word(&mut value, 4);
        subtract(&mut value, &arc_tangent_of_reciprocal(239, inner, true));
        multiply_by_word(&mut value, 2);
        value.split_off(SPARE)
    })
}

/// Returns ln 2 in fixed point: `words` words after the point, one before it.
///
/// ln 2 = 18 artanh 1/26 − 2 artanh 1/4801 + 8 artanh 1/8749: each product of the (n + 1)/(n − 1)
/// is 2.
fn ln_2(words: usize) -> &'static [u64] {
    table::<Ln2, u64>(words, || {
        let inner = words + SPARE;
        let part = |n: u64, times: u64| {
            let mut value = arc_tangent_of_reciprocal(n, inner, false);
            multiply_by_word(&mut value, times);
            value
        };
        let mut value = part(26, 18);
        subtract(&mut value, &part(4801, 2));
        add(&mut value, &part(8749, 8));
        value.split_off(SPARE)
    })
}

impl<const LIMBS: usize> Wide<LIMBS> {
    /// Returns [π, ln 2, the first words of ln 2, their remainder]: the product of the third with a
    /// word is exact.
    pub(super) fn constants() -> &'static [Self] {
        table::<Constants, Self>(0, || {
            let pi = half_pi(LIMBS + 1);
            let words = 2 * LIMBS;
            let ln_2 = ln_2(words);
            let first = LIMBS - 1;
            let high = &ln_2[words - first..];
            let low = &ln_2[..words - first];
            vec![
                Self::from_natural(false, pi, 1 - 64 * (LIMBS as i64 + 1)),
                Self::from_natural(false, ln_2, -64 * words as i64),
                Self::from_natural(false, high, -64 * first as i64),
                Self::from_natural(false, low, -64 * words as i64),
            ]
        })
    }

    /// Computes γ = Σ aₖ²Hₖ / Σ aₖ² − ln n up to e^(−4n), with aₖ = nᵏ/k! and Hₖ = 1 + ½ + … + 1/k.
    ///
    /// Source: R. P. Brent, E. M. McMillan, Some new algorithms for high-precision computation of
    /// Euler's constant, Mathematics of Computation 34 (1980), algorithm B1.
    pub(super) fn compute_euler_gamma() -> Self {
        let n = float::f64::ceil(f64::from(Self::PRECISION + 16) * core::f64::consts::LN_2 / 4.0) as u64;
        let wide = |value: u64| Self::of_f64(value as f64);
        let (mut square, mut harmonic) = (wide(1), Self::ZERO);
        let (mut weighted, mut total) = (Self::ZERO, wide(1));
        let mut k = 0;
        // The terms grow up to k = n and are negligible where aₖ² is.
        while k <= n || square.exponent() > total.exponent().map(|exponent| exponent - 64 * LIMBS as i64 - 8)
        {
            k += 1;
            square = square * wide(n * n);
            square = square.over_word(k * k);
            harmonic = harmonic + wide(1).over_word(k);
            weighted = weighted + square * harmonic;
            total = total + square;
        }
        weighted / total - wide(n).ln()
    }
}
