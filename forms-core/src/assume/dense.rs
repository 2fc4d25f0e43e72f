//! Functions that are not zero on a dense set of points.
//!
//! **Lemma.** Let N be built from numbers and variables by + − · /, integer powers and exp, sin,
//! cos, tan, sinh, cosh and tanh. If N is defined and not zero at one point, then every open set of
//! points at which it is defined contains points at which it is not zero.
//!
//! N has one value at each complex point at which it is defined. These are all points except the
//! poles. The poles are zeros of holomorphic functions, so that the remaining set is connected, by
//! induction over the operations. N is holomorphic on it; if N were zero on an open set, real or
//! complex, it would be zero everywhere. Without its hypotheses the lemma fails: |x| − x is not
//! zero at −1 and zero for all x > 0, as are √(x²) − x and atan x + atan(1/x) − π/2.

use crate::enclosure::{Precision, enclose_number};
use crate::expression::{Expr, Node, Operation, Pool, Substitution};

/// Number of points that are tried; a function that is zero nowhere dense may still be zero at a
/// single one of them.
const POINTS: i64 = 4;

const PRECISION: Precision = Precision(128);

/// Whether an expression is known to be zero on no open set of points at which it is defined; for a
/// product this holds if it holds for its factors.
pub(crate) fn is_not_zero_densely(pool: &mut Pool, expression: Expr) -> bool {
    let factors = pool.factors_that_may_vanish(expression);
    factors.into_iter().all(|factor| match *pool.node(factor) {
        Node::Apply(Operation::Abs, ref of) => {
            let of = of[0];
            is_not_zero_densely(pool, of)
        }
        Node::Apply(Operation::Log, ref of) => {
            let (of, one) = (of[0], pool.integer(1));
            let difference = pool.subtract(of, one);
            is_not_zero_densely(pool, difference)
        }
        _ => is_single_valued(pool, factor) && is_somewhere_not_zero(pool, factor),
    })
}

/// Whether an expression has one value at each complex point.
fn is_single_valued(pool: &Pool, expression: Expr) -> bool {
    pool.reachable(&[expression]).into_iter().all(|part| match pool.node(part) {
        Node::Number(_) | Node::Pi | Node::Symbol(_) => true,
        Node::Add(..) | Node::Negate(_) | Node::Multiply(..) | Node::Divide(..) => true,
        Node::Power(_, exponent) => exponent.is_integer(),
        Node::Apply(operation, _) => matches!(
            operation,
            Operation::Exp
                | Operation::Sin
                | Operation::Cos
                | Operation::Tan
                | Operation::Sinh
                | Operation::Cosh
                | Operation::Tanh
        ),
        Node::Jet { .. } | Node::Select { .. } => false,
    })
}

/// Whether a point is known at which an expression is not zero.
fn is_somewhere_not_zero(pool: &mut Pool, expression: Expr) -> bool {
    let symbols = pool.symbols_in(&[expression]);
    (1..=POINTS).any(|number| {
        let mut point = Substitution::default();
        for (place, &symbol) in symbols.iter().enumerate() {
            // unequal coordinates without a simple relation between them
            let place = place as i64;
            point.insert(symbol, pool.ratio(number + 3 * place * place, 7 + 2 * place));
        }
        let value = pool.substitute(expression, &point);
        enclose_number(pool, value, PRECISION).is_ok_and(|value| value.is_positive() || value.is_negative())
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::resolve::resolve;
    use crate::syntax::read;
    use crate::theory::Value;

    fn is_dense(text: &str) -> bool {
        let (file, errors) = read(&format!("chart L(x, y, z); let q = {text};"));
        assert!(errors.is_empty(), "{text}");
        let (mut theory, errors) = resolve(&file);
        assert!(errors.is_empty(), "{text}");
        let Value::Scalar(expression) = theory.objects[0].value else { panic!("{text} is a scalar") };
        is_not_zero_densely(&mut theory.pool, expression)
    }

    #[test]
    fn what_has_one_value_everywhere_is_zero_nowhere_dense() {
        for text in [
            "x",
            "x - y",
            "x*y*abs(z)",
            "sin(x)",
            "exp(1/x) - x",
            "sqrt(x)*y",
            "(x**2 - y)**(1/3)",
            "tan(1/x) + y",
            "log(x)",
        ] {
            assert!(is_dense(text), "{text}");
        }
    }

    #[test]
    fn what_is_zero_on_an_open_set_is_not_taken_for_dense() {
        let zeros = [
            "abs(x) - x",
            "sqrt(x**2) - x",
            "acos(cos(x)) - x",
            "asin(sin(x)) - x",
            "atan(tan(x)) - x",
            "atan(x) + atan(1/x) - pi/2",
            "log(x**2) - 2*log(abs(x))",
            "abs(x*y) - x*y",
            "x*(abs(y) - y)",
            "atan2(sin(x), cos(x)) - x",
            "x*y - y*x",
            "sin(x)**2 + cos(x)**2 - 1",
        ];
        for text in zeros {
            assert!(!is_dense(text), "{text}");
        }
    }
}
