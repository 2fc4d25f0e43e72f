//! Evaluation plan: the expressions that are computed on the way to some results, and how.
//!
//! A derivative of a derivative, or a sum of several derivatives, is not computed as the calculus
//! writes it: a sum of many quotients over powers of the same denominators. Instead its operands
//! are brought to normal form and differentiated there, over one denominator: such a sum is a
//! divergence.

use super::opaque::is_opaque;
use super::tower::Tower;
use crate::expression::{Expr, Node, Pool, Symbol};

/// Largest number of terms of a divergence; a longer one is computed term by term.
const MOST_TERMS: usize = 64;

/// Way in which an expression is computed.
pub(super) enum Step {
    /// By the operation of its node.
    Operation,
    /// As Σ ±∂f/∂x.
    Divergence(Vec<(i8, Expr, Symbol)>),
}

/// Returns the steps to some expressions from the elements that a tower knows, operands before
/// results.
pub(super) fn steps(tower: &Tower, pool: &Pool, roots: &[Expr]) -> Vec<(Expr, Step)> {
    let Some(last) = roots.iter().max() else { return Vec::new() };
    let mut wanted = vec![false; last.0 as usize + 1];
    roots.iter().for_each(|root| wanted[root.0 as usize] = true);
    let mut steps = Vec::new();
    for index in (0..=last.0).rev() {
        let expression = Expr(index);
        if !wanted[index as usize] || tower.elements.contains_key(&expression) {
            continue;
        }
        match divergence(tower, pool, expression) {
            Some(terms) => {
                terms.iter().for_each(|term| wanted[term.1.0 as usize] = true);
                steps.push((expression, Step::Divergence(terms)));
            }
            None => {
                pool.node(expression).for_each_operand(|operand| wanted[operand.0 as usize] = true);
                steps.push((expression, Step::Operation));
            }
        }
    }
    steps.reverse();
    steps
}

/// Σ ±∂f/∂x, if the expression is written as such a sum and every f has a normal form over the
/// known atoms.
fn divergence(tower: &Tower, pool: &Pool, expression: Expr) -> Option<Vec<(i8, Expr, Symbol)>> {
    let mut terms = Vec::new();
    let mut repeated = false;
    let mut pending = vec![(expression, 1)];
    while let Some((part, sign)) = pending.pop() {
        if let Some(origin) = pool.origin(part) {
            terms.push((sign, origin.of, origin.by));
            repeated |= origin.repeated;
        } else {
            match *pool.node(part) {
                Node::Add(a, b) => pending.extend([(b, sign), (a, sign)]),
                Node::Negate(a) => pending.push((a, -sign)),
                _ => return None,
            }
        }
        if terms.len() > MOST_TERMS || pending.len() > MOST_TERMS {
            return None;
        }
    }
    let worthwhile = repeated || terms.len() > 1;
    let operands: Vec<Expr> = terms.iter().map(|term| term.1).collect();
    (worthwhile && are_differentiable(tower, pool, &operands)).then_some(terms)
}

/// Whether expressions consist of known atoms whose derivatives have normal forms over the same
/// generators.
fn are_differentiable(tower: &Tower, pool: &Pool, expressions: &[Expr]) -> bool {
    pool.reachable(expressions).into_iter().all(|part| match pool.node(part) {
        Node::Jet { .. } | Node::Select { .. } => false,
        Node::Apply(operation, _) if is_opaque(*operation) => false,
        Node::Apply(..) => tower.elements.contains_key(&part),
        Node::Power(_, exponent) => exponent.is_integer() || tower.elements.contains_key(&part),
        _ => true,
    })
}
