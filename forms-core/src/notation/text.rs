//! Values in the language's own notation.

use super::sum::{Coefficient, Term, joined, terms};
use crate::calculus::Coordinate;
use crate::expression::Shape;
use crate::theory::{Theory, Value};

/// Writes the results of a kernel in the language, given the formula of each number in them: a
/// single result as it is, several in brackets, an array in square brackets.
pub fn results(formulas: &[String], shapes: &[Shape]) -> String {
    let parts = Shape::split(shapes, formulas, |parts| format!("[{}]", parts.join(", ")));
    match parts.as_slice() {
        [single] => single.clone(),
        several => format!("({})", several.join(", ")),
    }
}

/// Writes a value in the language: `4/(u**2 + v**2 + 1)**2*du^dv`.
pub fn text(theory: &Theory, value: &Value) -> String {
    let basis = |coordinates: &[Coordinate]| {
        let prefix = if matches!(value, Value::Field(_)) { "@" } else { "d" };
        let names: Vec<String> =
            coordinates.iter().map(|c| format!("{prefix}{}", theory.coordinate_name(*c))).collect();
        names.join("^")
    };
    match value {
        Value::Zero => "0".to_string(),
        Value::Scalar(scalar) => theory.pool.text(*scalar),
        Value::Array(array) => {
            array.shape.nested(&theory.pool.texts(&array.entries), |parts| format!("[{}]", parts.join(", ")))
        }
        Value::Form(_) | Value::Field(_) => {
            let written = |term: Term| {
                let write = |scalar| theory.pool.text(scalar);
                let brackets = |text| format!("({text})");
                let coefficient = Coefficient::new(&theory.pool, term.coefficient, write, brackets);
                (coefficient, basis(&term.coordinates))
            };
            joined(terms(value).into_iter().map(written).collect(), "*")
        }
    }
}
