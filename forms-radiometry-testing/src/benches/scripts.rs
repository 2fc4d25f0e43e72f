//! The same works by other programs: the scripts of a bench's directory `elsewhere` are run one
//! after the other, and their output is read.

use std::io::{self, BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};

/// Script, and the modules that must be installed for it.
pub type Script = (&'static str, &'static [&'static str]);

/// Line that a script printed.
pub struct Line {
    /// Program, with its version or its options.
    pub program: String,
    /// Work that it did.
    pub work: String,
    /// Time to the error; NaN if it was not measured.
    pub seconds: f64,
    /// Error of its result.
    pub error: f64,
    /// Remark of the script.
    pub remark: String,
}

/// Runs all scripts of a bench whose modules are installed, and returns the lines they print. For
/// every other script the missing modules are reported. `folder` holds the input of the scripts.
pub fn run_all(bench: &str, scripts: &[Script], folder: &Path) -> io::Result<Vec<Line>> {
    let of_scripts = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../forms-radiometry/benches")
        .join(bench)
        .join("elsewhere");
    let mut lines = Vec::new();
    for (script, modules) in scripts {
        let missing: Vec<&str> = modules.iter().copied().filter(|module| !is_installed(module)).collect();
        if !missing.is_empty() {
            println!(
                "{script} is skipped: install its missing modules with `pip install {}`",
                missing.join(" ")
            );
            continue;
        }
        lines.extend(run(&of_scripts.join(script), folder)?);
    }
    Ok(lines)
}

fn is_installed(module: &str) -> bool {
    let found =
        Command::new("python3").args(["-c", &format!("import {module}")]).stderr(Stdio::null()).status();
    found.is_ok_and(|status| status.success())
}

fn run(script: &Path, folder: &Path) -> io::Result<Vec<Line>> {
    let mut python = Command::new("python3");
    let mut running = python.arg("-B").arg(script).arg(folder).stdout(Stdio::piped()).spawn()?;
    let mut lines = Vec::new();
    // each line is printed immediately: a script can take long
    for line in running.stdout.take().into_iter().flat_map(|output| BufReader::new(output).lines()) {
        let line = line?;
        println!("{line}");
        lines.extend(Line::read(&line));
    }
    let status = running.wait()?;
    if !status.success() {
        println!("{} failed with {status}: its remaining results are missing", script.display());
    }
    Ok(lines)
}

impl Line {
    /// Parses a line. The fields are separated by commas; the program and the work can be quoted,
    /// and the last field can contain commas.
    fn read(line: &str) -> Option<Self> {
        let (program, rest) = name(line)?;
        let (work, rest) = name(rest)?;
        let (seconds, rest) = rest.split_once(',')?;
        let (error, remark) = rest.split_once(',')?;
        Some(Self {
            program: program.to_string(),
            work: work.to_string(),
            seconds: seconds.parse().ok()?,
            error: error.parse().ok()?,
            remark: remark.to_string(),
        })
    }
}

/// Splits a line after its first name.
fn name(line: &str) -> Option<(&str, &str)> {
    match line.strip_prefix('"') {
        Some(quoted) => quoted.split_once("\","),
        None => line.split_once(','),
    }
}
