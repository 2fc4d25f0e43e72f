//! Elementary functions: their rounding errors, and the propagation of the error ε of an argument.
//!
//! Every bound holds for all δ with |δ| ≤ ε and is stated above the line that computes it: by an
//! addition theorem if there is one, else by the largest derivative between x − ε and x + ε.

use super::{Bound, Guardable, Guarded};
use crate::elementary::LARGEST_BY_SQUARING;

impl<T: Guardable> Guarded<T> {
    /// Returns f(x) with a rounding error of `units` and the `propagated` error of the argument.
    pub(super) fn function(self, value: T, units: f64, propagated: impl FnOnce() -> T::Bound) -> Self {
        self.function_rounded(value, Self::rounding_of(self, value, units), propagated)
    }

    /// Returns f(x) with a known rounding error and the propagated error of the argument.
    pub(super) fn function_rounded(
        self,
        value: T,
        rounding: T::Bound,
        propagated: impl FnOnce() -> T::Bound,
    ) -> Self {
        if self.is_undefined() || (value.is_nan() && self.is_exact()) {
            return Self::undefined();
        }
        if value.is_nan() || !value.size().is_finite() || !self.error.is_finite() {
            return Self::undecided(value);
        }
        let error = if self.is_exact() { rounding } else { rounding.plus(propagated()) };
        Self { value, error }
    }

    /// Returns the rounding error. A function that vanishes at 0 or 1 has none there; any other
    /// zero has underflowed.
    fn rounding_of(self, value: T, units: f64) -> T::Bound {
        let zero = T::from_f64(0.0);
        let vanishes = self.value == zero || self.value == T::from_f64(1.0);
        if value == zero && self.is_exact() && vanishes {
            T::Bound::ZERO
        } else {
            rounding_above_zero(value, units)
        }
    }

    /// Returns an undefined result if the argument is certainly this far outside the domain, else a
    /// result without a bound.
    pub(super) fn outside(self, by: T) -> Self {
        let sure = !by.is_nan() && by.size_down() > self.error;
        if sure { Self::undefined() } else { Self::undecided(T::nan()) }
    }

    /// Returns a lower bound of |x|.
    pub(super) fn least_size(self) -> T::Bound {
        self.value.size_down().minus_down(self.error)
    }

    /// |e^δ − 1| ≤ ε (1 + ε) for ε < 1
    pub(super) fn growth(self) -> T::Bound {
        let one = T::Bound::of(1.0);
        if self.error < one { self.error.times(one.plus(self.error)) } else { T::Bound::INFINITE }
    }

    /// e^(x + δ) − e^x = e^x (e^δ − 1)
    pub(super) fn exponential(self) -> Self {
        if let Some(beyond) = self.exponential_beyond() {
            return beyond.exponential(0.0);
        }
        let value = self.value.exp();
        let rounding = rounding_above_zero(value, T::UNITS.elementary);
        self.function_rounded(value, rounding, || value.size().plus(rounding).times(self.growth()))
    }

    /// Uses the same difference, with e^x ≤ |e^x − 1| + 1.
    pub(super) fn exponential_minus_one(self) -> Self {
        if let Some(beyond) = self.exponential_beyond() {
            return beyond.exponential(-1.0);
        }
        let value = self.value.exp_m1();
        self.function(value, T::UNITS.elementary, || {
            value.size().shifted(1).plus(T::Bound::of(1.0)).times(self.growth())
        })
    }

    /// |ln(1 + δ/x)| ≤ ε/(x − ε)
    pub(super) fn logarithm(self) -> Self {
        if let Some(beyond) = self.is_beyond() {
            return beyond.logarithm();
        }
        if self.is_exact_zero() {
            return Self::undefined();
        }
        if self.value < T::from_f64(0.0) {
            return self.outside(self.value);
        }
        let value = self.value.ln();
        self.function(value, T::UNITS.elementary, || self.error.over(self.least_size()))
    }

    /// Uses the same bound, with 1 + x.
    pub(super) fn logarithm_of_one_plus(self) -> Self {
        if let Some(beyond) = self.is_beyond() {
            return beyond.logarithm();
        }
        let shifted = Self::exact(T::from_f64(1.0)) + self;
        if shifted.is_exact_zero() {
            return Self::undefined();
        }
        if shifted.value < T::from_f64(0.0) {
            return self.outside(shifted.value);
        }
        let value = self.value.ln_1p();
        self.function(value, T::UNITS.elementary, || self.error.over(shifted.least_size()))
    }

