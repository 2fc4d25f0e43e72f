//! Repetition of a formula in every precision: its code is compiled for each of them.
//!
//! A tape is recorded in storage of the running thread, which only the standard library has.

use alloc::vec;
use alloc::vec::Vec;
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::{Computation, Real};

/// Returns a computation of this number of arguments, and whether an output depends on an integral,
/// whose error is only estimated.
pub(super) fn in_any_precision<C: Computation>(
    computation: &C,
    arguments: usize,
) -> (Repetition<'_, C>, bool) {
    let outputs = computation.values(&vec![Dependence { on_integral: false }; arguments]);
    (Repetition(computation), outputs.iter().any(|output| output.on_integral))
}

/// Computation that is run anew.
pub(super) struct Repetition<'a, C>(&'a C);

impl<C: Computation> Computation for Repetition<'_, C> {
    fn values<T: Real>(&self, arguments: &[T]) -> Vec<T> {
        self.0.values(arguments)
    }
}

/// Number without a value, of which it is known whether it depends on an integral.
#[derive(Clone, Copy)]
struct Dependence {
    on_integral: bool,
}

impl Dependence {
    /// Returns the dependence of a function of these numbers.
    fn of<const N: usize>(numbers: [Self; N]) -> Self {
        Self { on_integral: numbers.iter().any(|number| number.on_integral) }
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident)*) => { $(
        impl $operator for Dependence {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self::of([self, other])
            }
        }
    )* };
}
operators! { Add add Sub sub Mul mul Div div }

impl Neg for Dependence {
    type Output = Self;
    fn neg(self) -> Self {
        self
    }
}

/// Functions of one number.
macro_rules! functions {
    ($($name:ident)*) => { $(
        fn $name(self) -> Self {
            self
        }
    )* };
}

/// Functions of four numbers.
macro_rules! functions_of_four {
    ($($name:ident)*) => { $(
        fn $name(a: Self, b: Self, c: Self, d: Self) -> Self {
            Self::of([a, b, c, d])
        }
    )* };
}

impl Real for Dependence {
    fn constant(_: &[f64]) -> Self {
        Self::of([])
    }
    fn from_f64(_: f64) -> Self {
        Self::of([])
    }
    fn to_f64(self) -> f64 {
        f64::NAN
    }
    fn power(self, _: i64, _: i64) -> Self {
        self
    }
    fn atan2(self, x: Self) -> Self {
        Self::of([self, x])
    }
    functions! {
        sqrt abs sin cos tan asin acos atan exp exp_m1 ln ln_1p sinh cosh tanh
        erf erfc expint1 expint2 expint3 dilog clausen
    }
    functions_of_four! { difference_of_products if_less if_less_equal if_equal }
    fn quadrature(_: Self, _: Self, _: impl Fn(Self) -> Self) -> Self {
        Self { on_integral: true }
    }
}
