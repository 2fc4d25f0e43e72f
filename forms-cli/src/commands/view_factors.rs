//! `forms view-factors`: the matrix of a scene, row by row, as CSV with row sums and areas, as
//! pairs, or as JSON.
//!
//! ```text
//! scene ─▶ rows (progress: a bar, Ctrl-C; journal: complete rows) ─▶ output as soon as a row is complete
//!                                                      └─ enclose ─▶ all rows, closed
//! ```

mod journal;
mod writer;

use super::simulate::Progress;
use super::{refuse, show_notes};
use crate::arguments::ViewFactorArguments;
use crate::status::Status;
use crate::streams::tell;
use forms_radiometry::scene::{Overrides, Scene, SceneError, Sources};
use forms_radiometry::simulation::{Share, Watch};
use forms_radiometry::{Row, Rows, ViewFactors};
use journal::Journal;
use std::io::{self, Write};
use std::path::Path;
use std::time::Instant;
use writer::Writer;

/// Number of surfaces that a closing sentence names.
const NAMED: usize = 5;

/// The rows that were computed, with the indices of their surfaces.
struct Found {
    rows: Vec<(usize, Row)>,
    is_stopped: bool,
    /// Whether they were stopped because their time was over.
    is_late: bool,
    failure: Option<String>,
}

/// Prints the view factors of the scene in a file.
pub(crate) fn view_factors(arguments: &ViewFactorArguments, output: &mut dyn Write) -> io::Result<Status> {
    let deadline = arguments.time.deadline();
    if let Err(message) = arguments.threads.make() {
        return Ok(refuse(&message));
    }
    let (scene, sources) = match Sources::open(Path::new(&arguments.scene)) {
        Ok(found) => found,
        Err(errors) => {
            errors.iter().for_each(|error| tell!("error: {error}"));
            return Ok(Status::Error);
        }
    };
    show_notes(&scene);
    let mut scene = scene.divided(arguments.by.division());
    let ViewFactorArguments { tolerance, seed, .. } = *arguments;
    Overrides { tolerance, seed, ..Overrides::default() }.apply(&mut scene);
    let journal = arguments.checkpoint.as_deref().map(|file| {
        Journal::open(file, &journal::identity(&sources, &scene, arguments), scene.surfaces.len())
    });
    let journal = match journal.transpose() {
        Ok(journal) => journal,
        Err(message) => return Ok(refuse(&message)),
    };
    let rows = Rows::of(&scene);
    let metres = scene.unit.metres();
    let areas = (0..scene.surfaces.len()).map(|surface| metres * metres * rows.area(surface)).collect();
    let writer = Writer::new(arguments, rows.names().to_vec(), areas);
    writer.begin(output)?;
    let each: &mut dyn FnMut(usize, &Row) -> io::Result<()> = &mut |surface, row| {
        if !arguments.enclose && row.contradiction(&scene, surface).is_none() {
            writer.row(surface, row, output)?;
            output.flush()?;
        }
        Ok(())
    };
    let found = match found(arguments, rows, journal, deadline, each) {
        Ok(found) => found?,
        Err(message) => return Ok(refuse(&message)),
    };
    finish(arguments, &scene, &writer, found, output)
}

/// Computes the rows of the shard, and passes each to `each` as soon as it is complete.
fn found(
    arguments: &ViewFactorArguments,
    mut rows: Rows,
    mut journal: Option<Journal>,
    deadline: Option<Instant>,
    each: &mut dyn FnMut(usize, &Row) -> io::Result<()>,
) -> Result<io::Result<Found>, String> {
    let progress = Progress::watch(deadline)?;
    let share = arguments.shard.unwrap_or(Share::WHOLE);
    let own: Vec<usize> = (0..rows.names().len()).filter(|&surface| share.has(surface)).collect();
    let mut found =
        Found { rows: Vec::with_capacity(own.len()), is_stopped: false, is_late: false, failure: None };
    for (place, &surface) in own.iter().enumerate() {
        let kept = journal.as_mut().and_then(|journal| journal.take(surface));
        let is_new = kept.is_none();
        let Some(row) = kept.or_else(|| rows.row(surface, &progress)) else {
            found.is_stopped = true;
            break;
        };
        if let Some(journal) = journal.as_mut().filter(|_| is_new) {
            found.failure = found.failure.take().or(journal.keep(surface, &row).err());
        }
        if let Err(error) = each(surface, &row) {
            return Ok(Err(error));
        }
        found.rows.push((surface, row));
        progress.progress("rows", (place + 1) as f64 / own.len() as f64);
        if progress.is_stopped() && place + 1 < own.len() {
            found.is_stopped = true;
            break;
        }
    }
    progress.end();
    found.is_late = found.is_stopped && progress.ran_out_of_time();
    Ok(Ok(found))
}

