//! Errors in scene files: a place in a text becomes a message that quotes the line.

use super::place::{Place, Source};
use forms::core::diagnostic::{MOST_DIAGNOSTICS, counted};
use forms::core::syntax::Excerpt;
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
    quoted: Box<Excerpt>,
}

/// The most errors of one scene that are shown, its meshes included.
const MOST_ERRORS: usize = MOST_DIAGNOSTICS;

/// The longest message, in characters: what it quotes may be as long as the file.
const LONGEST_MESSAGE: usize = 300;

impl SceneError {
    /// An error at a place.
    pub fn new(place: &Place, message: impl Into<String>, expected: impl Into<String>) -> Self {
        let located = place.located();
        Self {
            file: located.file.to_owned(),
            line: located.line,
            column: located.column,
            message: cut(message.into()),
            expected: cut(expected.into()),
            quoted: Box::new(located.quoted),
        }
    }

    /// An error of a file as a whole.
    pub(super) fn of_file(file: &str, message: impl Into<String>) -> Self {
        Self { file: file.to_owned(), ..Self::new(&Place::default(), message, "") }
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { file, line, column, message, expected, quoted } = self;
        let number = line.to_string();
        let margin = " ".repeat(number.len());
        if *line == 0 {
            let separator = if file.is_empty() { "" } else { ": " };
            write!(f, "{file}{separator}{message}")?;
        } else {
            let Excerpt { text, indent, marked } = quoted.as_ref();
            writeln!(f, "{file}:{line}:{column}: {message}")?;
            writeln!(f, "{margin} |")?;
            writeln!(f, "{}", format!("{number} | {text}").trim_end())?;
            write!(f, "{margin} | {}{}", " ".repeat(*indent), "^".repeat(*marked))?;
        }
        if !expected.is_empty() {
            write!(f, "\n{margin} = expected {expected}")?;
        }
        Ok(())
    }
}

impl std::error::Error for SceneError {}

/// A text that is not too long to be read.
fn cut(text: String) -> String {
    match text.char_indices().nth(LONGEST_MESSAGE) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text,
    }
}

/// The errors found so far in one text, and in the files that it names.
pub(super) struct Report {
    source: Arc<Source>,
    /// Each with the byte of the text that brought it up.
    errors: Vec<(usize, SceneError)>,
    /// How many more there are, of which nothing is kept.
    more: usize,
}

impl Report {
    pub(super) fn new(source: &Arc<Source>) -> Self {
        Self { source: Arc::clone(source), errors: Vec::new(), more: 0 }
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
        let place = self.place(range);
        self.error_at(&place, message, expected);
    }

    /// Records an error at a place of the text.
    pub(super) fn error_at(
        &mut self,
        place: &Place,
        message: impl Into<String>,
        expected: impl Into<String>,
    ) {
        if self.errors.len() < MOST_ERRORS {
            self.errors.push((place.start(), SceneError::new(place, message, expected)));
        } else {
            self.more += 1;
        }
    }

    /// Records the errors of a file that the text names at this byte.
    pub(super) fn include(&mut self, byte: usize, errors: Vec<SceneError>) {
        let room = MOST_ERRORS - self.errors.len();
        self.more += errors.len().saturating_sub(room);
        self.errors.extend(errors.into_iter().take(room).map(|error| (byte, error)));
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
        let mut errors: Vec<SceneError> = self.errors.into_iter().map(|(_, error)| error).collect();
        if self.more > 0 {
            let rest = counted(self.more, "more error");
            errors.push(SceneError::of_file(&self.source.file, rest));
        }
        errors
    }
}
