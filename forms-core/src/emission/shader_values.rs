//! Values of arguments and results in WGSL: numbers, arrays, and matrices as arrays of rows.

use super::parameters::nested_type;
use crate::expression::Shape;
use crate::kernel::Program;

/// Returns the shape of the result: several results are one array of all numbers in them.
pub(super) fn results(program: &Program) -> Shape {
    match program.signature.results.as_slice() {
        [single] => *single,
        _ => Shape::Vector(program.outputs.len()),
    }
}

/// Writes the type of a value of this shape.
pub(super) fn type_of(shape: Shape) -> String {
    nested_type(shape, "f32", |element, extent| format!("array<{element}, {extent}>"))
}

/// Writes a value of this shape from the texts of its numbers, matrices by rows.
pub(super) fn nested(shape: Shape, numbers: &[String]) -> String {
    let row = |parts: &[String]| format!("array<f32, {}>({})", parts.len(), parts.join(", "));
    match shape {
        Shape::Number => numbers.concat(),
        Shape::Vector(_) => row(numbers),
        Shape::Matrix(_, columns) => {
            let rows: Vec<String> = numbers.chunks(columns).map(row).collect();
            format!("{}({})", type_of(shape), rows.join(", "))
        }
    }
}
