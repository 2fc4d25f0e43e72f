//! Strata: the points at which a normal form makes no statement about its expression.
//!
//! ```text
//! half-angle tangents   cos u = (1 − t²)/(1 + t²)      not where cos u = −1, the poles of t
//! nested radicals       A + Bρ = n/(A − Bρ), …         not where the divisor vanishes
//! exponents             1/(A + Bρ) = (A − Bρ)/n        not where the norm n vanishes
//! ```
//! A tower records these poles and zeros while it computes. Everywhere else its steps are
//! identities of real functions. A conclusion for every point requires that these strata are
//! decided one by one: at a half turn (cos u, sin u) is (−1, 0), and [`Tower::at_half_turns`]
//! computes with these values.

use super::fraction::Fraction;
use super::generator::{Generator, Unit};
use super::obstacle::{Obstacle, OutsidePart};
use super::power::FactorPower;
use super::tower::Tower;
use crate::expression::Symbol;
use crate::polynomial::Polynomial;

/// Largest number of units whose choices are gone through.
const MOST_UNITS: usize = 4;

impl Tower {
    /// Returns the units u whose half-angle tangent was used: nothing is known where cos u = −1.
    pub(crate) fn poles(&self) -> &[Unit] {
        &self.exclusions.poles
    }

    /// Returns the polynomials without roots that were divisors: nothing is known where one
    /// vanishes.
    pub(crate) fn excluded(&self) -> &[Polynomial] {
        &self.exclusions.divisors
    }

    /// Whether the computed elements are valid at every point at which the expressions are defined.
    pub(crate) fn holds_everywhere(&self) -> bool {
        self.exclusions.poles.is_empty() && self.exclusions.divisors.is_empty()
    }

    /// Whether some variables are written relative to others.
    pub(crate) fn has_frame(&self) -> bool {
        !self.frame.is_empty()
    }

    /// Whether a unit was used together with a finer one of the same quantity, which happens before
    /// the finer one is known to be needed.
    pub(crate) fn has_coarser_poles(&self) -> bool {
        let finer =
            |unit: &Unit, other: &Unit| unit.quantity == other.quantity && unit.divisor != other.divisor;
        self.exclusions.poles.iter().any(|unit| self.exclusions.poles.iter().any(|other| finer(unit, other)))
    }

    /// Returns a tower with the same generators, with nothing computed and nothing recorded.
    pub(crate) fn apart(&self) -> Tower {
        let mut tower = self.clone();
        tower.exclusions.poles.clear();
        tower.exclusions.divisors.clear();
        tower.fix_signs(&[]);
        tower.start_again();
        tower
    }

    /// Returns a tower with the same generators and nothing computed, for the points at which these
    /// units, and no others, are at an odd multiple of π.
    pub(crate) fn at_half_turns(&self, units: &[Unit]) -> Tower {
        let mut tower = self.apart();
        tower.exclusions.half_turns = units.to_vec();
        tower
    }

    /// Returns every non-empty choice of the units whose half-angle tangents were used; `None` if
    /// there are too many.
    pub(crate) fn choices_of_half_turns(&self) -> Option<Vec<Vec<Unit>>> {
        if self.exclusions.poles.len() > MOST_UNITS {
            return None;
        }
        let chosen = |choice: usize| {
            let is_chosen = |(place, unit): (usize, &Unit)| (choice >> place & 1 == 1).then(|| unit.clone());
            self.exclusions.poles.iter().enumerate().filter_map(is_chosen).collect()
        };
        Some((1..1 << self.exclusions.poles.len()).map(chosen).collect())
    }

    /// Returns the angle of a unit.
    pub(crate) fn angle_of(&self, unit: &Unit) -> Fraction {
        let quantity = self.quantity(&unit.quantity);
        Fraction { divisor: quantity.divisor * unit.divisor, ..quantity }
    }

