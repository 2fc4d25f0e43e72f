//! Obligations: conditions under which an expression has a value, with the branches that lead to
//! each operation.
//!
//! ```text
//! expression ─ operations outside every conditional, then each branch under its condition ─▶ Obligation { path, ways }
//! ```
//! `ways` are alternatives, each a list of conditions that together are sufficient: 1 − q² ≥ 0 for
//! asin q, or 1 − q ≥ 0 and 1 + q ≥ 0.

use super::pieces::negated;
use crate::expression::{Condition, Expr, Node, Operation, Pool, Rational, Relation};
use num_traits::{One, Signed};
use rustc_hash::FxHashSet;

/// Largest number of paths through the conditionals of an expression that are followed.
pub(super) const MOST_PATHS: usize = 256;

/// Obligation of an operation that is not defined everywhere.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Obligation {
    /// Conditions of the branches that lead to the operation.
    pub(super) path: Vec<Condition>,
    /// The operation.
    pub(super) part: Expr,
    /// Alternative lists of conditions, each sufficient for the operation to have a value; the
    /// first is the language's own.
    pub(super) ways: Vec<Vec<Condition>>,
}

/// Returns every obligation of some expressions; `None` if they have too many paths through
/// conditionals.
pub(super) fn obligations(pool: &mut Pool, expressions: &[Expr]) -> Option<Vec<Obligation>> {
    let mut found = Vec::new();
    let mut open: Vec<(Vec<Condition>, Vec<Expr>)> = vec![(Vec::new(), expressions.to_vec())];
    let mut paths = 0;
    while let Some((path, roots)) = open.pop() {
        paths += 1;
        if paths > MOST_PATHS {
            return None;
        }
        let (parts, choices) = outside_choices(pool, &roots);
        for part in parts {
            let ways = ways(pool, part);
            if !ways.is_empty() {
                found.push(Obligation { path: path.clone(), part, ways });
            }
        }
        for choice in choices {
            let Node::Select { left, relation, right, then, otherwise, .. } = *pool.node(choice) else {
                continue;
            };
            let condition = Condition { left, relation, right };
            open.push((path.clone(), vec![left, right]));
            for (conditions, branch) in [(vec![condition], then), (negated(&condition), otherwise)] {
                open.push((path.iter().copied().chain(conditions).collect(), vec![branch]));
            }
        }
    }
    Some(found)
}

/// Returns the subexpressions that are computed whichever branches are taken, operands before
/// results, and the outermost conditionals.
fn outside_choices(pool: &Pool, roots: &[Expr]) -> (Vec<Expr>, Vec<Expr>) {
    let (mut parts, mut choices) = (Vec::new(), Vec::new());
    let mut seen: FxHashSet<Expr> = FxHashSet::default();
    let mut open = roots.to_vec();
    while let Some(part) = open.pop() {
        if !seen.insert(part) {
            continue;
        }
        match pool.node(part) {
            Node::Select { .. } => choices.push(part),
            node => {
                parts.push(part);
                node.for_each_operand(|operand| open.push(operand));
            }
        }
    }
    parts.sort_unstable();
    choices.sort_unstable();
    (parts, choices)
}

/// Returns the alternatives under which an operation has a value; empty if it always has one.
fn ways(pool: &mut Pool, part: Expr) -> Vec<Vec<Condition>> {
    let (stated, operation, q) = match pool.node(part).clone() {
        Node::Divide(_, divisor) => {
            return pool.quotient_domain(divisor).map(|c| vec![c]).into_iter().collect();
        }
        Node::Power(base, exponent) => {
            return pool.power_domain(base, exponent).map(|c| vec![c]).into_iter().collect();
        }
        Node::Apply(operation, q) => (pool.operation_domain(operation, &q), operation, q),
        _ => return Vec::new(),
    };
    let Some(stated) = stated else { return Vec::new() };
    let (zero, one) = (pool.integer(0), pool.integer(1));
    let against_zero = |left, relation| Condition { left, relation, right: zero };
    let others = match operation {
        Operation::Asin | Operation::Acos => {
            let (below, above) = (pool.subtract(one, q[0]), pool.add(one, q[0]));
            vec![[below, above].map(|margin| against_zero(margin, Relation::GreaterEqual)).to_vec()]
        }
        Operation::Atan2 => vec![
            vec![against_zero(q[1], Relation::Greater)],
            vec![against_zero(q[0], Relation::NotEqual)],
            vec![off_the_origin(pool, &q)],
        ],
        _ => Vec::new(),
    };
    std::iter::once(vec![stated]).chain(others).collect()
}

/// Returns x² + y² ≠ 0, where a kernel has a value of atan2(y, x): also on its branch cut, which
/// statements exclude.
fn off_the_origin(pool: &mut Pool, q: &[Expr]) -> Condition {
    let [(of_y, y), (of_x, x)] = [q[0], q[1]].map(|part| without_number(pool, part));
    // signs and a common numeric factor are dropped
    let [y, x] = if of_y == of_x { [y, x] } else { [q[0], q[1]] };
    let [y2, x2] = [y, x].map(|part| pool.power(part, 2.into()));
    let (left, right) = (pool.add(x2, y2), pool.integer(0));
    Condition { left, relation: Relation::NotEqual, right }
}

/// Returns |c| and q of a product c q with a number c.
fn without_number(pool: &Pool, product: Expr) -> (Rational, Expr) {
    match *pool.node(product) {
        Node::Negate(a) => without_number(pool, a),
        Node::Multiply(a, b) => match (pool.as_number(a), pool.as_number(b)) {
            (Some(c), _) => (c.abs(), b),
            (_, Some(c)) => (c.abs(), a),
            _ => (Rational::one(), product),
        },
        _ => (Rational::one(), product),
    }
}

/// Returns the conditions under which some expressions have a value in a kernel.
pub(super) fn domain(pool: &mut Pool, expressions: &[Expr]) -> Vec<Condition> {
    let mut conditions = pool.domain(expressions);
    for part in pool.reachable(expressions) {
        if let Node::Apply(Operation::Atan2, q) = pool.node(part).clone()
            && let Some(off_the_cut) = pool.operation_domain(Operation::Atan2, &q)
        {
            let wider = off_the_origin(pool, &q);
            conditions.iter_mut().filter(|known| **known == off_the_cut).for_each(|known| *known = wider);
        }
    }
    conditions
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::read_theory;

    fn texts(formula: &str) -> Vec<String> {
        let (mut theory, errors) = read_theory(&format!("kernel k(x, y) = {formula};"));
        assert!(errors.is_empty(), "{errors:?}");
        let outputs = theory.kernels[0].outputs.clone();
        let found = obligations(&mut theory.pool, &outputs).expect("few paths");
        let pool = &theory.pool;
        let list =
            |conditions: &[Condition]| conditions.iter().map(|c| c.text(pool)).collect::<Vec<_>>().join(", ");
        let mut texts: Vec<String> =
            found.iter().map(|it| format!("[{}] {}", list(&it.path), list(&it.ways[0]))).collect();
        texts.sort();
        texts
    }

    #[test]
    fn an_operation_is_asked_for_under_the_choices_that_lead_to_it() {
        assert_eq!(
            texts("if jump 1/y > x { sqrt(x) } else { if jump x != 0 { y/x } else { log(y) } }"),
            [
                "[1/y <= x, x != 0] x != 0",
                "[1/y <= x, x <= 0, x >= 0] y > 0",
                "[1/y > x] x >= 0",
                "[] y != 0",
            ]
        );
        assert_eq!(texts("x*y + sin(x)"), [""; 0]);
    }
}
