//! Functions of bounded lanes: rounding errors as measured by the tests, and the propagation of the error α of the
//! argument, for all δ with |δ| ≤ α.

use super::super::pair::two_product;
use super::super::word::Word;
use super::super::{error_function, exponential, inverse, logarithm, power, trigonometric};
use super::{Bounded, below_one, rest_of};

/// Errors of functions in units of 2^−p: an ulp is up to two units.
const ONE_ULP: f64 = 2.0;
const THREE_HALVES: f64 = 3.0;
const TWO_ULPS: f64 = 4.0;
const FIVE_ULPS: f64 = 10.0;

impl<W: Word> Bounded<W> {
    /// Returns a function's value with its rounding error, in units of 2^−p, and the propagated error
    /// of the argument.
    #[inline(always)]
    fn function(value: W, units: f64, propagated: W) -> Self {
        let rounding = value.magnitude() * (W::literal(units) * W::two_to(-W::PRECISION));
        Self::above_underflow(value, rounding + propagated, false)
    }

    /// |e^δ − 1| ≤ α (1 + α) for α < 1
    #[inline(always)]
    fn growth(self) -> W {
        let one = W::literal(1.0);
        let growth = self.error * (one + self.error);
        if self.error < one { growth } else { W::infinity() }
    }

    /// Computes α/least for a positive lower bound; zero if α is zero.
    #[inline(always)]
    fn error_over(self, least: W) -> W {
        let zero = W::literal(0.0);
        let quotient = if least > zero { self.error / least } else { W::infinity() };
        if self.error == zero { zero } else { quotient }
    }

    /// √(x + δ) − r = (x − r² + δ)/(√(x + δ) + r)
    #[inline(always)]
    pub(super) fn root(self) -> Self {
        let root = self.value.root();
        let square = two_product(root, root);
        let rest = rest_of(self.value, (self.value - square.head) - square.tail);
        let error = (rest + self.error) / root;
        let inside = self.value * below_one() >= self.error;
        let error = if inside { error } else { W::infinity() };
        Self::above_underflow(root, error, self.is_zero())
    }

    /// |(1 + δ/x)^p − 1| ≤ w (1 + w) for w = |p| α/(|x| − α) < 1
    #[inline(always)]
    pub(super) fn rational_power(self, numerator: i64, denominator: i64) -> Self {
        let value = power::power(self.value, numerator, denominator);
        let exponent = W::literal((numerator as f64 / denominator as f64).abs());
        let one = W::literal(1.0);
        let change = exponent * self.error_over(self.value.magnitude() * below_one() - self.error);
        let growth = if change < one { change * (one + change) } else { W::infinity() };
        let sure = self.error == W::literal(0.0);
        Self::function(value, TWO_ULPS, if sure { W::literal(0.0) } else { value.magnitude() * growth })
    }

    /// |sin′|, |cos′| ≤ 1
    #[inline(always)]
    pub(super) fn sine(self) -> Self {
        Self::function(trigonometric::sin(self.value), ONE_ULP, self.error)
    }
    #[inline(always)]
    pub(super) fn cosine(self) -> Self {
        Self::function(trigonometric::cos(self.value), ONE_ULP, self.error)
    }
    /// tan(x + δ) − t = (1 + t²) tan δ/(1 − t tan δ), with tan α ≤ 1.1 α and t tan α ≤ 1/8
    #[inline(always)]
    pub(super) fn tangent(self) -> Self {
        let t = trigonometric::tan(self.value);
        let step = self.error * W::literal(1.1);
        let size = W::literal(1.0) + t.magnitude();
        let error = size * size * step * W::literal(1.2);
        let small = size * step <= W::literal(0.125);
        Self::function(t, TWO_ULPS, if small { error } else { W::infinity() })
    }