    /// Records that a half-angle tangent is used, unless its unit is at a half turn here, and
    /// returns whether it is. A unit that is divided more finely than the one at a half turn has no
    /// known sine there.
    pub(super) fn is_at_half_turn(&mut self, unit: &Unit) -> Result<bool, Obstacle> {
        if self.exclusions.half_turns.contains(unit) {
            return Ok(true);
        }
        if self.exclusions.half_turns.iter().any(|known| known.quantity == unit.quantity) {
            return Err(Obstacle::Outside(OutsidePart::FractionOfHalfTurn));
        }
        if !self.exclusions.poles.contains(unit) {
            self.exclusions.poles.push(unit.clone());
        }
        Ok(false)
    }

    /// Records that a polynomial without roots was a divisor. A polynomial in π alone vanishes
    /// nowhere, and neither does an exponential.
    pub(super) fn exclude_zeros(&mut self, polynomial: Polynomial) {
        let mut powers = polynomial.monomial_content();
        powers.retain(|&(variable, _)| matches!(self.generator(variable), Generator::Exponential(_)));
        let polynomial = polynomial.divide_by_monomial(&powers).unwrap_or(polynomial);
        let pi = self.pi();
        if polynomial.variables().into_iter().all(|variable| Some(variable) == pi) {
            return;
        }
        if !self.exclusions.divisors.contains(&polynomial) {
            self.exclusions.divisors.push(polynomial);
        }
    }

    /// Records that the factors of a fraction's denominator were divisors, and returns whether
    /// their norms are known.
    pub(super) fn exclude_zeros_below(&mut self, fraction: &Fraction) -> Result<bool, Obstacle> {
        let below: Vec<FactorPower> =
            fraction.factors.iter().filter(|power| power.exponent > 0).copied().collect();
        for power in below {
            let polynomial = self.factor_polynomial(power.factor).clone();
            let Some(norm) = self.full_norm(&polynomial)? else { return Ok(false) };
            self.exclude_zeros(norm);
        }
        Ok(true)
    }

    /// Whether a non-zero polynomial vanishes at most on a thin set: its generators are variables,
    /// derivatives of unknown functions, half-angle tangents and π, which no relation binds.
    pub(crate) fn vanishes_on_a_thin_set(&self, polynomial: &Polynomial) -> bool {
        !polynomial.is_zero()
            && polynomial.variables().into_iter().all(|variable| self.is_independent(variable))
    }

    /// Whether a unit is constant on no open set: a product of generators as above, at least one of
    /// which is not a number.
    pub(crate) fn is_never_constant(&self, unit: &Unit) -> bool {
        let quantity = self.quantity(&unit.quantity);
        let variables = self.variables_of(&quantity);
        let varies = |&variable: &u32| !matches!(self.generator(variable), Generator::Pi);
        variables.iter().all(|&variable| self.is_independent(variable)) && variables.iter().any(varies)
    }

    /// Whether the omitted points are single values of a variable, whatever the others are: poles
    /// of angles that are multiples of powers of it, and zeros of polynomials in it whose
    /// coefficients are not all zero at once.
    pub(crate) fn leaves_out_single_values_of(&self, symbol: Symbol) -> bool {
        let is_it = |variable: u32| *self.generator(variable) == Generator::Variable(symbol);
        let plain =
            |variable: u32| matches!(self.generator(variable), Generator::Variable(_) | Generator::Pi);
        let poles = self.exclusions.poles.iter().all(|unit| {
            let variables = self.variables_of(&self.quantity(&unit.quantity));
            variables.iter().any(|&v| is_it(v)) && variables.iter().all(|&v| plain(v))
        });
        let zeros = self.exclusions.divisors.iter().all(|polynomial| {
            let variables = polynomial.variables();
            let own = variables.iter().copied().find(|&v| is_it(v));
            own.is_some_and(|own| {
                polynomial.coefficients_in(own).iter().any(|(_, c)| c.as_constant().is_some())
            }) && variables.iter().all(|&v| plain(v))
        });
        poles && zeros
    }

    fn is_independent(&self, variable: u32) -> bool {
        matches!(
            self.generator(variable),
            Generator::Variable(_) | Generator::Jet { .. } | Generator::HalfTangent(_) | Generator::Pi
        )
    }
}
