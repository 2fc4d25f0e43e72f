//! Import of expressions from another pool.

use super::node::{Expr, Node, Symbol};
use super::pool::Pool;
use rustc_hash::FxHashMap;

impl Pool {
    /// Copies expressions of another pool into this one, with the given expressions substituted for
    /// the other pool's variables. `None` if a variable has no replacement or an unknown function
    /// occurs.
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
