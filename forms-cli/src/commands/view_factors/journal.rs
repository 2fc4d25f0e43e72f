//! Journal: complete rows in a file, from which the same work resumes.
//!
//! ```text
//! first line: the identity of the work       each further line: a complete row, appended and flushed
//! ```
//! A line that was cut off when the program was killed is dropped, and its row is computed again.
//! Every line has a checksum.

use crate::arguments::ViewFactorArguments;
use crate::files::{Lock, reason};
use forms_radiometry::scene::{Scene, Sources};
use forms_radiometry::simulation::ErrorKind;
use forms_radiometry::{Row, ViewFactor};
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::fs::{File, OpenOptions};
use std::io::{BufRead, BufReader, ErrorKind as IoKind, Seek, SeekFrom, Write};
use std::path::Path;

/// A file of complete rows.
pub(super) struct Journal {
    file: File,
    path: String,
    rows: HashMap<usize, Row>,
    _lock: Lock,
}

/// A row in the file: factors above zero, or with an error, and the error of all others.
#[derive(Serialize, Deserialize)]
struct Line {
    row: usize,
    kind: ErrorKind,
    /// Number of surfaces.
    count: usize,
    /// Index, value and error of each factor that differs from the others.
    factors: Vec<(usize, f64, f64)>,
    /// Error of the factors of zero that are not listed.
    rest: f64,
}

/// Returns what has to be the same for work to resume.
pub(super) fn identity(sources: &Sources, scene: &Scene, arguments: &ViewFactorArguments) -> String {
    let digest: String = sources.digest().iter().map(|byte| format!("{byte:02x}")).collect();
    let (tolerance, seed) = (scene.solve.tolerance, scene.solve.seed);
    let version = env!("CARGO_PKG_VERSION");
    format!(
        "forms view-factors {version}: scene {digest}, tolerance {tolerance:e}, seed {seed}, by {:?}",
        arguments.by
    )
}

impl Journal {
    /// Opens the journal of this work, with the rows in it if the file exists. The error is a
    /// message why it cannot be used.
    pub(super) fn open(path: &str, identity: &str, count: usize) -> Result<Self, String> {
        let failed =
            |error: &std::io::Error| format!("the checkpoint `{path}` cannot be used: {}", reason(error));
        let lock = Lock::of(Path::new(path)).map_err(|error| failed(&error))?;
        let lock = lock.ok_or_else(|| {
            format!(
                "the checkpoint `{path}` is in use by another run: wait for its end, or name another file"
            )
        })?;
        let mut file = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path);
        let file = file.as_mut().map_err(|error| failed(error))?;
        let mut file = file.try_clone().map_err(|error| failed(&error))?;
        let (rows, end) = read(&file, path, identity, count)?;
        file.set_len(end).and_then(|()| file.seek(SeekFrom::Start(end))).map_err(|error| failed(&error))?;
        let mut journal = Self { file, path: path.to_owned(), rows, _lock: lock };
        if end == 0 {
            journal.append(identity)?;
        }
        Ok(journal)
    }

    /// Returns a row that was found before.
    pub(super) fn take(&mut self, surface: usize) -> Option<Row> {
        self.rows.remove(&surface)
    }

    /// Appends a row. The error is a message.
    pub(super) fn keep(&mut self, surface: usize, row: &Row) -> Result<(), String> {
        let rest = row.factors.iter().find(|factor| factor.value == 0.0).map_or(0.0, |factor| factor.error);
        let is_listed = |factor: &ViewFactor| factor.value != 0.0 || factor.error != rest;
        let listed = row.factors.iter().enumerate().filter(|(_, factor)| is_listed(factor));
        let factors = listed.map(|(index, factor)| (index, factor.value, factor.error)).collect();
        let line = Line { row: surface, kind: row.kind, count: row.factors.len(), factors, rest };
        let text = serde_json::to_string(&line).map_err(|error| error.to_string())?;
        self.append(&text)
    }

    fn append(&mut self, text: &str) -> Result<(), String> {
        let line = format!("{} {text}\n", checksum(text));
        let written = self.file.write_all(line.as_bytes()).and_then(|()| self.file.flush());
        written
            .map_err(|error| format!("the checkpoint `{}` cannot be written: {}", self.path, reason(&error)))
    }
}

/// Returns the rows in a file, and the end of the last complete line.
fn read(file: &File, path: &str, identity: &str, count: usize) -> Result<(HashMap<usize, Row>, u64), String> {
    let (mut rows, mut end) = (HashMap::new(), 0);
    let mut reader = BufReader::new(file);
    let mut bytes = Vec::new();
    loop {
        bytes.clear();
        let length = match reader.read_until(b'\n', &mut bytes) {
            Ok(length) => length,
            Err(error) if error.kind() == IoKind::Interrupted => continue,
            Err(error) => return Err(format!("the checkpoint `{path}` cannot be read: {}", reason(&error))),
        };
        let text =
            std::str::from_utf8(&bytes).ok().and_then(|line| line.strip_suffix('\n')).and_then(checked);
        match text {
            Some(text) if end == 0 && text != identity => {
                return Err(format!(
                    "the checkpoint `{path}` belongs to other work ({text}): remove it, or name another file"
                ));
            }
            Some(text) if end > 0 => match row(text, count) {
                Some((surface, row)) => _ = rows.insert(surface, row),
                None => return Ok((rows, end)),
            },
            Some(_) => {}
            None if end == 0 && length > 0 && !is_beginning(&bytes, identity) => {
                return Err(format!(
                    "`{path}` is not a checkpoint of view factors: remove it, or name another file"
                ));
            }
            // the end, or a line that was cut off or damaged
            None => return Ok((rows, end)),
        }
        end += length as u64;
    }
}

/// Whether bytes are the beginning of the first line, cut off.
fn is_beginning(bytes: &[u8], identity: &str) -> bool {
    format!("{} {identity}\n", checksum(identity)).as_bytes().starts_with(bytes)
}

fn row(text: &str, count: usize) -> Option<(usize, Row)> {
    let line: Line = serde_json::from_str(text).ok()?;
    let mut factors = vec![ViewFactor { value: 0.0, error: line.rest }; count];
    for &(index, value, error) in &line.factors {
        *factors.get_mut(index)? = ViewFactor { value, error };
    }
    (line.row < count && line.count == count).then_some((line.row, Row { factors, kind: line.kind }))
}

/// Returns the text of a line whose checksum is right.
fn checked(line: &str) -> Option<&str> {
    let (sum, text) = line.split_once(' ')?;
    (sum == checksum(text)).then_some(text)
}

/// Returns the FNV-1a hash of a text, which differs for any change of a byte.
fn checksum(text: &str) -> String {
    let step = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
    format!("{:016x}", text.as_bytes().iter().fold(0xcbf2_9ce4_8422_2325, step))
}
