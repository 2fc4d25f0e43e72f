//! Expressions with roots in a form of which the prover knows more.

use crate::expression::{Expr, Node, Operation, Pool};
use num_rational::Ratio;
use rustc_hash::FxHashMap;

/// Writes hypot(x, y) as √(x² + y²).
pub(super) fn with_roots(pool: &mut Pool, expressions: &[Expr]) -> Vec<Expr> {
    let mut squares: FxHashMap<Expr, Expr> = FxHashMap::default();
    with_images(pool, expressions, |pool, part, node, images| {
        let Node::Apply(Operation::Hypot, sides) = node else { return None };
        // of a hypotenuse, the square is the sum of squares that its root is taken of
        let square = |pool: &mut Pool, side: &Expr| {
            squares.get(side).copied().unwrap_or_else(|| pool.power(images[side], 2.into()))
        };
        let (x2, y2) = (square(pool, &sides[0]), square(pool, &sides[1]));
        let sum = pool.add(x2, y2);
        squares.insert(part, sum);
        Some(pool.sqrt(sum))
    })
}

/// Writes √p √q as √(p q) and √p/√q as √(p/q), which are equal wherever the roots on the left are
/// defined.
pub(super) fn with_one_root(pool: &mut Pool, expressions: &[Expr]) -> Vec<Expr> {
    with_images(pool, expressions, |pool, _, node, images| {
        let [a, b] = match node {
            Node::Multiply(a, b) | Node::Divide(a, b) => [*a, *b].map(|part| images[&part]),
            _ => return None,
        };
        let (p, q) = (radicand(pool, a)?, radicand(pool, b)?);
        let joined = if matches!(node, Node::Divide(..)) { pool.divide(p, q) } else { pool.multiply(p, q) };
        Some(pool.sqrt(joined))
    })
}

/// Returns p for an expression √p.
fn radicand(pool: &Pool, expression: Expr) -> Option<Expr> {
    match pool.node(expression) {
        Node::Power(base, exponent) if *exponent == Ratio::new(1, 2) => Some(*base),
        _ => None,
    }
}

/// Replaces each part for which `image` gives another expression, from the innermost on; the map holds
/// the images of the parts inside.
fn with_images(
    pool: &mut Pool,
    expressions: &[Expr],
    mut image: impl FnMut(&mut Pool, Expr, &Node, &FxHashMap<Expr, Expr>) -> Option<Expr>,
) -> Vec<Expr> {
    let mut images: FxHashMap<Expr, Expr> = FxHashMap::default();
    for part in pool.reachable(expressions) {
        let node = pool.node(part).clone();
        let replaced = image(pool, part, &node, &images);
        let replaced = replaced.unwrap_or_else(|| pool.image(part, node, &images));
        images.insert(part, replaced);
    }
    expressions.iter().map(|expression| images[expression]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::read_theory;

    /// Returns the texts of the outputs of `kernel f(p, q, x, y) = …` after a rewriting.
    fn rewritten(formula: &str, rewriting: fn(&mut Pool, &[Expr]) -> Vec<Expr>) -> String {
        let (mut theory, errors) = read_theory(&format!("kernel f(p, q, x, y) = {formula};"));
        assert!(errors.is_empty(), "{errors:?}");
        let outputs = theory.kernels[0].outputs.clone();
        let outputs = rewriting(&mut theory.pool, &outputs);
        theory.pool.texts(&outputs).join(", ")
    }

    #[test]
    fn products_and_quotients_of_roots_become_one_root() {
        for (formula, expected) in [
            ("sqrt(p)*sqrt(q)", "sqrt(p*q)"),
            ("sqrt(p)/sqrt(q)", "sqrt(p/q)"),
            ("sqrt(p)*sqrt(q)/sqrt(x)*sqrt(y)", "sqrt(p*q/x*y)"),
            ("x*sqrt(p)", "x*sqrt(p)"),
            ("1/sqrt(p)", "1/sqrt(p)"),
        ] {
            assert_eq!(rewritten(formula, with_one_root), expected, "{formula}");
        }
    }

    #[test]
    fn hypotenuses_become_roots_of_all_squares() {
        assert_eq!(rewritten("hypot(hypot(x, y), p)", with_roots), "sqrt(x**2 + y**2 + p**2)");
    }
}
