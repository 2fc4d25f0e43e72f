//! Quadratures: definite integrals that stay unevaluated, to be computed numerically.
//!
//! ```text
//! Q(a, b, q₁ … qₖ) = ∫ₐᵇ w(s, q₁ … qₖ) ds      each qᵢ one variable of the integrand other than s
//! ```
//! Such an integral is a function of its limits and of the other variables of its integrand, which
//! is written in formal variables. The same integral under other names is therefore the same
//! function, and a substitution leaves the integrand untouched. A numeric factor precedes the
//! integral, and the factors of the integrand are in the order of the pool. The derivatives of Q
//! are −w(a), w(b) and the quadratures of the derivatives of w.

use super::integral_table::Quadrature;
use super::node::{Expr, FunctionId, Symbol};
use super::pool::Pool;
use super::substitution::Substitution;

impl Pool {
    /// Builds ∫ integrand d variable between two limits, unevaluated.
    pub(crate) fn quadrature(&mut self, integrand: Expr, variable: Symbol, from: Expr, to: Expr) -> Expr {
        if self.is_zero(integrand) {
            return self.integer(0);
        }
        let captured: Vec<Symbol> =
            self.symbols_in(&[integrand]).into_iter().filter(|&symbol| symbol != variable).collect();
        let formal = self.formal_variable(0);
        let parameters: Vec<Symbol> =
            (0..captured.len()).map(|number| self.formal_parameter(number)).collect();
        let mut values: Substitution = Substitution::default();
        for (&own, &formal) in captured.iter().chain([&variable]).zip(parameters.iter().chain([&formal])) {
            values.insert(own, self.symbol(formal));
        }
        let integrand = self.substitute(integrand, &values);
        let (number, integrand) = self.content(integrand);
        let (number, integrand) = (self.number(number), self.with_factors_in_order(integrand));
        let function = self.function_of(Quadrature { integrand, variable: formal, parameters });
        let mut arguments = vec![from, to];
        arguments.extend(captured.into_iter().map(|symbol| self.symbol(symbol)));
        let orders = vec![0; arguments.len()];
        let integral = self.jet(function, &orders, &arguments);
        self.multiply(number, integral)
    }

    fn function_of(&mut self, quadrature: Quadrature) -> FunctionId {
        if let Some(&known) = self.quadratures.functions.get(&quadrature) {
            return known;
        }
        let ends = [self.formal_end(0), self.formal_end(1)];
        let arguments = ends.into_iter().chain(quadrature.parameters.iter().copied()).collect();
        let function = self.declare_function("quadrature", arguments);
        self.quadratures.functions.insert(quadrature.clone(), function);
        self.quadratures.integrands.insert(function, quadrature);
        function
    }

    /// Returns the integrand and the variables of a function, if it is a quadrature.
    pub(crate) fn quadrature_of(&self, function: FunctionId) -> Option<&Quadrature> {
        self.quadratures.integrands.get(&function)
    }

    /// Returns the integrand of a quadrature at these arguments, and its integration variable,
    /// which does not occur in them.
    pub(crate) fn integrand_at(
        &mut self,
        function: FunctionId,
        arguments: &[Expr],
    ) -> Option<(Expr, Symbol)> {
        let Quadrature { integrand, variable, parameters } = self.quadrature_of(function)?.clone();
        let taken = self.symbols_in(arguments);
        let free = (0..=taken.len()).map(|number| self.formal_variable(number));
        let fresh = free.collect::<Vec<_>>().into_iter().find(|symbol| !taken.contains(symbol))?;
        let mut values: Substitution = parameters.into_iter().zip(arguments[2..].iter().copied()).collect();
        values.insert(variable, self.symbol(fresh));
        Some((self.substitute(integrand, &values), fresh))
    }

    /// Returns the derivative of a quadrature with these orders. `None` if all orders are zero or
    /// the function is not a quadrature.
    pub(super) fn derivative_of_quadrature(
        &mut self,
        function: FunctionId,
        orders: &[u32],
        arguments: &[Expr],
    ) -> Option<Expr> {
        let Quadrature { integrand, variable, parameters } = self.quadrature_of(function)?.clone();
        let place = orders.iter().position(|&order| order > 0)?;
        let rest: Vec<(usize, u32)> =
            (0..orders.len()).map(|number| (number, orders[number] - u32::from(number == place))).collect();
        // the arguments are formal variables here, so that the remaining orders can be applied by
        // differentiation
        let ends = [self.formal_end(0), self.formal_end(1)];
        let formal: Vec<Symbol> = ends.into_iter().chain(parameters.iter().copied()).collect();
        let [from, to] = ends.map(|end| self.symbol(end));
        let mut value = match place {
            0 | 1 => {
                let end = if place == 0 { from } else { to };
                let at: Substitution = [(variable, end)].into_iter().collect();
                let value = self.substitute(integrand, &at);
                if place == 0 { self.negate(value) } else { value }
            }
            _ => {
                let slope = self.derivative(integrand, parameters[place - 2]);
                self.quadrature(slope, variable, from, to)
            }
        };
        for (number, order) in rest {
            for _ in 0..order {
                value = self.derivative(value, formal[number]);
            }
        }
        let values: Substitution = formal.into_iter().zip(arguments.iter().copied()).collect();
        Some(self.substitute(value, &values))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::SymbolKind;

    fn declared(pool: &mut Pool, name: &str) -> (Symbol, Expr) {
        let symbol = pool.declare_symbol(name, SymbolKind::Local);
        (symbol, pool.symbol(symbol))
    }

    #[test]
    fn the_same_integral_under_other_names_is_the_same_expression() {
        let mut pool = Pool::new();
        let [(x, x_value), (y, y_value), (_, a)] = ["x", "y", "a"].map(|name| declared(&mut pool, name));
        let integrals = [(x, x_value), (y, y_value)].map(|(variable, value)| {
            let product = pool.multiply(a, value);
            let zero = pool.integer(0);
            pool.quadrature(product, variable, zero, a)
        });
        assert_eq!(integrals[0], integrals[1]);
        assert_eq!(pool.symbols_in(&integrals), pool.symbols_in(&[a]));
    }

    #[test]
    fn derivatives_are_taken_at_the_ends_and_under_the_integral() {
        let mut pool = Pool::new();
        let [(t, t_value), (a, a_value)] = ["t", "a"].map(|name| declared(&mut pool, name));
        let power = pool.power(t_value, 2.into());
        let integrand = pool.multiply(a_value, power);
        let zero = pool.integer(0);
        let integral = pool.quadrature(integrand, t, zero, a_value);
        let derivative = pool.derivative(integral, a);
        assert_eq!(pool.text(derivative), "a*a**2 + quadrature(s1**2, s1 = 0..a)");
    }
}
