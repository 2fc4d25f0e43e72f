//! Enclosures: the known bounds of a real number, and the conclusions that certainly follow from
//! them.

use super::range::Range;
use crate::expression::{Rational, Relation};
use num_bigint::BigInt;
use num_traits::{Signed, Zero};
use std::cmp::Ordering;

/// Number of binary places of a range after the point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Precision(pub u32);

/// Reason why there is no enclosure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Undecided {
    /// The value is not real anywhere in the given enclosures: no precision helps.
    Undefined,
    /// The value is too large to be worth computing, at this precision and any other.
    TooLarge,
    /// The value is not decided at this precision.
    Unknown,
}

/// A closed interval that contains a real number, known exactly where its ends coincide.
#[derive(Clone, Debug, PartialEq)]
pub struct Enclosure(pub(super) Value);

/// Value of an enclosure, exact as long as numerator and denominator stay short.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value {
    Exact(Rational, u32),
    Range(Range),
}

/// Returns the length in bits up to which an exact value is kept, at precision p.
pub(super) fn exact_bits(precision: u32) -> u64 {
    4 * u64::from(precision).max(16)
}

impl Enclosure {
    /// Encloses a rational number.
    pub fn exact(value: &Rational, precision: Precision) -> Self {
        Enclosure::from_rational(value.clone(), precision.0)
    }

    /// Encloses an integer.
    pub fn integer(value: i64, precision: Precision) -> Self {
        Enclosure::from_rational(Rational::from_integer(value.into()), precision.0)
    }

    /// Encloses every number from the smaller to the larger of two.
    pub fn between(a: &Rational, b: &Rational, precision: Precision) -> Self {
        Enclosure::exact(a, precision).hull(&Enclosure::exact(b, precision))
    }

    /// Encloses a rational number in a narrow range, never exactly: arithmetic with ranges is faster
    /// than exact arithmetic.
    pub(crate) fn near(value: &Rational, precision: Precision) -> Self {
        let range = Range::rational(value, precision.0);
        if range.lower < range.upper {
            Enclosure(Value::Range(range))
        } else {
            Enclosure(Value::Range(range.widened(&1.into())))
        }
    }

    /// Encloses a rational number, rounded outward if it has become long.
    pub(super) fn from_rational(value: Rational, precision: u32) -> Self {
        if value.numer().bits().max(value.denom().bits()) <= exact_bits(precision) {
            Enclosure(Value::Exact(value, precision))
        } else {
            Enclosure(Value::Range(Range::rational(&value, precision)))
        }
    }

    /// Encloses a range, exactly if its ends coincide.
    pub(super) fn from_range(range: Range) -> Self {
        if range.lower != range.upper || range.lower.bits() > exact_bits(range.precision) {
            return Enclosure(Value::Range(range));
        }
        let value = Rational::new(range.lower, BigInt::from(1) << range.precision);
        Enclosure(Value::Exact(value, range.precision))
    }

    /// Returns the narrowest range around the enclosure at some precision.
    pub(super) fn to_range(&self, precision: u32) -> Range {
        match &self.0 {
            Value::Exact(value, _) => Range::rational(value, precision),
            Value::Range(range) => range.rescaled(precision),
        }
    }

    /// Returns the precision with which the enclosure is computed.
    pub fn precision(&self) -> Precision {
        match &self.0 {
            Value::Exact(_, precision) => Precision(*precision),
            Value::Range(range) => Precision(range.precision),
        }
    }

    /// Returns the same enclosure for use at another precision; a lower precision rounds outward.
    pub fn at(&self, precision: Precision) -> Self {
        match &self.0 {
            Value::Exact(value, _) => Enclosure::from_rational(value.clone(), precision.0),
            Value::Range(range) => Enclosure::from_range(range.rescaled(precision.0)),
        }
    }

    /// Returns the value, if it is known exactly.
    pub fn as_exact(&self) -> Option<&Rational> {
        match &self.0 {
            Value::Exact(value, _) => Some(value),
            Value::Range(_) => None,
        }
    }

    /// Whether the value is known exactly.
    pub fn is_exact(&self) -> bool {
        self.as_exact().is_some()
    }

    /// Whether it is exactly this integer.
    pub(super) fn is_integer(&self, value: i64) -> bool {
        self.as_exact().is_some_and(|known| known.is_integer() && *known.numer() == BigInt::from(value))
    }

    /// Returns the lower end.
    pub fn lower(&self) -> Rational {
        match &self.0 {
            Value::Exact(value, _) => value.clone(),
            Value::Range(range) => dyadic(&range.lower, range.precision),
        }
    }

