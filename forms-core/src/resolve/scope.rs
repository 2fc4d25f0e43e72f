//! Side results of an evaluation: the conditions under which the value is defined, and the
//! variables it uses.

use crate::expression::{Condition, Symbol};
use rustc_hash::FxHashSet;
use std::collections::BTreeSet;

/// Conditions and variables without duplicates, in the order of their first occurrence.
#[derive(Clone, Debug, Default)]
pub(super) struct Scope {
    conditions: Vec<Condition>,
    known: FxHashSet<Condition>,
    /// Conditions under which the computed value of an integral is valid.
    narrowing: FxHashSet<Condition>,
    used: FxHashSet<Symbol>,
    named: BTreeSet<String>,
}

impl Scope {
    pub(super) fn require(&mut self, condition: Condition) {
        if self.known.insert(condition) {
            self.conditions.push(condition);
        }
    }

    /// Requires a condition under which the computed value of an integral is valid.
    pub(super) fn narrow(&mut self, condition: Condition) {
        self.narrowing.insert(condition);
        self.require(condition);
    }

    /// Requires a condition of another scope.
    pub(super) fn adopt(&mut self, condition: Condition, is_narrowing: bool) {
        if is_narrowing { self.narrow(condition) } else { self.require(condition) }
    }

    pub(super) fn narrowing(&self) -> &FxHashSet<Condition> {
        &self.narrowing
    }

    pub(super) fn touch(&mut self, symbol: Symbol) {
        self.used.insert(symbol);
    }

    /// Records that a map or a named value is mentioned.
    pub(super) fn mention(&mut self, name: &str) {
        self.named.insert(name.to_string());
    }

    pub(super) fn mentioned(&self) -> &BTreeSet<String> {
        &self.named
    }

    pub(super) fn conditions(&self) -> &[Condition] {
        &self.conditions
    }

    /// Returns the variables in the order of their declaration.
    pub(super) fn used(&self) -> Vec<Symbol> {
        let mut used: Vec<Symbol> = self.used.iter().copied().collect();
        used.sort_unstable();
        used
    }

    pub(super) fn into_parts(self) -> (Vec<Condition>, Vec<Symbol>) {
        let used = self.used();
        (self.conditions, used)
    }
}
