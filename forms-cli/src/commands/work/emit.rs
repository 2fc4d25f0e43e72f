//! Task `emit`: one kernel of a text, as source code in each language.

use super::Refusal;
use super::record::{read, tell};
use crate::arguments::Tier;
use crate::commands::emit::{heading, sources};
use crate::json::write_record;
use crate::kernel::find;
use forms::core::emission;
use forms::core::emission::{Source, Target};
use serde::{Deserialize, Serialize};
use std::io::{self, Write};

/// Target languages of the answer.
const TARGETS: [Target; 3] = [Target::Rust, Target::C, Target::Wgsl];

#[derive(Deserialize)]
pub(super) struct Request {
    text: String,
    /// Name of a kernel.
    kernel: String,
}

#[derive(Serialize)]
struct Sources {
    code: Vec<Code>,
}

#[derive(Serialize)]
struct Code {
    target: &'static str,
    precision: &'static str,
    /// Source code, if there is any.
    text: Option<String>,
    /// Reason why there is no source code.
    reason: Option<String>,
}

/// Writes the source code in each language, or the errors of the kernel.
pub(super) fn emit(request: &Request, output: &mut dyn Write) -> io::Result<()> {
    let Some((_, file)) = read(&request.text, output)? else { return Ok(()) };
    let files = [file];
    let (file, kernel) = match find(&files, &request.kernel) {
        Ok(found) => found,
        Err(refusal) => return write_record(output, &Refusal { refusal }),
    };
    match sources(file, kernel, Tier::Stable) {
        Ok(sources) => {
            write_record(output, &Sources { code: TARGETS.map(|target| code(&sources, target)).into() })
        }
        Err(errors) => tell(&errors, output),
    }
}

fn code(sources: &[Source], target: Target) -> Code {
    let precision = target.usual_precision();
    let written = emission::emit(sources, target, precision);
    let (text, reason) = match written {
        Ok(text) => (Some(heading("the editor") + "\n" + &text), None),
        Err(error) => (None, Some(error.to_string())),
    };
    Code { target: target.name(), precision: precision.name(), text, reason }
}
