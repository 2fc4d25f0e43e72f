//! Bounds of magnitudes: non-negative numbers, for which every operation rounds to the safe side.

use crate::{error_free, float};

/// Bound of a magnitude: `plus`, `times`, `over` round up; operations whose names end in `down`
/// round down, for lower bounds.
pub trait Bound: Copy + PartialOrd + core::fmt::Debug {
    /// Zero.
    const ZERO: Self;
    /// Infinity: no bound.
    const INFINITE: Self;
    /// Converts a non-negative number.
    fn of(value: f64) -> Self;
    /// Returns the sum.
    fn plus(self, other: Self) -> Self;
    /// Returns the product; infinite if a factor is infinite.
    fn times(self, other: Self) -> Self;
    /// Returns the quotient by a lower bound of the divisor; infinite if that bound is zero.
    fn over(self, least: Self) -> Self;
    /// Returns e with 2^(e − 1) ≤ size < 2^e, for a finite non-zero magnitude.
    fn exponent(self) -> Option<i64>;
    /// self · 2^exponent
    fn shifted(self, exponent: i64) -> Self;
    /// Returns a lower bound of a difference: `self` is a lower bound and `other` an upper bound.
    fn minus_down(self, other: Self) -> Self;
    /// Returns a lower bound of the product of two lower bounds.
    fn times_down(self, other: Self) -> Self;
    /// Returns a lower bound of the root of a lower bound.
    fn root_down(self) -> Self;

    /// Returns size · other_error + (other_size + other_error) · error: the error of a product
    /// caused by the errors of its factors.
    fn of_product(size: Self, error: Self, other_size: Self, other_error: Self) -> Self {
        if error.is_zero() && other_error.is_zero() {
            return Self::ZERO;
        }
        size.times(other_error).plus(other_size.plus(other_error).times(error))
    }

    /// Whether this is zero.
    fn is_zero(self) -> bool {
        self == Self::ZERO
    }
    /// Whether this is a finite bound.
    fn is_finite(self) -> bool {
        self < Self::INFINITE
    }
    /// Returns the smaller bound.
    fn least(self, other: Self) -> Self {
        if other < self { other } else { self }
    }
    /// Returns the larger bound.
    fn most(self, other: Self) -> Self {
        if other > self { other } else { self }
    }
}

/// 1 + 2⁻⁵¹: multiplying by it raises a number that was rounded to nearest above its exact value.
const RAISE: f64 = 1.0 + 2.0 * f64::EPSILON;
/// 2⁻¹⁰⁰⁰
const UNDERFLOW: f64 = f64::from_bits((1023 - 1000) << 52);

#[cold]
fn product_at_the_end_of_the_range(first: f64, second: f64) -> f64 {
    if first == f64::INFINITY || second == f64::INFINITY {
        f64::INFINITY
    } else if first == 0.0 || second == 0.0 {
        0.0
    } else {
        (first * second).next_up()
    }
}

#[cold]
fn quotient_at_the_end_of_the_range(size: f64, least: f64) -> f64 {
    if least <= 0.0 || size == f64::INFINITY {
        f64::INFINITY
    } else if size == 0.0 {
        0.0
    } else {
        (size / least).next_up()
    }
}

impl Bound for f64 {
    const ZERO: Self = 0.0;
    const INFINITE: Self = f64::INFINITY;
    #[inline(always)]
    fn of(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        // A subnormal sum is exact; any other sum that is rounded down is raised by more than its
        // rounding error.
        (self + other) * RAISE
    }
    #[inline(always)]
    fn times(self, other: Self) -> Self {
        let product = self * other;
        if product > UNDERFLOW { product * RAISE } else { product_at_the_end_of_the_range(self, other) }
    }
    #[inline(always)]
    fn over(self, least: Self) -> Self {
        let quotient = self / least;
        if quotient > UNDERFLOW && least > 0.0 {
            quotient * RAISE
        } else {
            quotient_at_the_end_of_the_range(self, least)
        }
    }
    #[inline(always)]
    fn of_product(size: Self, error: Self, other_size: Self, other_error: Self) -> Self {
        if error + other_error == 0.0 {
            return 0.0;
        }
        let sum = size * other_error + (other_size + other_error) * error;
        // Five roundings, each below 2⁻⁵³.
        if sum > UNDERFLOW {
            return sum * (1.0 + 4.0 * f64::EPSILON);
        }
        size.times(other_error).plus(other_size.plus(other_error).times(error))
    }
    fn exponent(self) -> Option<i64> {
        (self > 0.0 && self < f64::INFINITY).then(|| error_free::mantissa_and_exponent(self).1)
    }
    #[inline(always)]
    fn shifted(self, exponent: i64) -> Self {
        let scaled = error_free::scaled(self, exponent);
        if scaled >= f64::MIN_POSITIVE || self == 0.0 { scaled } else { scaled.next_up() }
    }
    #[inline(always)]
    fn minus_down(self, other: Self) -> Self {
        if self > other { (self - other).next_down().max(0.0) } else { 0.0 }
    }
    #[inline(always)]
    fn times_down(self, other: Self) -> Self {
        let product = self * other;
        if product > 0.0 { product.next_down() } else { 0.0 }
    }
    #[inline(always)]
    fn root_down(self) -> Self {
        if self > 0.0 { float::f64::sqrt(self).next_down() } else { 0.0 }
    }
}