    /// Returns the angle with the error of its reduction.
    fn reduced(self) -> Self {
        Self { error: self.error.plus(self.value.reduction()), ..self }
    }

    /// |sin(x + δ) − sin x| ≤ ε
    pub(super) fn sine(self) -> Self {
        if let Some(beyond) = self.is_beyond() {
            return beyond.oscillation();
        }
        let angle = self.reduced();
        angle.function(self.value.sin(), T::UNITS.elementary, || angle.error)
    }

    /// |cos(x + δ) − cos x| ≤ ε
    pub(super) fn cosine(self) -> Self {
        if let Some(beyond) = self.is_beyond() {
            return beyond.oscillation();
        }
        let angle = self.reduced();
        angle.function(self.value.cos(), T::UNITS.elementary, || angle.error)
    }

    /// tan(x + δ) − tan x = (1 + t²) tan δ/(1 − t tan δ), t = tan x, tan ε ≤ ε (1 + ε²) for ε < 1
    pub(super) fn tangent(self) -> Self {
        if self.is_beyond().is_some() {
            return Self::undecided(T::nan());
        }
        let (value, angle) = (self.value.tan(), self.reduced());
        angle.function(value, T::UNITS.elementary, || {
            let one = T::Bound::of(1.0);
            if angle.error >= one {
                return T::Bound::INFINITE;
            }
            let size = value.size().plus(value.rounding(T::UNITS.elementary));
            let step = angle.error.times(one.plus(angle.error.times(angle.error)));
            one.plus(size.times(size)).times(step).over(one.minus_down(size.times(step)))
        })
    }

    /// ε/√(1 − |x| − ε): above the derivative at the end nearer to 1
    fn error_of_arc(self) -> T::Bound {
        let one = Self::exact(T::from_f64(1.0));
        let size = Self { value: self.value.abs(), error: self.error };
        let inner = (one - size).least_size();
        self.error.over(inner.root_down())
    }

    fn arc(self, value: T) -> Self {
        let beyond = self.value.abs() - T::from_f64(1.0);
        if beyond > T::from_f64(0.0) {
            return self.outside(beyond);
        }
        self.function(value, T::UNITS.elementary, || self.error_of_arc())
    }

    /// Computes the arc sine.
    pub(super) fn arc_sine(self) -> Self {
        if let Some(beyond) = self.is_beyond() {
            return beyond.outside_of_one();
        }
        self.arc(self.value.asin())
    }

    /// Computes the arc cosine.
    pub(super) fn arc_cosine(self) -> Self {
        if let Some(beyond) = self.is_beyond() {
            return beyond.outside_of_one();
        }
        self.arc(self.value.acos())
    }

    /// ε/(1 + (|x| − ε)²)
    pub(super) fn arc_tangent(self) -> Self {
        if let Some(beyond) = self.is_beyond() {
            return beyond.arc_tangent();
        }
        self.function(self.value.atan(), T::UNITS.elementary, || {
            let least = self.least_size();
            // 1 + m² ≥ the larger of 1 and m²
            self.error.over(T::Bound::of(1.0).most(least.times_down(least)))
        })
    }

    /// Bounds the angle between (x, y) and (x + ξ, y + η). With |y|, |x| ≤ p m, q m and
    /// max(|x|, |y|) ≥ m > 0, its tangent is
    /// |x η − y ξ|/(x² + y² + x ξ + y η) ≤ (q η + p ξ)/(m − ξ − η),
    /// if the sign of y is certain to the left of the origin.
    pub(super) fn angle(self, x: Self) -> Self {
        if self.is_beyond().is_some() || x.is_beyond().is_some() {
            return Self::angle_beyond(self, x);
        }
        let (y, zero) = (self, T::from_f64(0.0));
        // Zeros are unsigned here, independent of the type.
        let unsigned = |value: T| if value == zero { zero } else { value };
        let value = unsigned(y.value).atan2(unsigned(x.value));
        if y.is_undefined() || x.is_undefined() {
            return Self::undefined();
        }
        let certain_side = (x.value > zero && x.value.size_down() > x.error) || y.is_exact();
        let certain_sign = y.value.size_down() > y.error || y.is_exact();
        let certain_axis = y.value != zero || x.value.size_down() > x.error || x.is_exact();
        if value.is_nan() || !certain_axis || !(certain_side || certain_sign) {
            return Self::undecided(value);
        }
        let rounding = if value == zero && y.value == zero {
            T::Bound::ZERO
        } else {
            rounding_above_zero(value, T::UNITS.angle)
        };
        if y.is_exact() && x.is_exact() {
            return Self { value, error: rounding };
        }
        let larger = x.value.size_down().most(y.value.size_down());
        let part = |side: T| side.size().over(larger);
        let across = part(x.value).times(y.error).plus(part(y.value).times(x.error));
        let along = larger.minus_down(x.error.plus(y.error));
        Self { value, error: rounding.plus(across.over(along)) }
    }

