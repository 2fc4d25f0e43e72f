//! +, −, ×, ÷ and √.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::{Bound, Guardable, Guarded};

impl<T: Guardable> Guarded<T> {
    /// Returns the result with its error; undefined if an operand is undefined.
    #[inline]
    pub(super) fn of_operands(operands: &[Self], value: T, error: T::Bound) -> Self {
        if value.size().is_finite() {
            return Self { value, error };
        }
        Self::without_value(operands, value)
    }

    #[cold]
    fn without_value(operands: &[Self], value: T) -> Self {
        if operands.iter().any(|operand| operand.is_undefined()) {
            Self::undefined()
        } else {
            Self::undecided(value)
        }
    }

    /// Returns the error of a product caused by the errors of its factors: |a| β + |b| α + α β.
    #[inline]
    pub(super) fn error_of_product(self, other: Self) -> T::Bound {
        T::Bound::of_product(self.value.size(), self.error, other.value.size(), other.error)
    }

    /// Computes the square root; the propagated error is |δ|/(√x + √(x + δ)) ≤ α/(√x + √(x − α)).
    pub(super) fn root(self) -> Self {
        if let Some(beyond) = self.is_beyond() {
            return beyond.root();
        }
        let zero = T::from_f64(0.0);
        if self.value < zero && self.value.size_down() > self.error {
            return Self::undefined();
        }
        let least = self.value.size_down();
        if self.value < zero || (self.error > least && !self.is_exact()) {
            return Self::undecided(self.value.sqrt());
        }
        let (root, rounding) = self.value.root();
        let divisor = least.root_down();
        let propagated = if self.is_exact() {
            T::Bound::ZERO
        } else {
            self.error.over(divisor).times(root_factor(self, least))
        };
        Self::of_operands(&[self], root, rounding.plus(propagated))
    }
}

/// Returns an upper bound of 1/(1 + √(1 − α/x)): ½ + α/2x exceeds it for α ≤ x.
fn root_factor<T: Guardable>(argument: Guarded<T>, least: T::Bound) -> T::Bound {
    T::Bound::of(0.5).plus(argument.error.over(least).shifted(-1))
}

impl<T: Guardable> Add for Guarded<T> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        if self.is_beyond().is_some() || other.is_beyond().is_some() {
            return Self::sum_beyond(self, other);
        }
        let (value, rounding) = self.value.sum(other.value);
        Self::of_operands(&[self, other], value, rounding.plus(self.error).plus(other.error))
    }
}

impl<T: Guardable> Sub for Guarded<T> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<T: Guardable> Neg for Guarded<T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { value: -self.value, error: self.error }
    }
}

impl<T: Guardable> Mul for Guarded<T> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        if self.is_beyond().is_some() || other.is_beyond().is_some() {
            return Self::product_beyond(self, other);
        }
        let (value, rounding) = self.value.product(other.value);
        Self::of_operands(&[self, other], value, rounding.plus(self.error_of_product(other)))
    }
}

impl<T: Guardable> Div for Guarded<T> {
    type Output = Self;
    /// Propagated error: (α + |a/b| β)/(|b| − β).
    #[inline]
    fn div(self, other: Self) -> Self {
        if self.is_beyond().is_some() || other.is_beyond().is_some() {
            return Self::quotient_beyond(self, other);
        }
        let (value, rounding) = self.value.quotient(other.value);
        if !value.size().is_finite() && other.is_exact_zero() {
            return Self::undefined();
        }
        let least = other.value.size_down().minus_down(other.error);
        let propagated = if self.is_exact() && other.is_exact() {
            T::Bound::ZERO
        } else {
            self.error.plus(value.size().plus(rounding).times(other.error)).over(least)
        };
        Self::of_operands(&[self, other], value, rounding.plus(propagated))
    }
}
