//! The program `forms`: files of the language go in, verdicts, notation, numbers, source and
//! pictures come out.
//!
//! ```text
//! arguments ─▶ commands ─┬─ prove    ─▶ verdicts       (decisions, theory_file, verdict_line, json)
//!                        ├─ check    ─▶ certificates   (certificate)
//!                        ├─ show     ─▶ notation
//!                        ├─ derive   ─▶ steps
//!                        ├─ eval     ─▶ numbers        (decimal, kernel)
//!                        ├─ emit     ─▶ source code
//!                        ├─ kernels  ─▶ the library
//!                        ├─ simulate ─▶ the plan, numbers and pictures of a scene
//!                        ├─ merge    ─▶ the same, from parts that several machines computed
//!                        ├─ view-factors ─▶ the matrix of a scene
//!                        ├─ book     ─▶ the book as HTML pages, or for mdBook
//!                        ├─ man, completions ─▶ manual pages and shell completions
//!                        ├─ serve    ─▶ a page on localhost, answered by `work`
//!                        └─ tour     ─▶ a demonstration of all of it
//! ```
//! Answers go to standard output, errors to standard error (with `--json` to standard output). All
//! results are computed by the libraries.

mod arguments;
mod certificate;
mod commands;
mod decimal;
mod decisions;
mod files;
#[cfg(test)]
mod fuzz;
mod json;
mod kernel;
mod layout;
mod palette;
mod status;
mod streams;
mod theory_file;
mod verdict_line;

use clap::Parser;
use status::Status;
use std::io::Write;
use std::process::ExitCode;
use streams::{Output, tell};

/// Stack size of every working thread: recursion walks trees as deep as the parser admits.
const STACK_BYTES: usize = 256 << 20;

fn main() -> ExitCode {
    let arguments = arguments::Arguments::parse();
    let work = std::thread::Builder::new().stack_size(STACK_BYTES).spawn(move || run(&arguments));
    match work.map(std::thread::JoinHandle::join) {
        Ok(Ok(status)) => status.into(),
        Ok(Err(_)) => Status::Error.into(),
        Err(error) => {
            tell!("error: cannot start a thread: {error}");
            Status::Error.into()
        }
    }
}

/// Runs the command. The exit status is that of the work, even if the output is not read.
fn run(arguments: &arguments::Arguments) -> Status {
    let mut output = Output::new();
    let result = commands::run(arguments, &mut output).and_then(|status| output.flush().map(|()| status));
    match result {
        Ok(status) => status,
        Err(error) => {
            tell!("error: cannot write the output: {}", files::reason(&error));
            Status::Error
        }
    }
}
