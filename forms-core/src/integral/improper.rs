//! Antiderivatives with logarithms that have no value somewhere on the range, but have a limit
//! there.
//!
//! Let A = Σ Aₖ (log q)ᵏ with q ≥ 0 all over the range. Where q tends to 0, so does √q (log q)ᵏ; if
//! Aₖ/√q is continuous for every k ≥ 1, the terms with logarithms tend to 0 there, and A is
//! extended continuously by A₀. ∫₀¹ log x dx is such an integral, with A = x log x − x.

use super::signs::Region;
use super::{Failure, tidied};
use crate::assume::vanishes;
use crate::expression::{Condition, Expr, Node, Operation, Pool, Substitution, Symbol, SymbolKind};

/// The highest power of one logarithm.
const HIGHEST_POWER: usize = 4;

impl Region {
    /// Shows that an antiderivative, or its extension, is continuous over the closed range, and
    /// returns the conditions that this assumes of parameters.
    pub(super) fn where_extended(
        &self,
        pool: &mut Pool,
        antiderivative: Expr,
        variable: Symbol,
    ) -> Result<Vec<Condition>, Failure> {
        let plain = self.where_continuous(pool, antiderivative, variable);
        if plain.is_err() {
            for q in self.logarithms_with_limits(pool, antiderivative, variable) {
                if let Some(conditions) = self.where_terms_extended(pool, antiderivative, variable, q) {
                    return Ok(conditions);
                }
            }
        }
        plain
    }

    /// Shows the same by powers of log q.
    fn where_terms_extended(
        &self,
        pool: &mut Pool,
        antiderivative: Expr,
        variable: Symbol,
        q: Expr,
    ) -> Option<Vec<Condition>> {
        let coefficients = by_logarithm(pool, antiderivative, q)?;
        let root = pool.sqrt(q);
        let mut conditions = self.where_extended(pool, coefficients[0], variable).ok()?;
        for &coefficient in &coefficients[1..] {
            let quotient = pool.divide(coefficient, root);
            let quotient = tidied(pool, quotient, &self.conditions);
            conditions.extend(self.where_continuous(pool, quotient, variable).ok()?);
        }
        Some(conditions)
    }

    /// Returns the value of an antiderivative at an end of the range, or its limit where a
    /// logarithm has no value.
    pub(super) fn limit_at(
        &self,
        pool: &mut Pool,
        antiderivative: Expr,
        variable: Symbol,
        place: Expr,
    ) -> Expr {
        let at: Substitution = [(variable, place)].into_iter().collect();
        for q in logarithms(pool, antiderivative, variable) {
            let end = pool.substitute(q, &at);
            if vanishes(pool, end)
                && let Some(coefficients) = by_logarithm(pool, antiderivative, q)
            {
                return self.limit_at(pool, coefficients[0], variable, place);
            }
        }
        self.value_at(pool, antiderivative, variable, place)
    }

    /// Returns the arguments of logarithms that are not negative over the range, and may vanish.
    fn logarithms_with_limits(&self, pool: &mut Pool, antiderivative: Expr, variable: Symbol) -> Vec<Expr> {
        let all = logarithms(pool, antiderivative, variable);
        all.into_iter().filter(|&q| self.sign(pool, q).is_some_and(|sign| sign.0)).collect()
    }
}

fn logarithms(pool: &Pool, expression: Expr, variable: Symbol) -> Vec<Expr> {
    let argument = |part: Expr| match pool.node(part) {
        Node::Apply(Operation::Log, q) if pool.symbols_in(q).contains(&variable) => Some(q[0]),
        _ => None,
    };
    pool.reachable(&[expression]).into_iter().filter_map(argument).collect()
}

/// Returns A₀, A₁, … of A = Σ Aₖ (log q)ᵏ, if the expression has this form: Aₖ = A⁽ᵏ⁾(0)/k! with A
/// as a function of log q.
fn by_logarithm(pool: &mut Pool, expression: Expr, q: Expr) -> Option<Vec<Expr>> {
    let symbol = pool.declare_symbol("l", SymbolKind::Local);
    let value = pool.symbol(symbol);
    let logarithm = pool.apply(Operation::Log, &[q]);
    let mut derivative = pool.replace(expression, &[(logarithm, value)].into_iter().collect());
    let zero = pool.integer(0);
    let mut coefficients = Vec::new();
    for k in 0..=HIGHEST_POWER {
        let constant = pool.substitute(derivative, &[(symbol, zero)].into_iter().collect());
        let share = pool.ratio(1, (1..=k as i64).product());
        coefficients.push(pool.multiply(share, constant));
        derivative = pool.derivative(derivative, symbol);
        if vanishes(pool, derivative) {
            return Some(coefficients);
        }
    }
    None
}
