//! Numbers inside sums and products: small exact coefficients and exponents.

use super::super::constant::Constant;
use crate::expression::Rational;
use num_integer::Integer;
use num_rational::Ratio;
use num_traits::ToPrimitive;
use std::cmp::Ordering;

/// Rational number of two machine words. A number that does not fit is a node of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(in crate::kernel) struct Coefficient {
    numerator: i64,
    denominator: i64,
}

impl Coefficient {
    pub(in crate::kernel) const ZERO: Self = Coefficient { numerator: 0, denominator: 1 };
    pub(in crate::kernel) const ONE: Self = Coefficient { numerator: 1, denominator: 1 };
    pub(in crate::kernel) const MINUS_ONE: Self = Coefficient { numerator: -1, denominator: 1 };

    /// p/q in lowest terms, if it fits.
    fn reduced(numerator: i128, denominator: i128) -> Option<Self> {
        let divisor = numerator.gcd(&denominator).max(1);
        let sign = if denominator < 0 { -1 } else { 1 };
        let fit = |part: i128| i64::try_from(part / divisor * sign).ok().filter(|&part| part != i64::MIN);
        Some(Coefficient { numerator: fit(numerator)?, denominator: fit(denominator)? })
    }

    pub(in crate::kernel) fn of(constant: &Constant) -> Option<Self> {
        if constant.pi_exponent != 0 {
            return None;
        }
        Self::reduced(constant.factor.numer().to_i128()?, constant.factor.denom().to_i128()?)
    }

    pub(in crate::kernel) fn constant(self) -> Constant {
        Constant::rational(Rational::new(self.numerator.into(), self.denominator.into()))
    }

    pub(in crate::kernel) fn is_zero(self) -> bool {
        self.numerator == 0
    }

    pub(in crate::kernel) fn is_negative(self) -> bool {
        self.numerator < 0
    }

    pub(in crate::kernel) fn is_unit(self) -> bool {
        self.denominator == 1 && self.numerator.abs() == 1
    }

    pub(in crate::kernel) fn is_integer(self) -> bool {
        self.denominator == 1
    }

    pub(in crate::kernel) fn negated(self) -> Self {
        Coefficient { numerator: -self.numerator, ..self }
    }

    pub(in crate::kernel) fn magnitude(self) -> Self {
        Coefficient { numerator: self.numerator.abs(), ..self }
    }

    pub(in crate::kernel) fn plus(self, other: Self) -> Option<Self> {
        if self.denominator == 1 && other.denominator == 1 {
            return Self::reduced(i128::from(self.numerator) + i128::from(other.numerator), 1);
        }
        let [a, b, c, d] = self.parts_with(other);
        Self::reduced((a * d).checked_add(c * b)?, b * d)
    }

    pub(in crate::kernel) fn times(self, other: Self) -> Option<Self> {
        if other == Self::ONE {
            return Some(self);
        }
        let [a, b, c, d] = self.parts_with(other);
        Self::reduced(a * c, b * d)
    }

    /// c/d for d ≠ 0
    pub(in crate::kernel) fn over(self, other: Self) -> Option<Self> {
        if other == Self::ONE {
            return Some(self);
        }
        let [a, b, c, d] = self.parts_with(other);
        if c == 0 { None } else { Self::reduced(a * d, b * c) }
    }

    /// cⁿ; `None` for 0 to a negative power.
    pub(in crate::kernel) fn power(self, exponent: i32) -> Option<Self> {
        if self == Self::ONE {
            return Some(self);
        }
        let base = if exponent < 0 { Self::ONE.over(self)? } else { self };
        let exponent = exponent.unsigned_abs();
        Some(Coefficient {
            numerator: base.numerator.checked_pow(exponent)?,
            denominator: base.denominator.checked_pow(exponent)?,
        })
    }

    fn parts_with(self, other: Self) -> [i128; 4] {
        [self.numerator, self.denominator, other.numerator, other.denominator].map(i128::from)
    }
}

impl PartialOrd for Coefficient {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Coefficient {
    fn cmp(&self, other: &Self) -> Ordering {
        let [a, b, c, d] = self.parts_with(*other);
        (a * d).cmp(&(c * b))
    }
}

/// Rational exponent, counted in 24ths so that halves, thirds, quarters, sixths and eighths are
/// whole.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(in crate::kernel) struct Exponent(pub(in crate::kernel) i32);

impl Exponent {
    /// 1 in 24ths.
    pub(in crate::kernel) const WHOLE: i32 = 24;
    pub(in crate::kernel) const ONE: Self = Exponent(Self::WHOLE);
    pub(in crate::kernel) const MINUS_ONE: Self = Exponent(-Self::WHOLE);
    /// Largest exponent; larger ones are left to the general power function.
    const LARGEST: i64 = 1 << 12;

    pub(in crate::kernel) fn of(ratio: Ratio<i64>) -> Option<Self> {
        let whole = i64::from(Self::WHOLE);
        if whole % ratio.denom() != 0 || ratio.numer().abs() > Self::LARGEST {
            return None;
        }
        Some(Exponent((ratio.numer() * (whole / ratio.denom())) as i32))
    }

    pub(in crate::kernel) fn ratio(self) -> Ratio<i64> {
        Ratio::new(i64::from(self.0), i64::from(Self::WHOLE))
    }

    /// Returns the exponent as an integer, if it is one.
    pub(in crate::kernel) fn integer(self) -> Option<i32> {
        (self.0 % Self::WHOLE == 0).then_some(self.0 / Self::WHOLE)
    }

    pub(in crate::kernel) fn is_negative(self) -> bool {
        self.0 < 0
    }

    pub(in crate::kernel) fn negated(self) -> Self {
        Exponent(-self.0)
    }

    /// e₁ + e₂, if it is not too large.
    pub(in crate::kernel) fn plus(self, other: Self) -> Option<Self> {
        self.within(self.0 + other.0)
    }

    /// n e, if it is not too large.
    pub(in crate::kernel) fn times(self, count: i32) -> Option<Self> {
        self.within(self.0.checked_mul(count)?)
    }

    fn within(self, parts: i32) -> Option<Self> {
        (i64::from(parts.abs()) <= Self::LARGEST * i64::from(Self::WHOLE)).then_some(Exponent(parts))
    }
}
