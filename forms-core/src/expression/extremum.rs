//! The smaller and the larger of two numbers.
//!
//! ```text
//! min(a, b) = (a + b − |a − b|)/2      max(a, b) = (a + b + |a − b|)/2
//! ```
//! In this form, proofs, enclosures and certificates need no rule of their own. Kernels recognise the
//! form and compare a with b instead (`kernel/lower.rs`), which is exact and cannot cancel. The
//! derivative is that of the operand that is selected; it is not defined where a = b.

use super::node::{Expr, Node, Rational};
use super::operation::Operation;
use super::pool::Pool;
use crate::expression::{Relation, Seam};
use num_traits::Zero;
use rustc_hash::FxHashMap;

/// Which of two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Extremum {
    /// The smaller one.
    Least,
    /// The larger one.
    Greatest,
}

/// Operands of a minimum or maximum; `None` is the number 0, which leaves no trace in a sum.
pub(crate) type Operands = [Option<Expr>; 2];

impl Pool {
    /// Builds the smaller or the larger of two numbers.
    pub(crate) fn extremum(&mut self, which: Extremum, a: Expr, b: Expr) -> Expr {
        if let (Some(p), Some(q)) = (self.as_number(a), self.as_number(b)) {
            return if (p < q) == (which == Extremum::Least) { a } else { b };
        }
        if a == b {
            return a;
        }
        let (sum, distance, two) = (self.add(a, b), self.subtract(a, b), self.integer(2));
        let magnitude = self.apply(Operation::Abs, &[distance]);
        let above = match which {
            Extremum::Least => self.subtract(sum, magnitude),
            Extremum::Greatest => self.add(sum, magnitude),
        };
        self.divide(above, two)
    }

    /// Returns the operands of an expression that is built as a minimum or maximum.
    pub(crate) fn as_extremum(&self, expression: Expr) -> Option<(Extremum, Operands)> {
        let Node::Divide(above, two) = *self.node(expression) else { return None };
        let Node::Add(sum, rest) = *self.node(above) else { return None };
        let (which, magnitude) = match *self.node(rest) {
            Node::Negate(magnitude) => (Extremum::Least, magnitude),
            _ => (Extremum::Greatest, rest),
        };
        let Node::Apply(Operation::Abs, of) = self.node(magnitude) else { return None };
        let is_half = self.as_number(two).is_some_and(|two| *two == Rational::from_integer(2.into()));
        let operands = is_half.then(|| self.operands_of(sum, of[0])).flatten()?;
        Some((which, operands))
    }

    /// Returns a and b of a sum a + b and a difference a − b, as they are built.
    fn operands_of(&self, sum: Expr, difference: Expr) -> Option<Operands> {
        if sum == difference {
            return Some([Some(sum), None]);
        }
        if self.are_opposite(sum, difference) {
            return Some([None, Some(sum)]);
        }
        let (Node::Add(a, b), Node::Add(c, d)) = (self.node(sum), self.node(difference)) else {
            return None;
        };
        (a == c && self.are_opposite(*b, *d)).then_some([Some(*a), Some(*b)])
    }

    /// Whether one expression is built as the negative of the other.
    fn are_opposite(&self, a: Expr, b: Expr) -> bool {
        match (self.node(a), self.node(b)) {
            (Node::Negate(inner), _) if *inner == b => true,
            (_, Node::Negate(inner)) if *inner == a => true,
            (Node::Number(p), Node::Number(q)) => (p + q).is_zero(),
            _ => false,
        }
    }

    /// Returns expressions in which minima and maxima are conditionals: a < b decides.
    pub(crate) fn with_compared_extrema(&mut self, expressions: &[Expr]) -> Vec<Expr> {
        let order = self.reachable(expressions);
        if order.iter().all(|&part| self.as_extremum(part).is_none()) {
            return expressions.to_vec();
        }
        let mut compared: FxHashMap<Expr, Expr> = FxHashMap::default();
        for part in order {
            let value = match self.as_extremum(part) {
                Some((which, operands)) => {
                    let zero = self.integer(0);
                    let [a, b] = operands.map(|operand| operand.map_or(zero, |operand| compared[&operand]));
                    let (then, otherwise) = if which == Extremum::Least { (a, b) } else { (b, a) };
                    self.select((a, Relation::Less, b), then, otherwise, Seam::Agrees)
                }
                None => self.image(part, self.node(part).clone(), &compared),
            };
            compared.insert(part, value);
        }
        expressions.iter().map(|expression| compared[expression]).collect()
    }
}
