//! Arguments and results of emitted functions in their declared shapes: an array is one parameter,
//! and the program reads its elements.

use crate::expression::{Parameter, Shape};
use crate::kernel::Program;

/// Returns the text of each number among the arguments; `element` writes an entry of an array.
pub(super) fn numbers(program: &Program, element: impl Fn(&str, Shape, &[usize]) -> String) -> Vec<String> {
    let of = |Parameter { name, shape }: &Parameter| match shape {
        Shape::Number => vec![name.clone()],
        _ => shape.indices().iter().map(|index| element(name, *shape, index)).collect(),
    };
    program.signature.parameters.iter().flat_map(of).collect()
}

/// Writes an element of nested arrays: `R[1][2]`.
pub(super) fn nested_element(name: &str, _: Shape, index: &[usize]) -> String {
    index.iter().fold(name.to_owned(), |name, at| format!("{name}[{at}]"))
}

/// Writes an element of one array that holds the rows one after another: `R[5]`.
pub(super) fn flat_element(name: &str, shape: Shape, index: &[usize]) -> String {
    let place = index.iter().zip(shape.extents()).fold(0, |place, (at, extent)| place * extent + at);
    format!("{name}[{place}]")
}

/// Returns whether each parameter is used, given whether each number among the arguments is.
pub(super) fn used(program: &Program, is_used: impl Fn(usize) -> bool) -> Vec<bool> {
    let mut next = 0;
    let mut of = |parameter: &Parameter| {
        let own = next..next + parameter.shape.entries();
        next = own.end;
        own.into_iter().any(&is_used)
    };
    program.signature.parameters.iter().map(&mut of).collect()
}

/// Writes the type of a value of this shape as nested arrays; `array` writes the type of an array
/// with elements of a type.
pub(super) fn nested_type(shape: Shape, number: &str, array: impl Fn(&str, usize) -> String) -> String {
    shape.extents().into_iter().rev().fold(number.to_owned(), |element, extent| array(&element, extent))
}

/// Returns the sentences that say how arrays are stored where nested arrays are written as one.
pub(super) fn storage(program: &Program) -> Vec<String> {
    let of = |Parameter { name, shape }: &Parameter| match shape {
        Shape::Matrix(_, columns) => {
            Some(format!("`{name}` holds the rows of a matrix: `{name}[i, j]` is `{name}[{columns}*i + j]`."))
        }
        _ => None,
    };
    let mut notes: Vec<String> = program.signature.parameters.iter().filter_map(of).collect();
    if program.outputs.len() > 1 && !program.signature.has_numbers_only() {
        notes.push("`outputs` gets the results one after another, matrices by rows.".to_owned());
    }
    notes
}