/// Bound of any size: m · 2^exponent with ½ ≤ m < 1, or m = 0 or infinite with an exponent of 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Magnitude {
    mantissa: f64,
    exponent: i64,
}

impl Magnitude {
    /// Creates `mantissa` · 2^`exponent`; `mantissa` is positive and in the middle of the range of
    /// `f64`, or infinite.
    #[inline]
    pub(super) fn new(mantissa: f64, exponent: i64) -> Self {
        if mantissa == 0.0 || mantissa == f64::INFINITY {
            return Self { mantissa, exponent: 0 };
        }
        let (mantissa, more) = error_free::mantissa_and_exponent(mantissa);
        Self { mantissa, exponent: exponent.saturating_add(more) }
    }

    /// Returns (m, exponent).
    pub fn parts(self) -> (f64, i64) {
        (self.mantissa, self.exponent)
    }

    /// Returns (larger, smaller scaled to the exponent of the larger).
    fn aligned(self, other: Self) -> (Self, f64) {
        let (large, small) = if self < other { (other, self) } else { (self, other) };
        let shift = small.exponent.saturating_sub(large.exponent).max(-200);
        (large, error_free::scaled(small.mantissa, shift))
    }

    fn is_usual(self) -> bool {
        self.mantissa > 0.0 && self.mantissa < f64::INFINITY
    }
}

impl PartialOrd for Magnitude {
    fn partial_cmp(&self, other: &Self) -> Option<core::cmp::Ordering> {
        if self.is_usual() && other.is_usual() && self.exponent != other.exponent {
            return Some(self.exponent.cmp(&other.exponent));
        }
        self.mantissa.partial_cmp(&other.mantissa)
    }
}

impl Bound for Magnitude {
    const ZERO: Self = Self { mantissa: 0.0, exponent: 0 };
    const INFINITE: Self = Self { mantissa: f64::INFINITY, exponent: 0 };
    fn of(value: f64) -> Self {
        Self::new(value, 0)
    }
    fn plus(self, other: Self) -> Self {
        if !self.is_usual() || !other.is_usual() {
            return self.most(other);
        }
        let (large, small) = self.aligned(other);
        Self::new((large.mantissa + small).next_up(), large.exponent)
    }
    fn times(self, other: Self) -> Self {
        if self.mantissa == f64::INFINITY || other.mantissa == f64::INFINITY {
            return Self::INFINITE;
        }
        if self.mantissa == 0.0 || other.mantissa == 0.0 {
            return Self::ZERO;
        }
        Self::new((self.mantissa * other.mantissa).next_up(), self.exponent.saturating_add(other.exponent))
    }
    fn over(self, least: Self) -> Self {
        if least.mantissa == 0.0 || self.mantissa == f64::INFINITY {
            return Self::INFINITE;
        }
        if self.mantissa == 0.0 {
            return self;
        }
        if least.mantissa == f64::INFINITY {
            return Self::new(0.5, i64::MIN / 4);
        }
        Self::new((self.mantissa / least.mantissa).next_up(), self.exponent.saturating_sub(least.exponent))
    }
    fn exponent(self) -> Option<i64> {
        self.is_usual().then_some(self.exponent)
    }
    fn shifted(self, exponent: i64) -> Self {
        if self.is_usual() { Self { exponent: self.exponent.saturating_add(exponent), ..self } } else { self }
    }
    fn minus_down(self, other: Self) -> Self {
        if self <= other {
            return Self::ZERO;
        }
        if !self.is_usual() || !other.is_usual() {
            return self;
        }
        let (large, small) = self.aligned(other);
        Self::new((large.mantissa - small).next_down().max(0.0), large.exponent)
    }
    fn times_down(self, other: Self) -> Self {
        if !self.is_usual() || !other.is_usual() {
            return Self::ZERO;
        }
        Self::new((self.mantissa * other.mantissa).next_down(), self.exponent.saturating_add(other.exponent))
    }
    fn root_down(self) -> Self {
        if !self.is_usual() {
            return self;
        }
        let odd = self.exponent.rem_euclid(2);
        let root = float::f64::sqrt(error_free::scaled(self.mantissa, odd)).next_down();
        Self::new(root, (self.exponent - odd) / 2)
    }
}
