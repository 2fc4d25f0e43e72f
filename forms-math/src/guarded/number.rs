//! Rounding errors of each number type: the only module that states error bounds of a type's
//! functions.

use super::Guarded;
use super::bound::{Bound, Magnitude};
use crate::error_free::{difference_in_words, has_exact_rest, two_product, two_sum};
use crate::float::ULPS_OF_ANGLE;
use crate::scalar::Scalar;
use crate::{DoubleDouble, Number, Real, Wide};

/// Relative error bounds of functions, in units of 2^−[`Scalar::PRECISION`].
#[derive(Clone, Copy, Debug)]
pub struct Units {
    /// eˣ, ln, sin, cos, tan and their inverses, eˣ − 1, ln(1 + x)
    pub(super) elementary: f64,
    /// atan2
    pub(super) angle: f64,
    /// sinh, cosh, tanh
    pub(super) hyperbolic: f64,
    /// x^(n/d) with |n|, d ≤ 64
    pub(super) power: f64,
    /// x^(n/d) for larger exponents, times 1 + |n/d ln x|
    pub(super) power_by_logarithm: f64,
    /// erf, Li₂, Cl₂
    pub(super) special: f64,
    /// erfc
    pub(super) erfc: f64,
    /// Eₙ
    pub(super) exponential_integral: f64,
    /// A constant given by its words
    pub(super) constant: f64,
    /// A node or weight of a quadrature
    pub(super) node: f64,
    /// Additional error of a node or weight, times its logarithm to the base 2
    pub(super) node_by_logarithm: f64,
}

/// Number type with error bounds.
pub trait Guardable: Scalar {
    /// Type of the error bounds.
    type Bound: Bound;
    /// Error bounds of its functions.
    const UNITS: Units;
    /// Whether the type has numbers beyond its exponents with a known sign and a lower bound.
    const HAS_BEYOND: bool = false;
    /// Returns a number of this sign with a magnitude of at least 2^`exponent`.
    fn beyond(_negative: bool, _exponent: i64) -> Self {
        Self::nan()
    }
    /// Returns (whether it is negative, e) for such a number.
    #[inline(always)]
    fn is_beyond(self) -> Option<(bool, i64)> {
        None
    }
    /// Returns an upper bound of |x|.
    fn size(self) -> Self::Bound;
    /// Returns a lower bound of |x|.
    fn size_down(self) -> Self::Bound;
    /// Returns a number of a formula and its error bound.
    fn enclosed(number: Number<'_>) -> (Self, Self::Bound);
    /// Returns the error bound of a value that is accurate to this number of units; infinite if the
    /// value is outside the range of validity.
    fn rounding(self, units: f64) -> Self::Bound;
    /// Returns the error bound of a non-zero value that was computed as zero.
    fn underflow(units: f64) -> Self::Bound;
    /// Returns the error of the angle at which sine, cosine and tangent are accurate to their units.
    fn reduction(self) -> Self::Bound {
        Self::Bound::ZERO
    }
    /// Returns the sum and a bound of its rounding error.
    fn sum(self, other: Self) -> (Self, Self::Bound);
    /// Returns the product and a bound of its rounding error.
    fn product(self, other: Self) -> (Self, Self::Bound);
    /// Returns the quotient and a bound of its rounding error.
    fn quotient(self, other: Self) -> (Self, Self::Bound);
    /// Returns the square root of a non-negative number and a bound of its rounding error.
    fn root(self) -> (Self, Self::Bound);
    /// Returns a b − c d and a bound of its rounding error.
    fn products_difference(a: Self, b: Self, c: Self, d: Self) -> (Self, Self::Bound);
}

/// 2⁻¹⁰⁷⁴
const SMALLEST: f64 = f64::from_bits(1);
/// 2⁻¹⁰²¹: from here on, rounding errors are relative.
const NORMAL: f64 = 2.0 * f64::MIN_POSITIVE;

/// 2²⁶: the GNU library reduces larger angles by another method, from 2^26.6 on.
const LARGE_ANGLE: f64 = 67_108_864.0;
/// 2⁻⁸⁰, with a margin for other libraries.
const REDUCTION: f64 = f64::from_bits((1023 - 80) << 52);

/// Error bounds of `f64`. The functions of the standard library are within one ulp, and sinh, cosh,
/// tanh within two, as stated by the C library; those of `libm` are within 0.9 and 2.2 ulp, as
/// measured. An ulp is up to two units. Large angles are excepted, which the GNU library reduces by
/// multiples of π/2 to an absolute error only: at the doubles next to such multiples, sine and cosine
/// of glibc 2.36 are wrong by up to 2⁻⁹². The functions of this crate are measured against `Wide` in
/// its tests. erfc is one exponential, a polynomial and seven operations: at most 9 units, measured
/// 5.5.
impl Guardable for f64 {
    type Bound = f64;
    const UNITS: Units = Units {
        elementary: 2.0,
        angle: 2.0 * ULPS_OF_ANGLE,
        hyperbolic: 6.0,
        power: 6.0,
        power_by_logarithm: 6.0,
        special: 2.0,
        erfc: 10.0,
        exponential_integral: 2.0,
        constant: 1.0,
        node: 1.0,
        node_by_logarithm: 0.0,
    };

