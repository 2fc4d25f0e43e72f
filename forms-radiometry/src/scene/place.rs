//! Places: byte ranges of a text and its file, for errors that are reported later.

use forms::core::syntax::Excerpt;
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// A text, with the name of its file as the caller gave it.
#[derive(Debug)]
pub(super) struct Source {
    pub(super) file: String,
    pub(super) text: String,
    /// Whether it is the value of a command-line option, whose name replaces the file name.
    is_option: bool,
}

impl Source {
    pub(super) fn new(file: &str, text: &str) -> Arc<Self> {
        Arc::new(Self { file: file.to_owned(), text: text.to_owned(), is_option: false })
    }

    /// Creates the source of the value of a command-line option.
    pub(super) fn of_option(name: &str, value: &str) -> Arc<Self> {
        Arc::new(Self { file: name.to_owned(), text: value.to_owned(), is_option: true })
    }
}

/// Place of an item in a file. The default place is nowhere; items that did not come from a file
/// have it.
#[derive(Clone, Default)]
pub struct Place {
    source: Option<Arc<Source>>,
    start: usize,
    end: usize,
    /// The first byte in the whole text, of which the file can be a part.
    order: usize,
}

/// A place as lines and columns.
pub(super) struct Located<'p> {
    pub(super) file: &'p str,
    /// Line, counted from one, and column, counted from one in characters; zero for an error of a
    /// whole file.
    pub(super) line: usize,
    pub(super) column: usize,
    /// The displayed part of the line, with a mark under the place.
    pub(super) quoted: Excerpt,
}

impl Place {
    /// Creates the place of a range of bytes of a text. A bound beyond the end of the text is moved
    /// to the end, a bound within a character to the start of the character.
    pub(super) fn new(source: &Arc<Source>, range: Range<usize>) -> Self {
        Self { source: Some(Arc::clone(source)), start: range.start, end: range.end, order: range.start }
    }

    /// Returns the same place in a text of which its file is a part: there it starts at this byte.
    pub(super) fn in_text_at(self, order: usize) -> Self {
        Self { order, ..self }
    }

    /// Returns the first byte in the whole text, by which errors are ordered.
    pub(super) fn order(&self) -> usize {
        self.order
    }

    /// Returns the file, the line and the column, counted from one, if the place is in a file.
    pub fn position(&self) -> Option<(&str, usize, usize)> {
        let located = self.located();
        self.source.as_ref().map(|_| (located.file, located.line, located.column))
    }

    /// Whether the place is in the value of a command-line option.
    pub fn is_option(&self) -> bool {
        self.source.as_ref().is_some_and(|source| source.is_option)
    }

    pub(super) fn located(&self) -> Located<'_> {
        let Some(source) = &self.source else {
            let quoted = Excerpt { text: String::new(), indent: 0, marked: 0 };
            return Located { file: "", line: 0, column: 0, quoted };
        };
        let text = &source.text;
        let start = boundary(text, self.start);
        let line_start = text[..start].rfind('\n').map_or(0, |newline| newline + 1);
        let line_end = text[start..].find('\n').map_or(text.len(), |newline| start + newline);
        let end = boundary(text, self.end).clamp(start, line_end);
        let column = text[line_start..start].chars().count();
        let width = text[start..end].trim_end().chars().count();
        Located {
            file: &source.file,
            line: text[..start].matches('\n').count() + 1,
            column: column + 1,
            quoted: Excerpt::of(text[line_start..line_end].trim_end(), column, width),
        }
    }
}

impl fmt::Debug for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.position() {
            Some((file, line, column)) => write!(f, "{file}:{line}:{column}"),
            None => write!(f, "nowhere"),
        }
    }
}

/// Returns the last character boundary at or before this byte.
fn boundary(text: &str, byte: usize) -> usize {
    let byte = byte.min(text.len());
    (0..=byte).rev().find(|&i| text.is_char_boundary(i)).unwrap_or(0)
}