    /// Returns the upper end.
    pub fn upper(&self) -> Rational {
        match &self.0 {
            Value::Exact(value, _) => value.clone(),
            Value::Range(range) => dyadic(&range.upper, range.precision),
        }
    }

    /// Returns the lower and the upper end as numerators over one positive denominator, which comes
    /// last; not in lowest terms.
    pub(crate) fn ends(&self) -> (BigInt, BigInt, BigInt) {
        match &self.0 {
            Value::Exact(value, _) => (value.numer().clone(), value.numer().clone(), value.denom().clone()),
            Value::Range(range) => {
                (range.lower.clone(), range.upper.clone(), BigInt::from(1) << range.precision)
            }
        }
    }

    /// upper − lower
    pub fn width(&self) -> Rational {
        self.upper() - self.lower()
    }

    /// Returns n with |x| < 2ⁿ throughout.
    pub(super) fn magnitude_bits(&self) -> u64 {
        match &self.0 {
            Value::Exact(value, _) => (value.numer().bits() + 1).saturating_sub(value.denom().bits()),
            Value::Range(range) => range.magnitude_bits(),
        }
    }

    /// Returns n with |x| ≥ 2ⁿ⁻¹ throughout, or 0.
    pub(super) fn least_magnitude_bits(&self) -> u64 {
        match &self.0 {
            Value::Exact(value, _) => value.numer().bits().saturating_sub(value.denom().bits()),
            Value::Range(range) if range.contains_zero() => 0,
            Value::Range(range) => {
                range.lower.bits().min(range.upper.bits()).saturating_sub(u64::from(range.precision))
            }
        }
    }

    /// Whether the value is certainly greater than 0.
    pub fn is_positive(&self) -> bool {
        match &self.0 {
            Value::Exact(value, _) => value.is_positive(),
            Value::Range(range) => range.lower.is_positive(),
        }
    }

    /// Whether the value is certainly less than 0.
    pub fn is_negative(&self) -> bool {
        match &self.0 {
            Value::Exact(value, _) => value.is_negative(),
            Value::Range(range) => range.upper.is_negative(),
        }
    }

    /// Whether the value is certainly at least 0.
    pub fn is_nonnegative(&self) -> bool {
        match &self.0 {
            Value::Exact(value, _) => !value.is_negative(),
            Value::Range(range) => !range.lower.is_negative(),
        }
    }

    /// Whether the value is certainly at most 0.
    pub fn is_nonpositive(&self) -> bool {
        match &self.0 {
            Value::Exact(value, _) => !value.is_positive(),
            Value::Range(range) => !range.upper.is_positive(),
        }
    }

    /// Whether the value is certainly 0.
    pub fn is_zero(&self) -> bool {
        self.as_exact().is_some_and(Zero::is_zero)
    }

    /// Whether the value may be 0.
    pub fn contains_zero(&self) -> bool {
        !self.is_positive() && !self.is_negative()
    }

    /// Whether the value may be this number.
    pub fn contains(&self, value: &Rational) -> bool {
        self.lower() <= *value && *value <= self.upper()
    }

    /// Whether every number of the other enclosure is in this one.
    pub fn encloses(&self, other: &Enclosure) -> bool {
        self.lower() <= other.lower() && other.upper() <= self.upper()
    }

    /// Whether both contain a common number, so that the values may be equal.
    pub fn intersects(&self, other: &Enclosure) -> bool {
        self.sub(other).contains_zero()
    }

    /// Returns the narrowest enclosure of both.
    pub fn hull(&self, other: &Enclosure) -> Enclosure {
        if self.is_exact() && self.as_exact() == other.as_exact() {
            return self.clone();
        }
        let precision = self.common_precision(other);
        Enclosure::from_range(self.to_range(precision).hull(other.to_range(precision)))
    }

    /// Whether the relation holds; `None` if that is not certain.
    pub fn decide(&self, relation: Relation, other: &Enclosure) -> Option<bool> {
        let difference = self.sub(other);
        let possible = [
            (Ordering::Less, !difference.is_nonnegative()),
            (Ordering::Equal, difference.contains_zero()),
            (Ordering::Greater, !difference.is_nonpositive()),
        ];
        let mut answers = possible.into_iter().filter(|order| order.1).map(|order| relation.admits(order.0));
        let first = answers.next()?;
        answers.all(|answer| answer == first).then_some(first)
    }

    pub(super) fn common_precision(&self, other: &Enclosure) -> u32 {
        self.precision().max(other.precision()).0
    }
}

/// n·2⁻ᵖ
fn dyadic(n: &BigInt, precision: u32) -> Rational {
    Rational::new(n.clone(), BigInt::from(1) << precision)
}
