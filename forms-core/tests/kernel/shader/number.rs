//! Numbers of the interpreter of WGSL: the nearest value, and a bound that holds on every device.

use super::Value;
use naga::BinaryOperator;

/// Largest relative error of a correctly rounded operation: WGSL leaves the direction open.
const ROUNDING: f64 = f32::EPSILON as f64;

/// `f32` of a device.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Float {
    /// Value on a device that rounds to nearest.
    pub(crate) nearest: f32,
    /// Value without rounding, apart from that of `f64`.
    pub(crate) exact: f64,
    /// Bound of the distance between `exact` and the value on any device.
    pub(crate) error: f64,
}

impl Float {
    pub(crate) fn exactly(number: f32) -> Float {
        Float { nearest: number, exact: number.into(), error: 0.0 }
    }

    /// Value of a function for which WGSL states no relative error.
    pub(super) fn unbounded(value: f64) -> Float {
        Float { nearest: value as f32, exact: value, error: f64::INFINITY }
    }

    pub(super) fn negate(self) -> Float {
        Float { nearest: -self.nearest, exact: -self.exact, error: self.error }
    }

    /// Returns a value that inherits an error and is rounded, unless it is certain and an `f32`.
    fn rounded(nearest: f32, exact: f64, inherited: f64, is_exact: bool) -> Float {
        let is_certain = is_exact && inherited == 0.0 && f64::from(exact as f32) == exact;
        let error = if is_certain { 0.0 } else { inherited + ROUNDING * (exact.abs() + inherited) };
        Float { nearest, exact, error }
    }

    pub(super) fn add(self, other: Float) -> Float {
        let exact = self.exact + other.exact;
        // Knuth's two-sum: whether the sum of `f64`s was rounded
        let part = exact - self.exact;
        let rest = (self.exact - (exact - part)) + (other.exact - part);
        Self::rounded(self.nearest + other.nearest, exact, self.error + other.error, rest == 0.0)
    }

    pub(super) fn multiply(self, other: Float) -> Float {
        let inherited =
            self.exact.abs() * other.error + other.exact.abs() * self.error + self.error * other.error;
        // the product of two `f32`s is an `f64`
        Self::rounded(self.nearest * other.nearest, self.exact * other.exact, inherited, true)
    }

    pub(super) fn divide(self, other: Float) -> Float {
        let exact = self.exact / other.exact;
        let inherited = (self.error + exact.abs() * other.error) / (other.exact.abs() - other.error);
        let error = inherited + 2.5 * ROUNDING * (exact.abs() + inherited);
        Float { nearest: self.nearest / other.nearest, exact, error }
    }

    /// a b + c, whose accuracy is inherited from a product and a sum.
    pub(super) fn fused(self, factor: Float, summand: Float) -> Float {
        let nearest = self.nearest.mul_add(factor.nearest, summand.nearest);
        Float { nearest, ..self.multiply(factor).add(summand) }
    }

    /// √a, inherited from 1/inverseSqrt(a) with an error of 2 ulp.
    pub(super) fn sqrt(self) -> Float {
        let exact = self.exact.sqrt();
        let inherited = self.error / exact;
        let error = inherited + 5.0 * ROUNDING * (exact + inherited);
        Float { nearest: self.nearest.sqrt(), exact, error }
    }

    /// eᵃ, with an error of 3 + 2|a| ulp.
    pub(super) fn exp(self) -> Float {
        let exact = self.exact.exp();
        let inherited = exact * self.error.exp_m1();
        let error = inherited + (3.0 + 2.0 * self.exact.abs()) * ROUNDING * (exact + inherited);
        Float { nearest: exact as f32, exact, error }
    }

    /// log a, with an absolute error of 2⁻²¹ between 1/2 and 2, and of 3 ulp elsewhere.
    pub(super) fn log(self) -> Float {
        let exact = self.exact.ln();
        let inherited = self.error / (self.exact - self.error);
        let is_near_one = (0.5..=2.0).contains(&self.exact);
        let own = if is_near_one { 2f64.powi(-21) } else { 3.0 * ROUNDING * exact.abs() };
        Float { nearest: exact as f32, exact, error: inherited + own }
    }
}

/// Computes an operator.
pub(super) fn binary(operator: BinaryOperator, left: Value, right: Value) -> Value {
    use BinaryOperator as B;
    match (operator, left, right) {
        (operator, Value::Float(a), Value::Float(b)) => {
            let (x, y) = (a.nearest, b.nearest);
            match operator {
                B::Add => Value::Float(a.add(b)),
                B::Subtract => Value::Float(a.add(b.negate())),
                B::Multiply => Value::Float(a.multiply(b)),
                B::Divide => Value::Float(a.divide(b)),
                B::Less => Value::Truth(x < y),
                B::LessEqual => Value::Truth(x <= y),
                B::Greater => Value::Truth(x > y),
                B::GreaterEqual => Value::Truth(x >= y),
                B::Equal => Value::Truth(x == y),
                other => panic!("emission writes no {other:?} of f32"),
            }
        }
        (B::LogicalAnd, Value::Truth(a), Value::Truth(b)) => Value::Truth(a && b),
        (B::LogicalOr, Value::Truth(a), Value::Truth(b)) => Value::Truth(a || b),
        (B::Add, Value::Signed(a), Value::Signed(b)) => Value::Signed(a.wrapping_add(b)),
        (B::ShiftLeft, Value::Unsigned(a), Value::Unsigned(b)) => Value::Unsigned(a << b),
        (B::Add, Value::Unsigned(a), Value::Unsigned(b)) => Value::Unsigned(a.wrapping_add(b)),
        (B::Multiply, Value::Unsigned(a), Value::Unsigned(b)) => Value::Unsigned(a.wrapping_mul(b)),
        (B::GreaterEqual, Value::Unsigned(a), Value::Unsigned(b)) => Value::Truth(a >= b),
        (operator, left, right) => panic!("emission writes no {operator:?} of {left:?} and {right:?}"),
    }
}
