//! Names that have a value only while an expression is evaluated: the arguments of a definition in
//! its body, and the index of a sum in its terms.

use crate::diagnostic::{Diagnostic, Span};
use crate::theory::Value;

/// Maximum number of bodies that one item evaluates: definitions that call each other, and sums in
/// sums, can ask for exponentially many.
const MOST_BODIES: usize = 10_000;

/// Bound names with their values; the last binding of a name counts.
#[derive(Clone, Debug, Default)]
pub(super) struct Bindings {
    values: Vec<(String, Value)>,
    /// Number of bodies around the expression being evaluated.
    depth: usize,
    /// Number of bodies evaluated so far.
    bodies: usize,
}

impl Bindings {
    pub(super) fn get(&self, name: &str) -> Option<&Value> {
        self.values.iter().rev().find(|(bound, _)| bound == name).map(|(_, value)| value)
    }

    /// Whether the expression being evaluated can be evaluated again with other values.
    pub(super) fn are_in_body(&self) -> bool {
        self.depth > 0
    }

    /// Binds these names and no others; returns what was bound before.
    pub(super) fn enter(&mut self, names: Vec<(String, Value)>) -> Vec<(String, Value)> {
        self.depth += 1;
        std::mem::replace(&mut self.values, names)
    }

    /// Leaves a body, and binds what was bound before it.
    pub(super) fn leave(&mut self, outer: Vec<(String, Value)>) {
        self.depth -= 1;
        self.values = outer;
    }

    /// Returns the bound names with one more.
    pub(super) fn with(&self, name: &str, value: Value) -> Vec<(String, Value)> {
        let mut names = self.values.clone();
        names.push((name.to_owned(), value));
        names
    }

    /// Counts one more body; an error at the maximum.
    pub(super) fn count(&mut self, place: Span) -> Result<(), Diagnostic> {
        self.bodies += 1;
        if self.bodies <= MOST_BODIES {
            return Ok(());
        }
        let message = format!("this item has more than {MOST_BODIES} calls of definitions and terms of sums");
        Err(Diagnostic::new(place, message).with_help("name a common value with `let`, or sum fewer terms"))
    }
}
