//! Putting expressions in the place of variables, everywhere at once.

use super::node::{Expr, Node, Pool, Symbol};
use rustc_hash::FxHashMap;

/// What stands for each variable; variables not named stay.
pub type Substitution = FxHashMap<Symbol, Expr>;

impl Pool {
    /// The expression with every variable replaced at once; unknown functions become composed with it.
    pub fn substitute(&mut self, expression: Expr, values: &Substitution) -> Expr {
        self.substitute_all(&[expression], values)[0]
    }

    /// The same for several expressions that share nodes.
    pub fn substitute_all(&mut self, expressions: &[Expr], values: &Substitution) -> Vec<Expr> {
        let mut images: FxHashMap<Expr, Expr> = FxHashMap::default();
        for expression in self.reachable(expressions) {
            let image = self.image(expression, values, &images);
            images.insert(expression, image);
        }
        expressions.iter().map(|expression| images[expression]).collect()
    }

    /// The expression with some of its parts replaced by others.
    pub fn replace(&mut self, expression: Expr, parts: &FxHashMap<Expr, Expr>) -> Expr {
        let mut images: FxHashMap<Expr, Expr> = FxHashMap::default();
        let none = Substitution::default();
        for part in self.reachable(&[expression]) {
            let image = match parts.get(&part) {
                Some(&replacement) => replacement,
                None => self.image(part, &none, &images),
            };
            images.insert(part, image);
        }
        images[&expression]
    }

    fn image(&mut self, expression: Expr, values: &Substitution, images: &FxHashMap<Expr, Expr>) -> Expr {
        let of = |operand: &Expr| images[operand];
        match self.node(expression).clone() {
            Node::Number(_) | Node::Pi => expression,
            Node::Symbol(symbol) => values.get(&symbol).copied().unwrap_or(expression),
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
            Node::Select { left, relation, right, then, otherwise } => {
                self.select((of(&left), relation, of(&right)), of(&then), of(&otherwise))
            }
        }
    }
}
