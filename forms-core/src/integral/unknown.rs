//! Integrands with unknown functions that are derivatives of an expression: the fundamental
//! theorem.
//!
//! Let u stand for an unknown function along the variable x. A derivative DG is linear in its
//! highest derivative u⁽ⁿ⁾, n ≥ 1, and the coefficient is ∂G/∂u⁽ⁿ⁻¹⁾:
//!
//! ```text
//! f = A u⁽ⁿ⁾ + B,   G₀ = ∫ A du⁽ⁿ⁻¹⁾,   f − DG₀ has lower derivatives of u
//! ```
//! So the reduction ends, either with an integrand free of unknown functions or with one that is
//! not a derivative. This is the reduction of Boulier, Lemaire, Regensburger and Rosenkranz, On the
//! Integration of Differential Fractions (ISSAC 2013), with the partial derivatives of a function
//! of several arguments, f(a(x), b(x), …), ranked by total order and then lexicographically: the
//! leading term of D f = a′ f₁ + b′ f₂ + … is the derivative by the first argument that depends on
//! x.

use super::search::{Integrand, Search};
use super::{Failure, normal_form};
use crate::expression::{Condition, Expr, FunctionId, Node, Symbol, SymbolKind};
use crate::normal::{Generator, Tower, Trigonometry};
use crate::polynomial::Polynomial;
use rustc_hash::FxHashMap;

/// Limit on the number of derivatives that are reduced in one integrand.
const MOST_REDUCTIONS: u32 = 64;

/// Rank of a derivative among the derivatives of one integrand: the class, then the total order and
/// the orders by the arguments that depend on the variable.
type Rank = (Class, u32, Vec<u32>);

/// Identity of one unknown function along the variable: the function, its arguments, and the orders
/// by the other arguments.
type Class = (FunctionId, Vec<Expr>, Vec<u32>);

/// A derivative of an unknown function that depends on the variable.
struct Derivative {
    generator: u32,
    rank: Rank,
    function: FunctionId,
    orders: Vec<u32>,
    arguments: Vec<Expr>,
    /// The first argument that depends on the variable.
    first: usize,
}

