//! Expressions of one pool in another.

use super::node::{Expr, Node, Pool, Symbol};
use rustc_hash::FxHashMap;

impl Pool {
    /// Expressions of another pool as expressions of this one, with these in the place of the other's variables;
    /// nothing where a variable is left or an unknown function occurs.
    pub(crate) fn import(
        &mut self,
        other: &Pool,
        expressions: &[Expr],
        variables: &FxHashMap<Symbol, Expr>,
    ) -> Option<Vec<Expr>> {
        let mut images: FxHashMap<Expr, Expr> = FxHashMap::default();
        for expression in other.reachable(expressions) {
            let image = match other.node(expression) {
                Node::Number(value) => self.number(value.clone()),
                Node::Pi => self.pi(),
                Node::Symbol(symbol) => *variables.get(symbol)?,
                Node::Jet { .. } => return None,
                node => self.image(expression, node.clone(), &images),
            };
            images.insert(expression, image);
        }
        Some(expressions.iter().map(|expression| images[expression]).collect())
    }
}
