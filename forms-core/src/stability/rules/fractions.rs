//! Rules for quotients: common denominators, common factors, other orders of multiplication and
//! division.

use super::Rewriting;
use super::factors::{factors, product, quotient};
use crate::expression::{Expr, Node};
use num_rational::Ratio;

/// Maximum number of factors of a product that is reordered.
const MOST_FACTORS: usize = 6;

/// Applies p/q + r/s = (p s + r q)/(q s), with a simplified numerator.
pub(super) fn over_one_denominator(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let terms = rewriting.terms(expression);
    let parts: Vec<_> = terms.iter().map(|&term| factors(rewriting.pool, term)).collect();
    if !(2..=4).contains(&parts.len()) || parts.iter().all(|(_, below, _)| below.is_empty()) {
        return Vec::new();
    }
    let mut denominators: Vec<Expr> = Vec::new();
    for below in parts.iter().flat_map(|(_, below, _)| below) {
        if !denominators.contains(below) {
            denominators.push(*below);
        }
    }
    let numerators: Vec<Expr> = parts
        .iter()
        .map(|(above, below, negative)| {
            let missing = denominators.iter().copied().filter(|factor| !below.contains(factor));
            let all: Vec<Expr> = above.iter().copied().chain(missing).collect();
            let term = product(rewriting.pool, &all);
            if *negative { rewriting.pool.negate(term) } else { term }
        })
        .collect();
    let numerator = rewriting.total(&numerators);
    let denominator = product(rewriting.pool, &denominators);
    let simple = rewriting.simplified(numerator);
    let mut found = vec![rewriting.pool.divide(simple, denominator)];
    let mut in_turn = simple;
    for &factor in &denominators {
        in_turn = rewriting.pool.divide(in_turn, factor);
    }
    found.push(in_turn);
    found.push(rewriting.pool.divide(numerator, denominator));
    found
}

/// Divides the numerator and the denominator of p/q by a common factor, one factor at a time.
pub(super) fn without_a_common_factor(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let Node::Divide(p, q) = *rewriting.pool.node(expression) else { return Vec::new() };
    let (above, below, negative) = factors(rewriting.pool, expression);
    let mut found = Vec::new();
    let (plain_p, plain_q) = (rewriting.simplified(p), rewriting.simplified(q));
    found.push(rewriting.pool.divide(plain_p, plain_q));
    for (place, &top) in above.iter().enumerate() {
        for (other, &bottom) in below.iter().enumerate() {
            let ratio = rewriting.pool.divide(top, bottom);
            let simple = rewriting.simplified(ratio);
            if simple == ratio {
                continue;
            }
            let without = |list: &[Expr], at: usize| -> Vec<Expr> {
                list.iter().enumerate().filter(|(place, _)| *place != at).map(|(_, &factor)| factor).collect()
            };
            let rest = quotient(rewriting.pool, &without(&above, place), &without(&below, other));
            let value = rewriting.pool.multiply(rest, simple);
            found.push(if negative { rewriting.pool.negate(value) } else { value });
        }
    }
    found
}

/// Applies (p + q)/xⁿ = (p/x + q/x)/xⁿ⁻¹: the power leaves the floating-point range later, and terms
/// that contain x lose it.
pub(super) fn term_by_term(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let Node::Divide(p, _) = *rewriting.pool.node(expression) else { return Vec::new() };
    let terms = rewriting.terms(p);
    let (_, below, _) = factors(rewriting.pool, expression);
    let mut found = Vec::new();
    for (place, &factor) in below.iter().enumerate().filter(|_| !terms.is_empty()) {
        let (base, less) = match *rewriting.pool.node(factor) {
            Node::Power(base, n) if n.is_integer() && n > Ratio::from_integer(1) => {
                (base, Some(rewriting.pool.power(base, n - Ratio::from_integer(1))))
            }
            _ if below.len() > 1 => (factor, None),
            _ => continue,
        };
        let mut parts = Vec::new();
        for &term in &terms {
            let part = rewriting.pool.divide(term, base);
            parts.push(rewriting.simplified(part));
        }
        let others = below.iter().enumerate().filter(|(other, _)| *other != place).map(|(_, &factor)| factor);
        let rest: Vec<Expr> = others.chain(less).collect();
        let (above, below) = (rewriting.total(&parts), product(rewriting.pool, &rest));
        found.push(rewriting.pool.divide(above, below));
    }
    found
}

