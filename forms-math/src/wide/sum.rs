//! Sums, rounded to nearest.

use core::cmp::Ordering;
use core::ops::{Add, Neg, Sub};

use super::natural::{add_with_carry, subtract_with_borrow};
use super::{Class, Wide};

impl<const LIMBS: usize> Wide<LIMBS> {
    /// Returns the sum, and whether it is exact.
    pub(crate) fn sum(self, other: Self) -> (Self, bool) {
        match (self.class, other.class) {
            (Class::Finite, Class::Finite) => self.sum_of_finite(other),
            (Class::Zero, _) => (other, true),
            (_, Class::Zero) => (self, true),
            (Class::Infinite, Class::Infinite) if self.negative != other.negative => (Self::NAN, false),
            (Class::Nan, _) | (Class::Infinite, Class::Finite | Class::Infinite) => (self, false),
            (Class::Finite, _) | (Class::Infinite, Class::Nan) => (other, false),
        }
    }

    fn sum_of_finite(self, other: Self) -> (Self, bool) {
        let (large, small) = match self.compare_sizes(&other) {
            Ordering::Less => (other, self),
            Ordering::Equal if self.negative != other.negative => return (Self::ZERO, true),
            _ => (self, other),
        };
        let shift = large.exponent.saturating_sub(small.exponent);
        if shift > 64 * (LIMBS as i64 + 1) {
            return (large, false);
        }
        let (aligned, guard, sticky) = small.shifted_right(shift as usize);
        if large.negative == small.negative {
            large.plus_aligned(aligned, guard, sticky)
        } else {
            large.minus_aligned(aligned, guard, sticky)
        }
    }

    /// Returns the mantissa shifted right, the word after it, and whether there are bits beyond.
    #[inline(always)]
    fn shifted_right(&self, shift: usize) -> ([u64; LIMBS], u64, bool) {
        let (words, bits) = (shift / 64, shift % 64);
        // Words of the mantissa, shifted by whole words and bits.
        let at = |place: usize| if place < LIMBS { self.mantissa[place] } else { 0 };
        let moved = |place: usize| {
            if bits == 0 { at(place) } else { (at(place) >> bits) | (at(place + 1) << (64 - bits)) }
        };
        let mut aligned = [0; LIMBS];
        for (place, word) in aligned.iter_mut().enumerate() {
            *word = moved(place + words);
        }
        if shift == 0 {
            return (aligned, 0, false);
        }
        let guard = match words.checked_sub(1) {
            Some(place) => moved(place),
            None => self.mantissa[0] << (64 - bits),
        };
        let lost_words = words.saturating_sub(1).min(LIMBS);
        let lost_bits = words > 0 && bits > 0 && at(words - 1) << (64 - bits) != 0;
        (aligned, guard, lost_bits || self.mantissa[..lost_words].iter().any(|&word| word != 0))
    }

    #[inline(always)]
    fn plus_aligned(self, aligned: [u64; LIMBS], guard: u64, sticky: bool) -> (Self, bool) {
        let mut mantissa = self.mantissa;
        let mut carry = false;
        for (word, more) in mantissa.iter_mut().zip(aligned) {
            (*word, carry) = add_with_carry(*word, more, carry);
        }
        if !carry {
            return Self::rounded(self.negative, self.exponent, mantissa, guard, sticky);
        }
        let sticky = sticky || guard & 1 == 1;
        let guard = (guard >> 1) | (mantissa[0] << 63);
        let mut above = 1_u64;
        for word in mantissa.iter_mut().rev() {
            let next = *word & 1;
            *word = (*word >> 1) | (above << 63);
            above = next;
        }
        Self::rounded(self.negative, self.exponent + 1, mantissa, guard, sticky)
    }

    #[inline(always)]
    fn minus_aligned(self, aligned: [u64; LIMBS], guard: u64, sticky: bool) -> (Self, bool) {
        let (guard, mut borrow) = subtract_with_borrow(0, guard, sticky);
        let mut mantissa = self.mantissa;
        for (word, less) in mantissa.iter_mut().zip(aligned) {
            (*word, borrow) = subtract_with_borrow(*word, less, borrow);
        }
        Self::normalized(self.negative, self.exponent, mantissa, guard, sticky)
    }
}

impl<const LIMBS: usize> Add for Wide<LIMBS> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.sum(other).0
    }
}

impl<const LIMBS: usize> Sub for Wide<LIMBS> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.sum(-other).0
    }
}

impl<const LIMBS: usize> Neg for Wide<LIMBS> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { negative: !self.negative, ..self }
    }
}
