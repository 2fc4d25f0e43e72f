//! `forms serve`: a local web page, whose requests are answered by worker processes of this
//! program.

use crate::commands::refuse;
use crate::status::Status;
use crate::theory_file;
use forms::core::syntax::words::{FUNCTIONS, INSIDE, ITEMS};
use forms_serve::{Opened, Settings, Words, Worker};
use std::io::{self, Write};
use std::net::IpAddr;
use std::path::Path;
use std::time::Duration;

/// Memory limit of one worker process, including its stack of [`crate::STACK_BYTES`].
const MEBIBYTES: u64 = 2048;

/// Serves the page until the user stops it.
pub(crate) fn serve(
    file: Option<&str>,
    (bind, port): (IpAddr, u16),
    time_limit: Duration,
    output: &mut dyn Write,
) -> io::Result<Status> {
    let opened = match file.map(|path| theory_file::text(path).map(|text| (path, text))) {
        None => None,
        Some(Ok((path, text))) => {
            let name = Path::new(path).file_name().unwrap_or_default().to_string_lossy().into_owned();
            Some(Opened { name, text })
        }
        Some(Err(message)) => return Ok(refuse(&format!("{message}\n --> {}", file.unwrap_or_default()))),
    };
    // The limit of processor time exceeds the time limit on the clock by at least a second: the
    // clock ends computing processes, this limit ends processes for which no client waits any more.
    let seconds = time_limit.as_secs().saturating_add(2).to_string();
    let worker = Worker {
        program: std::env::current_exe()?,
        arguments: ["work", "--seconds", &seconds, "--mebibytes", &MEBIBYTES.to_string()]
            .map(str::to_owned)
            .to_vec(),
    };
    let words = Words { items: ITEMS, inside: INSIDE, functions: FUNCTIONS };
    let settings = Settings { bind, port, time_limit, worker, opened, words };
    let served = forms_serve::serve(settings, |address| {
        writeln!(output, "http://{address}/ serves the page; press Ctrl-C to stop")?;
        output.flush()
    });
    match served {
        Ok(()) => Ok(Status::AsStated),
        Err(error) => Ok(refuse(&error.to_string())),
    }
}