    #[inline(always)]
    fn size(self) -> f64 {
        self.abs()
    }
    #[inline(always)]
    fn size_down(self) -> f64 {
        self.abs()
    }
    #[inline(always)]
    fn rounding(self, units: f64) -> f64 {
        let relative = self.abs() * (units * (f64::EPSILON / 2.0 * (1.0 + 4.0 * f64::EPSILON)));
        if self.abs() < NORMAL { relative + units * SMALLEST } else { relative }
    }
    /// The remainder after the second word is below half an ulp of that word.
    fn enclosed(number: Number<'_>) -> (Self, f64) {
        let [value, rest] = *number.words();
        (
            value,
            (rest.abs() * (1.0 + f64::EPSILON)).plus(if value.abs() < NORMAL / f64::EPSILON {
                SMALLEST
            } else {
                0.0
            }),
        )
    }
    fn underflow(units: f64) -> f64 {
        units * SMALLEST
    }
    #[inline(always)]
    fn reduction(self) -> f64 {
        if self.abs() < LARGE_ANGLE || self.is_infinite() { 0.0 } else { REDUCTION }
    }
    #[inline(always)]
    fn sum(self, other: Self) -> (Self, f64) {
        let (sum, rest) = two_sum(self, other);
        (sum, if sum.is_finite() { rest.abs() } else { f64::INFINITY })
    }
    #[inline(always)]
    fn product(self, other: Self) -> (Self, f64) {
        let (product, rest) = two_product(self, other);
        if has_exact_rest(product, self, other) {
            (product, rest.abs())
        } else {
            (product, product.rounding(1.0))
        }
    }
    #[inline(always)]
    fn quotient(self, other: Self) -> (Self, f64) {
        let quotient = self / other;
        let (product, rest) = two_product(quotient, other);
        if self == 0.0 && other != 0.0 {
            (quotient, 0.0)
        } else if quotient.abs() >= NORMAL && has_exact_rest(product, quotient, other) {
            (quotient, ((self - product) - rest).abs().over(other.abs()))
        } else {
            (quotient, quotient.rounding(1.0))
        }
    }
    #[inline(always)]
    fn root(self) -> (Self, f64) {
        let root = self.sqrt();
        let (square, rest) = two_product(root, root);
        // √x − r = (x − r²)/(√x + r)
        let error = if has_exact_rest(square, root, root) {
            ((self - square) - rest).abs().over(root * 1.999)
        } else {
            root.rounding(1.0)
        };
        (root, if self == 0.0 { 0.0 } else { error })
    }
    #[inline(always)]
    fn products_difference(a: Self, b: Self, c: Self, d: Self) -> (Self, f64) {
        if has_exact_rest(a * b, a, b) && has_exact_rest(c * d, c, d) {
            let [value, rest, least] = difference_in_words(a, b, c, d);
            let (value, left) = two_sum(value, rest + least);
            // The last sums of the rests were rounded, with errors of at most an ulp of each.
            let inner = (rest.abs() + least.abs()) * (4.0 * f64::EPSILON);
            return (value, left.abs().plus(inner));
        }
        let value = f64::difference_of_products(a, b, c, d);
        (value, if value.is_finite() { value.rounding(2.0) } else { f64::INFINITY })
    }
}

/// Whether the error bounds of double-double hold: from 2⁻⁹⁰⁰ to 2⁹⁰⁰.
#[inline(always)]
fn in_range(value: f64) -> bool {
    const LEAST: f64 = f64::from_bits((1023 - 900) << 52);
    const MOST: f64 = f64::from_bits((1023 + 900) << 52);
    value == 0.0 || (value.abs() >= LEAST && value.abs() <= MOST)
}

/// Whether the error bounds of double-double hold for a product: a product of numbers other than
/// zero must not be zero.
fn has_product_in_range(a: DoubleDouble, b: DoubleDouble) -> bool {
    let (a, b) = (a.high(), b.high());
    in_range(a * b) && (a * b != 0.0 || a == 0.0 || b == 0.0)
}

impl DoubleDouble {
    /// Returns the result with an error of `units`, if all numbers are in range.
    #[inline(always)]
    fn of_numbers(self, units: f64, numbers: &[Self]) -> (Self, f64) {
        let known =
            numbers.iter().fold(in_range(self.high()), |known, number| known & in_range(number.high()));
        (self, if known { self.rounding(units) } else { f64::INFINITY })
    }

