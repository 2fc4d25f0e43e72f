//! `forms accuracy`: what each precision and each form of a kernel costs and buys.
//!
//! ```text
//! kernel ─┬─ sheet ──▶ errors of every variant in every regime ─┐
//!         ├─ timing ─▶ time per value, where there is a rustc ──┴─ Report ─▶ table · JSON · figure · page
//!         └─ search ─▶ the forms to use, written beside the file
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
use forms::core::resolve::Kernel;
use report::Report;
use std::io::{self, Write};
use std::path::Path;
use timing::Workshop;

/// What is asked for.
pub(crate) struct Request<'a> {
    /// The file, or that of the library.
    pub(crate) file: &'a str,
    /// Only this kernel.
    pub(crate) kernel: Option<&'a str>,
    /// One JSON object a line.
    pub(crate) json: bool,
    /// The forms to use are looked for and written beside the file.
    pub(crate) write: bool,
    /// Where the page and its figures are written.
    pub(crate) pages: Option<&'a str>,
    /// Samples of each regime.
    pub(crate) samples: usize,
    /// Whether times are measured.
    pub(crate) times: bool,
}

/// Measures, and shows what was measured.
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
    let chosen: Vec<(&TheoryFile, &Kernel)> = match request.kernel.map(|name| find(&files, name)) {
        Some(Ok(found)) => vec![found],
        Some(Err(message)) => return Ok(refuse(&format!("{message} (in {})", request.file))),
        None => files.iter().flat_map(|file| file.theory.kernels.iter().map(move |k| (file, k))).collect(),
    };
    let workshop = if request.times { Workshop::open() } else { None };
    let mut reports = Vec::new();
    for (file, kernel) in chosen {
        match Report::of(file, kernel, request.samples, workshop.as_ref()) {
            Ok(report) => {
                show(&report, request, output)?;
                reports.push(report);
            }
            Err(errors) => {
                complain(&errors);
                return Ok(Status::Error);
            }
        }
    }
    if !request.json {
        table::legend(workshop.is_some(), output)?;
    }
    if let Some(folder) = request.pages {
        let file = (request.file != LIBRARY).then(|| Path::new(request.file));
        page::write(Path::new(folder), file, request.samples, &reports)?;
    }
    Ok(Status::AsStated)
}

fn show(report: &Report, request: &Request<'_>, output: &mut dyn Write) -> io::Result<()> {
    if request.json { record::write(report, output) } else { table::write(report, output) }
}
