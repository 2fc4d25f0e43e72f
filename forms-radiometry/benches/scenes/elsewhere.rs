//! The same works by other programs: the scripts of a bench's folder `elsewhere`, run one after the other, and what they print.

use std::io::{self, BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};

/// A script, and the modules that have to be installed for it.
pub(crate) type Script = (&'static str, &'static [&'static str]);

/// A line that a script printed.
pub(crate) struct Line {
    /// Which program, in which version or with which options.
    pub(crate) program: String,
    /// What it did.
    pub(crate) work: String,
    /// How long it took to the error; not a number where that was not measured.
    pub(crate) seconds: f64,
    pub(crate) error: f64,
    pub(crate) remark: String,
}

/// What all scripts of a bench print whose modules are installed. Of each other one it is told what is missing. `folder` holds what
/// they read.
pub(crate) fn run_all(bench: &str, scripts: &[Script], folder: &Path) -> io::Result<Vec<Line>> {
    let of_scripts = Path::new(env!("CARGO_MANIFEST_DIR")).join("benches").join(bench).join("elsewhere");
    let mut lines = Vec::new();
    for (script, modules) in scripts {
        let missing: Vec<&str> = modules.iter().copied().filter(|module| !is_installed(module)).collect();
        if !missing.is_empty() {
            println!("{script} is left out: `pip install {}` installs what it needs", missing.join(" "));
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
    // what is there by now is told at once: a script may take long
    for line in running.stdout.take().into_iter().flat_map(|output| BufReader::new(output).lines()) {
        let line = line?;
        println!("{line}");
        lines.extend(Line::read(&line));
    }
    let status = running.wait()?;
    if !status.success() {
        println!("{} ended with {status}: what it had not printed by then is left out", script.display());
    }
    Ok(lines)
}

impl Line {
    /// The fields are apart by commas; those of the program and the work may stand in quotes, and the last one may hold any.
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

/// A name at the beginning of a line, and what follows after it.
fn name(line: &str) -> Option<(&str, &str)> {
    match line.strip_prefix('"') {
        Some(quoted) => quoted.split_once("\","),
        None => line.split_once(','),
    }
}
