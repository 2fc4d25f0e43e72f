//! Partial derivatives of structured expressions: the chain rule over the expression graph, each
//! node differentiated once.

use super::extremum::{Extremum, Operands};
use super::node::{Expr, Node, Origin, Symbol};
use super::operation::Operation;
use super::pool::Pool;
use num_rational::Ratio;

impl Pool {
    /// Returns ∂e/∂x. Derivatives are cached, so a shared subexpression is differentiated once.
    /// ∂(−e)/∂x is −∂e/∂x, so the result is recognised as a derivative of e whatever sign it is
    /// given afterwards.
    pub fn derivative(&mut self, expression: Expr, by: Symbol) -> Expr {
        if let Node::Negate(of) = *self.node(expression) {
            let derivative = self.derivative(of, by);
            return self.negate(derivative);
        }
        if let Some(&known) = self.derivatives.get(&(expression, by)) {
            self.note_origin(known, expression, by);
            return known;
        }
        if !self.may_mention(expression, by) {
            return self.integer(0);
        }
        let parts = self.parts_with(expression, by);
        self.derivatives.reserve(parts.len());
        for node in parts {
            if !self.derivatives.contains_key(&(node, by)) {
                let value = match self.as_extremum(node) {
                    Some((which, operands)) => self.derivative_of_extremum(which, operands, by),
                    None => self.derivative_of_node(node, by),
                };
                self.derivatives.insert((node, by), value);
            }
        }
        let derivative = self.derivatives[&(expression, by)];
        self.note_origin(derivative, expression, by);
        derivative
    }

    /// Records the differentiated expression as the origin of its derivative, if it precedes the
    /// derivative in the pool.
    fn note_origin(&mut self, derivative: Expr, of: Expr, by: Symbol) {
        let trivial = matches!(self.node(derivative), Node::Number(_) | Node::Symbol(_) | Node::Pi);
        if trivial || of >= derivative || self.origins.contains_key(&derivative) {
            return;
        }
        let repeated = self.least_derivative.is_some_and(|least| least <= of)
            && self.reachable(&[of]).iter().any(|part| self.origins.contains_key(part));
        self.origins.insert(derivative, Origin { of, by, repeated });
        self.least_derivative = Some(self.least_derivative.map_or(derivative, |least| least.min(derivative)));
    }

    /// Returns the expression and the variable that an expression was differentiated from, if it
    /// arose as a derivative.
    pub(crate) fn origin(&self, expression: Expr) -> Option<Origin> {
        self.origins.get(&expression).copied()
    }

    /// Returns the subexpressions that may depend on a variable, operands before results.
    fn parts_with(&self, expression: Expr, by: Symbol) -> Vec<Expr> {
        let mut wanted = vec![false; expression.0 as usize + 1];
        wanted[expression.0 as usize] = true;
        let mut parts = Vec::new();
        for index in (0..=expression.0).rev() {
            if wanted[index as usize] {
                parts.push(Expr(index));
                self.node(Expr(index)).for_each_operand(|operand| {
                    wanted[operand.0 as usize] |= self.may_mention(operand, by);
                });
            }
        }
        parts.reverse();
        parts
    }