    /// |arcsin′| ≤ 1/√(1 − |x| − α) up to |x| + α
    #[inline(always)]
    fn error_of_arc(self) -> W {
        let inner = (W::literal(1.0) - W::two_to(1 - W::PRECISION)) - self.value.magnitude() - self.error;
        self.error_over((inner * below_one()).root() * below_one())
    }
    #[inline(always)]
    pub(super) fn arc_sine(self) -> Self {
        Self::function(inverse::asin(self.value), ONE_ULP, self.error_of_arc())
    }
    #[inline(always)]
    pub(super) fn arc_cosine(self) -> Self {
        Self::function(inverse::acos(self.value), ONE_ULP, self.error_of_arc())
    }
    #[inline(always)]
    pub(super) fn arc_tangent(self) -> Self {
        Self::function(inverse::atan(self.value), THREE_HALVES, self.error)
    }
    /// Computes the angle of a point. A point at the distance r that moves by d ≤ r/2 turns by at
    /// most arcsin(d/r) ≤ 1.1 d/r, but the angle jumps where the point can cross the negative axis.
    #[inline(always)]
    pub(super) fn angle(self, x: Self) -> Self {
        let (height, width) = (self.value.magnitude(), x.value.magnitude());
        let distance = if height > width { height } else { width };
        let moved = self.error + x.error;
        let zero = W::literal(0.0);
        let turn = if moved == zero { zero } else { moved * W::literal(1.2) / distance };
        let passes = (self.error >= height) & (self.error > zero) & (x.value <= x.error);
        let far = (moved + moved > distance) | passes;
        let certain = (moved == zero) & (self.value == zero) & (x.value > zero);
        let value = inverse::atan2(self.value, x.value);
        let bound = Self::function(value, THREE_HALVES, if far { W::infinity() } else { turn });
        Self { value, error: if certain { zero } else { bound.error } }
    }

    /// e^(x + δ) − eˣ = eˣ (e^δ − 1)
    #[inline(always)]
    pub(super) fn exponential(self) -> Self {
        let value = exponential::exp(self.value);
        Self::function(value, ONE_ULP, value.magnitude() * self.growth() * W::literal(1.1))
    }
    #[inline(always)]
    pub(super) fn exponential_minus_one(self) -> Self {
        let value = exponential::exp_m1(self.value);
        Self::function(
            value,
            THREE_HALVES,
            (value.magnitude() + W::literal(1.0)) * self.growth() * W::literal(1.1),
        )
    }
    /// cosh(|x| + α) α ≤ (|sinh x| + 1) e^α α
    #[inline(always)]
    pub(super) fn hyperbolic_sine(self) -> Self {
        let value = exponential::sinh(self.value);
        let small = self.error <= W::literal(0.125);
        let error = (value.magnitude() + W::literal(1.0)) * self.error * W::literal(1.2);
        Self::function(value, ONE_ULP, if small { error } else { W::infinity() })
    }
    /// sinh(|x| + α) α ≤ cosh x e^α α
    #[inline(always)]
    pub(super) fn hyperbolic_cosine(self) -> Self {
        let value = exponential::cosh(self.value);
        let small = self.error <= W::literal(0.125);
        Self::function(
            value,
            ONE_ULP,
            if small { value * self.error * W::literal(1.2) } else { W::infinity() },
        )
    }
    #[inline(always)]
    pub(super) fn hyperbolic_tangent(self) -> Self {
        Self::function(exponential::tanh(self.value), ONE_ULP, self.error)
    }

    /// |ln(1 + δ/x)| ≤ α/(x − α)
    #[inline(always)]
    pub(super) fn logarithm(self) -> Self {
        Self::function(
            logarithm::ln(self.value),
            ONE_ULP,
            self.error_over(self.value * below_one() - self.error),
        )
    }
    #[inline(always)]
    pub(super) fn logarithm_of_one_plus(self) -> Self {
        let least = (W::literal(1.0) + self.value) * below_one() - self.error;
        Self::function(logarithm::ln_1p(self.value), ONE_ULP, self.error_over(least))
    }

    /// |erf′| ≤ 2/√π
    #[inline(always)]
    pub(super) fn error_function(self) -> Self {
        Self::function(error_function::erf(self.value), TWO_ULPS, self.error * W::literal(1.13))
    }

    /// |erfc′| ≤ 2/√π. For x > 0 and 2 x α ≤ ⅛ it is at most 1.2 (2 x + 1.5) erfc x between x − α and x + α,
    /// since erfc x > 2/√π e^(−x²)/(x + √(x² + 2)).
    #[inline(always)]
    pub(super) fn complementary_error_function(self) -> Self {
        let value = error_function::erfc(self.value);
        let twice = self.value + self.value;
        let falls = (twice > W::literal(0.0)) & (twice * self.error <= W::literal(0.125));
        let relative = W::literal(1.2) * (twice + W::literal(1.5)) * value;
        let slope = if falls { relative } else { W::literal(1.13) };
        Self::function(value, FIVE_ULPS, self.error * slope)
    }
}
