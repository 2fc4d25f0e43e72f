//! +, −, ×, ÷ and √, with relative errors in units of 2⁻¹⁰⁶.
//!
//! Source: M. Joldes, J.-M. Muller, V. Popescu, Tight and rigorous error bounds for basic building blocks of
//! double-word arithmetic, ACM Transactions on Mathematical Software 44 (2017), algorithms 6, 11 and 17.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::DoubleDouble;
use super::ends::is_near_an_end;
use crate::error_free::{fast_two_sum, two_product, two_sum};
use crate::float;

impl DoubleDouble {
    /// Returns high + low, if |high| ≥ |low|.
    #[inline(always)]
    pub(super) const fn ordered(high: f64, low: f64) -> Self {
        let (high, low) = fast_two_sum(high, low);
        Self { high, low }
    }

    #[inline(always)]
    const fn single(high: f64) -> Self {
        Self { high, low: 0.0 }
    }

    /// Adds two numbers, within 3 units.
    #[inline(always)]
    pub(super) const fn plus(self, other: Self) -> Self {
        let (sum, rest) = two_sum(self.high, other.high);
        if !sum.is_finite() {
            return Self::single(sum);
        }
        let (low_sum, low_rest) = two_sum(self.low, other.low);
        let partial = Self::ordered(sum, rest + low_sum);
        Self::ordered(partial.high, low_rest + partial.low)
    }

    /// Adds an `f64`, within 3 units.
    #[inline(always)]
    pub(super) const fn plus_f64(self, other: f64) -> Self {
        let (sum, rest) = two_sum(self.high, other);
        if !sum.is_finite() {
            return Self::single(sum);
        }
        Self::ordered(sum, rest + self.low)
    }

    /// Multiplies, within 7 units.
    #[inline(always)]
    pub(super) const fn times(self, other: Self) -> Self {
        let (product, rest) = two_product(self.high, other.high);
        if is_near_an_end(product) {
            return self.times_near_an_end(other);
        }
        Self::ordered(product, rest + (self.high * other.low + self.low * other.high))
    }

    /// Multiplies by an `f64`, within 4 units.
    #[inline(always)]
    pub(super) const fn times_f64(self, other: f64) -> Self {
        let (product, rest) = two_product(self.high, other);
        if is_near_an_end(product) {
            return self.times_near_an_end(Self::single(other));
        }
        Self::ordered(product, rest + self.low * other)
    }

    /// Divides, within 15 units.
    #[inline(always)]
    pub(super) const fn over(self, other: Self) -> Self {
        let quotient = self.high / other.high;
        if is_near_an_end(quotient) || is_near_an_end(self.high) {
            return self.over_near_an_end(other);
        }
        let product = other.times_f64(quotient);
        let left = (self.high - product.high) + (self.low - product.low);
        Self::ordered(quotient, left / other.high)
    }

    /// Computes the square root, within 4 units.
    #[inline(always)]
    pub(super) fn square_root(self) -> Self {
        if is_near_an_end(self.high) {
            return self.root_near_an_end();
        }
        let root = float::f64::sqrt(self.high);
        let (square, rest) = two_product(root, root);
        Self::ordered(root, ((self.high - square) - rest + self.low) / (2.0 * root))
    }

    /// Negates exactly.
    #[inline(always)]
    pub(super) const fn negated(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }

    /// Multiplies by a power of two, exactly if nothing underflows or overflows.
    #[inline(always)]
    pub(super) const fn by_power_of_two(self, power: f64) -> Self {
        let high = self.high * power;
        if high.is_finite() { Self { high, low: self.low * power } } else { Self::single(high) }
    }
}

impl Add for DoubleDouble {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        self.plus(other)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self.plus(other.negated())
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        self.times(other)
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        self.over(other)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.negated()
    }
}
