//! eˣ and eˣ − 1.

use super::product::LARGEST;
use super::{Class, Wide};
use crate::float;

impl<const LIMBS: usize> Wide<LIMBS> {
    /// Computes e^s − 1 by Taylor's series.
    fn series_of_exponential(self) -> Self {
        let (mut term, mut sum) = (self, self);
        for count in 2.. {
            term = (term * self).over_word(count);
            if term.class != Class::Finite || term.exponent < sum.exponent - 64 * LIMBS as i64 - 2 {
                break;
            }
            sum = sum + term;
        }
        sum
    }

    /// Returns (k, eˣ 2⁻ᵏ − 1) with k near x/ln 2, for finite |x| < 2⁵⁰: x = k ln 2 + 2ᵐ s, and m
    /// times e^(2s) − 1 = p (2 + p) with p = e^s − 1.
    fn reduced_exponential(self) -> (i64, Self) {
        let constants = Self::constants();
        let count = float::f64::round(self.nearest_f64() / core::f64::consts::LN_2);
        let factor = Self::of_f64(count);
        let reduced = (self - factor * constants[2]) - factor * constants[3];
        let doublings = 2 + (64 * LIMBS).isqrt() as i64 / 2;
        // A small argument needs fewer doublings.
        let doublings = (doublings + reduced.exponent.clamp(-doublings, 0)).max(0);
        let mut value = Self { exponent: reduced.exponent - doublings, ..reduced }.series_of_exponential();
        for _ in 0..doublings {
            value = value.by_power_of_two(1) + value * value;
        }
        (count as i64, value)
    }

    /// Multiplies by 2ᵉ.
    pub(super) fn by_power_of_two(self, exponent: i64) -> Self {
        if self.class != Class::Finite {
            return self;
        }
        match super::product::within_range(self.exponent.saturating_add(exponent)) {
            Some(exponent) => Self { exponent, ..self },
            None if exponent > 0 => Self::infinite(self.negative, LARGEST - 1),
            None => Self::ZERO,
        }
    }

    /// Computes eˣ; out of range from |x| = 2⁵⁰.
    pub(super) fn exponential(self) -> Self {
        match self.class {
            Class::Nan => self,
            Class::Zero => Self::of_f64(1.0),
            Class::Finite if self.exponent <= 50 => {
                let (count, value) = self.reduced_exponential();
                (Self::of_f64(1.0) + value).by_power_of_two(count)
            }
            _ if self.negative => Self::ZERO,
            _ => Self::infinite(false, 0),
        }
    }

    /// eˣ − 1
    pub(super) fn exponential_minus_one(self) -> Self {
        let one = Self::of_f64(1.0);
        match self.class {
            Class::Nan | Class::Zero => self,
            Class::Finite if self.exponent <= 50 => {
                let (count, value) = self.reduced_exponential();
                if count == 0 {
                    return value;
                }
                value.by_power_of_two(count) + (one.by_power_of_two(count) - one)
            }
            _ if self.negative => -one,
            _ => Self::infinite(false, 0),
        }
    }
}