/// Applies p q/(r s) = ((p/r) q)/s = ((p/r)/s) q = (p/r)(q/s), so that no product leaves the
/// floating-point range; a square among the factors is two of them.
pub(super) fn reordered(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let (above, below, negative) = factors(rewriting.pool, expression);
    let above: Vec<Expr> = above
        .into_iter()
        .flat_map(|factor| rewriting.squared(factor).map_or(vec![factor], |base| vec![base; 2]))
        .collect();
    let is_product = matches!(rewriting.pool.node(expression), Node::Divide(..) | Node::Multiply(..));
    if !is_product || below.is_empty() || above.len() + below.len() > MOST_FACTORS {
        return Vec::new();
    }
    let one = rewriting.pool.integer(1);
    let mut found = Vec::new();
    // alternately: a division as soon as there is a divisor
    let mut value = above.first().copied().unwrap_or(one);
    let mut tops = above.iter().skip(1);
    for &bottom in &below {
        value = rewriting.pool.divide(value, bottom);
        if let Some(&top) = tops.next() {
            value = rewriting.pool.multiply(value, top);
        }
    }
    for &top in tops {
        value = rewriting.pool.multiply(value, top);
    }
    found.push(value);
    // all divisions first
    let mut value = above.first().copied().unwrap_or(one);
    for &bottom in &below {
        value = rewriting.pool.divide(value, bottom);
    }
    for &top in above.iter().skip(1) {
        value = rewriting.pool.multiply(value, top);
    }
    found.push(value);
    // quotients of one factor by one other
    let mut value = one;
    for place in 0..above.len().max(below.len()) {
        let [top, bottom] = [&above, &below].map(|list| list.get(place).copied().unwrap_or(one));
        let ratio = rewriting.pool.divide(top, bottom);
        value = rewriting.pool.multiply(value, ratio);
    }
    found.push(value);
    if negative {
        found.iter_mut().for_each(|value| *value = rewriting.pool.negate(*value));
    }
    found
}

/// Applies c p²/q² = c (p/q)², where p² or q² can leave the floating-point range and p/q does not.
pub(super) fn power_of_a_quotient(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let (above, below, negative) = factors(rewriting.pool, expression);
    let square = |rewriting: &Rewriting<'_>, list: &[Expr]| -> Option<(Expr, Vec<Expr>)> {
        if let Some((place, base)) =
            list.iter().enumerate().find_map(|(place, &factor)| Some((place, rewriting.squared(factor)?)))
        {
            let rest = list.iter().enumerate().filter(|(at, _)| *at != place).map(|(_, &factor)| factor);
            return Some((base, rest.collect()));
        }
        // a square written as a product
        let (place, &factor) =
            list.iter().enumerate().find(|(at, factor)| list[at + 1..].contains(factor))?;
        let mut rest = list.to_vec();
        rest.remove(place);
        let other = rest.iter().position(|&known| known == factor)?;
        rest.remove(other);
        Some((factor, rest))
    };
    let (Some((p, above)), Some((q, below))) = (square(rewriting, &above), square(rewriting, &below)) else {
        return Vec::new();
    };
    let ratio = rewriting.pool.divide(p, q);
    let squared = rewriting.pool.power(ratio, Ratio::from_integer(2));
    let rest = quotient(rewriting.pool, &above, &below);
    let value = rewriting.pool.multiply(rest, squared);
    vec![if negative { rewriting.pool.negate(value) } else { value }]
}