    /// sinh(x + δ) − sinh x: cosh(|x| + ε) ε ≤ (|sinh x| + 1)(1 + 2ε) ε for ε < 1
    pub(super) fn hyperbolic_sine(self) -> Self {
        if let Some(beyond) = self.exponential_beyond() {
            return beyond.hyperbolic(beyond.is_negative());
        }
        let value = self.value.sinh();
        self.function(value, T::UNITS.hyperbolic, || {
            value.size().shifted(1).plus(T::Bound::of(1.0)).times(self.growth().shifted(1))
        })
    }

    /// Uses the same bound, with sinh(|x| + ε) ≤ cosh x (1 + 2ε).
    pub(super) fn hyperbolic_cosine(self) -> Self {
        if let Some(beyond) = self.exponential_beyond() {
            return beyond.hyperbolic(false);
        }
        let value = self.value.cosh();
        self.function(value, T::UNITS.hyperbolic, || value.size().shifted(1).times(self.growth().shifted(1)))
    }

    /// |tanh(x + δ) − tanh x| ≤ ε
    pub(super) fn hyperbolic_tangent(self) -> Self {
        if let Some(beyond) = self.exponential_beyond() {
            return beyond.step();
        }
        self.function(self.value.tanh(), T::UNITS.hyperbolic, || self.error)
    }

    /// |(1 + δ/x)^p − 1| ≤ e^z − 1 ≤ z (1 + z) for z = |p| ε/(|x| − ε) < 1
    pub(super) fn rational_power(self, numerator: i64, denominator: i64) -> Self {
        if let Some(beyond) = self.is_beyond() {
            return beyond.power(numerator, denominator);
        }
        let one = T::Bound::of(1.0);
        let negative = self.value < T::from_f64(0.0);
        match (numerator, denominator) {
            (0, _) => return Self::exact(T::from_f64(1.0)),
            (1, 1) => return self,
            (2, 1) => return self * self,
            (1, 2) => return self.root(),
            (-1, 1) => return Self::exact(T::from_f64(1.0)) / self,
            (n, _) if n < 0 && self.is_exact_zero() => return Self::undefined(),
            (_, d) if negative && d != 1 => return self.outside(self.value),
            _ => (),
        }
        let value = self.value.power(numerator, denominator);
        let rounding = if self.is_exact() && self.value == T::from_f64(0.0) {
            T::Bound::ZERO
        } else {
            rounding_above_zero(value, self.units_of_power(numerator, denominator))
        };
        self.function_rounded(value, rounding, || {
            let ratio = T::Bound::of((numerator as f64 / denominator as f64).abs().next_up());
            let exponent = ratio.times(self.error.over(self.least_size()));
            if exponent < one {
                value.size().plus(rounding).times(exponent.times(one.plus(exponent)))
            } else {
                T::Bound::INFINITE
            }
        })
    }

    fn units_of_power(self, numerator: i64, denominator: i64) -> f64 {
        if numerator.unsigned_abs() <= LARGEST_BY_SQUARING
            && denominator.unsigned_abs() <= LARGEST_BY_SQUARING
        {
            return T::UNITS.power;
        }
        let exponent = (numerator as f64 / denominator as f64).abs();
        // |ln x| ≤ ln 2 (|e| + 1) for x = m 2ᵉ
        let logarithm = self.value.exponent().map_or(0.0, |exponent| exponent.unsigned_abs() as f64 + 1.0);
        T::UNITS.power_by_logarithm * (1.0 + exponent * logarithm)
    }
}

/// Returns the rounding error of a function that is never zero: a zero has underflowed.
pub(super) fn rounding_above_zero<T: Guardable>(value: T, units: f64) -> T::Bound {
    if value == T::from_f64(0.0) { T::underflow(units) } else { value.rounding(units) }
}
