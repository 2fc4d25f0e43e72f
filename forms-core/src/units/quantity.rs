//! What is known of the unit of an expression, and the unit of a product, power or sum.

use super::agreement;
use super::unit::Unit;
use num_rational::BigRational;
use num_traits::One;

/// What is known of the unit of a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Quantity {
    /// The literal 0, which is in any unit.
    Zero,
    /// Made of numbers only: in the unit 1 until a declaration gives it another, as `let c: m/s = 299792458` does.
    Number,
    /// In a unit that nothing states: unchecked.
    Unstated,
    /// In this unit.
    Stated(Unit),
}

/// Two quantities that have to agree and do not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Disagreement(pub(super) Unit, pub(super) Unit);

impl Quantity {
    /// A quantity without a unit that cannot be declared to have another.
    pub(super) fn one() -> Self {
        Quantity::Stated(Unit::one())
    }

    /// The unit, if one is known.
    pub(super) fn unit(&self) -> Option<Unit> {
        match self {
            Quantity::Zero | Quantity::Unstated => None,
            Quantity::Number => Some(Unit::one()),
            Quantity::Stated(unit) => Some(unit.clone()),
        }
    }

    pub(super) fn times(self, other: &Quantity) -> Self {
        match (self, other) {
            (Quantity::Zero, _) | (_, Quantity::Zero) => Quantity::Zero,
            (Quantity::Unstated, _) | (_, Quantity::Unstated) => Quantity::Unstated,
            (Quantity::Number, other) => other.clone(),
            (stated, Quantity::Number) => stated,
            (Quantity::Stated(a), Quantity::Stated(b)) => Quantity::Stated(a.product(b)),
        }
    }

    pub(super) fn over(self, other: &Quantity) -> Self {
        self.times(&other.clone().power(&-BigRational::one()))
    }

    /// A power with a known exponent. That of 0 is 0, 1 or undefined, and nothing is said of it.
    pub(super) fn power(self, exponent: &BigRational) -> Self {
        match self {
            Quantity::Stated(unit) => Quantity::Stated(unit.power(exponent)),
            Quantity::Zero => Quantity::Unstated,
            other => other,
        }
    }

    /// What both of two quantities are that are added, equated or compared.
    pub(super) fn alike(self, other: Quantity) -> Result<Quantity, Disagreement> {
        match (self, other) {
            (Quantity::Zero, other) | (other, Quantity::Zero) => Ok(other),
            (Quantity::Number, Quantity::Number) => Ok(Quantity::Number),
            (Quantity::Unstated, Quantity::Unstated) => Ok(Quantity::Unstated),
            (Quantity::Unstated, other) | (other, Quantity::Unstated) => {
                Ok(other.unit().map_or(Quantity::Unstated, Quantity::Stated))
            }
            (a, b) => {
                let (a, b) = (a.unit().unwrap_or_default(), b.unit().unwrap_or_default());
                agreement::common(&a, &b).map(Quantity::Stated).ok_or(Disagreement(a, b))
            }
        }
    }
}
