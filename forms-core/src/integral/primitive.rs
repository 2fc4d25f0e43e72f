//! Integrals of unknown functions that are not derivatives: sums of products, each with its
//! primitive.
//!
//! ```text
//! f = DG + Σ cᵢ fᵢ + e,   ∫ f = G + Σ cᵢ Φᵢ + ∫ e,   fᵢ a product of unknown functions and of others, cᵢ free of x
//! ```
//! The reduction to G + … leaves no derivative of the last function in a product, so that integrals
//! that integration by parts transforms into each other end as the same sum. e contains no unknown
//! function of x.

use super::range::Integral;
use super::search::{DEPTH, Search};
use super::signs::Region;
use super::{Failure, normal_form};
use crate::expression::{Condition, Expr, Node, Pool, Substitution, Symbol, SymbolKind};
use crate::normal::{Tower, Trigonometry};
use rustc_hash::FxHashMap;

/// Limit on the number of products into which one integrand is decomposed.
const MOST_PRODUCTS: usize = 256;

/// An integrand decomposed into an antiderivative and the remaining terms.
struct Apart {
    antiderivative: Expr,
    /// The products that have primitives.
    products: Vec<Expr>,
    /// The terms without unknown functions.
    elementary: Expr,
}

impl Region {
    /// Returns the integral over the innermost range by primitives; `None` if no unknown function
    /// of its variable occurs.
    pub(super) fn by_primitives(&self, pool: &mut Pool, integrand: Expr) -> Result<Option<Integral>, String> {
        let Some(&(variable, from, to)) = self.ranges.last() else { return Ok(None) };
        let mut search = Search { pool, region: self };
        if !search.has_unknowns(integrand, variable) {
            return Ok(None);
        }
        let apart = search.apart(integrand, variable, &self.conditions).map_err(|failure| failure.0)?;
        let mut conditions = Vec::new();
        for part in apart.products.iter().chain([&apart.antiderivative]) {
            conditions.extend(self.where_continuous(pool, *part, variable).map_err(|failure| failure.0)?);
        }
        let elementary = self.integral(pool, apart.elementary)?;
        conditions.extend(elementary.conditions);
        let upper = self.value_at(pool, apart.antiderivative, variable, to);
        let lower = self.value_at(pool, apart.antiderivative, variable, from);
        let difference = pool.subtract(upper, lower);
        let value = pool.add(difference, elementary.value);
        Ok(Some(Integral { value, conditions, antiderivative: None }))
    }
}

