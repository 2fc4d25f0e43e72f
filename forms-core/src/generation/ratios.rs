//! Ratios: a formula of a few lengths often depends on their ratios alone, and has fewer variables
//! when written in ratios.
//!
//! An equality for all ratios holds for all lengths. From the conditions only one fact is used:
//! ratios of positive lengths are positive.

use super::limit::follow;
use crate::decide::{Budget, Equations, Finding};
use crate::expression::{Condition, Expr, Node, Pool, Relation, SymbolKind};
use rustc_hash::FxHashMap;

/// Returns the number of points at which the sides of each pair were seen to be equal, if the sides
/// are proved equal as functions of ratios of variables.
pub(super) fn equal_by_ratios(
    pool: &mut Pool,
    sides: &[(Expr, Expr)],
    conditions: &[Condition],
    budget: Budget,
) -> Option<usize> {
    let expressions: Vec<Expr> = sides.iter().flat_map(|&(a, b)| [a, b]).collect();
    let ratios: Vec<Expr> =
        pool.reachable(&expressions).into_iter().filter(|&part| is_ratio(pool, part)).collect();
    let variables: FxHashMap<Expr, Expr> = ratios.iter().map(|&ratio| (ratio, variable(pool))).collect();
    let images: Vec<Expr> = expressions.iter().map(|&side| pool.replace(side, &variables)).collect();
    if pool.symbols_in(&images).len() >= pool.symbols_in(&expressions).len() {
        return None;
    }
    let mut positive: Vec<Condition> = Vec::new();
    for ratio in ratios {
        if pool.node(ratio).operands().into_iter().all(|part| is_positive(pool, part, conditions)) {
            positive.push(above_zero(pool, variables[&ratio]));
        }
    }
    let sides: Vec<(Expr, Expr)> = images.chunks_exact(2).map(|pair| (pair[0], pair[1])).collect();
    match (Equations { sides: &sides, conditions: &positive }).decide(pool, budget) {
        Finding::Equal { points } => Some(points),
        _ => None,
    }
}

fn is_ratio(pool: &Pool, expression: Expr) -> bool {
    let is_variable = |part: Expr| matches!(pool.node(part), Node::Symbol(_));
    matches!(*pool.node(expression), Node::Divide(a, b) if is_variable(a) && is_variable(b))
}

fn variable(pool: &mut Pool) -> Expr {
    let symbol = pool.declare_symbol("ratio", SymbolKind::Local);
    pool.symbol(symbol)
}

fn is_positive(pool: &mut Pool, expression: Expr, conditions: &[Condition]) -> bool {
    let positive = above_zero(pool, expression);
    follow(pool, &[positive], conditions)
}

fn above_zero(pool: &mut Pool, expression: Expr) -> Condition {
    Condition { left: expression, relation: Relation::Greater, right: pool.integer(0) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::read_theory;

    const EFFORT: Budget = Budget { work: 2_000_000, candidates: 100, points: 12 };

    fn seen(outputs: &str) -> Option<usize> {
        let (theory, errors) =
            read_theory(&format!("kernel f(a, b, c) = ({outputs}) where a > 0, b > 0, c > 0;"));
        assert!(errors.is_empty(), "{errors:?}");
        let (mut pool, kernel) = (theory.pool, &theory.kernels[0]);
        let sides = [(kernel.outputs[0], kernel.outputs[1])];
        equal_by_ratios(&mut pool, &sides, &kernel.domain, EFFORT)
    }

    #[test]
    fn signs_of_lengths_are_signs_of_their_ratios() {
        assert!(seen("sqrt((a/c)**2)*(b/c), a/c*(b/c)").is_some());
        assert!(seen("sqrt((a/c)**2)*(b/c), a/c*(b/c) + 1").is_none());
    }

    #[test]
    fn what_is_no_function_of_ratios_is_left_alone() {
        assert!(seen("a*b + c, c + b*a").is_none());
    }
}
