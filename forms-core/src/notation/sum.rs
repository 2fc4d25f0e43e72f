//! Forms and fields as signed sums of coefficients times basis elements.

use crate::calculus::Coordinate;
use crate::expression::{Expr, Node, Pool};
use crate::theory::Value;
use num_traits::Signed;

/// Coefficient with the coordinates of its basis form, or the one coordinate of its basis field.
pub(super) struct Term {
    pub(super) coefficient: Expr,
    pub(super) coordinates: Vec<Coordinate>,
}

/// Returns the terms of a form or a field in their order; a scalar or an array has none.
pub(super) fn terms(value: &Value) -> Vec<Term> {
    match value {
        Value::Zero | Value::Scalar(_) | Value::Array(_) => vec![],
        Value::Form(form) => form
            .terms()
            .iter()
            .map(|(blade, coefficient)| Term {
                coefficient: *coefficient,
                coordinates: blade.coordinates().collect(),
            })
            .collect(),
        Value::Field(field) => field
            .components()
            .map(|(coordinate, coefficient)| Term {
                coefficient: *coefficient,
                coordinates: vec![coordinate],
            })
            .collect(),
    }
}

/// Joins coefficients and basis elements: `a*dx - b*dy`, without coefficients ±1. `times` separates
/// a coefficient and its basis element.
pub(super) fn joined(terms: Vec<(Coefficient, String)>, times: &str) -> String {
    let mut sum = String::new();
    for (coefficient, basis) in terms {
        sum.push_str(match (sum.is_empty(), coefficient.negative) {
            (true, true) => "-",
            (true, false) => "",
            (false, true) => " - ",
            (false, false) => " + ",
        });
        if coefficient.magnitude != "1" {
            sum.push_str(&coefficient.magnitude);
            sum.push_str(times);
        }
        sum.push_str(&basis);
    }
    if sum.is_empty() { "0".to_string() } else { sum }
}

/// Text of a coefficient in front of a basis element.
pub(super) struct Coefficient {
    negative: bool,
    magnitude: String,
}

impl Coefficient {
    /// Writes a coefficient; `brackets` encloses a sum in brackets.
    pub(super) fn new(
        pool: &Pool,
        expression: Expr,
        write: impl Fn(Expr) -> String,
        brackets: impl Fn(String) -> String,
    ) -> Self {
        let bracketed = |inner: Expr| {
            let written = write(inner);
            if matches!(pool.node(inner), Node::Add(..)) { brackets(written) } else { written }
        };
        match pool.node(expression) {
            Node::Negate(inner) => Coefficient { negative: true, magnitude: bracketed(*inner) },
            Node::Number(value) if value.is_negative() => {
                let written = write(expression);
                Coefficient { negative: true, magnitude: written.trim_start_matches('-').to_string() }
            }
            _ => Coefficient { negative: false, magnitude: bracketed(expression) },
        }
    }
}