    /// Differentiates one node, given the derivatives of its operands that depend on the variable.
    fn derivative_of_node(&mut self, expression: Expr, by: Symbol) -> Expr {
        let node = self.node(expression).clone();
        let zero = self.integer(0);
        let of = |pool: &Pool, operand: Expr| {
            if pool.may_mention(operand, by) { pool.derivatives[&(operand, by)] } else { zero }
        };
        match node {
            Node::Number(_) | Node::Pi => zero,
            Node::Symbol(symbol) => self.integer(i64::from(symbol == by)),
            Node::Add(a, b) => {
                let (da, db) = (of(self, a), of(self, b));
                self.add(da, db)
            }
            Node::Negate(a) => {
                let da = of(self, a);
                self.negate(da)
            }
            Node::Multiply(a, b) => {
                let (da, db) = (of(self, a), of(self, b));
                let (left, right) = (self.multiply(da, b), self.multiply(a, db));
                self.add(left, right)
            }
            Node::Divide(a, b) => {
                let (da, db) = (of(self, a), of(self, b));
                self.derivative_of_quotient(expression, (da, b), db)
            }
            Node::Power(a, exponent) => {
                let da = of(self, a);
                self.derivative_of_power(a, exponent, da)
            }
            Node::Apply(operation, arguments) => {
                let inner: Vec<Expr> = arguments.iter().map(|&a| of(self, a)).collect();
                if inner.iter().all(|&d| self.is_zero(d)) {
                    return zero;
                }
                let partials = operation.partials(self, &arguments);
                self.chain(&partials, &inner)
            }
            Node::Jet { function, orders, arguments } => {
                let inner: Vec<Expr> = arguments.iter().map(|&a| of(self, a)).collect();
                let partials: Vec<Expr> = (0..orders.len())
                    .map(|i| {
                        if self.is_zero(inner[i]) {
                            return inner[i];
                        }
                        let mut raised = orders.clone();
                        raised[i] += 1;
                        self.jet(function, &raised, &arguments)
                    })
                    .collect();
                self.chain(&partials, &inner)
            }
            Node::Select { left, relation, right, then, otherwise, seam } => {
                let (a, b) = (of(self, then), of(self, otherwise));
                self.select((left, relation, right), a, b, seam)
            }
        }
    }

    /// (a/b)′ = (a′ − (a/b) b′)/b, which keeps the quotient shared.
    fn derivative_of_quotient(&mut self, quotient: Expr, (da, b): (Expr, Expr), db: Expr) -> Expr {
        let correction = self.multiply(quotient, db);
        let numerator = self.subtract(da, correction);
        self.divide(numerator, b)
    }

    /// min(a, b)′ = (a′ (1 − s) + b′ (1 + s))/2 with s = (a − b)/|a − b|: one factor is 0 and the
    /// other is 2, so that no digit of the derivative that is selected is lost.
    fn derivative_of_extremum(&mut self, which: Extremum, operands: Operands, by: Symbol) -> Expr {
        let (zero, one, two) = (self.integer(0), self.integer(1), self.integer(2));
        let [a, b] = operands.map(|operand| operand.unwrap_or(zero));
        let [da, db] = [a, b].map(|q| self.derivatives.get(&(q, by)).copied().unwrap_or(zero));
        if da == db {
            return da;
        }
        let difference = match which {
            Extremum::Least => self.subtract(a, b),
            Extremum::Greatest => self.subtract(b, a),
        };
        let magnitude = self.apply(Operation::Abs, &[difference]);
        let sign = self.divide(difference, magnitude);
        let (of_a, of_b) = (self.subtract(one, sign), self.add(one, sign));
        let (left, right) = (self.multiply(da, of_a), self.multiply(db, of_b));
        let sum = self.add(left, right);
        self.divide(sum, two)
    }

    /// (aʳ)′ = r aʳ⁻¹ a′
    fn derivative_of_power(&mut self, a: Expr, exponent: Ratio<i64>, da: Expr) -> Expr {
        if self.is_zero(da) {
            return da;
        }
        let lowered = self.power(a, exponent - Ratio::from_integer(1));
        let factor = self.ratio(*exponent.numer(), *exponent.denom());
        let outer = self.multiply(factor, lowered);
        self.multiply(outer, da)
    }

    /// Σ ∂f/∂qᵢ · qᵢ′
    fn chain(&mut self, partials: &[Expr], inner: &[Expr]) -> Expr {
        let mut sum = self.integer(0);
        for (&partial, &derivative) in partials.iter().zip(inner) {
            let term = self.multiply(partial, derivative);
            sum = self.add(sum, term);
        }
        sum
    }
}
