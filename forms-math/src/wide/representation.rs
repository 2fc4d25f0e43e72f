//! Conversion from words and to `f64`, rounding, and order.

use core::cmp::Ordering;

use super::natural::{add_with_carry, bit_length};
use super::product::LARGEST;
use super::{Class, Wide};
use crate::error_free::{mantissa_and_exponent, scaled};

impl<const LIMBS: usize> Wide<LIMBS> {
    pub(super) const ZERO: Self =
        Self { class: Class::Zero, negative: false, exponent: 0, mantissa: [0; LIMBS] };
    pub(super) const NAN: Self = Self { class: Class::Nan, ..Self::ZERO };

    /// Returns a number of this sign with a magnitude of at least 2^`exponent`.
    pub(crate) fn infinite(negative: bool, exponent: i64) -> Self {
        Self { class: Class::Infinite, negative, exponent, ..Self::ZERO }
    }

    /// Returns (whether it is negative, e) for a number beyond the exponents with a magnitude of at
    /// least 2^e.
    pub(crate) fn least_exponent_of_infinite(self) -> Option<(bool, i64)> {
        (self.class == Class::Infinite).then_some((self.negative, self.exponent))
    }

    /// Rounds ± 0.m · 2^exponent by the bits after m: the next 64, and whether there are others.
    /// Also returns whether the result is exact.
    #[inline(always)]
    pub(super) fn rounded(
        negative: bool,
        exponent: i64,
        mantissa: [u64; LIMBS],
        guard: u64,
        sticky: bool,
    ) -> (Self, bool) {
        let (mut mantissa, mut exponent) = (mantissa, exponent);
        if guard >> 63 == 1 {
            let mut carry = true;
            for word in &mut mantissa {
                (*word, carry) = add_with_carry(*word, 0, carry);
            }
            if carry {
                mantissa[LIMBS - 1] = 1 << 63;
                exponent += 1;
            }
        }
        (Self { class: Class::Finite, negative, exponent, mantissa }, guard == 0 && !sticky)
    }

    /// Shifts the first bit of the mantissa to its place; bits of the guard follow.
    pub(super) fn normalized(
        negative: bool,
        exponent: i64,
        mantissa: [u64; LIMBS],
        guard: u64,
        sticky: bool,
    ) -> (Self, bool) {
        let (mut mantissa, mut guard) = (mantissa, guard);
        let Some(top) = mantissa.iter().rposition(|&word| word != 0) else {
            if guard == 0 {
                return (Self::ZERO, !sticky);
            }
            mantissa[LIMBS - 1] = guard;
            return Self::normalized(negative, exponent - 64 * LIMBS as i64, mantissa, 0, sticky);
        };
        let words = LIMBS - 1 - top;
        if words > 0 {
            mantissa.copy_within(..=top, words);
            mantissa[words - 1] = guard;
            mantissa[..words - 1].fill(0);
            guard = 0;
        }
        let bits = mantissa[LIMBS - 1].leading_zeros();
        if bits > 0 {
            let mut carry = guard >> (64 - bits);
            for word in &mut mantissa {
                let next = *word >> (64 - bits);
                *word = (*word << bits) | carry;
                carry = next;
            }
            guard <<= bits;
        }
        Self::rounded(negative, exponent - 64 * words as i64 - i64::from(bits), mantissa, guard, sticky)
    }

    /// Returns ± number · 2^exponent.
    pub(super) fn from_natural(negative: bool, number: &[u64], exponent: i64) -> Self {
        let length = bit_length(number);
        if length == 0 {
            return Self::ZERO;
        }
        let words = length.div_ceil(64);
        let mut mantissa = [0; LIMBS];
        let taken = words.min(LIMBS);
        mantissa[LIMBS - taken..].copy_from_slice(&number[words - taken..words]);
        let guard = if words > LIMBS { number[words - LIMBS - 1] } else { 0 };
        Self::normalized(negative, exponent + 64 * words as i64, mantissa, guard, false).0
    }

    /// Returns the natural number of these words, the least significant first.
    pub(crate) fn from_words(words: &[u64]) -> Self {
        Self::from_natural(false, words, 0)
    }

    /// Rounds to the nearest number with this number of limbs; exact if there are no fewer.
    pub fn to_limbs<const OTHER: usize>(self) -> Wide<OTHER> {
        match self.class {
            Class::Finite => {
                Wide::from_natural(self.negative, &self.mantissa, self.exponent - 64 * LIMBS as i64)
            }
            class => Wide { class, negative: self.negative, exponent: self.exponent, ..Wide::ZERO },
        }
    }

    pub(super) fn of_f64(value: f64) -> Self {
        if value == 0.0 {
            return Self::ZERO;
        }
        if value.is_nan() {
            return Self::NAN;
        }
        if value.is_infinite() {
            return Self::infinite(value < 0.0, LARGEST);
        }
        let (fraction, exponent) = mantissa_and_exponent(value);
        let mut mantissa = [0; LIMBS];
        // 0.1… in binary: the first bit is implied in the bits of an f64.
        mantissa[LIMBS - 1] = (fraction.to_bits() << 11) | (1 << 63);
        Self { class: Class::Finite, negative: value < 0.0, exponent, mantissa }
    }

    /// Returns the nearest `f64`, ties to even.
    pub(super) fn nearest_f64(&self) -> f64 {
        let signed = |size: f64| if self.negative { -size } else { size };
        match self.class {
            Class::Nan => return f64::NAN,
            Class::Zero => return 0.0,
            Class::Infinite => return signed(f64::INFINITY),
            Class::Finite if self.exponent > 1024 => return signed(f64::INFINITY),
            Class::Finite => (),
        }
        let bits = (self.exponent + 1074).min(53);
        if bits < 0 {
            return signed(0.0);
        }
        let top = self.mantissa[LIMBS - 1];
        let (kept, rest) = if bits == 0 { (0, top) } else { (top >> (64 - bits), top << bits) };
        let beyond = self.mantissa[..LIMBS - 1].iter().any(|&word| word != 0);
        let half = 1_u64 << 63;
        let up = rest > half || (rest == half && (beyond || kept & 1 == 1));
        signed(scaled((kept + u64::from(up)) as f64, self.exponent - bits))
    }

    /// Compares the magnitudes of two finite numbers.
    pub(super) fn compare_sizes(&self, other: &Self) -> Ordering {
        match (self.class, other.class) {
            (Class::Zero, Class::Zero) => Ordering::Equal,
            (Class::Zero, _) => Ordering::Less,
            (_, Class::Zero) => Ordering::Greater,
            _ => self
                .exponent
                .cmp(&other.exponent)
                .then_with(|| self.mantissa.iter().rev().cmp(other.mantissa.iter().rev())),
        }
    }

    fn sign(&self) -> i8 {
        match (self.class, self.negative) {
            (Class::Zero, _) => 0,
            (_, false) => 1,
            (_, true) => -1,
        }
    }
}

impl<const LIMBS: usize> PartialEq for Wide<LIMBS> {
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

impl<const LIMBS: usize> PartialOrd for Wide<LIMBS> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        if self.class == Class::Nan || other.class == Class::Nan {
            return None;
        }
        let signs = self.sign().cmp(&other.sign());
        if signs != Ordering::Equal {
            return Some(signs);
        }
        let sizes = match (self.class, other.class) {
            (Class::Infinite, Class::Infinite) => Ordering::Equal,
            (Class::Infinite, _) => Ordering::Greater,
            (_, Class::Infinite) => Ordering::Less,
            _ => self.compare_sizes(other),
        };
        Some(if self.negative { sizes.reverse() } else { sizes })
    }
}