    fn is_power_of_two(self) -> bool {
        self.low() == 0.0 && self.high().to_bits() << 12 == 0
    }
}

/// Error bounds of double-double. The bounds of the sum, product, quotient and root are stated at
/// the operations; the bounds of the functions are measured against `Wide` in the tests and stated
/// with a margin of at least a factor of four.
impl Guardable for DoubleDouble {
    type Bound = f64;
    const UNITS: Units = Units {
        elementary: 32.0,
        angle: 32.0,
        hyperbolic: 64.0,
        power: 1024.0,
        power_by_logarithm: 128.0,
        special: 512.0,
        erfc: 512.0,
        exponential_integral: 512.0,
        constant: 4.0,
        node: 64.0,
        node_by_logarithm: 16.0,
    };

    #[inline(always)]
    fn size(self) -> f64 {
        self.high().abs() * (1.0 + f64::EPSILON)
    }
    #[inline(always)]
    fn size_down(self) -> f64 {
        self.high().abs() * (1.0 - f64::EPSILON)
    }
    fn rounding(self, units: f64) -> f64 {
        // 2⁻¹⁰⁶, times a factor that rounds up the product of three.
        const UNIT: f64 = f64::from_bits((1023 - 106) << 52) * (1.0 + 4.0 * f64::EPSILON);
        if in_range(self.high()) { self.high().abs() * (units * UNIT) } else { f64::INFINITY }
    }
    fn enclosed(number: Number<'_>) -> (Self, f64) {
        let value = Self::number(number);
        (value, value.rounding(Self::UNITS.constant))
    }
    fn underflow(_: f64) -> f64 {
        f64::INFINITY
    }
    fn sum(self, other: Self) -> (Self, f64) {
        let exact = self.low() == 0.0 && other.low() == 0.0;
        (self + other).of_numbers(if exact { 0.0 } else { 3.0 }, &[self, other])
    }
    fn product(self, other: Self) -> (Self, f64) {
        let exact =
            (self.low() == 0.0 && other.low() == 0.0) || self.is_power_of_two() || other.is_power_of_two();
        let product = self * other;
        if product.high() == 0.0 && self.high() != 0.0 && other.high() != 0.0 {
            return (product, f64::INFINITY);
        }
        product.of_numbers(if exact { 0.0 } else { 7.0 }, &[self, other])
    }
    fn quotient(self, other: Self) -> (Self, f64) {
        let exact = other.is_power_of_two() || self.high() == 0.0;
        let quotient = self / other;
        if quotient.high() == 0.0 && self.high() != 0.0 {
            return (quotient, f64::INFINITY);
        }
        quotient.of_numbers(if exact { 0.0 } else { 15.0 }, &[self, other])
    }
    fn root(self) -> (Self, f64) {
        let root = self.sqrt();
        let exact = root.low() == 0.0 && root * root == self;
        root.of_numbers(if exact { 0.0 } else { 4.0 }, &[self])
    }
    fn products_difference(a: Self, b: Self, c: Self, d: Self) -> (Self, f64) {
        let (value, relative) = Self::difference_of_products(a, b, c, d).of_numbers(8.0, &[a, b, c, d]);
        let products = a.size().times(b.size()).plus(c.size().times(d.size()));
        const UNIT: f64 = f64::from_bits((1023 - 156) << 52);
        let known = has_product_in_range(a, b) && has_product_in_range(c, d);
        (value, if known { relative.plus(products * UNIT) } else { f64::INFINITY })
    }
}

/// Error bounds of wide numbers. Sums, products and quotients are rounded to nearest; the functions
/// are within a few ulp, with an eighth of a word of spare bits.
impl<const LIMBS: usize> Guardable for Wide<LIMBS> {
    type Bound = Magnitude;
    const UNITS: Units = Units {
        elementary: 4.0,
        angle: 4.0,
        hyperbolic: 4.0,
        power: 16.0,
        power_by_logarithm: 16.0,
        special: 16.0,
        erfc: 16.0,
        exponential_integral: 16.0,
        constant: 1.0,
        node: 4.0,
        node_by_logarithm: 1.0,
    };

