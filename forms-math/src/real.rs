//! The numbers a kernel can be computed in.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::Number;

/// Real numbers of some precision, with NaN for what is no real number.
///
/// A choice evaluates both of its branches, so that a body is one straight line and can run in the lanes of a vector.
/// Where its sides cannot be compared because one is NaN, its value is NaN.
pub trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// The number c₀ + c₁ + …: each word is the nearest `f64` of what the words before it leave.
    fn constant(words: &[f64]) -> Self;
    /// A number of a formula in all digits that the type holds.
    #[inline(always)]
    fn number(number: Number<'_>) -> Self {
        Self::constant(number.words())
    }
    /// The number of this value.
    fn from_f64(value: f64) -> Self;
    /// The nearest `f64`.
    fn to_f64(self) -> f64;
    /// The value that no operation is defined at.
    fn nan() -> Self {
        Self::from_f64(f64::NAN)
    }

    /// self · factor + summand, with one rounding where the type has that in an instruction.
    #[inline(always)]
    fn mul_add(self, factor: Self, summand: Self) -> Self {
        self * factor + summand
    }
    /// a b − c d without cancellation of its roundings: within a few ulp of the exact value.
    fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self;
    /// a b + c d, likewise.
    #[inline(always)]
    fn sum_of_products(a: Self, b: Self, c: Self, d: Self) -> Self {
        Self::difference_of_products(a, b, -c, d)
    }

    /// √x
    fn sqrt(self) -> Self;
    /// x^(numerator/denominator), of x > 0, or x = 0 where the exponent is positive.
    fn power(self, numerator: i64, denominator: i64) -> Self;
    /// |x|
    fn abs(self) -> Self;

    /// `then` where left < right, `otherwise` where left ≥ right.
    fn if_less(left: Self, right: Self, then: Self, otherwise: Self) -> Self;
    /// `then` where left ≤ right, `otherwise` where left > right.
    fn if_less_equal(left: Self, right: Self, then: Self, otherwise: Self) -> Self;
    /// `then` where left = right, `otherwise` where they differ.
    fn if_equal(left: Self, right: Self, then: Self, otherwise: Self) -> Self;

    /// [`Real::if_less`] for choices that are followed by NaN where their sides cannot be compared: `otherwise` will do there.
    #[inline(always)]
    fn either_if_less(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
        Self::if_less(left, right, then, otherwise)
    }
    /// [`Real::if_less_equal`], likewise.
    #[inline(always)]
    fn either_if_less_equal(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
        Self::if_less_equal(left, right, then, otherwise)
    }
    /// [`Real::if_equal`], likewise.
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
    /// The angle in [−π/2, π/2] of that sine.
    fn asin(self) -> Self;
    /// The angle in [0, π] of that cosine.
    fn acos(self) -> Self;
    /// The angle in (−π/2, π/2) of that tangent.
    fn atan(self) -> Self;
    /// The angle in (−π, π] of the point (x, y), with `self` = y.
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
    /// E₁(x) = ∫₁^∞ e^(−xt)/t dt, of x > 0
    fn expint1(self) -> Self;
    /// E₂(x) = ∫₁^∞ e^(−xt)/t² dt, of x ≥ 0
    fn expint2(self) -> Self;
    /// E₃(x) = ∫₁^∞ e^(−xt)/t³ dt, of x ≥ 0
    fn expint3(self) -> Self;
    /// The dilogarithm Li₂(x) = −∫₀ˣ ln(1 − t)/t dt, of x ≤ 1
    fn dilog(self) -> Self;
    /// Clausen's function Cl₂(x) = −∫₀ˣ ln|2 sin(t/2)| dt
    fn clausen(self) -> Self;
    /// ∫ₐᵇ f(t) dt, of an integrand that is analytic between a and b; it may have weak singularities at the ends.
    fn quadrature(from: Self, to: Self, integrand: impl Fn(Self) -> Self) -> Self;
}
