//! Products, rounded to nearest.

use core::ops::Mul;

use super::natural::multiply_add;
use super::{Class, Wide};

impl<const LIMBS: usize> Wide<LIMBS> {
    /// Returns the product, and whether it is exact.
    pub(crate) fn product(self, other: Self) -> (Self, bool) {
        let negative = self.negative != other.negative;
        match (self.class, other.class) {
            (Class::Finite, Class::Finite) => (),
            (Class::Nan, _)
            | (_, Class::Nan)
            | (Class::Zero, Class::Infinite)
            | (Class::Infinite, Class::Zero) => {
                return (Self::NAN, false);
            }
            (Class::Infinite, _) | (_, Class::Infinite) => return (Self::infinite(negative, 0), false),
            (Class::Zero, _) | (_, Class::Zero) => return (Self::ZERO, true),
        }
        let (mut low, mut high) = ([0_u64; LIMBS], [0_u64; LIMBS]);
        for (row, &factor) in self.mantissa.iter().enumerate() {
            if factor == 0 {
                continue;
            }
            let mut carry = 0;
            for (column, &word) in other.mantissa.iter().enumerate() {
                let place = row + column;
                let cell = if place < LIMBS { &mut low[place] } else { &mut high[place - LIMBS] };
                (*cell, carry) = multiply_add(*cell, word, factor, carry);
            }
            high[row] = carry;
        }
        let guard = low[LIMBS - 1];
        let sticky = low[..LIMBS - 1].iter().any(|&word| word != 0);
        match within_range(self.exponent.saturating_add(other.exponent)) {
            Some(exponent) => Self::normalized(negative, exponent, high, guard, sticky),
            None if self.exponent > 0 => (Self::infinite(negative, LARGEST - 1), false),
            None => (Self::ZERO, false),
        }
    }
}

/// Limit of the magnitude of finite exponents, which leaves room for shifts.
pub(super) const LARGEST: i64 = 1 << 60;

/// Returns the exponent if it is within that limit.
pub(super) fn within_range(exponent: i64) -> Option<i64> {
    (exponent.abs() < LARGEST).then_some(exponent)
}

impl<const LIMBS: usize> Mul for Wide<LIMBS> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.product(other).0
    }
}
