//! Unit as a product of rational powers of unit names, and its meaning in terms of the base units.
//!
//! ```text
//! W/m**2/sr = W · m⁻² · sr⁻¹ ─ meaning ─▶ kg · s⁻³ · sr⁻¹
//! ```
//! The names are kept as written, for messages; two units are compared by their meaning. A size
//! such as that of the millimetre is a product of primes, 2⁻³ 5⁻³ m, so that its roots are exact as
//! well: by unique factorisation a product of rational powers of primes is 1 only if every exponent
//! is 0.

use super::table::{self, Base};
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::collections::BTreeMap;
use std::fmt;

/// Nonzero exponents of base units and of primes.
pub(super) type Meaning = BTreeMap<Base, BigRational>;

/// Product of powers of unit names; the unit 1 has no factors.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Unit {
    /// Unit names without duplicates, in the order of their first occurrence, each with a nonzero
    /// exponent.
    factors: Vec<(String, BigRational)>,
}

impl Unit {
    /// Returns the unit of a number.
    pub(super) fn one() -> Self {
        Self::default()
    }

    /// Returns the unit with this name; `None` if there is none.
    pub(super) fn named(name: &str) -> Option<Self> {
        table::row(name)?;
        Some(Unit { factors: vec![(name.to_owned(), BigRational::one())] })
    }

    /// Returns the radian, the unit of the inverse trigonometric functions.
    pub(super) fn radian() -> Self {
        Unit { factors: vec![(table::RADIAN.to_owned(), BigRational::one())] }
    }

    pub(super) fn product(mut self, other: &Unit) -> Self {
        for (name, exponent) in &other.factors {
            match self.factors.iter_mut().find(|factor| factor.0 == *name) {
                Some(factor) => factor.1 += exponent,
                None => self.factors.push((name.clone(), exponent.clone())),
            }
        }
        self.factors.retain(|factor| !factor.1.is_zero());
        self
    }

    pub(super) fn power(mut self, exponent: &BigRational) -> Self {
        if exponent.is_zero() {
            return Unit::one();
        }
        self.factors.iter_mut().for_each(|factor| factor.1 *= exponent);
        self
    }

    pub(super) fn quotient(self, other: &Unit) -> Self {
        self.product(&other.clone().power(&-BigRational::one()))
    }

    /// Returns the unit in base units and primes.
    pub(super) fn meaning(&self) -> Meaning {
        let mut meaning = Meaning::new();
        for (name, exponent) in &self.factors {
            for (base, power) in table::row(name).into_iter().flatten() {
                *meaning.entry(base).or_insert_with(BigRational::zero) += exponent * power;
            }
        }
        meaning.retain(|_, exponent| !exponent.is_zero());
        meaning
    }

    /// Returns the unit with the radian read as 1.
    pub(super) fn without_radians(mut self) -> Self {
        self.factors.retain(|factor| factor.0 != table::RADIAN);
        self
    }

    /// Returns the unit with the square of the radian read as the steradian.
    pub(super) fn with_steradians(self) -> Self {
        let radians = self.factors.iter().find(|factor| factor.0 == table::RADIAN);
        let halves =
            radians.map_or_else(BigRational::zero, |factor| &factor.1 / BigRational::from_integer(2.into()));
        let steradian = Unit { factors: vec![(table::STERADIAN.to_owned(), BigRational::one())] };
        self.without_radians().product(&steradian.power(&halves))
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (above, below): (Vec<_>, Vec<_>) = self.factors.iter().partition(|factor| factor.1.is_positive());
        if above.is_empty() {
            f.write_str("1")?;
        }
        for (place, (name, exponent)) in above.into_iter().enumerate() {
            f.write_str(if place == 0 { "" } else { "*" })?;
            write_power(f, name, exponent)?;
        }
        below.into_iter().try_for_each(|(name, exponent)| {
            f.write_str("/")?;
            write_power(f, name, &-exponent)
        })
    }
}

/// Writes `m`, `m**2` or `m**(1/2)`.
fn write_power(f: &mut fmt::Formatter<'_>, name: &str, exponent: &BigRational) -> fmt::Result {
    match exponent {
        exponent if exponent.is_one() => f.write_str(name),
        exponent if exponent.is_integer() => write!(f, "{name}**{exponent}"),
        exponent => write!(f, "{name}**({exponent})"),
    }
}

/// Returns the exponent of one base unit.
pub(super) fn exponent(meaning: &Meaning, base: Base) -> BigRational {
    meaning.get(&base).cloned().unwrap_or_else(|| BigRational::from_integer(0.into()))
}

/// Returns the size of a meaning without base units, as a number; `None` if it is irrational or
/// very large.
pub(super) fn size(meaning: &Meaning) -> Option<BigRational> {
    let mut size = BigRational::from_integer(1.into());
    for (base, exponent) in meaning {
        let Base::Prime(prime) = base else { return None };
        let exponent = exponent.is_integer().then(|| exponent.to_i32())?.filter(|power| power.abs() < 100)?;
        size *= BigRational::from_integer((*prime).into()).pow(exponent);
    }
    Some(size)
}
