//! Number types in which a kernel can be computed.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::Number;

/// Real numbers of some precision; NaN represents undefined values.
///
/// A choice evaluates both of its branches, so that a body is straight-line code and can run in the
/// lanes of a vector. If its sides cannot be compared because one is NaN, its value is NaN.
pub trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// Returns the number c₀ + c₁ + …: each word is the `f64` nearest to the remainder after the
    /// words before it.
    fn constant(words: &[f64]) -> Self;
    /// Returns a number of a formula, with all digits that the type holds.
    #[inline(always)]
    fn number(number: Number<'_>) -> Self {
        Self::constant(number.words())
    }
    /// Returns the number with this value.
    fn from_f64(value: f64) -> Self;
    /// Returns the nearest `f64`.
    fn to_f64(self) -> f64;
    /// Returns NaN, at which no operation is defined.
    fn nan() -> Self {
        Self::from_f64(f64::NAN)
    }

    /// Computes self · factor + summand, with one rounding if the type has an instruction for it.
    #[inline(always)]
    fn mul_add(self, factor: Self, summand: Self) -> Self {
        self * factor + summand
    }
    /// Computes a b − c d without cancellation of its rounding errors: within a few ulp of the
    /// exact value.
    fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self;
    /// Computes a b + c d within a few ulp of the exact value.
    #[inline(always)]
    fn sum_of_products(a: Self, b: Self, c: Self, d: Self) -> Self {
        Self::difference_of_products(a, b, -c, d)
    }

    /// √x
    fn sqrt(self) -> Self;
    /// Computes x^(numerator/denominator) for x > 0, or for x = 0 if the exponent is positive.
    fn power(self, numerator: i64, denominator: i64) -> Self;
    /// |x|
    fn abs(self) -> Self;

    /// Returns `then` if left < right, and `otherwise` if left ≥ right.
    fn if_less(left: Self, right: Self, then: Self, otherwise: Self) -> Self;
    /// Returns `then` if left ≤ right, and `otherwise` if left > right.
    fn if_less_equal(left: Self, right: Self, then: Self, otherwise: Self) -> Self;
    /// Returns `then` if left = right, and `otherwise` if they differ.
    fn if_equal(left: Self, right: Self, then: Self, otherwise: Self) -> Self;

    /// Variant of [`Real::if_less`] for choices that a later step turns into NaN if their sides
    /// cannot be compared; in that case it can return `otherwise`.
    #[inline(always)]
    fn either_if_less(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
        Self::if_less(left, right, then, otherwise)
    }
    /// Variant of [`Real::if_less_equal`] with the same property as [`Real::either_if_less`].
    #[inline(always)]
    fn either_if_less_equal(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
        Self::if_less_equal(left, right, then, otherwise)
    }
    /// Variant of [`Real::if_equal`] with the same property as [`Real::either_if_less`].
    #[inline(always)]
    fn either_if_equal(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
        Self::if_equal(left, right, then, otherwise)
    }

    /// sin x
    fn sin(self) -> Self;
    /// cos x
    fn cos(self) -> Self;
    /// tan x
    fn tan(self) -> Self;
    /// Returns the angle in [−π/2, π/2] with this sine.
    fn asin(self) -> Self;
    /// Returns the angle in [0, π] with this cosine.
    fn acos(self) -> Self;
    /// Returns the angle in (−π/2, π/2) with this tangent.
    fn atan(self) -> Self;
    /// Returns the angle in (−π, π] of the point (x, y), where `self` = y.
    fn atan2(self, x: Self) -> Self;
    /// eˣ
    fn exp(self) -> Self;
    /// eˣ − 1
    fn exp_m1(self) -> Self;
    /// ln x
    fn ln(self) -> Self;
    /// ln(1 + x)
    fn ln_1p(self) -> Self;
    /// sinh x
    fn sinh(self) -> Self;
    /// cosh x
    fn cosh(self) -> Self;
    /// tanh x
    fn tanh(self) -> Self;
    /// erf x = 2/√π ∫₀ˣ e^(−t²) dt
    fn erf(self) -> Self;
    /// E₁(x) = ∫₁^∞ e^(−xt)/t dt, for x > 0
    fn expint1(self) -> Self;
    /// E₂(x) = ∫₁^∞ e^(−xt)/t² dt, for x ≥ 0
    fn expint2(self) -> Self;
    /// E₃(x) = ∫₁^∞ e^(−xt)/t³ dt, for x ≥ 0
    fn expint3(self) -> Self;
    /// Dilogarithm Li₂(x) = −∫₀ˣ ln(1 − t)/t dt, for x ≤ 1
    fn dilog(self) -> Self;
    /// Clausen's function Cl₂(x) = −∫₀ˣ ln|2 sin(t/2)| dt
    fn clausen(self) -> Self;
    /// Complementary error function erfc x = 1 − erf x, with a small relative error for large x
    fn erfc(self) -> Self;
    /// √(x² + y²). The types with the exponents of `f32` and `f64` scale both numbers where a square
    /// would overflow or underflow.
    #[inline(always)]
    fn hypot(self, y: Self) -> Self {
        Self::sum_of_products(self, self, y, y).sqrt()
    }
    /// ∛x for every x: ∛(−x) = −∛x
    #[inline(always)]
    fn cbrt(self) -> Self {
        let (root, zero) = (self.abs().power(1, 3), Self::from_f64(0.0));
        Self::if_less(self, zero, -root, root)
    }
    /// ∫ₐᵇ f(t) dt for an integrand that is analytic between a and b; weak singularities at the
    /// ends are allowed.
    fn quadrature(from: Self, to: Self, integrand: impl Fn(Self) -> Self) -> Self;
}
