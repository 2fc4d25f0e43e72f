//! Rules for sines, cosines and angles near the points where they cancel.

use super::Rewriting;
use super::factors::factors;
use crate::expression::{Expr, Node, Operation};

/// Applies c − c cos a = 2 c sin²(a/2), and 1 − sin² = cos², 1 − cos² = sin².
pub(super) fn versine(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let Some((first, second)) = rewriting.two_terms(expression) else { return Vec::new() };
    let mut found = Vec::new();
    for (constant, wave) in [(first, second), (second, first)] {
        let (above, below, negative) = factors(rewriting.pool, wave);
        for (place, &factor) in above.iter().enumerate() {
            let base = rewriting.squared(factor).unwrap_or(factor);
            if !matches!(rewriting.pool.node(base), Node::Apply(Operation::Sin | Operation::Cos, _)) {
                continue;
            }
            let mut others = above.clone();
            others.remove(place);
            let rest = super::factors::quotient(rewriting.pool, &others, &below);
            let rest = if negative { rewriting.pool.negate(rest) } else { rest };
            // constant + rest·wave with constant = −rest
            if rewriting.sum(constant, rest) != rewriting.pool.integer(0) {
                continue;
            }
            if let Some(a) = rewriting.argument_of(Operation::Cos, factor) {
                let half = rewriting.half(a);
                let sine = rewriting.pool.apply(Operation::Sin, &[half]);
                let square = rewriting.square(sine);
                let double = rewriting.times(2, constant);
                found.push(rewriting.pool.multiply(double, square));
            }
            if let Some(base) = rewriting.squared(factor) {
                for (operation, other) in [(Operation::Sin, Operation::Cos), (Operation::Cos, Operation::Sin)]
                {
                    if let Some(a) = rewriting.argument_of(operation, base) {
                        let wave = rewriting.pool.apply(other, &[a]);
                        let square = rewriting.square(wave);
                        found.push(rewriting.pool.multiply(constant, square));
                    }
                }
            }
        }
    }
    found
}

/// Applies sin a − sin b = 2 sin((a−b)/2) cos((a+b)/2),
/// cos a − cos b = −2 sin((a−b)/2) sin((a+b)/2), and tan a − tan b = sin(a−b)/(cos a cos b).
pub(super) fn differences(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let Some((first, second)) = rewriting.two_terms(expression) else { return Vec::new() };
    let ((c, p), (k, q)) = (rewriting.scaled(first), rewriting.scaled(second));
    if rewriting.sum(c, k) != rewriting.pool.integer(0) {
        return Vec::new();
    }
    let mut found = Vec::new();
    for operation in [Operation::Sin, Operation::Cos, Operation::Tan] {
        let (Some(a), Some(b)) = (rewriting.argument_of(operation, p), rewriting.argument_of(operation, q))
        else {
            continue;
        };
        let difference = rewriting.difference(a, b);
        let apply = |rewriting: &mut Rewriting<'_>, operation, a| rewriting.pool.apply(operation, &[a]);
        if operation == Operation::Tan {
            let sine = apply(rewriting, Operation::Sin, difference);
            let (a, b) = (apply(rewriting, Operation::Cos, a), apply(rewriting, Operation::Cos, b));
            let below = rewriting.pool.multiply(a, b);
            let quotient = rewriting.pool.divide(sine, below);
            found.push(rewriting.pool.multiply(c, quotient));
            continue;
        }
        let half = rewriting.half(difference);
        let middle = midpoint(rewriting, a, b, half);
        let sine = apply(rewriting, Operation::Sin, half);
        let (other, factor) =
            if operation == Operation::Sin { (Operation::Cos, 2) } else { (Operation::Sin, -2) };
        for middle in middle {
            let wave = apply(rewriting, other, middle);
            let product = rewriting.pool.multiply(sine, wave);
            let scaled = rewriting.times(factor, product);
            found.push(rewriting.pool.multiply(c, scaled));
        }
    }
    found
}

/// Returns (a + b)/2 as b + (a − b)/2, which has a smaller rounding error where a and b are close,
/// and in which the sum of two equal numbers does not overflow; also (a + b)/2 as written.
fn midpoint(rewriting: &mut Rewriting<'_>, a: Expr, b: Expr, half: Expr) -> [Expr; 2] {
    let sum = rewriting.sum(a, b);
    [rewriting.pool.add(b, half), rewriting.half(sum)]
}

