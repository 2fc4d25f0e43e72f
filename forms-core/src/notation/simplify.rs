//! Simplification: an expression's normal form, raised back to an expression.

use crate::calculus::Structured;
use crate::decide::simplified;
use crate::expression::{Expr, Pool};
use crate::resolve::{Theory, Value};

/// The expression in its simplest known form: its normal form where it has one that is shorter than what was written,
/// else what was written. Both have the same value wherever the original is defined.
pub fn simplify_expression(pool: &mut Pool, expression: Expr) -> Expr {
    let simplified = simplified(pool, expression);
    let texts = pool.texts(&[expression, simplified]);
    if texts[1].len() < texts[0].len() { simplified } else { expression }
}

/// The value with every coefficient simplified; coefficients that vanish are left out.
pub fn simplify(theory: &mut Theory, value: &Value) -> Value {
    let Theory { pool, coordinates, .. } = theory;
    let ring = &mut Structured { pool, coordinates };
    match value {
        Value::Zero => Value::Zero,
        Value::Scalar(scalar) => Value::Scalar(simplify_expression(ring.pool, *scalar)),
        Value::Form(form) => {
            Value::Form(form.map(ring, |ring, scalar| simplify_expression(ring.pool, *scalar)))
        }
        Value::Field(field) => {
            Value::Field(field.map(ring, |ring, scalar| simplify_expression(ring.pool, *scalar)))
        }
    }
}