/// Encloses the matrix if that is asked for, and reports the contradictions, missed tolerances and
/// residuals of the rows.
fn finish(
    arguments: &ViewFactorArguments,
    scene: &Scene,
    writer: &Writer,
    found: Found,
    output: &mut dyn Write,
) -> io::Result<Status> {
    let Found { rows, is_stopped, is_late, failure } = found;
    let names: Vec<String> = scene.surfaces.iter().map(|surface| surface.name.clone()).collect();
    let mut status = Status::AsStated;
    if let Some(message) = failure {
        tell!("error: {message}");
        status = Status::Error;
    }
    let over = rows.iter().filter_map(|(surface, row)| row.contradiction(scene, *surface));
    let over: Vec<SceneError> = over.collect();
    over.iter().for_each(|error| tell!("error: {error}"));
    if !over.is_empty() {
        status = Status::Error;
    }
    let tolerance = scene.solve.tolerance;
    let missed: Vec<&str> = rows
        .iter()
        .filter(|(_, row)| !row.meets(tolerance))
        .map(|(surface, _)| writer.name(*surface))
        .collect();
    if is_stopped {
        let rest = if arguments.checkpoint.is_some() { "; the same call resumes it" } else { "" };
        let why = if is_late { "the time is over" } else { "stopped" };
        tell!("{why}: {} rows are complete{rest}", rows.len());
        return Ok(if is_late { status.max(Status::Missed) } else { Status::Stopped });
    }
    if rows.len() == names.len() {
        let rows = rows.into_iter().map(|(_, row)| row).collect();
        let mut factors = ViewFactors { names, areas: writer.areas().to_vec(), rows };
        tell_residuals(&factors);
        if arguments.enclose && status == Status::AsStated {
            match factors.enclose() {
                Ok(enclosed) => tell!(
                    "enclosed: rows sum to 1 and A1 F12 = A2 F21; largest change of a factor {:.1e}",
                    enclosed.change
                ),
                Err(error) => return Ok(refuse(&error.to_string())),
            }
            for (surface, row) in factors.rows.iter().enumerate() {
                writer.row(surface, row, output)?;
            }
            output.flush()?;
        }
    }
    if !missed.is_empty() {
        tell!("missed: the tolerance {tolerance:e} is not met in {}", listed(&missed));
        status = status.max(Status::Missed);
    }
    Ok(status)
}

fn tell_residuals(factors: &ViewFactors) {
    tell!("largest |A1 F12 - A2 F21|, relative to the smaller area: {:.1e}", factors.reciprocity_residual());
    let open = (0..factors.names.len()).map(|surface| (1.0 - factors.sum(surface)).abs()).fold(0.0, f64::max);
    tell!("largest |1 - sum of a row|: {open:.1e}");
}

/// Lists names: "the row of `a`", "the rows of `a`, `b` and 3 more".
fn listed(names: &[&str]) -> String {
    let shown: Vec<String> = names.iter().take(NAMED).map(|name| format!("`{name}`")).collect();
    let rest = names.len().saturating_sub(NAMED);
    let more = if rest > 0 { format!(" and {rest} more") } else { String::new() };
    let rows = if names.len() == 1 { "row" } else { "rows" };
    format!("the {rows} of {}{more}", shown.join(", "))
}
