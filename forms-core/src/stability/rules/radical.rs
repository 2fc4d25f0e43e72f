//! Rules for roots: conjugates, and roots of products.

use super::Rewriting;
use super::factors::{factors, product, quotient};
use crate::expression::{Condition, Expr, Node, Operation, Pool, Rational, Relation, Seam};
use num_rational::Ratio;
use num_traits::Signed;

/// Applies a + b = (a² − b²)/(a − b) where one of a and b has a square root, and
/// a − b = (a³ − b³)/(a² + ab + b²) for cube roots, with a simplified numerator.
pub(super) fn conjugate(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let Some((a, b)) = rewriting.two_terms(expression) else { return Vec::new() };
    let mut found = Vec::new();
    if has_root(rewriting, a, 2) || has_root(rewriting, b, 2) {
        let (a2, b2) = (rewriting.square(a), rewriting.square(b));
        let (a2, b2) = (rewriting.simplified(a2), rewriting.simplified(b2));
        let numerator = rewriting.difference(a2, b2);
        let denominator = rewriting.pool.subtract(a, b);
        found.push(rewriting.pool.divide(numerator, denominator));
    }
    if has_root(rewriting, a, 3) || has_root(rewriting, b, 3) {
        let cube = |rewriting: &mut Rewriting<'_>, x: Expr| {
            let cube = rewriting.pool.power(x, 3.into());
            rewriting.simplified(cube)
        };
        let (a3, b3) = (cube(rewriting, a), cube(rewriting, b));
        let numerator = rewriting.sum(a3, b3);
        let (a2, ab, b2) = (rewriting.square(a), rewriting.pool.multiply(a, b), rewriting.square(b));
        let denominator = rewriting.pool.subtract(a2, ab);
        let denominator = rewriting.pool.add(denominator, b2);
        found.push(rewriting.pool.divide(numerator, denominator));
    }
    found
}

/// Applies c√(a² + p) + k a = (c² p + (c² − k²) a²)/(c√(a² + p) − k a) where the sum cancels, that
/// is, where it is smaller than a quarter of the difference. The radicand is used as written: p is
/// one term, or a sum of squares and roots in which nothing cancels.
pub(super) fn beside_its_root(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let Some((first, second)) = rewriting.two_terms(expression) else { return Vec::new() };
    let mut found = Vec::new();
    for (root, other) in [(first, second), (second, first)] {
        let Some(norm) = norm(rewriting, root, other) else { continue };
        if [first, second].into_iter().all(|term| is_nowhere_negative(rewriting, term)) {
            return found;
        }
        let difference = rewriting.pool.subtract(root, other);
        let form = norm.over(rewriting, difference);
        let form = unless_coefficient_is_huge(rewriting, expression, form, norm.c);
        let four = rewriting.pool.integer(4);
        let [sum_size, size] =
            [expression, difference].map(|part| rewriting.pool.apply(Operation::Abs, &[part]));
        let quarter = rewriting.pool.divide(size, four);
        if !rewriting.excludes(Condition { left: sum_size, relation: Relation::Less, right: quarter }) {
            let relation = (sum_size, Relation::Less, quarter);
            found.push(rewriting.pool.select(relation, form, expression, Seam::Jumps));
        }
    }
    found
}

/// Whether a term is shown to be negative nowhere in the domain.
fn is_nowhere_negative(rewriting: &mut Rewriting<'_>, term: Expr) -> bool {
    let zero = rewriting.pool.integer(0);
    rewriting.excludes(Condition { left: term, relation: Relation::Less, right: zero })
}

/// Decimal exponent of the largest coefficient that is doubled.
const HUGE: i32 = 300;

