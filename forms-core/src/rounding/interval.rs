//! Interval arithmetic in `f64` with every endpoint rounded outward.
//!
//! An endpoint that overflows is infinite, and an operation that is not defined everywhere on its
//! operands gives
//! [`Interval::EVERYTHING`]: an interval always contains all possible values.

use crate::expression::{Operation, Relation};
use std::f64::consts::{FRAC_PI_2, PI};

/// Relative error bound assumed for the functions of the standard library.
const FUNCTION: f64 = 1.0 / (1u64 << 51) as f64;

/// Interval of the real numbers from `lower` to `upper`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Interval {
    pub(super) lower: f64,
    pub(super) upper: f64,
}

impl Interval {
    pub(super) const EVERYTHING: Interval = Interval { lower: f64::NEG_INFINITY, upper: f64::INFINITY };
    pub(super) const ZERO: Interval = Interval::point(0.0);

    pub(super) const fn point(value: f64) -> Self {
        Interval { lower: value, upper: value }
    }

    /// Returns the interval between two endpoints, or `EVERYTHING` if an endpoint is NaN.
    pub(super) fn between(lower: f64, upper: f64) -> Self {
        if lower <= upper { Interval { lower, upper } } else { Self::EVERYTHING }
    }

    /// Returns the interval between endpoints that were rounded to nearest, each moved outward to
    /// the next number.
    fn rounded(lower: f64, upper: f64) -> Self {
        Self::between(lower.next_down(), upper.next_up())
    }

    pub(super) fn contains_zero(self) -> bool {
        self.lower <= 0.0 && self.upper >= 0.0
    }

    pub(super) fn is_finite(self) -> bool {
        self.lower.is_finite() && self.upper.is_finite()
    }

    /// Returns max |x|.
    pub(super) fn magnitude(self) -> f64 {
        self.upper.max(-self.lower)
    }

    /// Returns min |x|.
    pub(super) fn least_magnitude(self) -> f64 {
        if self.contains_zero() { 0.0 } else { self.lower.abs().min(self.upper.abs()) }
    }

    pub(super) fn hull(self, other: Self) -> Self {
        Interval { lower: self.lower.min(other.lower), upper: self.upper.max(other.upper) }
    }

    /// Returns an interval of all values that a relative and an absolute perturbation can produce
    /// from these.
    pub(super) fn perturbed(self, relative: f64, absolute: f64) -> Self {
        let by = |end: f64| (end.abs() * relative + absolute).next_up();
        Self::rounded(self.lower - by(self.lower), self.upper + by(self.upper))
    }

    /// Decides a relation: true if it holds for all pairs of members, false if for none, otherwise
    /// `None`.
    pub(super) fn decide(self, relation: Relation, other: Self) -> Option<bool> {
        let (holds, fails) = match relation {
            Relation::Less => (self.upper < other.lower, self.lower >= other.upper),
            Relation::LessEqual => (self.upper <= other.lower, self.lower > other.upper),
            Relation::Greater => (self.lower > other.upper, self.upper <= other.lower),
            Relation::GreaterEqual => (self.lower >= other.upper, self.upper < other.lower),
            Relation::NotEqual => {
                let is_apart = self.upper < other.lower || other.upper < self.lower;
                (is_apart, self == other && self.lower == self.upper)
            }
        };
        (holds || fails).then_some(holds)
    }

    pub(super) fn add(self, other: Self) -> Self {
        Self::rounded(self.lower + other.lower, self.upper + other.upper)
    }

    pub(super) fn negate(self) -> Self {
        Interval { lower: -self.upper, upper: -self.lower }
    }

    pub(super) fn subtract(self, other: Self) -> Self {
        self.add(other.negate())
    }

    /// Returns [min, max] of the products of the endpoints, where 0 · ∞ = 0, since an infinite
    /// endpoint stands for finite numbers.
    pub(super) fn multiply(self, other: Self) -> Self {
        let product = |a: f64, b: f64| if a == 0.0 || b == 0.0 { 0.0 } else { a * b };
        let products = [
            product(self.lower, other.lower),
            product(self.lower, other.upper),
            product(self.upper, other.lower),
            product(self.upper, other.upper),
        ];
        let least = products.iter().copied().fold(f64::INFINITY, f64::min);
        let largest = products.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Self::rounded(least, largest)
    }

