//! Knowledge about the unit of an expression, and the unit of a product, power or sum.

use super::agreement;
use super::unit::Unit;
use num_rational::BigRational;
use num_traits::One;

/// Knowledge about the unit of a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Quantity {
    /// Literal 0, which has every unit.
    Zero,
    /// Value made of numbers only: its unit is 1 until a declaration gives it another, as in `let
    /// c: m/s = 299792458`.
    Number,
    /// Value whose unit is not stated, and is not checked.
    Unstated,
    /// Value in this unit.
    Stated(Unit),
}

/// Units of two quantities that must agree and do not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Disagreement(pub(super) Unit, pub(super) Unit);

impl Quantity {
    /// Returns the quantity with the unit 1 that cannot be declared in another unit.
    pub(super) fn one() -> Self {
        Quantity::Stated(Unit::one())
    }

    /// Returns the unit, if one is known.
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

    /// Returns a power with a known exponent. A power of 0 is 0, 1 or undefined, and its unit is
    /// `Unstated`.
    pub(super) fn power(self, exponent: &BigRational) -> Self {
        match self {
            Quantity::Stated(unit) => Quantity::Stated(unit.power(exponent)),
            Quantity::Zero => Quantity::Unstated,
            other => other,
        }
    }

    /// Returns the common quantity of two quantities that are added, equated or compared.
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