/// Applies sin(a + b) = sin a cos b + cos a sin b, cos(a + b) = cos a cos b − sin a sin b: the
/// rounding of a + b has no effect.
pub(super) fn of_a_sum(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let Node::Apply(operation @ (Operation::Sin | Operation::Cos), arguments) =
        rewriting.pool.node(expression).clone()
    else {
        return Vec::new();
    };
    let Some((a, b)) = rewriting.two_terms(arguments[0]) else { return Vec::new() };
    let waves = [(Operation::Sin, a), (Operation::Cos, a), (Operation::Sin, b), (Operation::Cos, b)];
    let [sin_a, cos_a, sin_b, cos_b] = waves.map(|(wave, angle)| rewriting.pool.apply(wave, &[angle]));
    vec![if operation == Operation::Sin {
        let (p, q) = (rewriting.pool.multiply(sin_a, cos_b), rewriting.pool.multiply(cos_a, sin_b));
        rewriting.pool.add(p, q)
    } else {
        let (p, q) = (rewriting.pool.multiply(cos_a, cos_b), rewriting.pool.multiply(sin_a, sin_b));
        rewriting.pool.subtract(p, q)
    }]
}

/// Applies (1 − cos a)/sin a = sin a/(1 + cos a) = tan(a/2), and
/// (1 − cos a)/(1 + cos a) = tan²(a/2).
pub(super) fn half_angle(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let Node::Divide(p, q) = *rewriting.pool.node(expression) else { return Vec::new() };
    let angle = |rewriting: &mut Rewriting<'_>, sum: Expr| {
        let terms = rewriting.terms(sum);
        let [_, wave] = terms[..] else { return None };
        let (_, core) = rewriting.scaled(wave);
        rewriting.argument_of(Operation::Cos, core)
    };
    let candidates = [
        angle(rewriting, p).or_else(|| rewriting.argument_of(Operation::Sin, p)),
        angle(rewriting, q).or_else(|| rewriting.argument_of(Operation::Sin, q)),
    ];
    let [Some(a), Some(b)] = candidates else { return Vec::new() };
    if a != b {
        return Vec::new();
    }
    let half = rewriting.half(a);
    let tangent = rewriting.pool.apply(Operation::Tan, &[half]);
    let has_sine = [p, q].iter().any(|&part| rewriting.argument_of(Operation::Sin, part).is_some());
    vec![if has_sine { tangent } else { rewriting.square(tangent) }]
}

/// Applies atan a − atan b = atan2(a − b, 1 + a b).
pub(super) fn arc_tangents(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let Some((first, second)) = rewriting.two_terms(expression) else { return Vec::new() };
    let ((c, p), (k, q)) = (rewriting.scaled(first), rewriting.scaled(second));
    let (Some(a), Some(b)) =
        (rewriting.argument_of(Operation::Atan, p), rewriting.argument_of(Operation::Atan, q))
    else {
        return Vec::new();
    };
    if rewriting.sum(c, k) != rewriting.pool.integer(0) {
        return Vec::new();
    }
    let y = rewriting.difference(a, b);
    let (one, ab) = (rewriting.pool.integer(1), rewriting.pool.multiply(a, b));
    let x = rewriting.pool.add(one, ab);
    let (angle, slope) = (rewriting.pool.apply(Operation::Atan2, &[y, x]), rewriting.pool.divide(y, x));
    let tangent = rewriting.pool.apply(Operation::Atan, &[slope]);
    vec![rewriting.pool.multiply(c, angle), rewriting.pool.multiply(c, tangent)]
}

/// Applies acos q = 2 atan2(√(1 − q), √(1 + q)) = atan2(√((1 − q)(1 + q)), q) = 2 asin √((1 − q)/2),
/// asin q = atan2(q, √((1 − q)(1 + q))).
pub(super) fn from_the_other_leg(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let Node::Apply(operation @ (Operation::Acos | Operation::Asin), arguments) =
        rewriting.pool.node(expression).clone()
    else {
        return Vec::new();
    };
    let (q, one) = (arguments[0], rewriting.pool.integer(1));
    let (below, above) = (rewriting.difference(one, q), rewriting.sum(one, q));
    let product = rewriting.pool.multiply(below, above);
    let leg = rewriting.pool.sqrt(product);
    if operation == Operation::Asin {
        return vec![rewriting.pool.apply(Operation::Atan2, &[q, leg])];
    }
    let half = rewriting.half(below);
    let root = rewriting.pool.sqrt(half);
    let sine = rewriting.pool.apply(Operation::Asin, &[root]);
    let legs = [below, above].map(|square| rewriting.pool.sqrt(square));
    let half_angle = rewriting.pool.apply(Operation::Atan2, &legs);
    let angle = rewriting.pool.apply(Operation::Atan2, &[leg, q]);
    vec![rewriting.times(2, half_angle), angle, rewriting.times(2, sine)]
}
