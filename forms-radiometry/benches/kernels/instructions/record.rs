//! The committed file of counts: the compiler that they were counted with, then one line
//! `kernel,instructions` each.

use std::collections::BTreeMap;
use std::io::{Error, ErrorKind, Result};
use std::path::PathBuf;

/// Growth of a count that is still accepted, relative to it.
const GROWTH: f64 = 0.02;

/// Counts by kernel, and the compiler that generated the machine code.
#[derive(Debug, PartialEq)]
pub(crate) struct Record {
    pub(crate) compiler: String,
    pub(crate) counts: BTreeMap<String, u64>,
}

/// Returns the path of the record.
pub(crate) fn path() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("benches/kernels/instructions/counts.csv")
}

impl Record {
    /// Reads a record.
    ///
    /// # Errors
    /// If a line does not have this form.
    pub(crate) fn read(text: &str) -> Result<Self> {
        let unreadable = || {
            Error::new(ErrorKind::InvalidData, "counts are a line `# compiler`, then `kernel,instructions`")
        };
        let (first, rest) = text.split_once('\n').ok_or_else(unreadable)?;
        let compiler = first.strip_prefix("# ").ok_or_else(unreadable)?.to_string();
        let count = |line: &str| {
            let (kernel, instructions) = line.split_once(',')?;
            Some((kernel.to_string(), instructions.parse().ok()?))
        };
        let counts = rest.lines().map(|line| count(line).ok_or_else(unreadable)).collect::<Result<_>>()?;
        Ok(Self { compiler, counts })
    }

    pub(crate) fn text(&self) -> String {
        let lines = self.counts.iter().map(|(kernel, instructions)| format!("{kernel},{instructions}\n"));
        format!("# {}\n{}", self.compiler, lines.collect::<String>())
    }

    /// Returns complaints about these counts compared with the record: a line for each kernel that
    /// grew, is not in the record, or is in the record and was not counted.
    pub(crate) fn complaints(&self, counted: &BTreeMap<String, u64>) -> Vec<String> {
        let grown = self.counts.iter().filter_map(|(kernel, &before)| match counted.get(kernel) {
            None => Some(format!("{kernel} is in the record but was not counted")),
            Some(&now) if now as f64 > before as f64 * (1.0 + GROWTH) => {
                let percent = (now as f64 / before as f64 - 1.0) * 100.0;
                Some(format!("{kernel} grew by {percent:.1} %: {before} instructions, now {now}"))
            }
            Some(_) => None,
        });
        let new = counted.keys().filter(|kernel| !self.counts.contains_key(*kernel));
        grown.chain(new.map(|kernel| format!("{kernel} is not in the record"))).collect()
    }
}
