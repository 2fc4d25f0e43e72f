//! A lane with an error bound, without branches: the number type of batches with a promised
//! accuracy.
//!
//! A bound is a sum of products of non-negative upper bounds, raised by more than its own
//! roundings. If a rule is valid only in a range, there is no bound beyond it: the bound is ∞ or
//! NaN, and the value is recomputed by [`escalate`](crate::escalate). With α, β the bounds of the
//! arguments' errors:
//!
//! * sums, products, quotients and roots get their rounding error from the operations of
//!   [`pair`](super::pair);
//! * functions of lanes are within 1, 1.5, 2 or 5 ulp, as measured by the tests, and an ulp is at most 2^(1−p) relative;
//! * losses of a bound to underflow are far below 2^[`Word::SMALL`], which is added.

mod functions;
mod real;

use super::pair::{two_product, two_sum};
use super::word::{Lane64, Word};
use crate::{Computation, Formula, Real};
use alloc::vec::Vec;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Number whose exact value is at most `error` away; nothing is known about it if `error` is ∞ or
/// NaN.
#[derive(Clone, Copy)]
pub(crate) struct Bounded<W> {
    value: W,
    error: W,
}

/// Computes the values of a formula, each NaN unless its relative error is at most `units` · 2⁻⁵³.
#[inline(always)]
pub(crate) fn values_within<F: Formula<A, O>, const FMA: bool, const A: usize, const O: usize>(
    arguments: [f64; A],
    units: f64,
) -> [f64; O] {
    let mut lanes = [Bounded::<Lane64<FMA>>::nan(); A];
    for (lane, argument) in lanes.iter_mut().zip(arguments) {
        *lane = Bounded::lane(argument);
    }
    let mut values = [0.0; O];
    for (value, lane) in values.iter_mut().zip(F::value(lanes)) {
        *value = lane.value_within(units);
    }
    values
}

/// Computes a formula that is known only at run time, in lanes with fused multiply-add.
pub(crate) fn in_fused_lanes(
    computation: &impl Computation,
    arguments: &[f64],
) -> Vec<Bounded<Lane64<true>>> {
    let lanes: Vec<_> = arguments.iter().map(|&argument| Bounded::lane(argument)).collect();
    computation.values(&lanes)
}

/// Factors slightly above and slightly below 1, by the maximum number of roundings of a bound.
#[inline(always)]
fn above_one<W: Word>() -> W {
    W::literal(1.0) + W::two_to(8 - W::PRECISION)
}
#[inline(always)]
fn below_one<W: Word>() -> W {
    W::literal(1.0) - W::two_to(8 - W::PRECISION)
}

impl<const FMA: bool> Bounded<Lane64<FMA>> {
    /// Creates a number without error.
    #[inline(always)]
    pub(crate) fn lane(value: f64) -> Self {
        Self::exact(Lane64(value))
    }

    /// Returns the bound of the relative error in units of 2⁻⁵³; ∞ without a bound.
    pub(crate) fn units(self) -> f64 {
        let [value, error] = [self.value.0.abs(), self.error.0];
        let units = error / (below_one::<Lane64<FMA>>().0 * (value - error)) * (1_u64 << 53) as f64;
        if error == 0.0 {
            0.0
        } else if units >= 0.0 {
            units
        } else {
            f64::INFINITY
        }
    }

    /// Returns the value if its error is at most `within` · 2⁻⁵³ of it, otherwise NaN.
    #[inline(always)]
    pub(crate) fn value_within(self, within: f64) -> f64 {
        self.within(Lane64(within) * Lane64::two_to(-53)).0
    }
}

impl<W: Word> Bounded<W> {
    /// Creates a number without error.
    #[inline(always)]
    fn exact(value: W) -> Self {
        Self { value, error: W::literal(0.0) }
    }

    /// Returns the value if its relative error is at most `relative`, otherwise NaN.
    #[inline(always)]
    fn within(self, relative: W) -> W {
        let allowed = relative * below_one() * (self.value.magnitude() - self.error);
        if self.error <= allowed { self.value } else { W::not_a_number() }
    }

    /// Whether this is certainly zero.
    #[inline(always)]
    fn is_zero(self) -> bool {
        (self.value == W::literal(0.0)) & (self.error == W::literal(0.0))
    }

    /// Returns a value with a bound, raised by the few roundings of its computation.
    #[inline(always)]
    fn raised(value: W, error: W) -> Self {
        Self { value, error: error * above_one() }
    }

    /// Returns a value with a raised bound that covers losses to underflow; without error if the
    /// value is `certain`.
    #[inline(always)]
    fn above_underflow(value: W, error: W, certain: bool) -> Self {
        let bound = Self::raised(value, error + W::two_to(W::SMALL));
        Self { value, error: if certain { W::literal(0.0) } else { bound.error } }
    }

    /// Error of a product: α |b| + |a| β + α β.
    #[inline(always)]
    fn error_of_product(self, other: Self) -> W {
        let second = (self.value.magnitude() + self.error) * other.error;
        self.error.fused(other.value.magnitude(), second)
    }
}

/// Returns the magnitude of the remainder of x; ∞ if x is non-zero and so small that bits may be
/// lost to underflow.
#[inline(always)]
fn rest_of<W: Word>(x: W, rest: W) -> W {
    let small = if x == W::literal(0.0) { W::literal(0.0) } else { W::infinity() };
    if x.magnitude() > W::two_to(W::SMALL) { rest.magnitude() } else { small }
}

impl<W: Word> Add for Bounded<W> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let sum = two_sum(self.value, other.value);
        Self::raised(sum.head, sum.tail.magnitude() + (self.error + other.error))
    }
}

impl<W: Word> Sub for Bounded<W> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<W: Word> Neg for Bounded<W> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { value: -self.value, error: self.error }
    }
}

impl<W: Word> Mul for Bounded<W> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let product = two_product(self.value, other.value);
        let error = product.tail.magnitude() + self.error_of_product(other);
        Self::above_underflow(product.head, error, self.is_zero() | other.is_zero())
    }
}

impl<W: Word> Div for Bounded<W> {
    type Output = Self;
    /// (a + α)/(b + β) − q = (a − q b + α − q β)/(b + β)
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        let product = two_product(quotient, other.value);
        let rest = rest_of(self.value, (self.value - product.head) - product.tail);
        let least = other.value.magnitude() * below_one() - other.error;
        let error = (rest + self.error + quotient.magnitude() * other.error) / least;
        let error = if least > W::literal(0.0) { error } else { W::infinity() };
        Self::above_underflow(quotient, error, self.is_zero() & (least > W::literal(0.0)))
    }
}
