//! Signs that expressions have to zero, and the terms and factors by which they are shown.

use crate::expression::{Condition, Expr, Node, Operation, Pool, Rational, Relation};
use num_traits::{One, Signed};

/// Relation of an expression to zero that is to be shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Sign {
    Positive,
    NotNegative,
    NotZero,
}

impl Sign {
    pub(super) fn relation(self) -> Relation {
        match self {
            Sign::Positive => Relation::Greater,
            Sign::NotNegative => Relation::GreaterEqual,
            Sign::NotZero => Relation::NotEqual,
        }
    }

    /// Whether this sign follows from a known relation of the expression to zero.
    pub(super) fn follows_from(self, known: Relation) -> bool {
        match self {
            Sign::Positive => known == Relation::Greater,
            Sign::NotNegative => matches!(known, Relation::Greater | Relation::GreaterEqual),
            Sign::NotZero => matches!(known, Relation::Greater | Relation::Less | Relation::NotEqual),
        }
    }
}

/// The terms of a sum with their signs, in a fixed order.
pub(super) type Terms = Vec<(Expr, bool)>;

/// Returns the terms of an expression or of its negative; the sign of a number is moved to the sign
/// of its term.
pub(super) fn terms_of(pool: &mut Pool, expression: Expr, opposite: bool) -> Terms {
    let mut terms = pool.summands(expression);
    for term in &mut terms {
        term.1 ^= opposite;
        if pool.as_number(term.0).is_some_and(Signed::is_negative) {
            *term = (pool.negate(term.0), !term.1);
        }
    }
    terms.sort_unstable();
    terms
}

/// Returns the factors of all expressions that are known to be non-zero: a product is zero where
/// any of its factors is.
pub(super) fn factors_not_zero(pool: &Pool, conditions: &[Condition]) -> Vec<Expr> {
    let (mut found, mut open) = (Vec::new(), Vec::new());
    for condition in conditions.iter().filter(|c| Sign::NotZero.follows_from(c.relation)) {
        open.extend(pool.is_zero(condition.right).then_some(condition.left));
    }
    while let Some(part) = open.pop() {
        match pool.node(part) {
            Node::Multiply(a, b) | Node::Divide(a, b) => open.extend([*a, *b]),
            Node::Negate(a) | Node::Power(a, _) => open.push(*a),
            Node::Apply(operation, q) if increases_through_zero(*operation) => open.push(q[0]),
            Node::Apply(Operation::Abs, q) => open.push(q[0]),
            Node::Add(..) => open.extend(exponent_of_less_one(pool, part)),
            _ => {}
        }
        found.push(part);
    }
    found
}

/// Returns q of exp q − 1 or 1 − exp q, which vanish where q does.
fn exponent_of_less_one(pool: &Pool, sum: Expr) -> Option<Expr> {
    let [first, second] = pool.summands(sum)[..] else { return None };
    [(first, second), (second, first)].into_iter().find_map(|((power, is_minus), (number, is_less))| {
        let opposite = if is_minus == is_less { -Rational::one() } else { Rational::one() };
        match pool.node(power) {
            Node::Apply(Operation::Exp, q) if pool.as_number(number) == Some(&opposite) => Some(q[0]),
            _ => None,
        }
    })
}

/// Whether f(−q) = −f(q) and f increases.
pub(super) fn is_odd_and_increasing(operation: Operation) -> bool {
    use Operation::{Asin, Atan, Cbrt, Erf, Sinh, Tanh};
    matches!(operation, Sinh | Asin | Atan | Tanh | Erf | Cbrt)
}

/// Whether f(0) = 0 and f increases, so that f has the sign of its argument.
pub(super) fn increases_through_zero(operation: Operation) -> bool {
    is_odd_and_increasing(operation) || matches!(operation, Operation::Expm1 | Operation::Log1p)
}
