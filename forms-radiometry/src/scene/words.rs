//! Words: splits a line of a mesh file or of a scene of View3D into words with their places, and parses
//! words as numbers.

use super::value::COORDINATE;
use std::ops::Range;

/// An error at a range of bytes of a file.
pub(super) struct Fault {
    pub(super) range: Range<usize>,
    pub(super) message: String,
    pub(super) expected: String,
}

impl Fault {
    pub(super) fn new(range: Range<usize>, message: impl Into<String>, expected: impl Into<String>) -> Self {
        Self { range, message: message.into(), expected: expected.into() }
    }
}

/// Text between whitespace.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Word<'t> {
    pub(super) text: &'t str,
    /// Its byte range in the file.
    pub(super) range: Range<usize>,
}

/// Returns the lines of a text from a byte on, each with its first byte.
pub(super) fn lines(text: &str, from: usize) -> impl Iterator<Item = (usize, &str)> {
    let mut start = from;
    text[from..].split_inclusive('\n').map(move |line| {
        let begin = start;
        start += line.len();
        (begin, line)
    })
}

/// Returns the words of a line that starts at this byte.
pub(super) fn words(start: usize, line: &str) -> impl Iterator<Item = Word<'_>> {
    line.split_whitespace().map(move |text| {
        let begin = start + text.as_ptr() as usize - line.as_ptr() as usize;
        Word { text, range: begin..begin + text.len() }
    })
}

/// Returns the byte range that some words cover.
pub(super) fn extent(words: &[Word]) -> Range<usize> {
    match words {
        [] => 0..0,
        [first, .., last] | [first @ last] => first.range.start..last.range.end,
    }
}

impl Word<'_> {
    /// Parses a coordinate.
    pub(super) fn coordinate(&self) -> Result<f64, Fault> {
        self.float().and_then(|x| coordinate(self.range.clone(), x))
    }

    /// Parses any number.
    pub(super) fn float(&self) -> Result<f64, Fault> {
        let wrong =
            |_| Fault::new(self.range.clone(), format!("`{}` is not a number", self.text), "a number");
        self.text.parse().map_err(wrong)
    }

    /// Parses an integer.
    pub(super) fn whole(&self) -> Result<i64, Fault> {
        let wrong =
            |_| Fault::new(self.range.clone(), format!("`{}` is not an integer", self.text), "an integer");
        self.text.parse().map_err(wrong)
    }
}

/// Checks that a number is a valid coordinate.
pub(super) fn coordinate(range: Range<usize>, x: f64) -> Result<f64, Fault> {
    if !x.is_finite() {
        return Err(Fault::new(range, "a coordinate is not finite", COORDINATE.expected));
    }
    if !(COORDINATE.contains)(x) {
        return Err(Fault::new(range, "a coordinate is out of range", COORDINATE.expected));
    }
    Ok(x)
}
