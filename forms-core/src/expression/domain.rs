//! Domain on which an expression is real: one condition for each operation that is not defined
//! everywhere.

use super::condition::Condition;
use super::node::{Expr, Node};
use super::operation::Operation;
use super::pool::Pool;
use crate::expression::Relation;
use num_rational::Ratio;
use num_traits::{Signed, Zero};

impl Pool {
    /// a / b is defined for b ≠ 0.
    pub(crate) fn quotient_domain(&mut self, divisor: Expr) -> Option<Condition> {
        self.against_zero(divisor, Relation::NotEqual)
    }

    /// qʳ is real for q ≠ 0 where r is a negative integer, and for q > 0 or q ≥ 0 where r is a
    /// fraction.
    pub(crate) fn power_domain(&mut self, base: Expr, exponent: Ratio<i64>) -> Option<Condition> {
        match (exponent.is_integer(), exponent.is_negative()) {
            (true, true) => self.against_zero(base, Relation::NotEqual),
            (true, false) => None,
            (false, true) => self.against_zero(base, Relation::Greater),
            (false, false) => self.against_zero(base, Relation::GreaterEqual),
        }
    }

    /// Returns the condition under which a function is real: log q and E₁(q) for q > 0, E₂(q) and
    /// E₃(q) for q ≥ 0, log1p q for 1 + q > 0, Li₂(q) for 1 − q ≥ 0, tan q for cos q ≠ 0, asin q
    /// and acos q for 1 − q² ≥ 0, atan2(y, x) off its branch cut, where √(x² + y²) + x > 0.
    pub(crate) fn operation_domain(&mut self, operation: Operation, q: &[Expr]) -> Option<Condition> {
        match operation {
            Operation::Log | Operation::Expint1 => self.against_zero(q[0], Relation::Greater),
            Operation::Log1p => {
                let one = self.integer(1);
                let sum = self.add(one, q[0]);
                self.against_zero(sum, Relation::Greater)
            }
            Operation::Expint2 | Operation::Expint3 => self.against_zero(q[0], Relation::GreaterEqual),
            Operation::Dilog => {
                let one = self.integer(1);
                let rest = self.subtract(one, q[0]);
                self.against_zero(rest, Relation::GreaterEqual)
            }
            Operation::Tan => {
                let cosine = self.apply(Operation::Cos, q);
                self.against_zero(cosine, Relation::NotEqual)
            }
            Operation::Asin | Operation::Acos => {
                let square = self.power(q[0], 2.into());
                let one = self.integer(1);
                let rest = self.subtract(one, square);
                self.against_zero(rest, Relation::GreaterEqual)
            }
            Operation::Atan2 => {
                let (y2, x2) = (self.power(q[0], 2.into()), self.power(q[1], 2.into()));
                let r2 = self.add(x2, y2);
                let r = self.sqrt(r2);
                let off_the_cut = self.add(r, q[1]);
                self.against_zero(off_the_cut, Relation::Greater)
            }
            Operation::Sin
            | Operation::Cos
            | Operation::Atan
            | Operation::Exp
            | Operation::Sinh
            | Operation::Cosh
            | Operation::Tanh
            | Operation::Expm1
            | Operation::Erf
            | Operation::Clausen
            | Operation::Erfc
            | Operation::Hypot
            | Operation::Cbrt
            | Operation::Abs => None,
        }
    }

    /// Returns the conditions under which every operation in the expressions is defined, in both
    /// branches of every `if`.
    pub(crate) fn domain(&mut self, expressions: &[Expr]) -> Vec<Condition> {
        let mut conditions: Vec<Condition> = Vec::new();
        for expression in self.reachable(expressions) {
            let condition = match self.node(expression).clone() {
                Node::Divide(_, divisor) => self.quotient_domain(divisor),
                Node::Power(base, exponent) => self.power_domain(base, exponent),
                Node::Apply(operation, arguments) => self.operation_domain(operation, &arguments),
                _ => None,
            };
            if let Some(condition) = condition
                && !conditions.contains(&condition)
            {
                conditions.push(condition);
            }
        }
        conditions
    }

    /// Returns the condition `left relation 0`, unless `left` is a number that satisfies it.
    fn against_zero(&mut self, left: Expr, relation: Relation) -> Option<Condition> {
        if self.as_number(left).is_some_and(|value| relation.admits(value.cmp(&Zero::zero()))) {
            return None;
        }
        Some(Condition { left, relation, right: self.integer(0) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::SymbolKind;

    #[test]
    fn every_partial_operation_asks_for_its_domain_once() {
        let mut pool = Pool::new();
        let x = pool.declare_symbol("x", SymbolKind::Local);
        let x = pool.symbol(x);
        let root = pool.sqrt(x);
        let logarithm = pool.apply(Operation::Log, &[x]);
        let (two, sine) = (pool.integer(2), pool.apply(Operation::Asin, &[x]));
        let half = pool.divide(sine, two);
        let inverse = pool.power(root, (-1).into());
        let conditions = pool.domain(&[logarithm, half, inverse, root]);
        let texts: Vec<String> = conditions.iter().map(|condition| condition.text(&pool)).collect();
        assert_eq!(texts, ["x >= 0", "x > 0", "1 - x**2 >= 0"]);
    }
}
