//! `forms view-factors`: the matrix of a scene, as CSV with row sums or as JSON.

use crate::json::write_record;
use crate::status::Status;
use crate::streams::tell;
use forms_radiometry::scene;
use forms_radiometry::{ViewFactors, view_factors as factors};
use std::io::{self, Write};
use std::path::Path;

/// Prints the view factors of the scene in a file.
pub(crate) fn view_factors(file: &str, json: bool, output: &mut dyn Write) -> io::Result<Status> {
    let found = scene::open(Path::new(file)).map(|scene| factors(&scene));
    let found = match found {
        Ok(found) => found,
        Err(errors) => {
            errors.iter().for_each(|error| tell!("error: {error}"));
            return Ok(Status::Error);
        }
    };
    if json { lines(&found, output) } else { matrix(&found, output) }?;
    tell!("largest |A1 F12 - A2 F21|, relative to the smaller area: {:.1e}", found.reciprocity_residual());
    let open = (0..found.names.len()).map(|surface| (1.0 - found.sum(surface)).abs()).fold(0.0, f64::max);
    tell!("largest |1 - sum of a row|: {open:.1e}");
    Ok(Status::AsStated)
}

/// One line for each surface: its factors to all, and their sum.
fn matrix(found: &ViewFactors, output: &mut dyn Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(output);
    let head = std::iter::once("from").chain(found.names.iter().map(String::as_str)).chain(["sum"]);
    writer.write_record(head)?;
    for (surface, row) in found.rows.iter().enumerate() {
        let values = row.iter().map(|factor| factor.value).chain([found.sum(surface)]);
        let values = values.map(|value| format!("{value:?}"));
        writer.write_record(std::iter::once(found.names[surface].clone()).chain(values))?;
    }
    writer.flush()
}

/// A view factor as an object.
#[derive(serde::Serialize)]
struct Record<'a> {
    from: &'a str,
    to: &'a str,
    value: f64,
    error: f64,
}

fn lines(found: &ViewFactors, output: &mut dyn Write) -> io::Result<()> {
    for (from, row) in found.names.iter().zip(&found.rows) {
        for (to, factor) in found.names.iter().zip(row) {
            write_record(output, &Record { from, to, value: factor.value, error: factor.error })?;
        }
    }
    Ok(())
}