impl Search<'_> {
    /// Returns an antiderivative if unknown functions of the variable occur; `None` if none occur.
    pub(super) fn by_unknown_functions(
        &mut self,
        integrand: &mut Integrand,
        depth: u32,
    ) -> Result<Option<Expr>, Failure> {
        if integrand.such_that(|generator| matches!(generator, Generator::Jet { .. })).is_empty() {
            return Ok(None);
        }
        let (symbol, conditions) = (integrand.symbol, integrand.conditions);
        let (found, rest) = self.reduced(integrand.expression, symbol, conditions, depth)?;
        if self.has_unknowns(rest, symbol) {
            return Err(self.not_integrable(integrand));
        }
        let last = self.antiderivative(rest, symbol, conditions, depth)?;
        Ok(Some(self.pool.add(found, last)))
    }

    /// Whether an unknown function is evaluated at arguments that depend on the variable.
    pub(super) fn has_unknowns(&self, expression: Expr, symbol: Symbol) -> bool {
        self.pool.reachable(&[expression]).into_iter().any(|part| {
            matches!(self.pool.node(part), Node::Jet { .. })
                && self.pool.symbols_in(&[part]).contains(&symbol)
        })
    }

    /// Returns G and f − DG, reduced as long as the highest derivative gets lower.
    pub(super) fn reduced(
        &mut self,
        integrand: Expr,
        symbol: Symbol,
        conditions: &[Condition],
        depth: u32,
    ) -> Result<(Expr, Expr), Failure> {
        let (mut found, mut rest) = (self.pool.integer(0), integrand);
        let mut next: Option<(Expr, Expr)> = None;
        let mut last: Option<Rank> = None;
        for _ in 0..MOST_REDUCTIONS {
            let (sum, remainder) = next.unwrap_or((found, rest));
            let mut tower = Tower::new(Trigonometry::Circle);
            let normal = normal_form(self.pool, &mut tower, remainder, conditions)?;
            let generators = tower.generators_in(&normal, symbol);
            let expression = tower.raise(self.pool, &normal);
            let mut left =
                Integrand { expression, normal, tower: &mut tower, symbol, generators, conditions };
            let leading = self.leading(&left);
            if last.is_some() && leading.as_ref().map(|leading| &leading.rank) >= last.as_ref() {
                return Ok((found, rest));
            }
            (found, rest) = (sum, expression);
            let Some(leading) = leading else { return Ok((found, rest)) };
            let Some(part) = self.reduction(&mut left, &leading, depth) else { return Ok((found, rest)) };
            let derivative = self.pool.derivative(part, symbol);
            next = Some((self.pool.add(found, part), self.pool.subtract(rest, derivative)));
            last = Some(leading.rank);
        }
        Err(format!("the integrand has more than {MOST_REDUCTIONS} derivatives of unknown functions").into())
    }

    /// Returns ∫ A du⁽ⁿ⁻¹⁾ for the leading derivative u⁽ⁿ⁾, if the integrand may be a derivative.
    fn reduction(&mut self, integrand: &mut Integrand, leading: &Derivative, depth: u32) -> Option<Expr> {
        let terms = integrand.tower.laurent_terms(&integrand.normal, &[leading.generator])?;
        if leading.orders[leading.first] == 0 || terms.iter().any(|(powers, _)| !(0..=1).contains(&powers[0]))
        {
            return None;
        }
        let (_, coefficient) = terms.into_iter().find(|(powers, _)| powers[0] == 1)?;
        let coefficient = integrand.tower.raise(self.pool, &coefficient);
        let mut orders = leading.orders.clone();
        orders[leading.first] -= 1;
        let lowered = self.pool.jet(leading.function, &orders, &leading.arguments);
        let speed = self.pool.derivative(leading.arguments[leading.first], integrand.symbol);
        let share = self.pool.divide(coefficient, speed);
        let value = self.pool.declare_symbol("u", SymbolKind::Local);
        let images: FxHashMap<Expr, Expr> = [(lowered, self.pool.symbol(value))].into_iter().collect();
        let conditions: Vec<Condition> = integrand
            .conditions
            .iter()
            .map(|condition| Condition {
                left: self.pool.replace(condition.left, &images),
                relation: condition.relation,
                right: self.pool.replace(condition.right, &images),
            })
            .collect();
        let share = self.pool.replace(share, &images);
        if self.outranks(share, leading, integrand) {
            return None;
        }
        let found = self.antiderivative(share, value, &conditions, depth.checked_sub(1)?).ok()?;
        let back = [(value, lowered)].into_iter().collect();
        Some(self.pool.substitute(found, &back))
    }

    /// Whether a derivative of the same function occurs whose total order is not below the order of
    /// the leading derivative.
    fn outranks(&mut self, share: Expr, leading: &Derivative, integrand: &Integrand) -> bool {
        let (class, total, _) = &leading.rank;
        self.pool.reachable(&[share]).into_iter().any(|part| {
            self.derivative_at(part, 0, integrand)
                .is_some_and(|other| other.rank.0 == *class && other.rank.1 >= *total)
        })
    }

    /// Returns the derivative of the highest rank.
    fn leading(&mut self, integrand: &Integrand) -> Option<Derivative> {
        let jets = integrand.such_that(|generator| matches!(generator, Generator::Jet { .. }));
        let mut found: Vec<Derivative> = Vec::new();
        for generator in jets {
            let written = integrand.tower.raise(self.pool, &Polynomial::variable(generator).into());
            found.extend(self.derivative_at(written, generator, integrand));
        }
        found.into_iter().max_by(|a, b| a.rank.cmp(&b.rank))
    }

    /// Returns the expression as a derivative of an unknown function, if it is one and depends on
    /// the variable.
    fn derivative_at(&self, written: Expr, generator: u32, integrand: &Integrand) -> Option<Derivative> {
        let Node::Jet { function, orders, arguments } = self.pool.node(written) else { return None };
        let moves = |argument: &Expr| self.pool.symbols_in(&[*argument]).contains(&integrand.symbol);
        let first = arguments.iter().position(moves)?;
        let moving: Vec<u32> = orders
            .iter()
            .zip(arguments)
            .map(|(&order, argument)| if moves(argument) { order } else { 0 })
            .collect();
        let fixed = orders.iter().zip(&moving).map(|(order, moving)| order - moving).collect();
        let rank = ((*function, arguments.to_vec(), fixed), moving.iter().sum(), moving);
        let (function, orders, arguments) = (*function, orders.to_vec(), arguments.to_vec());
        Some(Derivative { generator, rank, function, orders, arguments, first })
    }
}
