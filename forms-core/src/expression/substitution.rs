//! Simultaneous substitution of expressions for variables.

use super::node::{Expr, Node, Symbol};
use super::pool::Pool;
use rustc_hash::FxHashMap;

/// Replacement for each variable; variables without one stay.
pub type Substitution = FxHashMap<Symbol, Expr>;

impl Pool {
    /// Replaces every variable of an expression simultaneously; unknown functions are composed with
    /// the substitution.
    pub fn substitute(&mut self, expression: Expr, values: &Substitution) -> Expr {
        self.substitute_all(&[expression], values)[0]
    }

    /// Substitutes in several expressions that share nodes.
    pub fn substitute_all(&mut self, expressions: &[Expr], values: &Substitution) -> Vec<Expr> {
        self.replace_all(expressions, |node, _| match node {
            Node::Symbol(symbol) => values.get(symbol).copied(),
            _ => None,
        })
    }

    /// Replaces nodes wherever they occur in the expressions, operands first. `replaced` receives a
    /// node and the images of the expressions below it, and returns the replacement of the node, or
    /// `None` if the node keeps its operation.
    pub(crate) fn replace_all(
        &mut self,
        expressions: &[Expr],
        mut replaced: impl FnMut(&Node, &FxHashMap<Expr, Expr>) -> Option<Expr>,
    ) -> Vec<Expr> {
        let mut images: FxHashMap<Expr, Expr> = FxHashMap::default();
        for expression in self.reachable(expressions) {
            let node = self.node(expression).clone();
            let image = replaced(&node, &images).unwrap_or_else(|| self.image(expression, node, &images));
            images.insert(expression, image);
        }
        expressions.iter().map(|expression| images[expression]).collect()
    }

    /// Replaces some subexpressions of an expression by others.
    pub(crate) fn replace(&mut self, expression: Expr, parts: &FxHashMap<Expr, Expr>) -> Expr {
        let nodes: FxHashMap<Node, Expr> =
            parts.iter().map(|(part, image)| (self.node(*part).clone(), *image)).collect();
        self.replace_all(&[expression], |node, _| nodes.get(node).copied())[0]
    }

    /// Applies the operation of a node to the images of its operands.
    pub(crate) fn image(&mut self, expression: Expr, node: Node, images: &FxHashMap<Expr, Expr>) -> Expr {
        let of = |operand: &Expr| images[operand];
        match node {
            Node::Number(_) | Node::Pi | Node::Symbol(_) => expression,
            Node::Add(a, b) => self.add(of(&a), of(&b)),
            Node::Negate(a) => self.negate(of(&a)),
            Node::Multiply(a, b) => self.multiply(of(&a), of(&b)),
            Node::Divide(a, b) => self.divide(of(&a), of(&b)),
            Node::Power(a, exponent) => self.power(of(&a), exponent),
            Node::Apply(operation, arguments) => {
                let arguments: Vec<Expr> = arguments.iter().map(of).collect();
                self.apply(operation, &arguments)
            }
            Node::Jet { function, orders, arguments } => {
                let arguments: Vec<Expr> = arguments.iter().map(of).collect();
                self.jet(function, &orders, &arguments)
            }
            Node::Select { left, relation, right, then, otherwise, seam } => {
                self.select((of(&left), relation, of(&right)), of(&then), of(&otherwise), seam)
            }
        }
    }
}
