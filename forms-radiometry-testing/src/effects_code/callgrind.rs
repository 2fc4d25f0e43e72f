//! Callgrind: runs a program under Valgrind, and counts every instruction that it executes at its
//! source location.
//!
//! ```text
//! program ─ valgrind ─▶ fl, fi: files of lines │ fn: functions │ counts │ calls ─▶ Counts
//! ```
//! Inlined lines are counted in the source file that contains them, as recorded in the debug
//! information, and not in the file of the function that they were inlined into.

use std::collections::{BTreeMap, BTreeSet};
use std::io::{Error, Result};
use std::path::Path;
use std::process::{Command, Stdio};

/// Executed instructions and calls of a program.
#[derive(Debug, Default)]
pub struct Counts {
    /// Number of instructions at each source location.
    pub instructions: BTreeMap<Place, u64>,
    /// Locations of the calls of each function.
    pub calls: BTreeMap<String, BTreeSet<Place>>,
}

/// Source location of instructions.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// Symbol of the function. Instances of a generic function have the same name and different
    /// symbols.
    pub function: String,
    /// File that contains the line; unknown without debug information.
    pub file: String,
    /// Line.
    pub line: u64,
}

/// Returns the instructions that a program executes with these arguments, on one thread.
///
/// # Errors
/// If Valgrind fails, or its file cannot be read.
pub fn counted(program: &Path, arguments: &[&str], variables: &[(&str, &str)]) -> Result<Counts> {
    let file = std::env::temp_dir().join(format!("forms-effects-{}-{:p}", std::process::id(), &arguments));
    let mut out = std::ffi::OsString::from("--callgrind-out-file=");
    out.push(&file);
    let status = Command::new("valgrind")
        .args(["--quiet", "--tool=callgrind", "--compress-strings=no", "--compress-pos=no", "--demangle=no"])
        .arg(out)
        .arg(program)
        .args(arguments)
        .env("RAYON_NUM_THREADS", "1")
        .envs(variables.iter().copied())
        .stdout(Stdio::null())
        .status()?;
    if !status.success() {
        return Err(Error::other(format!("valgrind failed: {status}")));
    }
    let text = std::fs::read_to_string(&file)?;
    std::fs::remove_file(&file)?;
    Ok(counts(&text))
}

/// Reads the counts of a Callgrind file. The line after `calls=` holds the location and the
/// inclusive cost of a call; that cost is counted in the callee.
fn counts(text: &str) -> Counts {
    let mut counts = Counts::default();
    let (mut function, mut file, mut callee) = (String::new(), String::new(), String::new());
    let mut is_of_call = false;
    for line in text.lines() {
        if let Some(name) = line.strip_prefix("fn=") {
            function = name.to_owned();
        } else if let Some(name) = ["fl=", "fi=", "fe="].iter().find_map(|key| line.strip_prefix(key)) {
            file = name.to_owned();
        } else if let Some(name) = line.strip_prefix("cfn=") {
            callee = name.to_owned();
        } else if line.starts_with("calls=") {
            is_of_call = true;
        } else if line.starts_with(|first: char| first.is_ascii_digit()) {
            let mut numbers = line.split_whitespace().map(|number| number.parse::<u64>().unwrap_or(0));
            if let (Some(line), Some(count)) = (numbers.next(), numbers.next()) {
                let place = Place { function: function.clone(), file: file.clone(), line };
                if is_of_call {
                    counts.calls.entry(callee.clone()).or_default().insert(place);
                } else {
                    *counts.instructions.entry(place).or_default() += count;
                }
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
            found.instructions.iter().filter(|(place, _)| place.file == file).map(|(_, count)| count).sum()
        };
        assert_eq!((of("/a/one.rs"), of("/a/two.rs")), (13, 403));
        let place = Place { function: "one".to_owned(), file: "/a/one.rs".to_owned(), line: 6 };
        assert_eq!(found.calls, BTreeMap::from([("two".to_owned(), BTreeSet::from([place]))]));
    }
}
