//! What is gathered beside a value while it is evaluated: where it is defined and what it uses.

use crate::expression::{Condition, Symbol};
use rustc_hash::FxHashSet;

/// Conditions and variables, each once, in the order they were met.
#[derive(Clone, Debug, Default)]
pub(super) struct Scope {
    conditions: Vec<Condition>,
    known: FxHashSet<Condition>,
    used: FxHashSet<Symbol>,
}

impl Scope {
    pub(super) fn require(&mut self, condition: Condition) {
        if self.known.insert(condition) {
            self.conditions.push(condition);
        }
    }

    pub(super) fn touch(&mut self, symbol: Symbol) {
        self.used.insert(symbol);
    }

    pub(super) fn forget(&mut self, symbol: Symbol) {
        self.used.remove(&symbol);
    }

    pub(super) fn uses(&self, symbol: Symbol) -> bool {
        self.used.contains(&symbol)
    }

    pub(super) fn conditions(&self) -> &[Condition] {
        &self.conditions
    }

    /// The variables in the order of their declaration.
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
