//! Elements of the tower's field: a reduced polynomial over an integer, times powers of known
//! factors.

use super::power::FactorPower;
use crate::expression::Rational;
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_traits::One;

/// N / (d ∏ Fᵉ) with d > 0 and known factors F. A factor of the numerator (e < 0) stays factored
/// until a sum needs it multiplied out, so that it can cancel. Zero has neither d nor factors.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Fraction {
    pub(super) numerator: Polynomial,
    pub(super) divisor: BigInt,
    pub(super) factors: Vec<FactorPower>,
}

impl From<Polynomial> for Fraction {
    fn from(numerator: Polynomial) -> Self {
        Fraction { numerator, divisor: BigInt::one(), factors: Vec::new() }
    }
}

impl Fraction {
    /// 0
    pub fn zero() -> Self {
        Polynomial::zero().into()
    }

    /// 1
    pub fn one() -> Self {
        Polynomial::one().into()
    }

    /// Creates a number.
    pub fn number(value: &Rational) -> Self {
        Fraction {
            numerator: Polynomial::constant(value.numer().clone()),
            divisor: value.denom().clone(),
            factors: Vec::new(),
        }
    }

    /// Whether the fraction is zero; for a reduced fraction this is a proof.
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// Returns the number, if the fraction is one.
    pub fn as_number(&self) -> Option<Rational> {
        if !self.factors.is_empty() {
            return None;
        }
        Some(Rational::new(self.numerator.as_constant()?, self.divisor.clone()))
    }

    /// Returns the numerator, if the denominator is only a number, which is positive.
    pub fn as_polynomial(&self) -> Option<&Polynomial> {
        self.factors.is_empty().then_some(&self.numerator)
    }

    /// Returns the positive integer of the denominator.
    pub fn divisor(&self) -> &BigInt {
        &self.divisor
    }

    /// Returns the reduced numerator.
    pub fn numerator(&self) -> &Polynomial {
        &self.numerator
    }

    /// Whether there is no denominator.
    pub(super) fn is_polynomial(&self) -> bool {
        self.divisor.is_one() && self.factors.is_empty()
    }
}
