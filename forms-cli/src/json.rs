//! The records of `--json`, one object per line.

use crate::theory_file::FileError;
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::io::{self, Write};

/// Result for one statement.
#[derive(serde::Serialize)]
pub(crate) struct StatementRecord<'a> {
    pub(crate) file: &'a str,
    pub(crate) name: &'a str,
    pub(crate) kind: &'a str,
    pub(crate) verdict: &'a str,
    pub(crate) ok: bool,
    pub(crate) conditions: &'a [String],
    pub(crate) witness: Option<Point<'a>>,
    pub(crate) micros: u64,
}

/// Names with exact values, serialised as an object in their order.
pub(crate) struct Point<'a>(pub(crate) &'a [(String, String)]);

impl Serialize for Point<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (name, value) in self.0 {
            map.serialize_entry(name, value)?;
        }
        map.end()
    }
}

/// Error in a file.
#[derive(serde::Serialize)]
struct ErrorRecord<'a> {
    file: &'a str,
    line: usize,
    column: usize,
    error: &'a str,
}

/// Writes a record as one line.
pub(crate) fn write_record(output: &mut dyn Write, record: &impl Serialize) -> io::Result<()> {
    serde_json::to_writer(&mut *output, record)?;
    writeln!(output)
}

/// Writes an error.
pub(crate) fn write_error(output: &mut dyn Write, error: &FileError) -> io::Result<()> {
    let FileError { file, line, column, message, .. } = error;
    write_record(output, &ErrorRecord { file, line: *line, column: *column, error: message })
}
