//! Errors in scene files: a place in a text becomes a message that quotes the line.

use super::place::{Place, Source};
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// One thing that is wrong with a scene file, or with a file that it names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SceneError {
    /// The file, as it was named by the caller; empty for what did not come from a file.
    pub file: String,
    /// The line, counted from one; zero where the whole file is meant.
    pub line: usize,
    /// The column in characters, counted from one; zero where the whole file is meant.
    pub column: usize,
    /// What is wrong.
    pub message: String,
    /// What was expected there; may be empty.
    pub expected: String,
    quoted: String,
    marked: usize,
}

impl SceneError {
    /// An error at a place.
    pub fn new(place: &Place, message: impl Into<String>, expected: impl Into<String>) -> Self {
        let located = place.located();
        Self {
            file: located.file.to_owned(),
            line: located.line,
            column: located.column,
            message: message.into(),
            expected: expected.into(),
            quoted: located.quoted.to_owned(),
            marked: located.marked,
        }
    }

    /// An error of a file as a whole.
    pub(super) fn of_file(file: &str, message: impl Into<String>) -> Self {
        Self { file: file.to_owned(), ..Self::new(&Place::default(), message, "") }
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { file, line, column, message, expected, quoted, marked } = self;
        let number = line.to_string();
        let margin = " ".repeat(number.len());
        if *line == 0 {
            let separator = if file.is_empty() { "" } else { ": " };
            write!(f, "{file}{separator}{message}")?;
        } else {
            let before = quoted.chars().take(column - 1);
            let indent: String = before.map(|c| if c == '\t' { '\t' } else { ' ' }).collect();
            writeln!(f, "{file}:{line}:{column}: {message}")?;
            writeln!(f, "{margin} |")?;
            writeln!(f, "{}", format!("{number} | {quoted}").trim_end())?;
            write!(f, "{margin} | {indent}{}", "^".repeat(*marked))?;
        }
        if !expected.is_empty() {
            write!(f, "\n{margin} = expected {expected}")?;
        }
        Ok(())
    }
}

impl std::error::Error for SceneError {}

/// The errors found so far in one text, and in the files that it names.
pub(super) struct Report {
    source: Arc<Source>,
    /// Each with the byte of the text that brought it up.
    errors: Vec<(usize, SceneError)>,
}

impl Report {
    pub(super) fn new(source: &Arc<Source>) -> Self {
        Self { source: Arc::clone(source), errors: Vec::new() }
    }

    /// A range of bytes of the text.
    pub(super) fn place(&self, range: Range<usize>) -> Place {
        Place::new(&self.source, range)
    }

    /// Records an error at a range of bytes of the text.
    pub(super) fn error(
        &mut self,
        range: Range<usize>,
        message: impl Into<String>,
        expected: impl Into<String>,
    ) {
        let error = SceneError::new(&self.place(range.clone()), message, expected);
        self.errors.push((range.start, error));
    }

    /// Records an error at a place of the text.
    pub(super) fn error_at(
        &mut self,
        place: &Place,
        message: impl Into<String>,
        expected: impl Into<String>,
    ) {
        self.errors.push((place.start(), SceneError::new(place, message, expected)));
    }

    /// Records the errors of a file that the text names at this byte.
    pub(super) fn include(&mut self, byte: usize, errors: Vec<SceneError>) {
        self.errors.extend(errors.into_iter().map(|error| (byte, error)));
    }

    /// The line of a byte of the text, counted from one.
    pub(super) fn line(&self, byte: usize) -> usize {
        self.place(byte..byte).located().line
    }

    pub(super) fn is_empty(&self) -> bool {
        self.errors.is_empty()
    }

    /// All errors, in the order of the text.
    pub(super) fn into_errors(mut self) -> Vec<SceneError> {
        self.errors.sort_by_key(|(start, _)| *start);
        self.errors.into_iter().map(|(_, error)| error).collect()
    }
}
