//! Conditions on magnitudes, rewritten without magnitudes: |u| ≤ b is u ≤ b and −u ≤ b, and |u| is
//! u where another condition states u ≥ 0. The same holds for u² ≤ b², which is |u| ≤ b.
//!
//! A condition whose normal form depends on an open sign is left out; its consequences without that
//! sign are not.

use crate::expression::{Condition, Expr, Node, Operation, Pool, Relation};
use num_traits::{Signed, Zero};
use rustc_hash::FxHashMap;

/// Sums of more magnitudes are not rewritten: each magnitude doubles the number of conditions.
const MOST_MAGNITUDES: usize = 3;

/// Returns conditions that follow from the given ones, with fewer magnitudes.
pub(super) fn consequences(pool: &mut Pool, conditions: &[Condition]) -> Vec<Condition> {
    let has_magnitude = |pool: &Pool, condition: &Condition| {
        let parts = pool.reachable(&[condition.left, condition.right]);
        parts.into_iter().any(|part| matches!(pool.node(part), Node::Apply(Operation::Abs, _)))
    };
    let about: Vec<Condition> = conditions.iter().copied().filter(|c| has_magnitude(pool, c)).collect();
    let mut found: Vec<Condition> = conditions.iter().flat_map(|c| roots_of_square(pool, c)).collect();
    if about.is_empty() {
        return found;
    }
    let images: FxHashMap<Expr, Expr> =
        conditions.iter().filter_map(|condition| magnitude_of_signed(pool, condition)).collect();
    for condition in about {
        let Condition { left, relation, right } = condition;
        let signed =
            Condition { left: pool.replace(left, &images), relation, right: pool.replace(right, &images) };
        if signed != condition {
            found.push(signed);
        }
        found.extend(both_signs(pool, &signed));
    }
    found
}

/// Returns the conditions u ≤ √c and −u ≤ √c for u² ≤ c with a number c.
fn roots_of_square(pool: &mut Pool, condition: &Condition) -> Vec<Condition> {
    let (less, more, relation) = match condition.relation {
        Relation::Less | Relation::LessEqual => (condition.left, condition.right, condition.relation),
        Relation::Greater => (condition.right, condition.left, Relation::Less),
        Relation::GreaterEqual => (condition.right, condition.left, Relation::LessEqual),
        Relation::NotEqual => return vec![],
    };
    let Node::Power(u, exponent) = *pool.node(less) else { return vec![] };
    if exponent != 2.into() || pool.as_number(more).is_none_or(Signed::is_negative) {
        return vec![];
    }
    let (bound, minus) = (pool.sqrt(more), pool.negate(u));
    [u, minus].map(|left| Condition { left, relation, right: bound }).to_vec()
}

/// Returns |u| and ±u if the condition states on which side of zero u is.
fn magnitude_of_signed(pool: &mut Pool, condition: &Condition) -> Option<(Expr, Expr)> {
    let is_zero = |side: Expr| pool.as_number(side).is_some_and(Zero::is_zero);
    let above = matches!(condition.relation, Relation::Greater | Relation::GreaterEqual);
    let (u, is_positive) = match (is_zero(condition.left), is_zero(condition.right)) {
        _ if condition.relation == Relation::NotEqual => return None,
        (false, true) => (condition.left, above),
        (true, false) => (condition.right, !above),
        _ => return None,
    };
    let magnitude = pool.apply(Operation::Abs, &[u]);
    Some((magnitude, if is_positive { u } else { pool.negate(u) }))
}

