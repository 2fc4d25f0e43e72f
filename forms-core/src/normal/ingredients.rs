//! What elements are made of, for whoever writes a proof down: generators, units, bases of radicands.

use super::fraction::Fraction;
use super::generator::Unit;
use super::root::Base;
use super::tower::Tower;
use crate::expression::{Expr, Node, Operation, Pool};

impl Base {
    /// The order of its root, 1 if none was asked for.
    pub(crate) fn order(&self) -> u32 {
        self.order
    }
}

impl Tower {
    /// The generators a fraction is written with.
    pub(crate) fn variables_of(&self, fraction: &Fraction) -> Vec<u32> {
        let factors = fraction.factors.iter().map(|power| self.factor_polynomial(power.factor));
        let mut all: Vec<u32> =
            std::iter::once(fraction.numerator()).chain(factors).flat_map(|p| p.variables()).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// The unit as a fraction.
    pub(crate) fn unit_value(&self, unit: &Unit) -> Fraction {
        let mut quantity = self.quantity(&unit.quantity);
        quantity.divisor *= unit.divisor;
        quantity
    }

    /// The bases that the roots and signs among some expressions are written with.
    pub(crate) fn bases_of(&self, pool: &Pool, parts: &[Expr]) -> Vec<usize> {
        let is_magnitude = |part: &Expr| matches!(pool.node(*part), Node::Apply(Operation::Abs, _));
        if parts.iter().any(is_magnitude) {
            return self.bases().map(|(number, _)| number).collect();
        }
        let constraints = parts.iter().filter_map(|part| self.constraint_of(*part));
        let bases = constraints.flat_map(|constraint| constraint.odd.iter().chain(&constraint.other));
        let mut all: Vec<usize> = bases.copied().filter(|base| !self.base(*base).is_retired()).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// The element of an expression, if it has been computed.
    pub(crate) fn element_of(&self, expression: Expr) -> Option<&Fraction> {
        self.elements.get(&expression)
    }
}