/// Returns a form that contains the double of c √(a² + p). If c can be so large that this
/// overflows, the formula is used for such c.
fn unless_coefficient_is_huge(rewriting: &mut Rewriting<'_>, formula: Expr, form: Expr, c: Expr) -> Expr {
    if !rewriting.varies(c) {
        return form;
    }
    let size = rewriting.pool.apply(Operation::Abs, &[c]);
    let most = rewriting.pool.number(Rational::from_integer(10.into()).pow(HUGE));
    if rewriting.excludes(Condition { left: most, relation: Relation::Less, right: size }) {
        return form;
    }
    rewriting.pool.select((most, Relation::Less, size), formula, form, Seam::Agrees)
}

/// Norm c² p + e a² = (c√(a² + p))² − (k a)² with e = c² − k², in which a² is not subtracted from
/// itself.
struct Norm {
    c: Expr,
    p: Expr,
    e: Expr,
    a: Expr,
}

impl Norm {
    /// Returns (c² p + e a²)/d, where d has the magnitude of c√(a² + p). A c that is not constant
    /// can be so large, or so small, that its square is out of range. In this case the result is c
    /// (c/d p) + e/d a a, in which no intermediate value is larger than the result or than a² + p.
    fn over(&self, rewriting: &mut Rewriting<'_>, d: Expr) -> Expr {
        let Norm { c, p, e, a } = *self;
        if rewriting.varies(c) {
            let first = rewriting.pool.divide(c, d);
            let first = rewriting.pool.multiply(first, p);
            let first = rewriting.pool.multiply(c, first);
            let second = rewriting.pool.divide(e, d);
            let second = rewriting.pool.multiply(second, a);
            let second = rewriting.pool.multiply(second, a);
            return rewriting.pool.add(first, second);
        }
        let [c2, a2] = [c, a].map(|part| rewriting.square(part));
        let (first, second) = (rewriting.pool.multiply(c2, p), rewriting.pool.multiply(e, a2));
        let norm = rewriting.pool.add(first, second);
        rewriting.pool.divide(norm, d)
    }
}

/// Returns the parts of the norm of c√(a² + p) + k a; `None` where the terms do not have this form.
fn norm(rewriting: &mut Rewriting<'_>, root: Expr, other: Expr) -> Option<Norm> {
    let (c, radicand) = without(rewriting, root, |rewriting, factor| rewriting.radicand(factor))?;
    let terms = rewriting.terms(radicand);
    let (place, a, k) = terms.iter().enumerate().find_map(|(place, &term)| {
        let a = rewriting.squared(term)?;
        let (k, _) = without(rewriting, other, |_, factor| (factor == a).then_some(a))?;
        Some((place, a, k))
    })?;
    let rest: Vec<Expr> = (0..terms.len()).filter(|&at| at != place).map(|at| terms[at]).collect();
    if rest.is_empty() || rest.len() > 1 && !rest.iter().all(|&term| is_of_squares(rewriting.pool, term)) {
        return None;
    }
    let [c2, k2] = [c, k].map(|part| rewriting.square(part));
    let zero = rewriting.pool.integer(0);
    let e = rewriting.difference(c2, k2);
    // coefficients that are different numbers do not cancel, and coefficients in the same variables
    // can have a cancellation of their own
    let own = rewriting.pool.symbols_in(&[radicand]);
    let others = rewriting.pool.symbols_in(&[e]);
    if e != zero && (others.is_empty() || others.iter().any(|symbol| own.contains(symbol))) {
        return None;
    }
    Some(Norm { c, p: rewriting.total(&rest), e, a })
}