/// Returns the conditions Σ ±cᵢuᵢ + rest ≤ 0 for Σ cᵢ|uᵢ| + rest ≤ 0 with positive numbers cᵢ.
fn both_signs(pool: &mut Pool, condition: &Condition) -> Vec<Condition> {
    let (less, more, relation) = match condition.relation {
        Relation::Less | Relation::LessEqual => (condition.left, condition.right, condition.relation),
        Relation::Greater => (condition.right, condition.left, Relation::Less),
        Relation::GreaterEqual => (condition.right, condition.left, Relation::LessEqual),
        Relation::NotEqual => return vec![],
    };
    let taken_away = pool.summands(more).into_iter().map(|(summand, negative)| (summand, !negative));
    let (magnitudes, others): (Vec<_>, Vec<_>) = pool
        .summands(less)
        .into_iter()
        .chain(taken_away)
        .partition(|&(summand, negative)| !negative && inside_magnitude(pool, summand).is_some());
    if magnitudes.is_empty() || magnitudes.len() > MOST_MAGNITUDES {
        return vec![];
    }
    let zero = pool.integer(0);
    let mut sums = vec![zero];
    for (summand, negative) in others {
        sums = vec![signed_sum(pool, sums[0], summand, negative)];
    }
    for (summand, _) in magnitudes {
        let Some(inside) = inside_magnitude(pool, summand) else { continue };
        let bare = pool.replace(summand, &[inside].into_iter().collect());
        let signs = [false, true];
        let all = sums.iter().flat_map(|&sum| signs.map(|negative| (sum, negative)));
        sums = all
            .collect::<Vec<_>>()
            .into_iter()
            .map(|(sum, sign)| signed_sum(pool, sum, bare, sign))
            .collect();
    }
    sums.into_iter().map(|left| Condition { left, relation, right: zero }).collect()
}

fn signed_sum(pool: &mut Pool, sum: Expr, summand: Expr, negative: bool) -> Expr {
    if negative { pool.subtract(sum, summand) } else { pool.add(sum, summand) }
}

/// Returns |u| and u for |u| or a positive multiple of it.
fn inside_magnitude(pool: &Pool, summand: Expr) -> Option<(Expr, Expr)> {
    let is_positive = |factor: Expr| pool.as_number(factor).is_some_and(Signed::is_positive);
    match pool.node(summand) {
        Node::Apply(Operation::Abs, arguments) => Some((summand, arguments[0])),
        &Node::Multiply(a, b) if is_positive(a) => inside_magnitude(pool, b),
        &Node::Multiply(a, b) if is_positive(b) => inside_magnitude(pool, a),
        &Node::Divide(a, b) if is_positive(b) => inside_magnitude(pool, a),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::consequences;
    use crate::resolve::resolve;
    use crate::syntax::read;

    /// Returns the consequences of the conditions of a chart.
    fn of(conditions: &str) -> Vec<String> {
        let (file, errors) = read(&format!("chart R2(x, y) where {conditions};"));
        assert!(errors.is_empty());
        let (mut theory, errors) = resolve(&file);
        assert!(errors.is_empty());
        let conditions = theory.charts[0].conditions.clone();
        let found = consequences(&mut theory.pool, &conditions);
        found.into_iter().map(|condition| condition.text(&theory.pool)).collect()
    }

    #[test]
    fn a_magnitude_below_a_bound_leaves_both_signs_below_it() {
        assert_eq!(of("abs(x) <= 1"), ["-1 + x <= 0", "-1 - x <= 0"]);
        assert_eq!(of("y > 2*abs(x)"), ["-y + 2*x < 0", "-y - 2*x < 0"]);
        assert_eq!(of("abs(x) + abs(y) < 1").len(), 4);
    }

    #[test]
    fn a_magnitude_above_a_bound_says_nothing_of_one_sign() {
        for condition in ["abs(x) >= 1", "1 - abs(x) < y", "abs(x) != 1", "x < y"] {
            assert_eq!(of(condition), [""; 0], "{condition}");
        }
    }

    #[test]
    fn a_magnitude_of_what_has_a_sign_is_that_or_its_negative() {
        assert_eq!(of("abs(x) >= y, x > 0")[0], "x >= y");
        assert_eq!(of("abs(x) >= y, 0 >= x")[0], "-x >= y");
        assert_eq!(of("abs(x) >= y, x > 1"), [""; 0]);
    }
}
