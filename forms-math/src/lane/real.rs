//! Lanes as numbers of a kernel.

use super::pair::two_product;
use super::word::Word;
use super::{Lane32, Lane64, error_function, exponential, inverse, logarithm, power, trigonometric};
use crate::Real;

/// Computes a b − c d: the fused operation adds the rounding error of one product (Kahan); without
/// it, the rounding errors of both products are added.
#[inline(always)]
fn difference_of_products<W: Word>(a: W, b: W, c: W, d: W) -> W {
    if W::FUSED {
        let product = c * d;
        return a.fused(b, -product) + (-c).fused(d, product);
    }
    let (left, right) = (two_product(a, b), two_product(c, d));
    (left.head - right.head) + (left.tail - right.tail)
}

/// Functions of one argument, from the modules that compute them.
macro_rules! functions {
    ($($module:ident: $($name:ident),*;)*) => { $($(
        #[inline(always)]
        fn $name(self) -> Self {
            $module::$name(self)
        }
    )*)* };
}

/// Functions that lanes do not have; a batch computes them as single numbers.
macro_rules! unknown {
    ($($name:ident),*) => { $(
        #[inline(always)]
        fn $name(self) -> Self {
            Self::nan()
        }
    )* };
}

macro_rules! real {
    ($lane:ident, $raw:ty) => {
        impl<const FMA: bool> Real for $lane<FMA> {
            #[inline(always)]
            fn constant(words: &[f64]) -> Self {
                words.first().map_or(Self(0.0), |&word| Self(word as $raw))
            }
            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                Self(value as $raw)
            }
            #[inline(always)]
            fn to_f64(self) -> f64 {
                self.0.into()
            }
            #[inline(always)]
            fn mul_add(self, factor: Self, summand: Self) -> Self {
                self.fused(factor, summand)
            }
            #[inline(always)]
            fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self {
                difference_of_products(a, b, c, d)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                self.root()
            }
            #[inline(always)]
            fn power(self, numerator: i64, denominator: i64) -> Self {
                power::power(self, numerator, denominator)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                self.magnitude()
            }
            #[inline(always)]
            fn if_less(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
                let otherwise = if left >= right { otherwise } else { Self::nan() };
                if left < right { then } else { otherwise }
            }
            #[inline(always)]
            fn if_less_equal(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
                let otherwise = if left > right { otherwise } else { Self::nan() };
                if left <= right { then } else { otherwise }
            }
            #[inline(always)]
            fn if_equal(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
                let ordered = left <= right || left >= right;
                let otherwise = if ordered { otherwise } else { Self::nan() };
                if left == right { then } else { otherwise }
            }
            $crate::scalar::either_choices!();
            #[inline(always)]
            fn atan2(self, x: Self) -> Self {
                inverse::atan2(self, x)
            }
            #[inline(always)]
            fn hypot(self, y: Self) -> Self {
                power::hypotenuse(self, y)
            }
            #[inline(always)]
            fn cbrt(self) -> Self {
                power::power(self.magnitude(), 1, 3).with_sign(self)
            }
            functions! {
                trigonometric: sin, cos, tan;
                inverse: asin, acos, atan;
                exponential: exp, exp_m1, sinh, cosh, tanh;
                logarithm: ln, ln_1p;
                error_function: erf, erfc;
            }
            unknown!(expint1, expint2, expint3, dilog, clausen);
            #[inline(always)]
            fn quadrature(_: Self, _: Self, _: impl Fn(Self) -> Self) -> Self {
                Self::nan()
            }
        }
    };
}

real!(Lane64, f64);
real!(Lane32, f32);
