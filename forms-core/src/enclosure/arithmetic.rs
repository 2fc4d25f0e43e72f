//! Sums, products and quotients: exact between short rationals, rounded outward otherwise.

use super::bounds::{Enclosure, Undecided, Value};
use num_traits::{Signed, Zero};

impl Enclosure {
    /// a + b
    pub fn add(&self, other: &Enclosure) -> Enclosure {
        let precision = self.common_precision(other);
        match (&self.0, &other.0) {
            (Value::Exact(a, _), Value::Exact(b, _)) => Enclosure::from_rational(a + b, precision),
            (Value::Range(a), Value::Range(b)) if a.precision == b.precision => {
                Enclosure::from_range(a.add(b))
            }
            _ => Enclosure::from_range(self.to_range(precision).add(&other.to_range(precision))),
        }
    }

    /// a − b
    pub fn sub(&self, other: &Enclosure) -> Enclosure {
        self.add(&other.neg())
    }

    /// −a
    pub fn neg(&self) -> Enclosure {
        Enclosure(match &self.0 {
            Value::Exact(value, precision) => Value::Exact(-value, *precision),
            Value::Range(range) => Value::Range(range.negate()),
        })
    }

    /// a b; exactly 0 if a factor is exactly 0, whatever the other factor is
    pub fn mul(&self, other: &Enclosure) -> Enclosure {
        let precision = self.common_precision(other);
        match (&self.0, &other.0) {
            (Value::Exact(a, _), Value::Exact(b, _)) => Enclosure::from_rational(a * b, precision),
            (Value::Exact(exact, _), Value::Range(range)) | (Value::Range(range), Value::Exact(exact, _)) => {
                Enclosure::from_range(range.rescaled(precision).scaled(exact))
            }
            (Value::Range(a), Value::Range(b)) if a.precision == b.precision => {
                Enclosure::from_range(a.multiply(b))
            }
            _ => Enclosure::from_range(self.to_range(precision).multiply(&other.to_range(precision))),
        }
    }

    /// a / b, undefined where b is certainly 0
    pub fn div(&self, other: &Enclosure) -> Result<Enclosure, Undecided> {
        if other.is_zero() {
            return Err(Undecided::Undefined);
        }
        if other.contains_zero() {
            return Err(Undecided::Unknown);
        }
        if self.is_zero() {
            return Ok(self.clone());
        }
        let precision = self.common_precision(other);
        Ok(match (&self.0, &other.0) {
            (Value::Exact(a, _), Value::Exact(b, _)) => Enclosure::from_rational(a / b, precision),
            (Value::Range(range), Value::Exact(exact, _)) => {
                Enclosure::from_range(range.rescaled(precision).scaled(&exact.recip()))
            }
            _ => Enclosure::from_range(self.to_range(precision).divide(&other.to_range(precision))),
        })
    }

    /// |a|
    pub fn abs(&self) -> Enclosure {
        match &self.0 {
            Value::Exact(value, precision) => Enclosure(Value::Exact(value.abs(), *precision)),
            Value::Range(range) if range.contains_zero() => {
                let mut image = range.clone();
                image.upper = range.magnitude();
                image.lower.set_zero();
                Enclosure::from_range(image)
            }
            Value::Range(range) if range.upper.is_negative() => self.neg(),
            Value::Range(_) => self.clone(),
        }
    }
}
