//! Callgrind: a program is run by valgrind, and every instruction that it executes is counted where the source has it.
//!
//! ```text
//! program ─ valgrind ─▶ fl, fi: the files of lines │ fn: functions │ counts ─▶ instructions by function and file
//! ```
//! Lines that are inlined are counted in the file that they stand in, which debug information tells, and not in that of the function
//! that they have become a part of.

use std::collections::BTreeMap;
use std::io::{Error, Result};
use std::path::Path;
use std::process::{Command, Stdio};

/// Instructions by where they are.
pub(crate) type Counts = BTreeMap<Place, u64>;

/// Where instructions are.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Place {
    /// The function, as the program names it.
    pub(crate) function: String,
    /// The file that the line stands in; unknown without debug information.
    pub(crate) file: String,
    /// The line.
    pub(crate) line: u64,
}

/// Whether valgrind is installed.
pub(crate) fn is_installed() -> bool {
    let version =
        Command::new("valgrind").arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    version.is_ok_and(|status| status.success())
}

/// What a program executes with these arguments, on one thread.
///
/// # Errors
/// Where valgrind fails, or its file cannot be read.
pub(crate) fn counted(program: &Path, arguments: &[&str], variables: &[(&str, &str)]) -> Result<Counts> {
    let file = std::env::temp_dir().join(format!("forms-effects-{}-{:p}", std::process::id(), &arguments));
    let mut out = std::ffi::OsString::from("--callgrind-out-file=");
    out.push(&file);
    let status = Command::new("valgrind")
        .args(["--quiet", "--tool=callgrind", "--compress-strings=no", "--compress-pos=no"])
        .arg(out)
        .arg(program)
        .args(arguments)
        .env("RAYON_NUM_THREADS", "1")
        .envs(variables.iter().copied())
        .stdout(Stdio::null())
        .status()?;
    if !status.success() {
        return Err(Error::other(format!("valgrind ends with {status}")));
    }
    let text = std::fs::read_to_string(&file)?;
    std::fs::remove_file(&file)?;
    Ok(counts(&text))
}

/// The counts of a file of callgrind's. A line behind `calls=` tells what a call takes in all: that is counted where it is.
fn counts(text: &str) -> Counts {
    let mut counts = Counts::new();
    let (mut function, mut file) = (String::new(), String::new());
    let mut is_of_call = false;
    for line in text.lines() {
        if let Some(name) = line.strip_prefix("fn=") {
            function = name.to_owned();
        } else if let Some(name) = ["fl=", "fi=", "fe="].iter().find_map(|key| line.strip_prefix(key)) {
            file = name.to_owned();
        } else if line.starts_with("calls=") {
            is_of_call = true;
        } else if line.starts_with(|first: char| first.is_ascii_digit()) {
            let mut numbers = line.split_whitespace().map(|number| number.parse::<u64>().unwrap_or(0));
            if let (Some(line), Some(count), false) = (numbers.next(), numbers.next(), is_of_call) {
                let place = Place { function: function.clone(), file: file.clone(), line };
                *counts.entry(place).or_default() += count;
            }
            is_of_call = false;
        }
    }
    counts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_counted_in_their_files_and_calls_are_not_counted_twice() {
        let text = "events: Ir\nfl=/a/one.rs\nfn=one\n5 10\nfi=/a/two.rs\n7 3\nfe=/a/one.rs\n6 2\ncfn=two\n\
                    calls=4 1\n6 400\n6 1\n\nfl=/a/two.rs\nfn=two\n1 400\ntotals: 416\n";
        let found = counts(text);
        let of = |file: &str| -> u64 {
            found.iter().filter(|(place, _)| place.file == file).map(|(_, count)| count).sum()
        };
        assert_eq!((of("/a/one.rs"), of("/a/two.rs")), (13, 403));
    }
}
