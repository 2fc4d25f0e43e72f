//! Errors in scene files: a place in the text becomes a message that quotes the line.

use std::fmt;
use std::ops::Range;

/// One thing that is wrong with a scene file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SceneError {
    /// The file, as it was named by the caller.
    pub file: String,
    /// The line, counted from one.
    pub line: usize,
    /// The column in characters, counted from one.
    pub column: usize,
    /// What is wrong.
    pub message: String,
    /// What was expected there; may be empty.
    pub expected: String,
    quoted: String,
    marked: usize,
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { file, line, column, message, expected, quoted, marked } = self;
        let number = line.to_string();
        let margin = " ".repeat(number.len());
        let indent: String =
            quoted.chars().take(column - 1).map(|c| if c == '\t' { '\t' } else { ' ' }).collect();
        writeln!(f, "{file}:{line}:{column}: {message}")?;
        writeln!(f, "{margin} |")?;
        writeln!(f, "{number} | {quoted}")?;
        write!(f, "{margin} | {indent}{}", "^".repeat(*marked))?;
        if !expected.is_empty() {
            write!(f, "\n{margin} = expected {expected}")?;
        }
        Ok(())
    }
}

impl std::error::Error for SceneError {}

/// The errors found so far in one text.
pub(super) struct Report<'t> {
    file: &'t str,
    text: &'t str,
    errors: Vec<(usize, SceneError)>,
}

impl<'t> Report<'t> {
    pub(super) fn new(file: &'t str, text: &'t str) -> Self {
        Self { file, text, errors: Vec::new() }
    }

    /// Records an error at a range of bytes of the text.
    pub(super) fn error(
        &mut self,
        place: Range<usize>,
        message: impl Into<String>,
        expected: impl Into<String>,
    ) {
        let start = self.boundary(place.start);
        let line_start = self.text[..start].rfind('\n').map_or(0, |newline| newline + 1);
        let line_end = self.text[start..].find('\n').map_or(self.text.len(), |newline| start + newline);
        let end = self.boundary(place.end).clamp(start, line_end);
        let error = SceneError {
            file: self.file.to_owned(),
            line: self.line(start),
            column: self.text[line_start..start].chars().count() + 1,
            message: message.into(),
            expected: expected.into(),
            quoted: self.text[line_start..line_end].trim_end().to_owned(),
            marked: self.text[start..end].trim_end().chars().count().max(1),
        };
        self.errors.push((start, error));
    }

    /// The line of a byte of the text, counted from one.
    pub(super) fn line(&self, byte: usize) -> usize {
        self.text[..self.boundary(byte)].matches('\n').count() + 1
    }

    pub(super) fn is_empty(&self) -> bool {
        self.errors.is_empty()
    }

    /// All errors, in the order of the text.
    pub(super) fn into_errors(mut self) -> Vec<SceneError> {
        self.errors.sort_by_key(|(start, _)| *start);
        self.errors.into_iter().map(|(_, error)| error).collect()
    }

    /// The last start of a character at or before this byte.
    fn boundary(&self, byte: usize) -> usize {
        let byte = byte.min(self.text.len());
        (0..=byte).rev().find(|&i| self.text.is_char_boundary(i)).unwrap_or(0)
    }
}
