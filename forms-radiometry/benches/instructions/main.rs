//! How many instructions the batch of each kernel takes with AVX2, so that it does not grow unseen.
//!
//! ```text
//! kernels ── callgrind ──▶ counts ─┬─▶ compared with counts.csv: a kernel that grew by more than 2 % fails
//!                                  └─▶ counts.csv, written anew
//! ```
//! `cargo bench --bench instructions` compares; with `-- --write` it writes the file. Without valgrind it says that nothing
//! was counted. Counts belong to a compiler: with another than the record’s they are shown, and not compared.

mod callgrind;
mod record;
mod work;

use record::Record;
use std::collections::BTreeMap;
use std::io::Result;
use std::process::{Command, ExitCode};

/// What this program is started with to be counted.
const COUNTED: &str = "--counted";

fn main() -> Result<ExitCode> {
    let has = |option: &str| std::env::args().any(|argument| argument == option);
    if has(COUNTED) {
        work::all().iter().for_each(work::Work::call);
        return Ok(ExitCode::SUCCESS);
    }
    if !callgrind::is_installed() {
        println!("valgrind is not installed: no instructions were counted, so none were checked");
        return Ok(ExitCode::SUCCESS);
    }
    let counts = callgrind::counted(COUNTED)?;
    let counts: BTreeMap<String, u64> = work::all().iter().map(work::Work::name).zip(counts).collect();
    if has("--write") {
        std::fs::write(record::path(), Record { compiler: compiler(), counts }.text())?;
        return Ok(ExitCode::SUCCESS);
    }
    compare(&Record::read(&std::fs::read_to_string(record::path())?)?, &counts)
}

fn compare(record: &Record, counts: &BTreeMap<String, u64>) -> Result<ExitCode> {
    let compiler = compiler();
    if record.compiler != compiler {
        print!("{}", Record { compiler, counts: counts.clone() }.text());
        println!("the record is of {}: not compared", record.compiler);
        return Ok(ExitCode::SUCCESS);
    }
    let complaints = record.complaints(counts);
    complaints.iter().for_each(|complaint| println!("{complaint}"));
    println!("{} kernels counted, {} as recorded", counts.len(), counts.len().saturating_sub(complaints.len()));
    if !complaints.is_empty() {
        println!("if that is meant: cargo bench --bench instructions -- --write");
        return Ok(ExitCode::FAILURE);
    }
    Ok(ExitCode::SUCCESS)
}

/// The compiler of this workspace, by its own words.
fn compiler() -> String {
    let output = Command::new("rustc").arg("--version").output();
    output.map_or_else(|_| "unknown".to_string(), |output| String::from_utf8_lossy(&output.stdout).trim().to_string())
}
