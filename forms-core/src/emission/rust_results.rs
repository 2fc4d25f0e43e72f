//! Results of Rust functions: numbers, arrays of numbers, and tuples of both.

use super::parameters::nested_type;
use crate::expression::Shape;

/// Longest list that stays on one line.
const LINE: usize = 60;

/// Writes the type of an array.
pub(super) fn array_type(element: &str, extent: usize) -> String {
    format!("[{element}; {extent}]")
}

/// Writes the type of the results: a number, an array of several numbers, or a tuple if there are
/// arrays among several results. With the text of a value for `number` this is an
/// expression whose numbers all have this value.
pub(super) fn result_type(results: &[Shape], number: &str) -> String {
    let one = |shape: &Shape| nested_type(*shape, number, array_type);
    match results {
        [single] => one(single),
        several if are_numbers(several) => array_type(number, several.len()),
        several => format!("({})", several.iter().map(one).collect::<Vec<_>>().join(", ")),
    }
}

fn are_numbers(results: &[Shape]) -> bool {
    results.iter().all(|&shape| shape == Shape::Number)
}

/// Writes the results from the texts of the numbers in them, as the last expression of a function.
pub(super) fn result_lines(results: &[Shape], numbers: &[&str]) -> String {
    let texts: Vec<String> = numbers.iter().map(|&number| number.to_owned()).collect();
    let text = match results {
        [Shape::Number] => texts.concat(),
        [Shape::Vector(_)] => list('[', &texts, ']'),
        [Shape::Matrix(_, columns)] => {
            let rows: Vec<String> =
                texts.chunks(*columns).map(|row| format!("[{}]", row.join(", "))).collect();
            list('[', &rows, ']')
        }
        several if are_numbers(several) => list('[', &texts, ']'),
        several => list('(', &Shape::split(several, &texts, |parts| format!("[{}]", parts.join(", "))), ')'),
    };
    format!("    {text}\n")
}

fn list(open: char, items: &[String], close: char) -> String {
    let line = items.join(", ");
    if line.len() <= LINE {
        return format!("{open}{line}{close}");
    }
    format!("{open}\n        {},\n    {close}", items.join(",\n        "))
}

/// Writes the results from an expression for the array of all numbers in them.
pub(super) fn results_of_array(results: &[Shape], array: &str) -> String {
    match results {
        [Shape::Number] => format!("    let [value] = {array};\n    value\n"),
        [Shape::Vector(_)] => format!("    {array}\n"),
        several if are_numbers(several) => format!("    {array}\n"),
        shapes => {
            let count: usize = shapes.iter().map(|shape| shape.entries()).sum();
            let names: Vec<String> = (0..count).map(|place| format!("v{place}")).collect();
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            format!("    let [{}] = {array};\n{}", names.join(", "), result_lines(shapes, &names))
        }
    }
}
