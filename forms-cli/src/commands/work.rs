//! Worker of the page of `serve`: one request from standard input becomes an answer of JSON lines.
//!
//! ```text
//! request ─ bounds ─ task ─┬─ check  ─▶ diagnostics, statements, kernels, then the verdicts one by one
//!                          ├─ derive ─▶ steps
//!                          ├─ emit   ─▶ code
//!                          └─ plot   ─▶ drawing
//! ```
//! Each line is an object; its lists are appended to those of the lines before it. If the process
//! is stopped, the lines written so far are part of the answer, so each line is written as soon as
//! it is known.

mod bounds;
mod check;
mod derive;
mod emit;
mod plot;
mod record;

use crate::arguments::Task;
use crate::json::write_record;
use crate::status::Status;
use record::Place;
use serde::de::DeserializeOwned;
use std::io::{self, Read, Write};

/// Limit of the length of a request in bytes; the server of the page rejects longer ones.
const LONGEST_REQUEST: u64 = 4 << 20;

/// Runs one task within these limits: seconds of processor time and mebibytes of memory.
pub(crate) fn work(
    task: Task,
    (seconds, mebibytes): (u64, u64),
    output: &mut dyn Write,
) -> io::Result<Status> {
    bounds::bound(seconds, mebibytes)?;
    let mut request = Vec::new();
    io::stdin().lock().take(LONGEST_REQUEST).read_to_end(&mut request)?;
    match task {
        Task::Check => with(&request, output, check::check),
        Task::Derive => with(&request, output, derive::derive),
        Task::Emit => with(&request, output, emit::emit),
        Task::Plot => with(&request, output, plot::plot),
    }
}

/// Parses a request in the format of the task, and runs the task.
fn with<R: DeserializeOwned>(
    request: &[u8],
    output: &mut dyn Write,
    task: fn(&R, &mut dyn Write) -> io::Result<()>,
) -> io::Result<Status> {
    match serde_json::from_slice(request) {
        Ok(request) => task(&request, output)?,
        Err(error) => {
            write_record(output, &Refusal { refusal: format!("the request cannot be read: {error}") })?;
        }
    }
    Ok(Status::AsStated)
}

/// Reason why a request is not answered.
#[derive(serde::Serialize)]
struct Refusal {
    refusal: String,
}

/// Errors of the text in a request.
#[derive(serde::Serialize)]
struct Diagnostics {
    diagnostics: Vec<Told>,
}

/// Error with its place.
#[derive(serde::Serialize)]
struct Told {
    #[serde(flatten)]
    place: Place,
    message: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    help: Option<String>,
}
