//! Values of random expressions at special points: exact fractions where possible, and
//! floating-point numbers in addition.

use num_rational::Ratio;
use num_traits::{CheckedAdd, CheckedMul, Signed, Zero};

type Fraction = Ratio<i64>;

/// Relative difference below which floating-point values decide nothing.
const CERTAIN: f64 = 1e-7;

/// Real number, exact if it is known as a fraction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Value {
    exact: Option<Fraction>,
    near: f64,
}

impl Value {
    pub(crate) fn fraction(p: i64, q: i64) -> Self {
        Value::exact(Fraction::new(p, q))
    }

    fn exact(value: Fraction) -> Self {
        Value { exact: Some(value), near: *value.numer() as f64 / *value.denom() as f64 }
    }

    fn near(value: f64) -> Self {
        Value { exact: None, near: value }
    }

    pub(crate) fn add(self, other: Self) -> Self {
        let exact = self.exact.zip(other.exact).and_then(|(a, b)| a.checked_add(&b));
        exact.map_or(Value::near(self.near + other.near), Value::exact)
    }

    pub(crate) fn multiply(self, other: Self) -> Self {
        if self.is_exactly_zero() || other.is_exactly_zero() {
            return Value::fraction(0, 1);
        }
        let exact = self.exact.zip(other.exact).and_then(|(a, b)| a.checked_mul(&b));
        exact.map_or(Value::near(self.near * other.near), Value::exact)
    }

    pub(crate) fn negate(self) -> Self {
        Value { exact: self.exact.map(|value| -value), near: -self.near }
    }

    pub(crate) fn abs(self) -> Self {
        Value { exact: self.exact.map(|value| value.abs()), near: self.near.abs() }
    }

    /// Returns the square root; `None` for a number that is or could be negative.
    pub(crate) fn sqrt(self) -> Option<Self> {
        match self.exact {
            Some(value) if value.is_negative() => None,
            Some(value) => {
                let root = |n: i64| {
                    let root = (n as f64).sqrt().round() as i64;
                    (root.checked_mul(root) == Some(n)).then_some(root)
                };
                let exact = root(*value.numer()).zip(root(*value.denom()));
                Some(exact.map_or(Value::near(self.near.sqrt()), |(p, q)| Value::fraction(p, q)))
            }
            None if self.near > CERTAIN => Some(Value::near(self.near.sqrt())),
            None => None,
        }
    }

    /// Returns e raised to the number, exact for 0.
    pub(crate) fn exp(self) -> Self {
        if self.is_exactly_zero() { Value::fraction(1, 1) } else { Value::near(self.near.exp()) }
    }

    /// Returns the cosine of a multiple of π, exact at the sixths where it is a fraction.
    pub(crate) fn cosine_of_turns(turns: Fraction) -> Self {
        let two = Fraction::from_integer(2);
        let turns = turns - (turns / two).floor() * two;
        let twelfths = turns * Fraction::from_integer(6);
        let known = [
            (0, (1, 1)),
            (2, (1, 2)),
            (3, (0, 1)),
            (4, (-1, 2)),
            (6, (-1, 1)),
            (8, (-1, 2)),
            (9, (0, 1)),
            (10, (1, 2)),
        ];
        let found = known.iter().find(|(at, _)| twelfths == Fraction::from_integer(*at));
        let near = (*turns.numer() as f64 / *turns.denom() as f64 * std::f64::consts::PI).cos();
        found.map_or(Value::near(near), |&(_, (p, q))| Value::fraction(p, q))
    }

    /// Returns a multiple of π, exact for 0.
    pub(crate) fn turns(turns: Fraction) -> Self {
        if turns.is_zero() {
            return Value::fraction(0, 1);
        }
        Value::near(*turns.numer() as f64 / *turns.denom() as f64 * std::f64::consts::PI)
    }

    /// Returns sin(n)/n, and 1 for n = 0; `None` where n could be 0.
    pub(crate) fn mean_of_wave(self) -> Option<Self> {
        if self.is_exactly_zero() {
            return Some(Value::fraction(1, 1));
        }
        (self.near.abs() > CERTAIN).then(|| Value::near(self.near.sin() / self.near))
    }

    /// Returns the sine of a multiple of π.
    pub(crate) fn sine_of_turns(turns: Fraction) -> Self {
        Value::cosine_of_turns(turns - Fraction::new(1, 2))
    }

    /// Whether a ≤ b, where that is certain.
    pub(crate) fn at_most(self, other: Self) -> Option<bool> {
        if let Some((a, b)) = self.exact.zip(other.exact) {
            return Some(a <= b);
        }
        self.is_far_from(other).then_some(self.near < other.near)
    }

    /// Whether two values certainly differ.
    pub(crate) fn differs(self, other: Self) -> bool {
        match self.exact.zip(other.exact) {
            Some((a, b)) => a != b,
            None => self.is_far_from(other),
        }
    }

    fn is_far_from(self, other: Self) -> bool {
        (self.near - other.near).abs() > CERTAIN * (1.0 + self.near.abs() + other.near.abs())
    }

    fn is_exactly_zero(self) -> bool {
        self.exact.is_some_and(|value| value.is_zero())
    }
}
