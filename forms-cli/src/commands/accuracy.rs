//! `forms accuracy`: the run time and the accuracy of each precision and form of a kernel.
//!
//! ```text
//! kernel ─┬─ sheet ──▶ errors of every variant in every regime ─┐
//!         ├─ timing ─▶ time per value, if rustc is available ───┴─ Report ─▶ table · JSON · figure · page
//!         └─ search ─▶ the forms to use, written next to the file
//! ```

mod choose;
mod figure;
mod page;
mod record;
mod report;
mod table;
mod timing;

use crate::commands::refuse;
use crate::kernel::{LIBRARY, files, find};
use crate::status::Status;
use crate::theory_file::{TheoryFile, complain};
use forms::core::expression::Node;
use forms::core::theory::Kernel;
use report::Report;
use std::io::{self, Write};
use std::path::Path;
use timing::Workshop;

/// Request of the command line.
pub(crate) struct Request<'a> {
    /// The file, or the value that selects the library.
    pub(crate) file: &'a str,
    /// Name of the only kernel to measure, if given.
    pub(crate) kernel: Option<&'a str>,
    /// Whether to print one JSON object per line.
    pub(crate) json: bool,
    /// Whether to search better forms and to write them next to the file.
    pub(crate) write: bool,
    /// Folder for the page and its figures.
    pub(crate) pages: Option<&'a str>,
    /// Number of samples of each regime.
    pub(crate) samples: usize,
    /// Whether to measure times.
    pub(crate) times: bool,
}

/// Measures kernels and prints the results.
pub(crate) fn accuracy(request: &Request<'_>, output: &mut dyn Write) -> io::Result<Status> {
    if request.write {
        return choose::choose(request.file, output);
    }
    let files = match files(request.file) {
        Ok(files) => files,
        Err(errors) => {
            complain(&errors);
            return Ok(Status::Error);
        }
    };
    let (chosen, left_out) = match choice(request, &files) {
        Ok(choice) => choice,
        Err(message) => return Ok(refuse(&format!("{message} (in {})", request.file))),
    };
    let workshop = if request.times { Workshop::open() } else { None };
    let mut reports = Vec::new();
    for (file, kernel) in chosen {
        let report = match Report::of(file, kernel, request.samples, workshop.as_ref()) {
            Ok(report) => report,
            Err(errors) => {
                complain(&errors);
                return Ok(Status::Error);
            }
        };
        show(&report, request, output)?;
        reports.push(report);
        // The page is rewritten after each kernel, so that results are kept if the run is
        // interrupted.
        if let Some(folder) = request.pages {
            let file = (request.file != LIBRARY).then(|| Path::new(request.file));
            page::Page { folder: Path::new(folder), file, samples: request.samples, left_out: &left_out }
                .write(&reports)?;
        }
    }
    if !request.json {
        table::legend(workshop.is_some(), output)?;
    }
    Ok(Status::AsStated)
}

/// Kernels with their files.
type Chosen<'a> = Vec<(&'a TheoryFile, &'a Kernel)>;

/// Returns the named kernel, or all kernels. For a page, kernels with integrals are omitted and
/// their names returned, because enclosing integrals takes long.
fn choice<'a>(request: &Request<'_>, files: &'a [TheoryFile]) -> Result<(Chosen<'a>, Vec<&'a str>), String> {
    if let Some(name) = request.kernel {
        return Ok((vec![find(files, name)?], Vec::new()));
    }
    let all = files.iter().flat_map(|file| file.theory.kernels.iter().map(move |kernel| (file, kernel)));
    let (left_out, chosen): (Chosen<'_>, Chosen<'_>) =
        all.partition(|(file, kernel)| request.pages.is_some() && has_integrals(file, kernel));
    Ok((chosen, left_out.into_iter().map(|(_, kernel)| kernel.name.as_str()).collect()))
}

fn has_integrals(file: &TheoryFile, kernel: &Kernel) -> bool {
    let pool = &file.theory.pool;
    let mut parts = pool.reachable(&kernel.outputs).into_iter();
    parts.any(|part| matches!(pool.node(part), Node::Jet { .. }))
}

fn show(report: &Report, request: &Request<'_>, output: &mut dyn Write) -> io::Result<()> {
    if request.json { record::write(report, output) } else { table::write(report, output) }
}
