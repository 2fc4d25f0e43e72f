//! Elements as products of powers of factors of radicands and of exponentials.

use super::base::SignConstraint;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::Ratio;
use num_traits::{Signed, Zero};

/// gᵉ with rational e. It arises from factors g themselves and from roots of ±g, which are
/// non-negative.
#[derive(Clone)]
pub(super) struct Power {
    pub(super) base: usize,
    pub(super) exponent: Ratio<i64>,
    /// Whether g itself, apart from its roots, occurs to an odd power, so that the product has its
    /// sign.
    pub(super) odd: bool,
}

/// c ∏ gᵢ^eᵢ ∏ (exp u)ᵉ
#[derive(Clone)]
pub(super) struct Factored {
    pub(super) constant: BigInt,
    pub(super) powers: Vec<Power>,
    /// Exponential generators, with their exponents.
    pub(super) exponentials: Vec<(u32, Ratio<i64>)>,
    /// Number of nested radicals that were denested so far.
    pub(super) denested: u32,
}

impl Factored {
    /// Multiplies by gᵉ for an integer e.
    pub(super) fn raise(&mut self, base: usize, exponent: Ratio<i64>) {
        self.multiply(Power { base, exponent, odd: exponent.numer().is_odd() });
    }

    /// Multiplies by (±g)ᵉ, a power of a root.
    pub(super) fn raise_root(&mut self, base: usize, exponent: Ratio<i64>) {
        self.multiply(Power { base, exponent, odd: false });
    }

    pub(super) fn multiply(&mut self, factor: Power) {
        match self.powers.iter_mut().find(|power| power.base == factor.base) {
            Some(power) => {
                power.exponent += factor.exponent;
                power.odd ^= factor.odd;
            }
            None => self.powers.push(factor),
        }
    }

    pub(super) fn drop_neutral(&mut self) {
        self.powers.retain(|power| power.odd || !power.exponent.is_zero());
    }

    pub(super) fn constraint(&self) -> SignConstraint {
        let (odd, other): (Vec<&Power>, Vec<&Power>) = self.powers.iter().partition(|power| power.odd);
        let numbers = |powers: Vec<&Power>| powers.into_iter().map(|power| power.base).collect();
        SignConstraint { negative: self.constant.is_negative(), odd: numbers(odd), other: numbers(other) }
    }
}
