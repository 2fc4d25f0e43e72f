//! sin and cos.

use super::DoubleDouble;
use super::exponential::reciprocal_factorial;
use crate::error_free::{two_product, two_sum};
use crate::float;
use crate::{Real, Wide};

/// π/2 to 318 bits; each word is the `f64` nearest to the remainder after the words before it.
const QUARTER_TURN: [f64; 6] = [
    core::f64::consts::FRAC_PI_2,
    6.123_233_995_736_766e-17,
    -1.497_384_904_859_169_8e-33,
    5.562_271_104_316_826e-50,
    2.836_115_989_820_158e-66,
    8.724_931_080_676_243e-84,
];

/// Largest argument that is reduced by these words; larger ones are reduced with the number of
/// digits of π that they need.
const LARGEST_BY_WORDS: f64 = 1_048_576.0;

impl DoubleDouble {
    /// Returns (q mod 4, x − q π/2) with an integer q. The remainder is at most slightly larger
    /// than π/4 and has a relative error within 4 units.
    pub(super) fn to_quadrant(self) -> (u8, Self) {
        if self.high.abs() <= core::f64::consts::FRAC_PI_4 {
            return (0, self);
        }
        if !self.high.is_finite() {
            return (0, Self::NAN);
        }
        if self.high.abs() > LARGEST_BY_WORDS {
            let (quadrant, rest) = crate::wide::quadrant_of_words(self.high, self.low);
            let high = rest.to_f64();
            return (quadrant, Self::new(high, (rest - Wide::from_f64(high)).to_f64()));
        }
        let count = float::f64::round(self.high / core::f64::consts::FRAC_PI_2);
        let mut terms = [0.0; 14];
        (terms[0], terms[1]) = (self.high, self.low);
        for (index, word) in QUARTER_TURN.into_iter().enumerate() {
            let (product, rest) = two_product(-count, word);
            (terms[2 + 2 * index], terms[3 + 2 * index]) = (product, rest);
        }
        (float::f64::rem_euclid(count, 4.0) as u8, distilled(terms))
    }

    /// Computes (sin r, cos r) for |r| ≤ 0.8 by Taylor's series, each within 16 units.
    fn sine_and_cosine_of_rest(self) -> (Self, Self) {
        let square = self.times(self);
        let sine = series(square, 1);
        let cosine = series(square, 0);
        // sin r = r + r³ S(r²), cos r = 1 − r²/2 + r⁴ C(r²)
        let sine = self.plus(self.times(square).times(sine));
        let half = square.by_power_of_two(0.5);
        let cosine = Self::ONE.plus(half.negated().plus(square.times(square).times(cosine)));
        (sine, cosine)
    }

    /// Computes (sin x, cos x), each within 24 units.
    pub(super) fn sine_cosine(self) -> (Self, Self) {
        let (quadrant, rest) = self.to_quadrant();
        if rest.high == 0.0 && quadrant == 0 {
            return (rest, Self::ONE);
        }
        let (sine, cosine) = rest.sine_and_cosine_of_rest();
        match quadrant {
            0 => (sine, cosine),
            1 => (cosine, sine.negated()),
            2 => (sine.negated(), cosine.negated()),
            _ => (cosine.negated(), sine),
        }
    }
}

/// Evaluates the coefficients ∓1/3!, ±1/5!, … of the sine (`odd` = 1) or ±1/4!, ∓1/6!, … of the
/// cosine (0) as a polynomial in r². Terms below 2⁻⁵³ of the value are computed in `f64`.
fn series(square: DoubleDouble, odd: usize) -> DoubleDouble {
    let first = 4 - odd;
    let sign = |index: usize| if (index + odd).is_multiple_of(2) { 1.0 } else { -1.0 };
    let tail = (7..13).rev().fold(0.0, |sum, index| {
        sum * square.high + sign(index) * reciprocal_factorial(first + 2 * index).high
    });
    let mut sum = DoubleDouble::new(tail, 0.0);
    for index in (0..7).rev() {
        let coefficient = reciprocal_factorial(first + 2 * index).by_power_of_two(sign(index));
        sum = sum.times(square).plus(coefficient);
    }
    sum
}

/// Adds terms by three error-free passes, with the accuracy of four times the precision.
///
/// Source: T. Ogita, S. M. Rump, S. Oishi, Accurate sum and dot product, SIAM J. Sci. Comput. 26
/// (2005).
fn distilled(mut terms: [f64; 14]) -> DoubleDouble {
    for _ in 0..3 {
        for index in 1..terms.len() {
            let (sum, rest) = two_sum(terms[index], terms[index - 1]);
            (terms[index - 1], terms[index]) = (rest, sum);
        }
    }
    let last = terms.len() - 1;
    let low: DoubleDouble = terms[..last].iter().fold(DoubleDouble::ZERO, |sum, &term| sum.plus_f64(term));
    low.plus_f64(terms[last])
}
