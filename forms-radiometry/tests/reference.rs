//! Rows of the reference that describe a scene: each answer is within its reported error.

use forms_radiometry_testing::reference_rows::{self as rows, Compared, Row};

/// Whether numeric code is optimised; otherwise rows without spheres have to suffice.
const IS_OPTIMISED: bool = !cfg!(debug_assertions);
/// Tolerance that the reference allows a solver.
const TOLERANCE: f64 = 5e-3;
/// Relative to unit radiance: answers below it may have larger relative errors.
const DARK: f64 = 1e-9;

/// Asserts that answers are within their errors. Also asserts that the errors of all answers that
/// are not nearly dark meet the tolerance, with at most `most_rough` exceptions.
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
    // next to the boundary of a curved shape it is not known on which side of its faces a point is
    assert_within(&rows::visible(), 4);
}

#[test]
fn rows_of_definitions_are_within_what_is_said() {
    assert_within(&rows::own(), 8);
}
