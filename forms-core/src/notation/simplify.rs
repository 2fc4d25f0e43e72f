//! Simplification: an expression's normal form, raised back to an expression.

use crate::calculus::Structured;
use crate::decide::simplified_where;
use crate::expression::{Condition, Expr, Pool};
use crate::theory::{Array, Theory, Value};

/// Returns the expression in its simplest known form where the conditions hold: its normal form if
/// that exists and is shorter than the expression as written, or else the expression as written.
/// Both have the same value wherever the original is defined.
pub fn simplify_expression(pool: &mut Pool, conditions: &[Condition], expression: Expr) -> Expr {
    let simplified = simplified_where(pool, conditions, expression);
    let texts = pool.texts(&[expression, simplified]);
    if texts[1].len() < texts[0].len() { simplified } else { expression }
}

/// Simplifies every coefficient of a value; coefficients that vanish are omitted.
pub fn simplify(theory: &mut Theory, conditions: &[Condition], value: &Value) -> Value {
    let Theory { pool, coordinates, .. } = theory;
    let ring = &mut Structured { pool, coordinates };
    let simple =
        |ring: &mut Structured<'_>, scalar: &Expr| simplify_expression(ring.pool, conditions, *scalar);
    match value {
        Value::Zero => Value::Zero,
        Value::Scalar(scalar) => Value::Scalar(simple(ring, scalar)),
        Value::Form(form) => Value::Form(form.map(ring, simple)),
        Value::Field(field) => Value::Field(field.map(ring, simple)),
        Value::Array(Array { shape, entries }) => {
            let entries = entries.iter().map(|entry| simple(ring, entry)).collect();
            Value::Array(Array { shape: *shape, entries })
        }
    }
}
