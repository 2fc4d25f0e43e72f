//! Elements of a View3D file: a letter at the start of a line, then words, on the lines that follow too
//! if they begin with a number. Comments begin with `!` or `/`.

use super::super::words::{Fault, Word, lines, words};
use crate::geometry::Vector;
use std::ops::Range;

/// An element with its words.
pub(super) struct Element<'t> {
    pub(super) keyword: char,
    /// The place of its first line.
    pub(super) place: Range<usize>,
    text: &'t str,
    words: std::vec::IntoIter<Word<'t>>,
}

/// The elements of a text.
pub(super) struct Elements;

impl Elements {
    pub(super) fn of(text: &str) -> Vec<Element<'_>> {
        let mut elements: Vec<(usize, &str, Vec<Word>)> = Vec::new();
        for (start, line) in lines(text, 0) {
            let length = line.find(['!', '/']).unwrap_or(line.len());
            let line_words: Vec<Word> = words(start, &line[..length]).collect();
            let Some(first) = line_words.first() else { continue };
            let begins_element = first.text.starts_with(|c: char| c.is_alphabetic() || c == '*');
            match elements.last_mut() {
                Some((_, _, words)) if !begins_element => words.extend(line_words),
                _ => elements.push((start, line.trim_end(), line_words)),
            }
        }
        elements.into_iter().map(|(start, line, words)| Element::new(start, line, words)).collect()
    }
}

impl<'t> Element<'t> {
    fn new(start: usize, line: &'t str, mut words: Vec<Word<'t>>) -> Self {
        let first = words.remove(0);
        let letter = first.text.chars().next().unwrap_or(' ');
        let offset = first.range.start - start;
        Self {
            keyword: letter.to_ascii_uppercase(),
            place: first.range.start..start + line.len(),
            // what follows the letter
            text: &line[offset + letter.len_utf8()..],
            words: words.into_iter(),
        }
    }

    /// Returns the rest of the line as it is written.
    pub(super) fn rest(&self) -> &'t str {
        self.text.trim()
    }

    /// Returns a fault at the first line of the element.
    pub(super) fn fault(&self, message: &str, expected: &str) -> Fault {
        Fault::new(self.place.clone(), message, expected)
    }

    /// Returns the next word, which `what` names.
    pub(super) fn word(&mut self, what: &str) -> Result<Word<'t>, Fault> {
        let ended = self.fault(&format!("the line ends before {what}"), what);
        self.words.next().ok_or(ended)
    }

    /// Returns the next word as a number of a vertex or surface, or zero.
    pub(super) fn number(&mut self) -> Result<u32, Fault> {
        let word = self.word("an integer")?;
        let whole = word.whole()?;
        u32::try_from(whole)
            .map_err(|_| Fault::new(word.range, "the number is out of range", "an integer of at least 0"))
    }

    pub(super) fn coordinate(&mut self) -> Result<f64, Fault> {
        self.word("a coordinate")?.coordinate()
    }

    pub(super) fn point(&mut self) -> Result<Vector, Fault> {
        Ok(Vector::new(self.coordinate()?, self.coordinate()?, self.coordinate()?))
    }

    /// Returns the next word as a number from 0 to 1.
    pub(super) fn fraction(&mut self, what: &str) -> Result<f64, Fault> {
        let word = self.word(what)?;
        let number = word.float()?;
        let is_fraction = (0.0..=1.0).contains(&number);
        let wrong = || Fault::new(word.range, format!("{what} is out of range"), "a number from 0 to 1");
        if is_fraction { Ok(number) } else { Err(wrong()) }
    }
}