    const HAS_BEYOND: bool = true;
    fn beyond(negative: bool, exponent: i64) -> Self {
        Self::infinite(negative, exponent)
    }
    fn is_beyond(self) -> Option<(bool, i64)> {
        self.least_exponent_of_infinite()
    }
    fn size(self) -> Magnitude {
        match self.exponent() {
            Some(exponent) => Magnitude::new(self.scaled(-exponent).to_f64().abs().next_up(), exponent),
            None if self == Self::from_f64(0.0) => Magnitude::ZERO,
            None => Magnitude::INFINITE,
        }
    }
    fn size_down(self) -> Magnitude {
        match self.exponent() {
            Some(exponent) => Magnitude::new(self.scaled(-exponent).to_f64().abs().next_down(), exponent),
            None => match self.is_beyond() {
                Some((_, exponent)) => Magnitude::new(0.5, exponent + 1),
                None => Magnitude::ZERO,
            },
        }
    }
    fn rounding(self, units: f64) -> Magnitude {
        self.size().times(Magnitude::of(units)).shifted(-i64::from(Self::PRECISION))
    }
    /// Computes the quotient and the power of π, each with its error.
    fn enclosed(number: Number<'_>) -> (Self, Magnitude) {
        let part = |words: &[u64]| {
            let value = Self::from_words(words);
            let rounded = words.len() > LIMBS;
            Guarded { value, error: if rounded { value.rounding(1.0) } else { Magnitude::ZERO } }
        };
        let quotient = part(number.numerator()) / part(number.denominator());
        let value = match i64::from(number.pi_exponent()) {
            0 => quotient,
            exponent => {
                let pi = Self::pi();
                quotient * Guarded { value: pi, error: pi.rounding(1.0) }.rational_power(exponent, 1)
            }
        };
        (if number.is_negative() { -value.value } else { value.value }, value.error)
    }
    /// If eˣ is out of range, it is below 2^(−2⁵⁰).
    fn underflow(_: f64) -> Magnitude {
        Magnitude::new(0.5, -(1 << 49))
    }
    fn sum(self, other: Self) -> (Self, Magnitude) {
        Self::within_half_an_ulp(Wide::sum(self, other))
    }
    fn product(self, other: Self) -> (Self, Magnitude) {
        Self::within_half_an_ulp(Wide::product(self, other))
    }
    fn quotient(self, other: Self) -> (Self, Magnitude) {
        Self::within_half_an_ulp(Wide::quotient(self, other))
    }
    fn root(self) -> (Self, Magnitude) {
        let root = self.sqrt();
        let exact = Wide::product(root, root) == (self, true);
        (root, if exact { Magnitude::ZERO } else { root.rounding(1.0) })
    }
    fn products_difference(a: Self, b: Self, c: Self, d: Self) -> (Self, Magnitude) {
        let ((first, first_error), (second, second_error)) =
            (Guardable::product(a, b), Guardable::product(c, d));
        let (value, error) = Guardable::sum(first, -second);
        (value, error.plus(first_error).plus(second_error))
    }
}

impl<const LIMBS: usize> Wide<LIMBS> {
    fn within_half_an_ulp((value, exact): (Self, bool)) -> (Self, Magnitude) {
        if exact {
            return (value, Magnitude::ZERO);
        }
        // An inexact zero is below the range of the exponents.
        if value == Self::from_f64(0.0) {
            return (value, <Self as Guardable>::underflow(1.0));
        }
        (value, value.size().shifted(-64 * LIMBS as i64))
    }
}
