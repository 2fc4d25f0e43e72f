//! Guarded numbers as numbers of a kernel; an undecided choice covers the values of both branches.

use super::{Bound, Guardable, Guarded};
use crate::quadrature::{Kind, double_exponential};
use crate::{Number, Real};

impl<T: Guardable> Guarded<T> {
    /// Returns the order of left and right; `None` if the errors leave it undecided.
    fn order(left: Self, right: Self) -> Option<core::cmp::Ordering> {
        if left.is_exact() && right.is_exact() && left.is_beyond().is_none() && right.is_beyond().is_none() {
            return left.value.partial_cmp(&right.value);
        }
        let distance = left - right;
        (distance.value.size_down() > distance.error)
            .then(|| distance.value.partial_cmp(&T::from_f64(0.0)))?
    }

    /// Returns one of two values; its error includes the distance to the other.
    fn either(first: Self, second: Self) -> Self {
        if first.is_undefined() && second.is_undefined() {
            return Self::undefined();
        }
        if first.value.is_nan() || second.value.is_nan() {
            return Self::undecided(T::nan());
        }
        if first.value == second.value && first.is_beyond().is_none() {
            return Self { value: first.value, error: first.error.most(second.error) };
        }
        let (distance, rounding) = first.value.sum(-second.value);
        let error = distance.size().plus(rounding).plus(first.error.most(second.error));
        Self { value: first.value, error }
    }

    fn choice(
        left: Self,
        right: Self,
        then: Self,
        otherwise: Self,
        holds: impl Fn(core::cmp::Ordering) -> bool,
    ) -> Self {
        if left.is_undefined() || right.is_undefined() {
            return Self::undefined();
        }
        if !left.error.is_finite() || !right.error.is_finite() {
            // The result can be undefined.
            return Self::undecided(then.value);
        }
        match Self::order(left, right) {
            Some(order) if holds(order) => then,
            Some(_) => otherwise,
            None => Self::either(then, otherwise),
        }
    }

    /// Returns a node or weight of a quadrature, below one, with its error.
    fn node(value: T) -> Self {
        let logarithm = value.exponent().map_or(0.0, |exponent| exponent.unsigned_abs() as f64 + 1.0);
        Self { value, error: value.rounding(T::UNITS.node + T::UNITS.node_by_logarithm * logarithm) }
    }
}

impl<T: Guardable> Real for Guarded<T> {
    fn constant(words: &[f64]) -> Self {
        let value = T::constant(words);
        let (Some(&first), Some(&last)) = (words.first(), words.last()) else { return Self::exact(value) };
        if words.len() == 1 {
            return Self::exact(T::from_f64(first));
        }
        // Error of the words, and error of the type for these words.
        let beyond = T::Bound::of(last.abs()).shifted(-53);
        Self { value, error: value.rounding(T::UNITS.constant).plus(beyond) }
    }
    fn number(number: Number<'_>) -> Self {
        let (value, error) = T::enclosed(number);
        Self { value, error }
    }
    #[inline]
    fn from_f64(value: f64) -> Self {
        if value.is_nan() { Self::undefined() } else { Self::exact(T::from_f64(value)) }
    }
    #[inline]
    fn to_f64(self) -> f64 {
        self.value.to_f64()
    }
    fn nan() -> Self {
        Self::undefined()
    }
    #[inline]
    fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self {
        if [a, b, c, d].iter().any(|factor| factor.is_beyond().is_some()) {
            return a * b - c * d;
        }
        let (value, rounding) = T::products_difference(a.value, b.value, c.value, d.value);
        let propagated = a.error_of_product(b).plus(c.error_of_product(d));
        Self::of_operands(&[a, b, c, d], value, rounding.plus(propagated))
    }
    #[inline]
    fn sqrt(self) -> Self {
        self.root()
    }
    fn power(self, numerator: i64, denominator: i64) -> Self {
        self.rational_power(numerator, denominator)
    }
    #[inline]
    fn abs(self) -> Self {
        Self { value: self.value.abs(), error: self.error }
    }
    #[inline]
    fn if_less(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
        Self::choice(left, right, then, otherwise, core::cmp::Ordering::is_lt)
    }
    #[inline]
    fn if_less_equal(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
        Self::choice(left, right, then, otherwise, core::cmp::Ordering::is_le)
    }
    #[inline]
    fn if_equal(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
        Self::choice(left, right, then, otherwise, core::cmp::Ordering::is_eq)
    }
    fn sin(self) -> Self {
        self.sine()
    }
    fn cos(self) -> Self {
        self.cosine()
    }
    fn tan(self) -> Self {
        self.tangent()
    }
    fn asin(self) -> Self {
        self.arc_sine()
    }
    fn acos(self) -> Self {
        self.arc_cosine()
    }
    fn atan(self) -> Self {
        self.arc_tangent()
    }
    fn atan2(self, x: Self) -> Self {
        self.angle(x)
    }
    fn exp(self) -> Self {
        self.exponential()
    }
    fn exp_m1(self) -> Self {
        self.exponential_minus_one()
    }
    fn ln(self) -> Self {
        self.logarithm()
    }
    fn ln_1p(self) -> Self {
        self.logarithm_of_one_plus()
    }
    fn sinh(self) -> Self {
        self.hyperbolic_sine()
    }
    fn cosh(self) -> Self {
        self.hyperbolic_cosine()
    }
    fn tanh(self) -> Self {
        self.hyperbolic_tangent()
    }
    fn erf(self) -> Self {
        self.error_function()
    }
    fn erfc(self) -> Self {
        self.complementary_error_function()
    }
    fn expint1(self) -> Self {
        self.exponential_integral(1)
    }
    fn expint2(self) -> Self {
        self.exponential_integral(2)
    }
    fn expint3(self) -> Self {
        self.exponential_integral(3)
    }
    fn dilog(self) -> Self {
        self.dilogarithm()
    }
    fn clausen(self) -> Self {
        self.clausen_function()
    }
    /// The bound covers the sum of the rule; the error of the rule itself is estimated, not
    /// bounded.
    fn quadrature(from: Self, to: Self, integrand: impl Fn(Self) -> Self) -> Self {
        let kind = Kind { of: Self::node, number: |value: Self| value.value, bits: T::PRECISION };
        let (sum, estimate) = double_exponential(from, to, integrand, &kind);
        Self::of_operands(&[sum], sum.value, sum.error.plus(estimate.size()))
    }
}
