//! Special functions: their rounding errors, and the propagation of the error ε of an argument.

use super::functions::rounding_above_zero;
use super::{Bound, Guardable, Guarded};

impl<T: Guardable> Guarded<T> {
    /// |erf′| ≤ 2/√π < 1.13
    pub(super) fn error_function(self) -> Self {
        if let Some(beyond) = self.is_beyond() {
            return beyond.step();
        }
        self.function(self.value.erf(), T::UNITS.special, || self.error.times(T::Bound::of(1.13)))
    }

    /// For x > 0, erfc x > 2/√π e^(−x²)/(x + √(x² + 2)), so that |(ln erfc)′| < 2 x + 1.5; for x ≤ 0,
    /// |erfc′| < 1.13 and erfc x ≥ 1. Thus |erfc(x + δ)/erfc x − 1| ≤ w (1 + w) for w < 1, which is ε
    /// times 2 (|x| + ε) + 1.5.
    pub(super) fn complementary_error_function(self) -> Self {
        if let Some(beyond) = self.is_beyond() {
            return beyond.step_down();
        }
        let value = self.value.erfc();
        let rounding = rounding_above_zero(value, T::UNITS.erfc);
        self.function_rounded(value, rounding, || {
            let one = T::Bound::of(1.0);
            let slope = self.value.size().plus(self.error).shifted(1).plus(T::Bound::of(1.5));
            let change = self.error.times(slope);
            let growth = if change < one { change.times(one.plus(change)) } else { T::Bound::INFINITE };
            value.size().plus(rounding).times(growth)
        })
    }

    /// Eₙ′ = −Eₙ₋₁, and e^(−x) < (x + n) Eₙ(x). Between x − ε and x + ε, with y = x − ε > 0 and e^(−y) ≤ e^(−x)(1 + 2ε):
    /// E₀ = e^(−y)/y, E₁ ≤ e^(−y) ln(1 + 1/y) ≤ e^(−y)/√y, E₂ ≤ e^(−y)/(1 + y) ≤ e^(−y).
    pub(super) fn exponential_integral(self, order: u32) -> Self {
        if let Some(beyond) = self.exponential_beyond() {
            return beyond.exponential_integral();
        }
        if self.value < T::from_f64(0.0) {
            return self.outside(self.value);
        }
        if order == 1 && self.is_exact_zero() {
            return Self::undefined();
        }
        let value = match order {
            1 => self.value.expint1(),
            2 => self.value.expint2(),
            _ => self.value.expint3(),
        };
        let rounding = rounding_above_zero(value, T::UNITS.exponential_integral);
        self.function_rounded(value, rounding, || {
            let (one, least) = (T::Bound::of(1.0), self.least_size());
            if self.error >= one || least.is_zero() {
                return T::Bound::INFINITE;
            }
            let decay =
                value.size().plus(rounding).times(self.value.size().plus(T::Bound::of(f64::from(order))));
            let grown = decay.times(one.plus(self.error.shifted(1))).times(self.error);
            match order {
                1 => grown.over(least),
                2 => grown.over(least.root_down()),
                _ => grown,
            }
        })
    }

    /// Li₂′ = −ln(1 − t)/t increases. Up to ½ it is below 1.4; beyond, with w = 1 − x − ε,
    /// −ln w ≤ 0.75/√w gives 1.5/√w. For t ≤ −1, ln(1 + |t|)/|t| ≤ 1/√|t|.
    pub(super) fn dilogarithm(self) -> Self {
        if self.is_beyond().is_some() {
            return Self::undecided(T::nan());
        }
        let one = Self::exact(T::from_f64(1.0));
        let beyond = self.value - T::from_f64(1.0);
        if beyond > T::from_f64(0.0) {
            return self.outside(beyond);
        }
        self.function(self.value.dilog(), T::UNITS.special, || {
            let limit = T::Bound::of(1.0);
            let least = self.least_size();
            if self.value < T::from_f64(0.0) && least > limit {
                return self.error.over(least.root_down());
            }
            let width = (one - self).least_size().least(limit);
            self.error.times(T::Bound::of(1.5)).over(width.root_down())
        })
    }

    /// Cl₂′ = −ln|2 sin(t/2)| lies between −ln 2 and 1/√m if |2 sin(t/2)| ≥ m, and |2 sin(t/2)|
    /// changes by at most ε.
    pub(super) fn clausen_function(self) -> Self {
        if self.is_beyond().is_some() {
            return Self::undecided(T::nan());
        }
        self.function(self.value.clausen(), T::UNITS.special, || {
            let half = Self { value: self.value.scaled(-1), error: T::Bound::ZERO };
            let least = half.sine().least_size().shifted(1).minus_down(self.error);
            if least.is_zero() {
                return T::Bound::INFINITE;
            }
            self.error.times(T::Bound::of(1.0).most(T::Bound::of(1.0).over(least.root_down())))
        })
    }
}
