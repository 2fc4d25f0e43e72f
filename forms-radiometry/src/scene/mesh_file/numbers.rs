//! Numbers of a file with sections: in text form they are words, in binary form they have fixed
//! sizes. Names of sections and of their parts are words in both forms.

use super::Fault;
use super::words::coordinate;
use crate::scene::place::Source;
use std::borrow::Cow;
use std::ops::Range;
use std::sync::Arc;

/// The bytes of the file, and the next one to read.
pub(super) struct Numbers<'b> {
    bytes: &'b [u8],
    next: usize,
    pub(super) is_binary: bool,
    pub(super) is_big_endian: bool,
    /// The place of the last number or word.
    last: Range<usize>,
}

impl<'b> Numbers<'b> {
    pub(super) fn new(bytes: &'b [u8]) -> Self {
        Self { bytes, next: 0, is_binary: false, is_big_endian: false, last: 0..0 }
    }

    /// Returns the place of the last number or word.
    pub(super) fn place(&self) -> Range<usize> {
        self.last.clone()
    }

    /// Returns the text to which places refer; empty for a binary file.
    pub(super) fn source(&self, file: &str) -> Arc<Source> {
        let text = if self.is_binary { Cow::default() } else { String::from_utf8_lossy(self.bytes) };
        Source::new(file, &text)
    }

    /// Returns the first byte of the next number.
    pub(super) fn next_start(&self) -> usize {
        if self.is_binary { self.next } else { self.next_word_place().start }
    }

    fn next_word_place(&self) -> Range<usize> {
        let rest = &self.bytes[self.next..];
        let blanks = rest.iter().take_while(|byte| byte.is_ascii_whitespace()).count();
        let length = rest[blanks..].iter().take_while(|byte| !byte.is_ascii_whitespace()).count();
        self.next + blanks..self.next + blanks + length
    }

    /// Returns the next word, if there is one.
    pub(super) fn next_word(&mut self) -> Option<Cow<'b, str>> {
        let place = self.next_word_place();
        (self.next, self.last) = (place.end, place.clone());
        (!place.is_empty()).then(|| String::from_utf8_lossy(&self.bytes[place]))
    }

    /// Returns the next word, which `what` names.
    pub(super) fn word(&mut self, what: &str) -> Result<(Cow<'b, str>, Range<usize>), Fault> {
        match self.next_word() {
            Some(word) => Ok((word, self.place())),
            None => Err(self.ended(what)),
        }
    }

    fn ended(&self, what: &str) -> Fault {
        let end = self.bytes.len();
        Fault::new(end..end, format!("the file ends where {what} is expected"), "a complete file")
    }

    /// Passes over the rest of the line before the numbers of a section, if they are binary.
    pub(super) fn begin_binary(&mut self) {
        if self.is_binary {
            self.line_end();
        }
    }

    /// Passes over the next bytes up to the end of this text; returns whether it was found.
    pub(super) fn pass(&mut self, text: &str) -> bool {
        let rest = &self.bytes[self.next..];
        let found = rest.windows(text.len()).position(|window| window == text.as_bytes());
        self.next += found.map_or(0, |found| found + text.len());
        found.is_some()
    }

    /// Returns the rest of the line, and its place.
    pub(super) fn rest_of_line(&mut self) -> (Cow<'b, str>, Range<usize>) {
        let start = self.next;
        self.line_end();
        let line = String::from_utf8_lossy(&self.bytes[start..self.next]);
        let length = line.trim_end().len();
        (line, start..start + length)
    }

    /// Passes over the rest of the line.
    pub(super) fn line_end(&mut self) {
        let rest = &self.bytes[self.next..];
        self.next += rest.iter().position(|&byte| byte == b'\n').map_or(rest.len(), |newline| newline + 1);
    }

    /// Returns a whole number that is text in both forms.
    pub(super) fn whole_in_text(&mut self) -> Result<i64, Fault> {
        let (word, place) = self.word("a number")?;
        word.parse().map_err(|_| self.fault(place, &format!("`{word}` is not an integer"), "an integer"))
    }

    /// Returns a number of lines or rows, which is text in both forms; in a binary file the rows
    /// begin in the next line.
    pub(super) fn count_in_text(&mut self) -> Result<u64, Fault> {
        let count = self.whole_in_text()?;
        self.begin_binary();
        u64::try_from(count).map_err(|_| self.fault(self.place(), "the number is negative", ""))
    }

    /// Returns the next bytes of a number, the least significant one first.
    pub(super) fn take<const N: usize>(&mut self) -> Result<[u8; N], Fault> {
        let taken: Option<&[u8; N]> = self.bytes.get(self.next..).and_then(|rest| rest.first_chunk());
        let mut bytes = *taken.ok_or_else(|| self.fault(0..0, "the file ends within a section", ""))?;
        self.last = self.next..self.next + N;
        self.next += N;
        if self.is_big_endian {
            bytes.reverse();
        }
        Ok(bytes)
    }

    /// Returns an integer of four bytes.
    pub(super) fn int(&mut self) -> Result<i64, Fault> {
        if self.is_binary {
            self.take().map(|bytes| i32::from_le_bytes(bytes).into())
        } else {
            self.whole_in_text()
        }
    }

    /// Returns an unsigned integer of eight bytes.
    pub(super) fn size(&mut self) -> Result<u64, Fault> {
        if self.is_binary {
            return self.take().map(u64::from_le_bytes);
        }
        let whole = self.whole_in_text()?;
        u64::try_from(whole).map_err(|_| self.fault(self.place(), "the number is negative", ""))
    }

    /// Returns a number of eight bytes.
    pub(super) fn real(&mut self) -> Result<f64, Fault> {
        if self.is_binary {
            return self.take().map(f64::from_le_bytes);
        }
        let (word, place) = self.word("a number")?;
        word.parse().map_err(|_| self.fault(place, &format!("`{word}` is not a number"), "a number"))
    }

    /// Checks that the last number is a valid coordinate.
    pub(super) fn coordinate(&self, number: f64) -> Result<f64, Fault> {
        coordinate(self.place(), number)
            .map_err(|wrong| self.fault(wrong.range, &wrong.message, &wrong.expected))
    }

    /// Returns a fault; in a binary file its message names the byte.
    pub(super) fn fault(&self, place: Range<usize>, message: &str, expected: &str) -> Fault {
        let message = match self.is_binary {
            true => format!("byte {}: {message}", self.next),
            false => message.to_owned(),
        };
        Fault::new(place, message, expected)
    }
}