/// Returns a product without its first factor for which `find` succeeds, and the result of `find`.
pub(super) fn without<T>(
    rewriting: &mut Rewriting<'_>,
    product: Expr,
    find: impl Fn(&Rewriting<'_>, Expr) -> Option<T>,
) -> Option<(Expr, T)> {
    let (mut above, below, negative) = factors(rewriting.pool, product);
    let (place, found) =
        above.iter().enumerate().find_map(|(place, &factor)| Some((place, find(rewriting, factor)?)))?;
    above.remove(place);
    let rest = quotient(rewriting.pool, &above, &below);
    Some((if negative { rewriting.pool.negate(rest) } else { rest }, found))
}

/// Whether an expression is non-negative by its structure: a square, a square root, an absolute
/// value, an exponential, a number, or a product, a quotient or a sum of such expressions.
fn is_of_squares(pool: &Pool, expression: Expr) -> bool {
    match pool.node(expression) {
        Node::Number(value) => !value.is_negative(),
        Node::Power(_, exponent) => exponent.numer() % 2 == 0 || exponent.denom() % 2 == 0,
        Node::Apply(Operation::Abs | Operation::Exp, _) => true,
        Node::Multiply(a, b) if a == b => true,
        Node::Multiply(a, b) | Node::Divide(a, b) | Node::Add(a, b) => {
            is_of_squares(pool, *a) && is_of_squares(pool, *b)
        }
        _ => false,
    }
}

/// Whether a factor is a root of this degree.
fn has_root(rewriting: &mut Rewriting<'_>, term: Expr, degree: i64) -> bool {
    let (above, below, _) = factors(rewriting.pool, term);
    above.iter().chain(&below).any(|&factor| match rewriting.pool.node(factor) {
        Node::Power(_, exponent) => *exponent.denom() == degree,
        Node::Apply(Operation::Cbrt, _) => degree == 3,
        Node::Apply(Operation::Hypot, _) => degree == 2,
        _ => false,
    })
}

/// Applies p/(a + b) = p (a − b)/(a² − b²) where a or b has a square root.
pub(super) fn rationalised(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let Node::Divide(p, q) = *rewriting.pool.node(expression) else { return Vec::new() };
    let Some((a, b)) = rewriting.two_terms(q) else { return Vec::new() };
    if !has_root(rewriting, a, 2) && !has_root(rewriting, b, 2) {
        return Vec::new();
    }
    let (a2, b2) = (rewriting.square(a), rewriting.square(b));
    let norm = rewriting.pool.subtract(a2, b2);
    let norm = rewriting.simplified(norm);
    let conjugate = rewriting.pool.subtract(a, b);
    let quotient = rewriting.pool.divide(p, norm);
    let quotient = rewriting.simplified(quotient);
    vec![rewriting.pool.multiply(quotient, conjugate)]
}

/// Applies √(p/q) = √p/√q, √(p q) = √p √q, √(p² q) = |p| √q, and √q with a simplified q.
pub(super) fn of_quotients_and_products(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    let Some(radicand) = rewriting.radicand(expression) else { return Vec::new() };
    let mut found = Vec::new();
    let simple = rewriting.simplified(radicand);
    found.push(rewriting.pool.sqrt(simple));
    let (above, below, negative) = factors(rewriting.pool, radicand);
    if negative || above.len() + below.len() < 2 {
        return found;
    }
    let (p, q) = (product(rewriting.pool, &above), product(rewriting.pool, &below));
    let (p, q) = (rewriting.pool.sqrt(p), rewriting.pool.sqrt(q));
    found.push(rewriting.pool.divide(p, q));
    let roots = |rewriting: &mut Rewriting<'_>, list: &[Expr]| -> Vec<Expr> {
        list.iter().map(|&factor| root_of_factor(rewriting, factor)).collect()
    };
    let (above, below) = (roots(rewriting, &above), roots(rewriting, &below));
    found.push(quotient(rewriting.pool, &above, &below));
    found
}

/// Returns the root of a factor: |a| for a², aⁿᐟ² for aⁿ with n divisible by 4, √a otherwise.
fn root_of_factor(rewriting: &mut Rewriting<'_>, factor: Expr) -> Expr {
    if let Some(base) = rewriting.squared(factor) {
        return rewriting.size(base);
    }
    match *rewriting.pool.node(factor) {
        Node::Power(base, exponent) if exponent.is_integer() && exponent.numer() % 4 == 0 => {
            rewriting.pool.power(base, exponent / Ratio::from_integer(2))
        }
        _ => rewriting.pool.sqrt(factor),
    }
}
