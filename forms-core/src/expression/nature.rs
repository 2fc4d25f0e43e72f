//! Signs that are evident from the form of an expression: squares, roots, exponentials, and sums
//! and products of these.

use super::node::{Expr, Node};
use super::operation::Operation;
use super::pool::Pool;
use num_traits::{Signed, Zero};
use rustc_hash::{FxHashMap, FxHashSet};

/// Evident sign of an expression, valid wherever the expression is defined.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Nature {
    /// Unknown.
    Open,
    /// Non-negative.
    NotNegative,
    /// Positive.
    Positive,
}

/// Returns the sign that all values of a function share, if it is evident.
fn nature_of_function(operation: Operation) -> Nature {
    match operation {
        Operation::Exp | Operation::Cosh => Nature::Positive,
        Operation::Expint1 | Operation::Expint2 | Operation::Expint3 => Nature::Positive,
        Operation::Erfc => Nature::Positive,
        Operation::Abs | Operation::Hypot => Nature::NotNegative,
        _ => Nature::Open,
    }
}

impl Pool {
    /// Returns the sign that is evident from the form of an expression.
    pub(crate) fn nature(&self, expression: Expr) -> Nature {
        let mut signs: FxHashMap<Expr, Nature> = FxHashMap::default();
        for part in self.reachable(&[expression]) {
            let of = |operand: &Expr| signs[operand];
            let nature = match self.node(part) {
                Node::Number(value) if value.is_positive() => Nature::Positive,
                Node::Number(value) if value.is_zero() => Nature::NotNegative,
                Node::Pi => Nature::Positive,
                Node::Apply(operation, _) => nature_of_function(*operation),
                Node::Add(a, b) if of(a) != Nature::Open && of(b) != Nature::Open => of(a).max(of(b)),
                Node::Multiply(a, b) | Node::Divide(a, b) => of(a).min(of(b)),
                Node::Power(a, _) if of(a) == Nature::Positive => Nature::Positive,
                Node::Power(_, r) if !r.is_integer() || r.numer() % 2 == 0 => Nature::NotNegative,
                Node::Power(a, _) => of(a),
                _ => Nature::Open,
            };
            signs.insert(part, nature);
        }
        signs[&expression]
    }

    /// Returns the factors of a product as written, without powers, divisors and signs: the product
    /// is zero where any factor is zero.
    pub(crate) fn factors_that_may_vanish(&self, expression: Expr) -> Vec<Expr> {
        let (mut found, mut rest) = (Vec::new(), vec![expression]);
        let mut seen = FxHashSet::default();
        while let Some(part) = rest.pop() {
            // repeated squaring gives few subexpressions but many factors
            if !seen.insert(part) {
                continue;
            }
            match self.node(part) {
                Node::Multiply(a, b) => rest.extend([*b, *a]),
                Node::Divide(a, _) | Node::Negate(a) | Node::Power(a, _) => rest.push(*a),
                Node::Number(value) if !value.is_zero() => {}
                _ if self.nature(part) == Nature::Positive => {}
                _ => found.push(part),
            }
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::SymbolKind;

    #[test]
    fn a_product_of_shared_parts_is_taken_apart_once() {
        let mut pool = Pool::new();
        let [x, y] = ["x", "y"].map(|name| {
            let symbol = pool.declare_symbol(name, SymbolKind::Local);
            pool.symbol(symbol)
        });
        let sum = pool.add(x, y);
        let mut product = pool.multiply(sum, x);
        for _ in 0..60 {
            product = pool.multiply(product, product);
        }
        assert_eq!(pool.factors_that_may_vanish(product), [sum, x]);
    }
}
