//! Instruction counts of calls, by Valgrind's Callgrind: this program runs itself under it.
//!
//! Callgrind counts only within [`call`], and writes its counts each time `call` returns. It
//! emulates a processor without AVX-512, so batches choose AVX2.

use std::ffi::OsStr;
use std::io::{Error, ErrorKind, Result};
use std::path::Path;
use std::process::Command;

/// Runs the work in a function that Callgrind finds by its name.
#[inline(never)]
pub(crate) fn call(work: &mut dyn FnMut()) {
    work();
}

/// Returns the instructions of each `call` of this program when it is started with this argument.
///
/// # Errors
/// If a directory for Callgrind's files cannot be created or read, or Valgrind fails.
pub(crate) fn counted(argument: &str) -> Result<Vec<u64>> {
    let folder = std::env::temp_dir().join(format!("forms-instructions-{}", std::process::id()));
    std::fs::create_dir_all(&folder)?;
    let counts = run(argument, &folder).and_then(|()| totals(&folder));
    std::fs::remove_dir_all(&folder)?;
    counts
}

fn run(argument: &str, folder: &Path) -> Result<()> {
    let mut out = OsStr::new("--callgrind-out-file=").to_owned();
    out.push(folder.join("counts"));
    let name = "*::callgrind::call";
    let status = Command::new("valgrind")
        .args(["--quiet", "--tool=callgrind", "--combine-dumps=no"])
        .args([format!("--toggle-collect={name}"), format!("--dump-after={name}")])
        .arg(out)
        .arg(std::env::current_exe()?)
        .arg(argument)
        .status()?;
    if status.success() { Ok(()) } else { Err(Error::other(format!("valgrind failed: {status}"))) }
}

/// Returns the totals in Callgrind's files, which are numbered from 1 in the order of the calls.
fn totals(folder: &Path) -> Result<Vec<u64>> {
    let numbered =
        (1..).map(|number| folder.join(format!("counts.{number}"))).take_while(|path| path.exists());
    numbered.map(|path| total(&std::fs::read_to_string(path)?)).collect()
}

/// Returns the number of the line `totals: 1234`.
fn total(file: &str) -> Result<u64> {
    let line = file.lines().find_map(|line| line.strip_prefix("totals: "));
    line.and_then(|number| number.trim().parse().ok())
        .ok_or_else(|| Error::new(ErrorKind::InvalidData, "a Callgrind file has no line `totals:`"))
}
