//! Constituents of elements, for writing proofs: generators, units, bases of radicands.

use super::base::Base;
use super::fraction::Fraction;
use super::generator::{Generator, Unit};
use super::tower::Tower;
use crate::expression::Expr;
use rustc_hash::FxHashSet;

impl Base {
    /// Returns the order of its root, or 1 if no root was needed.
    pub(crate) fn order(&self) -> u32 {
        self.order
    }
}

impl Tower {
    /// Returns the bases whose logarithms are generators.
    pub(crate) fn logarithmic_bases(&self) -> FxHashSet<usize> {
        let base = |generator: &Generator| match generator {
            Generator::Logarithm { base } => Some(*base),
            _ => None,
        };
        self.generators.list().iter().filter_map(base).collect()
    }

    /// Returns the unit as a fraction.
    pub(crate) fn unit_value(&self, unit: &Unit) -> Fraction {
        let mut quantity = self.quantity(&unit.quantity);
        quantity.divisor *= unit.divisor;
        quantity
    }

    /// Returns the bases that the roots and magnitudes among some expressions are factored over.
    pub(crate) fn bases_of(&self, parts: &[Expr]) -> Vec<usize> {
        let met = parts.iter().filter_map(|part| self.signs.met_by.get(part)).flatten();
        let mut all: Vec<usize> = met.copied().filter(|base| !self.base(*base).is_retired()).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// Returns the element of an expression, if it has been computed.
    pub(crate) fn element_of(&self, expression: Expr) -> Option<&Fraction> {
        self.elements.get(&expression)
    }
}
