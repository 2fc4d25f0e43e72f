//! Quotients, rounded to nearest, and square roots.

use core::cmp::Ordering;
use core::ops::Div;

use super::natural::{divide_by_word, quotient_word};
use super::product::{LARGEST, within_range};
use super::{Class, Wide};
use crate::float;

impl<const LIMBS: usize> Wide<LIMBS> {
    /// Returns the quotient, and whether it is exact.
    pub(crate) fn quotient(self, other: Self) -> (Self, bool) {
        let negative = self.negative != other.negative;
        match (self.class, other.class) {
            (Class::Finite, Class::Finite) => (),
            (Class::Nan, _)
            | (_, Class::Nan)
            | (Class::Zero, Class::Zero)
            | (Class::Infinite, Class::Infinite) => {
                return (Self::NAN, false);
            }
            (Class::Infinite, _) | (_, Class::Zero) => return (Self::infinite(negative, 0), false),
            (Class::Zero, _) => return (Self::ZERO, true),
            (_, Class::Infinite) => return (Self::ZERO, false),
        }
        let Some(exponent) = within_range(self.exponent.saturating_sub(other.exponent)) else {
            let infinite = self.exponent > 0;
            return (if infinite { Self::infinite(negative, LARGEST - 2) } else { Self::ZERO }, false);
        };
        // The dividend is made smaller than the divisor, so that the first bit of the quotient is
        // directly after the point.
        let halved = self.mantissa.iter().rev().cmp(other.mantissa.iter().rev()) != Ordering::Less;
        let mut left = self.mantissa;
        let mut next = 0;
        if halved {
            let mut above = 0;
            for word in left.iter_mut().rev() {
                let carried = *word << 63;
                *word = (*word >> 1) | above;
                above = carried;
            }
            next = above;
        }
        let mut mantissa = [0; LIMBS];
        for place in (0..LIMBS).rev() {
            mantissa[place] = next_word(&mut left, next, &other.mantissa);
            next = 0;
        }
        let guard = next_word(&mut left, next, &other.mantissa);
        let sticky = left.iter().any(|&word| word != 0);
        Self::rounded(negative, exponent + i64::from(halved), mantissa, guard, sticky)
    }

    /// Divides by a small non-zero integer; the result is rounded by the next 64 bits.
    pub(super) fn over_word(self, divisor: u64) -> Self {
        if self.class != Class::Finite {
            return self;
        }
        let mut mantissa = self.mantissa;
        let rest = divide_by_word(&mut mantissa, divisor);
        let guard = ((u128::from(rest) << 64) / u128::from(divisor)) as u64;
        Self::normalized(self.negative, self.exponent, mantissa, guard, true).0
    }

    /// Computes √x: s + y (x − s²)/2 with s = x y, and y = 1/√x by Newton's y + y (1 − x y²)/2.
    pub(super) fn square_root(self) -> Self {
        match self.class {
            Class::Zero => return self,
            Class::Infinite if !self.negative => return self,
            Class::Finite if !self.negative => (),
            _ => return Self::NAN,
        }
        let shift = self.exponent.div_euclid(2);
        let x = Self { exponent: self.exponent - 2 * shift, ..self };
        let one = Self::of_f64(1.0);
        let half = |value: Self| value.halved();
        let mut inverse = Self::of_f64(1.0 / float::f64::sqrt(x.nearest_f64()));
        let mut bits = 50;
        while bits < 32 * LIMBS + 8 {
            inverse = inverse + inverse * half(one - x * inverse * inverse);
            bits = 2 * bits - 2;
        }
        let root = x * inverse;
        let root = root + inverse * half(x - root * root);
        Self { exponent: root.exponent + shift, ..root }
    }

    fn halved(self) -> Self {
        Self { exponent: self.exponent - 1, ..self }
    }
}

/// Computes the next word of left / divisor, where left < divisor and `next` is the following word;
/// `left` becomes the remainder.
#[inline(always)]
fn next_word<const LIMBS: usize>(left: &mut [u64; LIMBS], next: u64, divisor: &[u64; LIMBS]) -> u64 {
    // `row` has one word more than the divisor: `next`, then the words of `left`.
    let mut buffer = [[0_u64; LIMBS]; 2];
    let row = buffer.as_flattened_mut();
    row[0] = next;
    row[1..=LIMBS].copy_from_slice(left);
    let word = quotient_word(&mut row[..=LIMBS], divisor);
    left.copy_from_slice(&row[..LIMBS]);
    word
}

impl<const LIMBS: usize> Div for Wide<LIMBS> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        self.quotient(other).0
    }
}
