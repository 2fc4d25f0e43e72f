//! Rules for exponentials and logarithms near the points where they are 1 and 0.

use super::Rewriting;
use super::factors::factors;
use crate::expression::{Condition, Expr, Extremum, Node, Operation, Rational, Relation, Seam};
use num_traits::Signed;

/// Applies eᵃ − 1 = expm1 a, also among the terms of a longer sum, and with a common factor of both
/// terms.
pub(super) fn less_one(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let terms = rewriting.terms(expression);
    let mut found = Vec::new();
    for (place, &first) in terms.iter().enumerate() {
        for (other, &second) in terms.iter().enumerate() {
            let ((c, power), (k, number)) = (rewriting.scaled(first), rewriting.scaled(second));
            let opposite = rewriting.pool.negate(k);
            let is_one = number == rewriting.pool.integer(1);
            let Some(a) = rewriting.argument_of(Operation::Exp, power).filter(|_| c == opposite && is_one)
            else {
                continue;
            };
            let value = rewriting.pool.apply(Operation::Expm1, &[a]);
            let mut all = vec![rewriting.pool.multiply(c, value)];
            all.extend((0..terms.len()).filter(|at| ![place, other].contains(at)).map(|at| terms[at]));
            found.push(rewriting.total(&all));
        }
    }
    found
}

/// Applies eᵃ − eᵇ = eᵇ expm1(a − b).
pub(super) fn difference(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let Some((first, second)) = rewriting.two_terms(expression) else { return Vec::new() };
    let ((c, p), (k, q)) = (rewriting.scaled(first), rewriting.scaled(second));
    let opposite = rewriting.pool.negate(k);
    let (Some(a), Some(b)) =
        (rewriting.argument_of(Operation::Exp, p), rewriting.argument_of(Operation::Exp, q))
    else {
        return Vec::new();
    };
    if c != opposite {
        return Vec::new();
    }
    let exponent = rewriting.difference(a, b);
    let growth = rewriting.pool.apply(Operation::Expm1, &[exponent]);
    let scaled = rewriting.pool.multiply(c, q);
    vec![rewriting.pool.multiply(scaled, growth)]
}

/// Applies eᵃ − e⁻ᵃ = 2 sinh a, eᵃ + e⁻ᵃ = 2 cosh a, eᵃ + e⁻ᵃ − 2 = 4 sinh²(a/2), and
/// cosh a − 1 = 2 sinh²(a/2).
pub(super) fn hyperbolic(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let terms = rewriting.terms(expression);
    let two = rewriting.pool.integer(2);
    let half_sine = |rewriting: &mut Rewriting<'_>, a: Expr, factor: i64| {
        let half = rewriting.half(a);
        let sine = rewriting.pool.apply(Operation::Sinh, &[half]);
        let square = rewriting.square(sine);
        rewriting.times(factor, square)
    };
    let exponents: Vec<Option<Expr>> =
        terms.iter().map(|&term| rewriting.argument_of(Operation::Exp, term)).collect();
    let known: Vec<Expr> = exponents.iter().flatten().copied().collect();
    let minus_two = rewriting.pool.integer(-2);
    let minus_one = rewriting.pool.integer(-1);
    let mut found = Vec::new();
    if let [a, b] = known[..]
        && rewriting.sum(a, b) == rewriting.pool.integer(0)
    {
        if terms.len() == 2 {
            let cosine = rewriting.pool.apply(Operation::Cosh, &[a]);
            found.push(rewriting.pool.multiply(two, cosine));
        }
        if terms.len() == 3 && terms.contains(&minus_two) {
            found.push(half_sine(rewriting, a, 4));
        }
    }
    if let [first, second] = terms[..] {
        if let (Some(a), Node::Negate(other)) = (exponents[0], rewriting.pool.node(second).clone())
            && let Some(b) = rewriting.argument_of(Operation::Exp, other)
            && rewriting.sum(a, b) == rewriting.pool.integer(0)
        {
            let sine = rewriting.pool.apply(Operation::Sinh, &[a]);
            found.push(rewriting.pool.multiply(two, sine));
        }
        if let Some(a) = rewriting.argument_of(Operation::Cosh, first).filter(|_| second == minus_one) {
            found.push(half_sine(rewriting, a, 2));
        }
    }
    found
}

