//! Conditions of declarations, which come with every use of a param or an unknown function.

use crate::expression::{Condition, FunctionId, Symbol};
use rustc_hash::FxHashMap;

/// Conditions with which params and unknown functions were declared.
#[derive(Clone, Debug, Default)]
pub(super) struct Declarations {
    pub(super) parameters: FxHashMap<Symbol, Vec<Condition>>,
    pub(super) functions: FxHashMap<FunctionId, Vec<Condition>>,
}

impl Declarations {
    pub(super) fn of_parameter(&self, symbol: Symbol) -> Vec<Condition> {
        self.parameters.get(&symbol).cloned().unwrap_or_default()
    }

    pub(super) fn of_function(&self, function: FunctionId) -> Vec<Condition> {
        self.functions.get(&function).cloned().unwrap_or_default()
    }
}
