//! Bounded lanes as numbers of a kernel; an unknown value is NaN, without a bound.

use super::super::pair::two_product;
use super::super::word::Word;
use super::Bounded;
use crate::{Number, Real};

impl<W: Word> Bounded<W> {
    /// Whether the order of the numbers is known: |a − b| > α + β, or neither has an error.
    #[inline(always)]
    fn is_decided(self, other: Self) -> bool {
        let error = self.error + other.error;
        let distance = (self.value - other.value).magnitude();
        (distance > error + error) | (error == W::literal(0.0))
    }

    /// Selects one of two values by a comparison; if the comparison is undecided, the result has no
    /// bound.
    #[inline(always)]
    fn chosen(decided: bool, holds: bool, then: Self, otherwise: Self) -> Self {
        let value = if holds { then.value } else { otherwise.value };
        let error = if holds { then.error } else { otherwise.error };
        Self { value, error: if decided { error } else { W::infinity() } }
    }

    #[inline(always)]
    fn unknown() -> Self {
        Self { value: W::not_a_number(), error: W::infinity() }
    }
}

/// Functions of one argument, by their names in this module.
macro_rules! functions {
    ($($name:ident: $own:ident;)*) => { $(
        #[inline(always)]
        fn $name(self) -> Self {
            self.$own()
        }
    )* };
}

/// Functions that lanes do not have.
macro_rules! unknown {
    ($($name:ident),*) => { $(
        #[inline(always)]
        fn $name(self) -> Self {
            Self::unknown()
        }
    )* };
}

impl<W: Word> Real for Bounded<W> {
    #[inline(always)]
    fn constant(words: &[f64]) -> Self {
        let word = |position: usize| words.get(position).copied().unwrap_or(0.0);
        let value = W::literal(word(0));
        let rest = W::literal((word(0) - value.to_double() + word(1)).abs());
        Self::raised(value, rest)
    }
    /// Adds an error for a second word of zero, whose remainder may have been lost to underflow.
    #[inline(always)]
    fn number(number: Number<'_>) -> Self {
        let known = Self::constant(number.words());
        Self { error: known.error + W::two_to(W::SMALL), ..known }
    }
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self::constant(&[value])
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        self.value.to_double()
    }

    /// The differences of the products' heads and of their rests are each rounded, as is their sum:
    /// 2 u |v| + 4 u² (|a b| + |c d|) with u = 2^−p, if no rest of a product is lost to underflow.
    #[inline(always)]
    fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self {
        let (left, right) = (two_product(a.value, b.value), two_product(c.value, d.value));
        let value = (left.head - right.head) + (left.tail - right.tail);
        let sizes = left.head.magnitude() + right.head.magnitude();
        let unit = W::two_to(1 - W::PRECISION);
        let rounding = (value.magnitude() + sizes * unit) * unit;
        let propagated = a.error_of_product(b) + c.error_of_product(d);
        let certain = (a.is_zero() | b.is_zero()) & (c.is_zero() | d.is_zero());
        Self::above_underflow(value, rounding + propagated, certain)
    }

    #[inline(always)]
    fn power(self, numerator: i64, denominator: i64) -> Self {
        match (numerator, denominator) {
            (1, 1) => self,
            (2, 1) => self * self,
            (3, 1) => self * self * self,
            (-1, 1) => Self::exact(W::literal(1.0)) / self,
            (1, 2) => self.root(),
            (-1, 2) => Self::exact(W::literal(1.0)) / self.root(),
            (n, d) => self.rational_power(n, d),
        }
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self { value: self.value.magnitude(), error: self.error }
    }

    #[inline(always)]
    fn if_less(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
        Self::chosen(left.is_decided(right), left.value < right.value, then, otherwise)
    }
    #[inline(always)]
    fn if_less_equal(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
        Self::chosen(left.is_decided(right), left.value <= right.value, then, otherwise)
    }
    #[inline(always)]
    fn if_equal(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
        Self::chosen(left.is_decided(right), left.value == right.value, then, otherwise)
    }

    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        self.angle(x)
    }
    functions! {
        sqrt: root;
        sin: sine;
        cos: cosine;
        tan: tangent;
        asin: arc_sine;
        acos: arc_cosine;
        atan: arc_tangent;
        exp: exponential;
        exp_m1: exponential_minus_one;
        ln: logarithm;
        ln_1p: logarithm_of_one_plus;
        sinh: hyperbolic_sine;
        cosh: hyperbolic_cosine;
        tanh: hyperbolic_tangent;
        erf: error_function;
        erfc: complementary_error_function;
    }
    unknown!(expint1, expint2, expint3, dilog, clausen);
    #[inline(always)]
    fn quadrature(_: Self, _: Self, _: impl Fn(Self) -> Self) -> Self {
        Self::unknown()
    }
}