    pub(super) fn reciprocal(self) -> Self {
        if self.contains_zero() {
            return Self::EVERYTHING;
        }
        Self::rounded(1.0 / self.upper, 1.0 / self.lower)
    }

    pub(super) fn divide(self, other: Self) -> Self {
        self.multiply(other.reciprocal())
    }

    /// Returns the range of a/(a + b). For a and b of the same sign the quotient increases with |a|
    /// and decreases with |b|.
    pub(super) fn share(self, other: Self) -> Self {
        if self.upper <= 0.0 && other.upper <= 0.0 && self.lower < 0.0 {
            return self.negate().share(other.negate());
        }
        if self.lower < 0.0 || other.lower < 0.0 || self.upper == 0.0 {
            return self.divide(self.add(other));
        }
        let share = |a: f64, b: f64| if a == 0.0 { 0.0 } else { a / (a + b) };
        let (least, largest) = (share(self.lower, other.upper), share(self.upper, other.lower));
        Self::between(least, largest).perturbed(f64::EPSILON, 0.0)
    }

    pub(super) fn sqrt(self) -> Self {
        if self.upper < 0.0 {
            return Self::EVERYTHING;
        }
        // negative numbers have no root and contribute no values
        let root = Self::rounded(self.lower.max(0.0).sqrt(), self.upper.sqrt());
        Interval { lower: root.lower.max(0.0), ..root }
    }

    /// Returns the range of |x|.
    pub(super) fn absolute(self) -> Self {
        Interval { lower: self.least_magnitude(), upper: self.magnitude() }
    }

    /// Returns the range of xⁿ for an integer n ≥ 0; even powers are computed from |x|.
    fn integer_power(self, exponent: u64) -> Self {
        let base = if exponent.is_multiple_of(2) { self.absolute() } else { self };
        let exponent = exponent as f64;
        // powf is accurate to one ulp, which the widening of a function covers
        Self::of_function(base.lower.powf(exponent), base.upper.powf(exponent))
    }

    /// Returns the range of xʳ for r = p/q.
    pub(super) fn power(self, numerator: i64, denominator: i64) -> Self {
        let magnitude = numerator.unsigned_abs();
        let power = if denominator == 1 {
            self.integer_power(magnitude)
        } else {
            let base = self.lower.max(0.0);
            if self.upper < 0.0 {
                return Self::EVERYTHING;
            }
            let exponent = magnitude as f64 / denominator as f64;
            // the rounding error of the exponent is multiplied by the logarithm of the base
            let slack = FUNCTION * (2.0 + magnitude as f64) * 1024.0;
            Self::between(base.powf(exponent), self.upper.powf(exponent)).perturbed(slack, f64::MIN_POSITIVE)
        };
        if numerator < 0 { power.reciprocal() } else { power }
    }

    /// Returns the interval between endpoints computed by a function of the standard library,
    /// widened by its error.
    fn of_function(lower: f64, upper: f64) -> Self {
        Self::between(lower, upper).perturbed(FUNCTION, 0.0)
    }

    fn increasing(self, function: impl Fn(f64) -> f64) -> Self {
        Self::of_function(function(self.lower), function(self.upper))
    }

    fn decreasing(self, function: impl Fn(f64) -> f64) -> Self {
        Self::of_function(function(self.upper), function(self.lower))
    }

    /// Returns the range of a function of the op table.
    pub(super) fn apply(operation: Operation, operands: &[Interval]) -> Self {
        let x = operands[0];
        let value = |x: f64| operation.apply(&[x]);
        match operation {
            Operation::Exp
            | Operation::Expm1
            | Operation::Log
            | Operation::Log1p
            | Operation::Sinh
            | Operation::Tanh
            | Operation::Asin
            | Operation::Atan
            | Operation::Erf
            | Operation::Dilog
            | Operation::Cbrt => x.increasing(value),
            Operation::Acos
            | Operation::Erfc
            | Operation::Expint1
            | Operation::Expint2
            | Operation::Expint3 => x.decreasing(value),
            Operation::Abs => x.absolute(),
            Operation::Cosh => x.absolute().increasing(value),
            Operation::Cos => x.wave(),
            Operation::Sin => x.subtract(Interval::rounded(FRAC_PI_2, FRAC_PI_2)).wave(),
            Operation::Tan => x.tangent(),
            Operation::Atan2 => atan2(x, operands[1]),
            Operation::Hypot => {
                let (x, y) = (x.absolute(), operands[1].absolute());
                let length = |x: f64, y: f64| operation.apply(&[x, y]);
                Interval::of_function(length(x.lower, y.lower), length(x.upper, y.upper))
            }
            // |Cl₂| ≤ Cl₂(π/3) = 1.01494…
            Operation::Clausen => Interval::between(-1.015, 1.015),
        }
    }

