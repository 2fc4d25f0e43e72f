//! Requests for signs: the bases whose signs the elements of a tower depend on.

use super::base::SignConstraint;
use crate::expression::Expr;
use rustc_hash::FxHashMap;

/// Bases whose signs the elements of a tower depend on.
#[derive(Clone, Debug, Default)]
pub(super) struct SignRequests {
    /// Bases whose signs the element being computed needs.
    asked: Vec<usize>,
    asked_by: FxHashMap<Expr, Vec<usize>>,
    /// Bases that the element being computed is factored over, and the bases of each known element.
    pub(super) met: Vec<usize>,
    pub(super) met_by: FxHashMap<Expr, Vec<usize>>,
    /// Constraints under which radicands are non-negative.
    constraints: FxHashMap<Expr, SignConstraint>,
}

impl SignRequests {
    /// Records that the sign of a base matters.
    pub(super) fn ask(&mut self, base: usize) {
        self.asked.push(base);
    }

    /// Returns the number of signs requested since they were last taken.
    pub(super) fn count(&self) -> usize {
        self.asked.len()
    }

    /// Takes the signs requested since the last call.
    pub(super) fn take(&mut self) -> Vec<usize> {
        std::mem::take(&mut self.asked)
    }

    /// Records the signs that an expression itself depends on, and the bases it is factored over.
    pub(super) fn note(&mut self, expression: Expr) {
        let met = std::mem::take(&mut self.met);
        if !met.is_empty() {
            self.met_by.insert(expression, met);
        }
        let mut asked = self.take();
        if !asked.is_empty() {
            asked.sort_unstable();
            asked.dedup();
            self.asked_by.insert(expression, asked);
        }
    }

    /// Returns the signs that an expression itself depends on, without the signs that only its
    /// operands depend on.
    pub(super) fn of(&self, expression: Expr) -> &[usize] {
        self.asked_by.get(&expression).map_or(&[], Vec::as_slice)
    }

    /// Returns the constraint under which a radicand is non-negative.
    pub(super) fn constraint_of(&self, radicand: Expr) -> Option<&SignConstraint> {
        self.constraints.get(&radicand)
    }

    /// Records the constraint under which a radicand is non-negative.
    pub(super) fn constrain(&mut self, radicand: Expr, constraint: SignConstraint) {
        self.constraints.insert(radicand, constraint);
    }
}
