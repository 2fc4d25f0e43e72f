//! Rows of the reference that say something of a scene: each answer is within the error that is said beside it.

mod rows;

use rows::{Compared, Row};

/// Whether numeric code is optimised; where it is not, rows without spheres have to do.
const IS_OPTIMISED: bool = !cfg!(debug_assertions);
/// What the reference allows of a solver.
const TOLERANCE: f64 = 5e-3;
/// Of unit radiance: answers below it may be less exact beside themselves.
const DARK: f64 = 1e-9;

/// Asserts that answers are within their errors, and that all but so many errors are what was asked for, of answers that are not all but dark.
fn assert_within(rows: &[Row], most_rough: usize) {
    let mut compared = Vec::new();
    for row in rows.iter().filter(|row| IS_OPTIMISED || !row.has_spheres()) {
        compared.extend(row.compared(TOLERANCE).map(|compared| (row, compared)));
    }
    let said = |(row, Compared { value, off, bound }): &(&Row, Compared)| {
        format!("{}: {value:e} ± {bound:e} is off by {off:e}", row.id)
    };
    let wrong: Vec<String> = compared.iter().filter(|(_, found)| found.off > found.bound).map(said).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    let is_rough = |(row, found): &&(&Row, Compared)| found.bound > TOLERANCE * row.value().max(DARK);
    let rough: Vec<String> = compared.iter().filter(is_rough).map(said).collect();
    assert!(rough.len() <= most_rough, "{}", rough.join("\n"));
}

#[test]
fn rows_of_the_reference_are_within_what_is_said() {
    // beside the border of a round shape it is not known on which side of its pieces a point is
    assert_within(&rows::visible(), 4);
}

#[test]
fn rows_of_definitions_are_within_what_is_said() {
    assert_within(&rows::own(), 8);
}
