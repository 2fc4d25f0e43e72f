//! Words: splits a line of a mesh file into words with their places, and parses words as numbers.

use super::Fault;
use crate::scene::value::COORDINATE;
use std::ops::Range;

/// Text between whitespace.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::scene) struct Word<'t> {
    pub(in crate::scene) text: &'t str,
    /// Its byte range in the file.
    pub(in crate::scene) range: Range<usize>,
}

/// Returns the lines of a text from a byte on, each with its first byte.
pub(in crate::scene) fn lines(text: &str, from: usize) -> impl Iterator<Item = (usize, &str)> {
    let mut start = from;
    text[from..].split_inclusive('\n').map(move |line| {
        let begin = start;
        start += line.len();
        (begin, line)
    })
}

/// Returns the words of a line that starts at this byte.
pub(in crate::scene) fn words(start: usize, line: &str) -> impl Iterator<Item = Word<'_>> {
    line.split_whitespace().map(move |text| {
        let begin = start + text.as_ptr() as usize - line.as_ptr() as usize;
        Word { text, range: begin..begin + text.len() }
    })
}

/// Returns the byte range that some words cover.
pub(in crate::scene) fn extent(words: &[Word]) -> Range<usize> {
    match words {
        [] => 0..0,
        [first, .., last] | [first @ last] => first.range.start..last.range.end,
    }
}

impl Word<'_> {
    /// Parses a coordinate.
    pub(in crate::scene) fn coordinate(&self) -> Result<f64, Fault> {
        self.float().and_then(|x| coordinate(self.range.clone(), x))
    }

    /// Parses any number.
    pub(in crate::scene) fn float(&self) -> Result<f64, Fault> {
        let wrong =
            |_| Fault::new(self.range.clone(), format!("`{}` is not a number", self.text), "a number");
        self.text.parse().map_err(wrong)
    }

    /// Parses an integer.
    pub(in crate::scene) fn whole(&self) -> Result<i64, Fault> {
        let wrong =
            |_| Fault::new(self.range.clone(), format!("`{}` is not an integer", self.text), "an integer");
        self.text.parse().map_err(wrong)
    }
}

/// Checks that a number is a valid coordinate.
pub(in crate::scene) fn coordinate(range: Range<usize>, x: f64) -> Result<f64, Fault> {
    if !x.is_finite() {
        return Err(Fault::new(range, "a coordinate is not finite", COORDINATE.expected));
    }
    if !(COORDINATE.contains)(x) {
        return Err(Fault::new(range, "a coordinate is out of range", COORDINATE.expected));
    }
    Ok(x)
}