impl Search<'_> {
    /// Decomposes an integrand into parts, each reduced separately.
    fn apart(&mut self, integrand: Expr, symbol: Symbol, conditions: &[Condition]) -> Result<Apart, Failure> {
        let zero = self.pool.integer(0);
        let mut apart = Apart { antiderivative: zero, products: vec![], elementary: zero };
        let mut open = vec![integrand];
        let mut steps = 0;
        while let Some(part) = open.pop() {
            steps += 1;
            if steps > MOST_PRODUCTS {
                return Err(format!("the integrand has more than {MOST_PRODUCTS} products").into());
            }
            let (found, rest) = self.reduced(part, symbol, conditions, DEPTH)?;
            apart.antiderivative = self.pool.add(apart.antiderivative, found);
            let mut tower = self.tower_with(symbol, rest);
            let normal = normal_form(self.pool, &mut tower, rest, conditions)?;
            let products = tower.products(&normal, symbol)?;
            let single = products.len() == 1;
            for (coefficient, product) in products {
                let coefficient = tower.raise(self.pool, &coefficient);
                let product = tower.raise(self.pool, &product);
                let whole = self.pool.multiply(coefficient, product);
                if !self.has_unknowns(product, symbol) {
                    apart.elementary = self.pool.add(apart.elementary, whole);
                } else if single {
                    let primitive = self.primitive(product, symbol, conditions)?;
                    let term = self.pool.multiply(coefficient, primitive);
                    apart.antiderivative = self.pool.add(apart.antiderivative, term);
                    apart.products.push(product);
                } else {
                    open.push(whole);
                }
            }
        }
        Ok(apart)
    }

    /// Returns the primitive of a product. Let y be the first argument at which an unknown function
    /// is evaluated; if the product is a function of y times dy, then ∫ f(g(x)) g′(x) dx = Φ(g(x)).
    fn primitive(
        &mut self,
        product: Expr,
        symbol: Symbol,
        conditions: &[Condition],
    ) -> Result<Expr, Failure> {
        let Some(inner) = self.first_place(product, symbol) else {
            return Ok(self.pool.primitive(product, symbol));
        };
        let y = self.pool.declare_symbol("y", SymbolKind::Local);
        let Some(outer) = self.by_place(product, symbol, inner, y, conditions) else {
            return Ok(self.pool.primitive(product, symbol));
        };
        let mut tower = self.tower_with(y, outer);
        let normal = normal_form(self.pool, &mut tower, outer, &[])?;
        let values: Substitution = [(y, inner)].into_iter().collect();
        let mut sum = self.pool.integer(0);
        for (coefficient, product) in tower.products(&normal, y)? {
            let product = tower.raise(self.pool, &product);
            let primitive = self.pool.primitive(product, y);
            let coefficient = tower.raise(self.pool, &coefficient);
            let term = self.pool.multiply(coefficient, primitive);
            sum = self.pool.add(sum, term);
        }
        Ok(self.pool.substitute(sum, &values))
    }

    /// Creates a tower in which the variable comes first and all others follow in the order of
    /// their declaration, so that products are written in the same way whatever their origin.
    fn tower_with(&self, variable: Symbol, expression: Expr) -> Tower {
        let mut tower = Tower::new(Trigonometry::Circle);
        tower.variable_number(variable);
        for symbol in self.pool.symbols_in(&[expression]) {
            tower.variable_number(symbol);
        }
        tower
    }

    /// Returns the argument of the first unknown function that depends on the variable, if it is
    /// not the variable itself.
    fn first_place(&mut self, product: Expr, symbol: Symbol) -> Option<Expr> {
        let variable = self.pool.symbol(symbol);
        let moves = |pool: &Pool, argument: Expr| pool.symbols_in(&[argument]).contains(&symbol);
        let place = |part: Expr| match self.pool.node(part) {
            Node::Jet { function, arguments, .. } => {
                let moving = arguments.iter().copied().find(|&argument| moves(self.pool, argument));
                moving.map(|argument| (*function, argument))
            }
            _ => None,
        };
        let first = self.pool.reachable(&[product]).into_iter().filter_map(place).min()?;
        (first.1 != variable).then_some(first.1)
    }

    /// Returns f/g′ in terms of y = g(x): by x = (y − β)/α if g = αx + β, otherwise if only g
    /// occurs.
    fn by_place(
        &mut self,
        product: Expr,
        symbol: Symbol,
        inner: Expr,
        y: Symbol,
        conditions: &[Condition],
    ) -> Option<Expr> {
        let derivative = self.pool.derivative(inner, symbol);
        let slope = self.without(derivative, symbol, conditions);
        let quotient = self.pool.divide(product, slope.unwrap_or(derivative));
        let value = self.pool.symbol(y);
        if let Some(slope) = slope {
            let zero: Substitution = [(symbol, self.pool.integer(0))].into_iter().collect();
            let offset = self.pool.substitute(inner, &zero);
            let rest = self.pool.subtract(value, offset);
            let place: Substitution = [(symbol, self.pool.divide(rest, slope))].into_iter().collect();
            return Some(self.pool.substitute(quotient, &place));
        }
        let mut tower = Tower::new(Trigonometry::Circle);
        let normal = normal_form(self.pool, &mut tower, quotient, conditions).ok()?;
        let raised = tower.raise(self.pool, &normal);
        let images: FxHashMap<Expr, Expr> = [(inner, value)].into_iter().collect();
        let replaced = self.pool.replace(raised, &images);
        (!self.pool.symbols_in(&[replaced]).contains(&symbol)).then_some(replaced)
    }

    /// Returns the expression in normal form, if it is free of the variable and not zero.
    fn without(&mut self, expression: Expr, symbol: Symbol, conditions: &[Condition]) -> Option<Expr> {
        let mut tower = Tower::new(Trigonometry::Circle);
        let normal = normal_form(self.pool, &mut tower, expression, conditions).ok()?;
        (!normal.is_zero() && tower.generators_in(&normal, symbol).is_empty())
            .then(|| tower.raise(self.pool, &normal))
    }
}