/// Applies sinh a/cosh a = tanh a.
pub(super) fn hyperbolic_tangent(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let Node::Divide(p, q) = *rewriting.pool.node(expression) else { return Vec::new() };
    let ((c, p), (k, q)) = (rewriting.scaled(p), rewriting.scaled(q));
    let (Some(a), Some(b)) =
        (rewriting.argument_of(Operation::Sinh, p), rewriting.argument_of(Operation::Cosh, q))
    else {
        return Vec::new();
    };
    if a != b {
        return Vec::new();
    }
    let (ratio, tangent) = (rewriting.pool.divide(c, k), rewriting.pool.apply(Operation::Tanh, &[a]));
    vec![rewriting.pool.multiply(ratio, tangent)]
}

/// Applies eᵃ/q(eᵃ) = 1/(q(eᵃ) e⁻ᵃ), which does not overflow, and eᵃ/expm1 a = −1/expm1(−a).
pub(super) fn reciprocal(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let Node::Divide(p, q) = *rewriting.pool.node(expression) else { return Vec::new() };
    let Some(a) = rewriting.argument_of(Operation::Exp, p) else { return Vec::new() };
    let minus = rewriting.pool.negate(a);
    let shrinking = rewriting.pool.apply(Operation::Exp, &[minus]);
    let one = rewriting.pool.integer(1);
    let mut found = Vec::new();
    if rewriting.argument_of(Operation::Expm1, q) == Some(a) {
        let growth = rewriting.pool.apply(Operation::Expm1, &[minus]);
        let inverse = rewriting.pool.divide(one, growth);
        found.push(rewriting.pool.negate(inverse));
    }
    let terms = rewriting.terms(q);
    if !terms.is_empty() {
        let scaled: Vec<Expr> = terms
            .iter()
            .map(|&term| {
                let product = rewriting.pool.multiply(term, shrinking);
                rewriting.simplified(product)
            })
            .collect();
        let rest = rewriting.total(&scaled);
        found.push(rewriting.pool.divide(one, rest));
    }
    found
}

/// Applies log a = log1p(a − 1), log(p/q) = log1p((p − q)/q) = log p − log q,
/// (1 + u)ʳ − 1 = expm1(r log1p u).
pub(super) fn near_one(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let one = rewriting.pool.integer(1);
    let mut found = Vec::new();
    if let Some(a) = rewriting.argument_of(Operation::Log, expression) {
        if let Some(excess) = beside_one(rewriting, a) {
            found.push(rewriting.pool.apply(Operation::Log1p, &[excess]));
        }
        let excess = rewriting.difference(a, one);
        found.push(rewriting.pool.apply(Operation::Log1p, &[excess]));
        let (above, below, negative) = factors(rewriting.pool, a);
        if !negative && !below.is_empty() {
            let p = super::factors::product(rewriting.pool, &above);
            let q = super::factors::product(rewriting.pool, &below);
            let difference = rewriting.difference(p, q);
            let ratio = rewriting.pool.divide(difference, q);
            found.push(rewriting.pool.apply(Operation::Log1p, &[ratio]));
            let logs = [p, q].map(|part| {
                let excess = rewriting.difference(part, one);
                rewriting.pool.apply(Operation::Log1p, &[excess])
            });
            found.push(rewriting.pool.subtract(logs[0], logs[1]));
        }
    }
    let minus_one = rewriting.pool.integer(-1);
    if let Some((power, number)) = rewriting.two_terms(expression)
        && number == minus_one
        && let Node::Power(base, exponent) = *rewriting.pool.node(power)
    {
        let excess = rewriting.difference(base, one);
        let logarithm = rewriting.pool.apply(Operation::Log1p, &[excess]);
        let exponent = rewriting.pool.ratio(*exponent.numer(), *exponent.denom());
        let product = rewriting.pool.multiply(exponent, logarithm);
        found.push(rewriting.pool.apply(Operation::Expm1, &[product]));
    }
    found
}

/// Returns u for a sum written as 1 + u.
pub(super) fn beside_one(rewriting: &mut Rewriting<'_>, sum: Expr) -> Option<Expr> {
    let one = rewriting.pool.integer(1);
    let mut terms = rewriting.terms(sum);
    let place = terms.iter().position(|&term| term == one)?;
    terms.remove(place);
    Some(rewriting.total(&terms))
}

/// Applies log a − log b = log1p((a − b)/b) = −log1p((b − a)/a).
pub(super) fn logarithms(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let Some((first, second)) = rewriting.two_terms(expression) else { return Vec::new() };
    let ((c, p), (k, q)) = (rewriting.scaled(first), rewriting.scaled(second));
    let opposite = rewriting.pool.negate(k);
    let (Some(a), Some(b)) =
        (rewriting.argument_of(Operation::Log, p), rewriting.argument_of(Operation::Log, q))
    else {
        return Vec::new();
    };
    if c != opposite {
        return Vec::new();
    }
    let mut found = Vec::new();
    for (a, b, c) in [(a, b, c), (b, a, k)] {
        let difference = rewriting.difference(a, b);
        let ratio = rewriting.pool.divide(difference, b);
        let logarithm = rewriting.pool.apply(Operation::Log1p, &[ratio]);
        let form = rewriting.pool.multiply(c, logarithm);
        found.push(unless_divisor_is_tiny(rewriting, expression, form, (difference, b)));
    }
    found
}

