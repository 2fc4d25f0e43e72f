//! Conditions that amount to equations: d ≤ 0 where d ≥ 0 holds anyway.
//!
//! ```text
//! d <= 0, d >= 0  ─▶  d = 0  ─▶  some factor e of d is 0  ─ solved ─▶  the problem with the solution substituted
//! ```
//! A factor is solved for a variable in which it is linear, or else for a function in which it is
//! linear: 1 − sin x = 0 gives sin x = 1. At each point of the statement one of the factors is
//! zero, so it is enough to prove the remaining problem for each of them.

use super::problem::Problem;
use super::proof::by_normal_forms;
use super::special::{Stratum, mapped, solved, vanishing_together};
use crate::assume::is_at_most;
use crate::expression::{Condition, Expr, Node, Operation, Pool, Relation, SymbolKind};
use num_traits::One;
use rustc_hash::FxHashMap;

/// Whether the equations among the conditions of a problem prove it.
pub(super) fn equations_prove(pool: &mut Pool, problem: &Problem, work: u64) -> bool {
    for place in 0..problem.assumptions.len() {
        let Some(vanishing) = equation(pool, problem, place) else { continue };
        let factors = pool.factors_that_may_vanish(vanishing);
        let is_proved = |factor: &Expr| {
            let Some(left) = on(pool, problem, *factor) else { return false };
            !by_normal_forms(pool, &left, work).is_open()
        };
        if !factors.is_empty() && factors.iter().all(is_proved) {
            return true;
        }
    }
    false
}

/// Returns the difference d of a condition d ≤ 0, if d ≥ 0 follows from the other conditions or
/// from the form of d.
fn equation(pool: &mut Pool, problem: &Problem, place: usize) -> Option<Expr> {
    let Condition { left, relation, right } = problem.assumptions[place];
    let (smaller, larger) = match relation {
        Relation::LessEqual => (left, right),
        Relation::GreaterEqual => (right, left),
        _ => return None,
    };
    let mut others = problem.assumptions.clone();
    others.remove(place);
    is_at_most(pool, larger, smaller, &others).then(|| pool.subtract(smaller, larger))
}

/// Returns the problem where a factor is zero; `None` if the factor cannot be solved.
fn on(pool: &mut Pool, problem: &Problem, factor: Expr) -> Option<Problem> {
    let equations = vanishing_together(pool, factor);
    if let Some(stratum) = Stratum::of(pool, problem, &equations) {
        return Some(stratum.problem);
    }
    let images = equations.iter().map(|&equation| function_of(pool, equation)).collect::<Option<Vec<_>>>()?;
    let images: FxHashMap<Expr, Expr> = images.into_iter().flatten().collect();
    Some(mapped(pool, problem, |pool, expression| pool.replace(expression, &images)))
}

/// Solves an equation for a function in which it is linear and returns the function with its value.
/// A sine or cosine of ±1 makes the other one 0.
fn function_of(pool: &mut Pool, equation: Expr) -> Option<Vec<(Expr, Expr)>> {
    for part in pool.reachable(&[equation]) {
        let Node::Apply(operation, of) = pool.node(part).clone() else { continue };
        let placeholder = pool.declare_symbol("v", SymbolKind::Local);
        let variable = pool.symbol(placeholder);
        let linear = pool.replace(equation, &[(part, variable)].into_iter().collect());
        let Some((symbol, value)) = solved(pool, linear) else { continue };
        if symbol != placeholder || pool.symbols_in(&[value]).contains(&placeholder) {
            continue;
        }
        let mut images = vec![(part, value)];
        let is_one = pool.as_number(value).is_some_and(|value| (value * value).is_one());
        let other = match operation {
            Operation::Sin => Some(Operation::Cos),
            Operation::Cos => Some(Operation::Sin),
            _ => None,
        };
        if let (Some(other), true) = (other, is_one) {
            images.push((pool.apply(other, &of), pool.integer(0)));
        }
        return Some(images);
    }
    None
}
