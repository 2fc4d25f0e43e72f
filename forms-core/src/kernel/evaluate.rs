//! Plain evaluation of expressions in `f64`, the reference for every kernel.

use super::constant::nearest_f64;
use super::program::holds;
use crate::expression::{Expr, Node, Pool, Symbol};
use forms_math::Real;
use rustc_hash::FxHashMap;

/// Evaluates expressions as they are written, with one rounding for each node. `None` if a variable
/// has no value or an unknown function occurs.
pub fn evaluate_f64(pool: &Pool, expressions: &[Expr], values: &[(Symbol, f64)]) -> Option<Vec<f64>> {
    let mut known: FxHashMap<Expr, f64> = FxHashMap::default();
    for expression in pool.reachable(expressions) {
        let value = evaluate_node(pool, pool.node(expression), values, &known)?;
        known.insert(expression, value);
    }
    Some(expressions.iter().map(|expression| known[expression]).collect())
}

fn evaluate_node(
    pool: &Pool,
    node: &Node,
    values: &[(Symbol, f64)],
    known: &FxHashMap<Expr, f64>,
) -> Option<f64> {
    let of = |expression: &Expr| known[expression];
    Some(match node {
        Node::Number(value) => nearest_f64(value),
        Node::Pi => std::f64::consts::PI,
        Node::Symbol(symbol) => values.iter().find(|(known, _)| known == symbol)?.1,
        Node::Add(a, b) => of(a) + of(b),
        Node::Negate(a) => -of(a),
        Node::Multiply(a, b) => of(a) * of(b),
        Node::Divide(a, b) => of(a) / of(b),
        Node::Power(a, exponent) => of(a).power(*exponent.numer(), *exponent.denom()),
        Node::Apply(operation, arguments) => {
            let arguments: Vec<f64> = arguments.iter().map(of).collect();
            operation.apply(&arguments)
        }
        Node::Jet { function, arguments, .. } => {
            let quadrature = pool.quadrature_of(*function)?;
            let [from, to, captured @ ..] = &arguments[..] else { return None };
            let mut inner: Vec<(Symbol, f64)> =
                quadrature.parameters.iter().copied().zip(captured.iter().map(of)).collect();
            inner.push((quadrature.variable, 0.0));
            let place = inner.len() - 1;
            f64::quadrature(of(from), of(to), |t| {
                let mut values = inner.clone();
                values[place].1 = t;
                evaluate_f64(pool, &[quadrature.integrand], &values).map_or(f64::NAN, |values| values[0])
            })
        }
        Node::Select { left, relation, right, then, otherwise, .. } => {
            match holds(*relation, of(left), of(right)) {
                Some(true) => of(then),
                Some(false) => of(otherwise),
                None => f64::NAN,
            }
        }
    })
}