/// Applies log(eᵃ + eᵇ) = max(a, b) + log1p(e^−|a − b|), also with b = 0 for 1 and for log1p(eᵃ):
/// nothing overflows.
pub(super) fn logarithm_of_a_sum(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let (zero, one) = (rewriting.pool.integer(0), rewriting.pool.integer(1));
    let exponents = if let Some(a) = rewriting.argument_of(Operation::Log1p, expression) {
        [rewriting.argument_of(Operation::Exp, a), Some(zero)]
    } else {
        let sum = rewriting.argument_of(Operation::Log, expression);
        let Some((p, q)) = sum.and_then(|sum| rewriting.two_terms(sum)) else { return Vec::new() };
        [p, q].map(|term| if term == one { Some(zero) } else { rewriting.argument_of(Operation::Exp, term) })
    };
    let [Some(a), Some(b)] = exponents else { return Vec::new() };
    let largest = rewriting.pool.extremum(Extremum::Greatest, a, b);
    let difference = rewriting.difference(a, b);
    let distance = rewriting.pool.apply(Operation::Abs, &[difference]);
    let opposite = rewriting.pool.negate(distance);
    let ratio = rewriting.pool.apply(Operation::Exp, &[opposite]);
    let rest = rewriting.pool.apply(Operation::Log1p, &[ratio]);
    vec![rewriting.pool.add(largest, rest)]
}

/// Applies c + c erf a = c erfc(−a), c − c erf a = c erfc a.
pub(super) fn complementary_error_function(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let Some((first, second)) = rewriting.two_terms(expression) else { return Vec::new() };
    let mut found = Vec::new();
    for (constant, term) in [(first, second), (second, first)] {
        let (c, core) = rewriting.scaled(term);
        let Some(a) = rewriting.argument_of(Operation::Erf, core) else { continue };
        let opposite = rewriting.pool.negate(a);
        for (sign, a) in [(c, opposite), (rewriting.pool.negate(c), a)] {
            if sign == constant {
                let value = rewriting.pool.apply(Operation::Erfc, &[a]);
                found.push(rewriting.pool.multiply(constant, value));
            }
        }
    }
    found
}

/// Applies eᵃ p/expm1 a = −p/expm1(−a), which does not overflow for large a.
pub(super) fn over_less_one(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    if !matches!(rewriting.pool.node(expression), Node::Divide(..) | Node::Multiply(..)) {
        return Vec::new();
    }
    let (mut above, mut below, negative) = factors(rewriting.pool, expression);
    let power = above.iter().enumerate().find_map(|(place, &factor)| {
        let a = rewriting.argument_of(Operation::Exp, factor)?;
        let is_its = |&factor: &Expr| rewriting.argument_of(Operation::Expm1, factor) == Some(a);
        Some((place, below.iter().position(is_its)?, a))
    });
    let Some((place, place_below, a)) = power else { return Vec::new() };
    let opposite = rewriting.pool.negate(a);
    above.remove(place);
    below[place_below] = rewriting.pool.apply(Operation::Expm1, &[opposite]);
    let form = super::factors::quotient(rewriting.pool, &above, &below);
    vec![if negative { form } else { rewriting.pool.negate(form) }]
}

/// Decimal exponent of the smallest divisor b of a number n, relative to n: for smaller divisors
/// n/b is out of range.
const TINY: i32 = -300;

/// Returns a form that contains n/b for a number n and b > 0. If b can be so small that n/b
/// overflows, the formula is used for such b.
fn unless_divisor_is_tiny(
    rewriting: &mut Rewriting<'_>,
    formula: Expr,
    form: Expr,
    (n, b): (Expr, Expr),
) -> Expr {
    let Node::Number(n) = rewriting.pool.node(n) else { return form };
    let least = n.abs() * Rational::from_integer(10.into()).pow(TINY);
    let least = rewriting.pool.number(least);
    if rewriting.excludes(Condition { left: b, relation: Relation::Less, right: least }) {
        return form;
    }
    rewriting.pool.select((b, Relation::Less, least), formula, form, Seam::Agrees)
}
