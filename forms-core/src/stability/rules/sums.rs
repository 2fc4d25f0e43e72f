//! Rules for sums: common factors, and grouping of cancelling terms.

use super::Rewriting;
use super::factors::{factors, quotient};
use crate::expression::{Expr, Node, Operation};

/// Maximum number of terms of a sum that is regrouped.
const MOST_TERMS: usize = 6;

/// Applies a² − b² = (a − b)(a + b), where a − b is also a difference of sums with common terms, and
/// a b − a c = a (b − c).
pub(super) fn factored(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let terms = rewriting.terms(expression);
    let mut found = Vec::new();
    if let Some((a, b)) = rewriting.two_terms(expression)
        && let Node::Negate(b) = *rewriting.pool.node(b)
        && let (Some(a), Some(b)) = (root_of(rewriting, a), root_of(rewriting, b))
    {
        let (difference, sum) = (rewriting.difference(a, b), rewriting.sum(a, b));
        found.push(rewriting.pool.multiply(difference, sum));
        let (difference, sum) = (rewriting.pool.subtract(a, b), rewriting.pool.add(a, b));
        found.push(rewriting.pool.multiply(difference, sum));
        if let Some(difference) = without_common_terms(rewriting, a, b) {
            found.push(rewriting.pool.multiply(difference, sum));
        }
    }
    if terms.len() < 2 {
        return found;
    }
    let parts: Vec<_> = terms.iter().map(|&term| factors(rewriting.pool, term)).collect();
    for &common in &parts[0].0 {
        if rewriting.varies(common) && parts.iter().all(|(above, ..)| above.contains(&common)) {
            let rest: Vec<Expr> = parts
                .iter()
                .map(|(above, below, negative)| {
                    let mut above = above.clone();
                    let place = above.iter().position(|&factor| factor == common).unwrap_or(0);
                    above.remove(place);
                    let rest = quotient(rewriting.pool, &above, below);
                    if *negative { rewriting.pool.negate(rest) } else { rest }
                })
                .collect();
            let rest = rewriting.total(&rest);
            found.push(rewriting.pool.multiply(common, rest));
        }
    }
    found
}

/// Returns a − b without the terms that both have, each other term as it is written; `None` if they
/// have none in common.
fn without_common_terms(rewriting: &mut Rewriting<'_>, a: Expr, b: Expr) -> Option<Expr> {
    let list = |rewriting: &mut Rewriting<'_>, sum: Expr| {
        let terms = rewriting.terms(sum);
        if terms.is_empty() { vec![sum] } else { terms }
    };
    let (mut rest, subtracted) = (list(rewriting, a), list(rewriting, b));
    let count = rest.len() + subtracted.len();
    for term in subtracted {
        match rest.iter().position(|&known| known == term) {
            Some(place) => drop(rest.remove(place)),
            None => rest.push(rewriting.pool.negate(term)),
        }
    }
    (rest.len() < count).then(|| rewriting.total(&rest))
}

/// Returns a for an expression a², and 1 for 1.
pub(super) fn root_of(rewriting: &mut Rewriting<'_>, expression: Expr) -> Option<Expr> {
    let one = rewriting.pool.integer(1);
    if expression == one { Some(one) } else { rewriting.squared(expression) }
}

/// Applies a + b + c = (a + c) + b and so on: two terms are added first and simplified, then the
/// others are added.
pub(super) fn regrouped(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let terms = rewriting.terms(expression);
    if !(3..=MOST_TERMS).contains(&terms.len()) {
        return Vec::new();
    }
    let mut found = Vec::new();
    for first in 0..terms.len() {
        for second in first + 1..terms.len() {
            let pair = rewriting.sum(terms[first], terms[second]);
            let rest: Vec<Expr> = (0..terms.len())
                .filter(|place| ![first, second].contains(place))
                .map(|place| terms[place])
                .collect();
            let rest = rewriting.total(&rest);
            found.push(rewriting.pool.add(pair, rest));
            found.push(rewriting.pool.add(rest, pair));
        }
    }
    found
}

/// Applies c f(a) − k f(b) = k (f(a) − f(b)) + (c − k) f(a), for logarithms: their difference is
/// one logarithm.
pub(super) fn shared_function(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let terms = rewriting.terms(expression);
    let mut found = Vec::new();
    for (place, &first) in terms.iter().enumerate() {
        for (other, &second) in terms.iter().enumerate() {
            if place == other {
                continue;
            }
            let (Some((c, f)), Some((k, g))) =
                (with_logarithm(rewriting, first), with_logarithm(rewriting, second))
            else {
                continue;
            };
            // c f + k g = −k (f − g) + (c + k) f
            let difference = rewriting.pool.subtract(f, g);
            let Some(&joined) = super::exponential::logarithms(rewriting, difference).first() else {
                continue;
            };
            let minus = rewriting.pool.negate(k);
            let main = rewriting.pool.multiply(minus, joined);
            let rest = rewriting.sum(c, k);
            let rest = rewriting.pool.multiply(rest, f);
            let mut all = vec![main, rest];
            all.extend((0..terms.len()).filter(|at| ![place, other].contains(at)).map(|at| terms[at]));
            found.push(rewriting.total(&all));
        }
    }
    found
}

/// Returns c and log a for an expression c log a.
fn with_logarithm(rewriting: &mut Rewriting<'_>, term: Expr) -> Option<(Expr, Expr)> {
    let (mut above, below, negative) = factors(rewriting.pool, term);
    let is_logarithm = |&factor: &Expr| rewriting.argument_of(Operation::Log, factor).is_some();
    let place = above.iter().position(is_logarithm)?;
    let logarithm = above.remove(place);
    let rest = quotient(rewriting.pool, &above, &below);
    Some((if negative { rewriting.pool.negate(rest) } else { rest }, logarithm))
}
