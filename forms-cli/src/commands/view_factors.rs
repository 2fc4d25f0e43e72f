//! `forms view-factors`: the matrix of a scene, as CSV with row sums and areas or as JSON.

use super::show_notes;
use crate::json::write_record;
use crate::status::Status;
use crate::streams::tell;
use forms_radiometry::scene::{self, Overrides, Scene};
use forms_radiometry::{ViewFactors, view_factors as factors};
use std::io::{self, Write};
use std::path::Path;

/// Prints the view factors of the scene in a file.
pub(crate) fn view_factors(
    file: &str,
    tolerance: Option<f64>,
    json: bool,
    output: &mut dyn Write,
) -> io::Result<Status> {
    let scene = scene::open(Path::new(file));
    let found = scene.and_then(|mut scene| {
        show_notes(&scene);
        Overrides { tolerance, ..Overrides::default() }.apply(&mut scene);
        let found = factors(&scene);
        let errors = found.contradictions(&scene);
        if errors.is_empty() { Ok(Matrix::of(&scene, found)) } else { Err(errors) }
    });
    let found = match found {
        Ok(found) => found,
        Err(errors) => {
            errors.iter().for_each(|error| tell!("error: {error}"));
            return Ok(Status::Error);
        }
    };
    if json { found.write_lines(output) } else { found.write_csv(output) }?;
    let factors = &found.factors;
    tell!("largest |A1 F12 - A2 F21|, relative to the smaller area: {:.1e}", factors.reciprocity_residual());
    let open = (0..factors.names.len()).map(|surface| (1.0 - factors.sum(surface)).abs()).fold(0.0, f64::max);
    tell!("largest |1 - sum of a row|: {open:.1e}");
    Ok(Status::AsStated)
}

/// View factors with the emitting areas of the surfaces, in m².
struct Matrix {
    factors: ViewFactors,
    areas: Vec<f64>,
}

impl Matrix {
    fn of(scene: &Scene, factors: ViewFactors) -> Self {
        let metres = scene.unit.metres();
        let areas = factors.areas.iter().map(|area| area * metres * metres).collect();
        Self { factors, areas }
    }

    /// Writes one line for each surface: its factors to all surfaces, their sum, and its area.
    fn write_csv(&self, output: &mut dyn Write) -> io::Result<()> {
        let Self { factors, areas } = self;
        let mut writer = csv::Writer::from_writer(output);
        let names = factors.names.iter().map(String::as_str);
        writer.write_record(std::iter::once("from").chain(names).chain(["sum", "area"]))?;
        for (surface, row) in factors.rows.iter().enumerate() {
            let closing = [factors.sum(surface), areas[surface]];
            let values = row.iter().map(|factor| factor.value).chain(closing);
            let values = values.map(|value| format!("{value:?}"));
            writer.write_record(std::iter::once(factors.names[surface].clone()).chain(values))?;
        }
        writer.flush()
    }

    /// Writes one object per line for each pair of surfaces.
    fn write_lines(&self, output: &mut dyn Write) -> io::Result<()> {
        let Self { factors, areas } = self;
        for ((from, row), &area) in factors.names.iter().zip(&factors.rows).zip(areas) {
            for (to, factor) in factors.names.iter().zip(row) {
                let (value, error) = (factor.value, factor.error);
                write_record(output, &Record { from, to, value, error, area })?;
            }
        }
        Ok(())
    }
}

/// JSON record of a view factor.
#[derive(serde::Serialize)]
struct Record<'a> {
    from: &'a str,
    to: &'a str,
    value: f64,
    error: f64,
    /// Emitting area of `from`.
    area: f64,
}