    /// Returns the range of the cosine, which reaches ±1 if the interval can contain a multiple of
    /// π.
    fn wave(self) -> Self {
        let everywhere = Interval::between(-1.0, 1.0);
        if self.magnitude() > 1e9 {
            return everywhere;
        }
        // multiples of π in the interval, or so close to it that rounding cannot exclude them
        let wider = self.perturbed(FUNCTION, FUNCTION);
        let (first, last) = ((wider.lower / PI).ceil(), (wider.upper / PI).floor());
        let (a, b) = (self.lower.cos(), self.upper.cos());
        let ends = Self::of_function(a.min(b), a.max(b));
        let turn = Interval::point(if first % 2.0 == 0.0 { 1.0 } else { -1.0 });
        let hull = match last - first {
            inside if inside < 0.0 => ends,
            0.0 => ends.hull(turn),
            _ => everywhere,
        };
        Interval { lower: hull.lower.max(-1.0), upper: hull.upper.min(1.0) }
    }

    /// Returns the range of the tangent, which is bounded only between two poles.
    fn tangent(self) -> Self {
        let branch = |end: f64| ((end + FRAC_PI_2) / PI).floor();
        let is_near_pole = |end: f64| {
            let place = (end + FRAC_PI_2) / PI;
            (place - place.round()).abs() < 1e-9
        };
        let is_within = self.magnitude() < 1e6 && branch(self.lower) == branch(self.upper);
        if is_within && !is_near_pole(self.lower) && !is_near_pole(self.upper) {
            self.increasing(f64::tan)
        } else {
            Self::EVERYTHING
        }
    }
}

/// Returns the range of angles of the points of a box: between the angles of its corners, if the
/// box does not meet the branch cut.
fn atan2(y: Interval, x: Interval) -> Interval {
    if y.contains_zero() && x.lower <= 0.0 {
        return Interval::between(-PI.next_up(), PI.next_up());
    }
    let corners = [(y.lower, x.lower), (y.lower, x.upper), (y.upper, x.lower), (y.upper, x.upper)];
    let angles = corners.map(|(y, x)| y.atan2(x));
    let least = angles.iter().copied().fold(f64::INFINITY, f64::min);
    let largest = angles.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    Interval::of_function(least, largest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_range_contains_the_values_of_its_members(
            ends in (-20.0..20.0_f64, 0.0..5.0_f64),
            others in (-20.0..20.0_f64, 0.0..5.0_f64),
            parts in (0.0..=1.0_f64, 0.0..=1.0_f64),
        ) {
            let x = Interval::between(ends.0, ends.0 + ends.1);
            let y = Interval::between(others.0, others.0 + others.1);
            let member = |interval: Interval, part: f64| {
                (interval.lower + part * (interval.upper - interval.lower)).clamp(interval.lower, interval.upper)
            };
            let (a, b) = (member(x, parts.0), member(y, parts.1));
            let cases = [
                ("add", x.add(y), a + b),
                ("subtract", x.subtract(y), a - b),
                ("multiply", x.multiply(y), a * b),
                ("divide", x.divide(y), a / b),
                ("sqrt", x.sqrt(), a.sqrt()),
                ("cube", x.power(3, 1), a.powi(3)),
                ("inverse square", x.power(-2, 1), a.powi(-2)),
                ("three halves", x.power(3, 2), a.powf(1.5)),
            ];
            for (name, range, value) in cases {
                prop_assert!(
                    value.is_nan() || range.lower <= value && value <= range.upper,
                    "{name} {range:?} {value}"
                );
            }
            for row in crate::expression::TABLE {
                let operands = [x, y];
                let range = Interval::apply(row.operation, &operands[..row.arity]);
                let value = row.operation.apply(&[a, b][..row.arity]);
                prop_assert!(
                    value.is_nan() || range.lower <= value && value <= range.upper,
                    "{} of {x:?}, {y:?}: {range:?}, {value}", row.name
                );
            }
        }
    }
}
