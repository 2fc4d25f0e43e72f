//! sin and cos; arguments are reduced with the number of digits of π that they need.

use alloc::vec::Vec;

use super::constants::half_pi;
use super::natural::{compare, quotient_and_remainder, shifted_left, subtract};
use super::{Class, Wide};

/// Largest exponent of an argument; beyond it the result is NaN, since the reduction would need too
/// many digits of π.
const LARGEST_EXPONENT: i64 = 1 << 16;

/// Returns (q mod 4, sign, rest) with ± number · 2^exponent = q π/2 ± rest · 2^(−64 words) and
/// 0 ≤ rest ≤ π/4, for exponent ≥ −64 words. The rest is accurate to a few units of 2^(−64 words).
fn reduced(
    negative: bool,
    number: &[u64],
    exponent: i64,
    words: usize,
) -> Option<(u8, bool, Vec<u64>, usize)> {
    let length = super::natural::bit_length(number) as i64 + exponent;
    if length > LARGEST_EXPONENT {
        return None;
    }
    // The number of words grows with the quotient, in steps of four, so that few lengths of π are
    // stored.
    let words = (words + (length.max(0) as usize).div_ceil(64)).next_multiple_of(4);
    let quarter_turn = half_pi(words);
    let dividend = shifted_left(number, usize::try_from(exponent + 64 * words as i64).ok()?);
    let (quotient, mut rest) = quotient_and_remainder(&dividend, quarter_turn);
    let mut count = quotient.first().map_or(0, |word| (word & 3) as u8);
    rest.resize(quarter_turn.len(), 0);
    let mut complement = quarter_turn.to_vec();
    subtract(&mut complement, &rest);
    let mut below = false;
    if compare(&complement, &rest).is_lt() {
        (rest, below, count) = (complement, true, (count + 1) % 4);
    }
    if negative {
        (below, count) = (!below, (4 - count) % 4);
    }
    Some((count, below, rest, words))
}

/// Returns (q mod 4, rest) of high + low, with the rest as a number of four words.
pub(crate) fn quadrant_of_words(high: f64, low: f64) -> (u8, Wide<4>) {
    let (high, low) = (Wide::<1>::of_f64(high), Wide::<1>::of_f64(low));
    // A common power of two below both: a low word is at least 2^−1074.
    let lowest = |part: &Wide<1>| if part.class == Class::Finite { part.exponent - 64 } else { i64::MAX };
    let common = lowest(&high).min(lowest(&low));
    let integer = |part: &Wide<1>| match part.class {
        Class::Finite => shifted_left(&part.mantissa, (lowest(part) - common) as usize),
        _ => Vec::new(),
    };
    let (mut sum, mut other) = (integer(&high), integer(&low));
    other.resize(sum.len().max(other.len()), 0);
    sum.resize(other.len(), 0);
    if high.negative == low.negative {
        super::natural::add(&mut sum, &other);
    } else {
        subtract(&mut sum, &other);
    }
    let least = (-common).max(0) as usize;
    match reduced(high.negative, &sum, common, least.div_ceil(64).max(6)) {
        Some((count, below, rest, words)) => (count, Wide::from_natural(below, &rest, -64 * words as i64)),
        None => (0, Wide::NAN),
    }
}

impl<const LIMBS: usize> Wide<LIMBS> {
    /// Returns (q mod 4, x − q π/2), where the remainder is at most π/4 in magnitude, or NaN beyond
    /// 2^65536.
    pub(super) fn to_quadrant(self) -> (u8, Self) {
        match self.class {
            Class::Zero => return (0, self),
            // |x| < ½
            Class::Finite if self.exponent < 0 => return (0, self),
            Class::Finite => (),
            _ => return (0, Self::NAN),
        }
        let exponent = self.exponent - 64 * LIMBS as i64;
        match reduced(self.negative, &self.mantissa, exponent, 2 * LIMBS + 2) {
            Some((count, below, rest, words)) => {
                (count, Self::from_natural(below, &rest, -64 * words as i64))
            }
            None => (0, Self::NAN),
        }
    }

    /// Computes (sin r, cos r − 1) by Taylor's series.
    fn series_of_rotation(self) -> (Self, Self) {
        let (mut term, mut sine, mut versine) = (self, self, Self::ZERO);
        for count in 2_u64.. {
            term = (term * self).over_word(count);
            if term.class != Class::Finite || term.exponent < self.exponent - 64 * LIMBS as i64 - 2 {
                break;
            }
            // The signs of i, i², i³, …
            let signed = if count % 4 >= 2 { -term } else { term };
            if count % 2 == 0 { versine = versine + signed } else { sine = sine + signed }
        }
        (sine, versine)
    }

    /// Computes (sin x, cos x) by doubling: with s = sin a, c = cos a − 1, sin 2a = 2 s (1 + c),
    /// cos 2a − 1 = 2 c (2 + c).
    pub(super) fn sine_cosine(self) -> (Self, Self) {
        let (quadrant, rest) = self.to_quadrant();
        let one = Self::of_f64(1.0);
        match rest.class {
            Class::Nan => return (rest, rest),
            Class::Zero => return rotated(quadrant, rest, one),
            _ => (),
        }
        let doublings = 2 + (64 * LIMBS).isqrt() as i64 / 3;
        let doublings = (doublings + rest.exponent.clamp(-doublings, 0)).max(0);
        let (mut sine, mut versine) =
            Self { exponent: rest.exponent - doublings, ..rest }.series_of_rotation();
        for _ in 0..doublings {
            (sine, versine) = (
                (sine + sine * versine).by_power_of_two(1),
                versine.by_power_of_two(2) + (versine * versine).by_power_of_two(1),
            );
        }
        rotated(quadrant, sine, one + versine)
    }
}

/// Rotates (sin, cos) of an angle by this number of quarter turns.
fn rotated<const LIMBS: usize>(
    quadrant: u8,
    sine: Wide<LIMBS>,
    cosine: Wide<LIMBS>,
) -> (Wide<LIMBS>, Wide<LIMBS>) {
    match quadrant {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}
