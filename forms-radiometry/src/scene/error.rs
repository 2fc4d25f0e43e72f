//! Errors in scene files: a place in a text becomes a message that quotes the line.

use super::place::{Place, Source};
use forms::core::diagnostic::{MOST_DIAGNOSTICS, counted};
use forms::core::syntax::Excerpt;
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// An error in a scene file, or in a file that it names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SceneError {
    /// The file, as it was named by the caller; empty if the scene did not come from a file.
    pub file: String,
    /// The line, counted from one; zero for an error of the whole file.
    pub line: usize,
    /// The column in characters, counted from one; zero for an error of the whole file.
    pub column: usize,
    /// The error message.
    pub message: String,
    /// The expected input; can be empty.
    pub expected: String,
    quoted: Box<Excerpt>,
}

/// A part of a text that was put together from several files: from this byte to the start of the
/// next part.
pub(super) struct Span {
    pub(super) start: usize,
    /// The file of the part, and the byte in it at which the part starts.
    pub(super) source: Arc<Source>,
    pub(super) offset: usize,
}

/// The largest number of errors that are shown for a scene and its meshes.
const MOST_ERRORS: usize = MOST_DIAGNOSTICS;

/// The longest message, in characters: a quotation in it can be as long as the file.
const LONGEST_MESSAGE: usize = 300;

impl SceneError {
    /// Creates an error at a place.
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

    /// Creates an error of a file as a whole.
    pub(super) fn of_file(file: &str, message: impl Into<String>) -> Self {
        Self { file: file.to_owned(), ..Self::new(&Place::default(), message, "") }
    }

    /// Returns the error with another expected input.
    pub(super) fn expecting(self, expected: impl Into<String>) -> Self {
        Self { expected: cut(expected.into()), ..self }
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

/// Shortens a text to a readable length.
fn cut(text: String) -> String {
    match text.char_indices().nth(LONGEST_MESSAGE) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text,
    }
}

/// The errors found so far in one text, and in the files that it names. The text can be put together
/// from the texts of several files.
pub(super) struct Report {
    source: Arc<Source>,
    /// The origins of the text, in its order; a single one for the text of one file.
    spans: Vec<Span>,
    /// Each error with the byte of the text that caused it.
    errors: Vec<(usize, SceneError)>,
    /// The number of further errors, which are only counted.
    more: usize,
    /// Descriptions of parts that are read in another way than they are written.
    notes: Vec<String>,
}

impl Report {
    pub(super) fn new(source: &Arc<Source>) -> Self {
        let spans = vec![Span { start: 0, source: Arc::clone(source), offset: 0 }];
        Self { source: Arc::clone(source), spans, errors: Vec::new(), more: 0, notes: Vec::new() }
    }

    /// Returns the text of the file that the errors are about.
    pub(super) fn source(&self) -> Arc<Source> {
        Arc::clone(&self.source)
    }

    /// Sets the origins of a text that was put together from several files.
    pub(super) fn set_spans(&mut self, spans: Vec<Span>) {
        self.spans = spans;
    }

    /// Records that something was read in another way than it is written.
    pub(super) fn note(&mut self, note: String) {
        self.notes.push(note);
    }

    /// Returns the notes so far, and forgets them.
    pub(super) fn take_notes(&mut self) -> Vec<String> {
        std::mem::take(&mut self.notes)
    }

    /// Returns the place of a range of bytes of the text.
    pub(super) fn place(&self, range: Range<usize>) -> Place {
        let next = self.spans.partition_point(|span| span.start <= range.start);
        let Some(span) = self.spans.get(next.saturating_sub(1)) else { return Place::default() };
        let limit = self.spans.get(next).map_or(usize::MAX, |next| next.start);
        let moved = |byte: usize| byte.min(limit).saturating_sub(span.start) + span.offset;
        Place::new(&span.source, moved(range.start)..moved(range.end)).in_text_at(range.start)
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
            self.errors.push((place.order(), SceneError::new(place, message, expected)));
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

    /// Names the line of a byte of the text, counted from one, and its file unless it is the file
    /// of another byte.
    pub(super) fn line(&self, byte: usize, seen_from: usize) -> String {
        let [place, other] = [byte, seen_from].map(|byte| self.place(byte..byte));
        let (located, other) = (place.located(), other.located());
        if located.file == other.file {
            format!("line {}", located.line)
        } else {
            format!("line {} of `{}`", located.line, located.file)
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.errors.is_empty()
    }

    /// Returns all errors, in the order of the text.
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
