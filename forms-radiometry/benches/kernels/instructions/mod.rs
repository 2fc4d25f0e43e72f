//! Instruction counts of the batch of each kernel with AVX2, so that an increase does not go
//! unnoticed.
//!
//! ```text
//! work ─ callgrind ─▶ counts ─┬─▶ compared with counts.csv: fails if a kernel grew by over 2 %
//!                             └─▶ counts.csv, rewritten
//! ```
//! Without Valgrind it reports that nothing was counted. Counts are valid for one compiler: if the
//! record is from another compiler, they are shown but not compared.

mod callgrind;
mod record;
mod work;

use record::Record;
use std::collections::BTreeMap;
use std::io::{Error, Result};
use std::process::{Command, ExitCode};

/// Argument with which this program starts itself under Valgrind.
const COUNTED: &str = "--counted";

/// Runs the counted work if this process is the one under Valgrind, and returns whether it is.
pub(crate) fn is_counted() -> bool {
    let counted = std::env::args().any(|argument| argument == COUNTED);
    if counted {
        work::all().iter().for_each(work::Work::run);
    }
    counted
}

/// Counts instructions, and compares them with the record or rewrites it.
///
/// # Errors
/// If Valgrind fails, or the record cannot be read or written.
pub(crate) fn check(writes: bool) -> Result<ExitCode> {
    if !forms_testing::is_installed("valgrind") {
        println!("valgrind is not installed: no instructions were counted, so none were checked");
        return Ok(ExitCode::SUCCESS);
    }
    let counts = callgrind::counted(COUNTED)?;
    let works = work::all();
    if counts.len() != works.len() {
        return Err(Error::other(format!(
            "valgrind counted {} calls, expected {}",
            counts.len(),
            works.len()
        )));
    }
    let counts: BTreeMap<String, u64> = works.into_iter().map(|work| work.name).zip(counts).collect();
    if writes {
        std::fs::write(record::path(), Record { compiler: compiler(), counts }.text())?;
        return Ok(ExitCode::SUCCESS);
    }
    Ok(compare(&Record::read(&std::fs::read_to_string(record::path())?)?, counts))
}

fn compare(record: &Record, counts: BTreeMap<String, u64>) -> ExitCode {
    let compiler = compiler();
    if record.compiler != compiler {
        println!(
            "the record was made with {}: counts of {compiler} are not compared with it",
            record.compiler
        );
        print!("{}", Record { compiler, counts }.text());
        return ExitCode::SUCCESS;
    }
    let complaints = record.complaints(&counts);
    complaints.iter().for_each(|complaint| println!("{complaint}"));
    println!("instructions of {} functions counted, {} complaints", counts.len(), complaints.len());
    if complaints.is_empty() {
        return ExitCode::SUCCESS;
    }
    println!("to accept the new counts, run: cargo bench --bench kernels -- --instructions --write");
    ExitCode::FAILURE
}

/// Returns the compiler's own name and version.
fn compiler() -> String {
    let output = Command::new("rustc").arg("--version").output();
    output.map_or_else(
        |_| "an unknown compiler".to_string(),
        |output| String::from_utf8_lossy(&output.stdout).trim().to_string(),
    )
}
