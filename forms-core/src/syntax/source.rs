//! Named source text: conversion of offsets to positions, and rendering of diagnostics.

use crate::diagnostic::{Diagnostic, Kind, Span};
use std::fmt::Write;

/// Maximum number of columns of a line that are quoted.
const QUOTED: usize = 100;

/// Text with the name under which it is reported.
#[derive(Clone, Debug)]
pub struct Source {
    /// Its file name, as shown to the user.
    pub name: String,
    /// Its characters.
    pub text: String,
}

/// Position for human readers: line and column count from 1, columns in characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Position {
    /// Line number.
    pub line: usize,
    /// Number of the character in its line.
    pub column: usize,
}

impl Source {
    /// Creates a source from a name and a text.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        Source { name: name.into(), text: text.into() }
    }

    /// Returns the position of a byte offset. An offset outside the text is mapped to its end, an
    /// offset inside a character to its start.
    pub fn position(&self, offset: u32) -> Position {
        let offset = self.boundary(offset);
        let start = self.line_start(offset);
        let line = self.text[..start].bytes().filter(|&byte| byte == b'\n').count() + 1;
        Position { line, column: self.text[start..offset].chars().count() + 1 }
    }

    /// Renders a diagnostic with the source line to which it refers.
    ///
    /// ```text
    /// error: expected `;` after the statement, found `prove`
    ///   --> box.forms:3:14
    ///    |
    ///  3 | let r = x + y
    ///    |              ^
    ///    = help: …
    /// ```
    pub fn render(&self, diagnostic: &Diagnostic) -> String {
        format!("error: {}", self.explain(diagnostic))
    }

    /// Returns the message of a diagnostic with its place, the quoted line, note and help.
    pub fn explain(&self, diagnostic: &Diagnostic) -> String {
        if diagnostic.kind == Kind::Rest {
            return format!("{}\n", diagnostic.message);
        }
        let Position { line, column } = self.position(diagnostic.span.start);
        let number = line.to_string();
        let margin = " ".repeat(number.len() + 2);
        let (quote, marks) = self.quote(diagnostic.span);
        let mut text = format!("{}\n", diagnostic.message);
        let mut put = |part: std::fmt::Arguments<'_>| text.write_fmt(part).expect("a String takes all text");
        put(format_args!("{}--> {}:{line}:{column}\n", " ".repeat(number.len() + 1), self.name));
        put(format_args!("{margin}|\n {number} | {quote}\n{margin}| {marks}\n"));
        if let Some((span, name)) = &diagnostic.related {
            let Position { line, column } = self.position(span.start);
            put(format_args!("{margin}= note: {name} is at {line}:{column}\n"));
        }
        if let Some(help) = &diagnostic.help {
            put(format_args!("{margin}= help: {help}\n"));
        }
        text
    }

    /// Returns the line in which a span begins, and the marks under the span, up to the end of that
    /// line.
    fn quote(&self, span: Span) -> (String, String) {
        let start = self.boundary(span.start);
        let line_start = self.line_start(start);
        let line_end = self.text[start..].find('\n').map_or(self.text.len(), |length| start + length);
        let line = self.text[line_start..line_end].trim_end_matches('\r');
        let end = self.boundary(span.end).clamp(start, line_end);
        let column = self.text[line_start..start].chars().count();
        let width = self.text[start..end].trim_end_matches('\r').chars().count();
        let Excerpt { text, indent, marked } = Excerpt::of(line, column, width);
        (text, format!("{}{}", " ".repeat(indent), "^".repeat(marked)))
    }

    /// Returns the nearest character boundary at or before an offset.
    fn boundary(&self, offset: u32) -> usize {
        let offset = usize::try_from(offset).unwrap_or(usize::MAX).min(self.text.len());
        (0..=offset).rev().find(|&at| self.text.is_char_boundary(at)).unwrap_or(0)
    }

    fn line_start(&self, offset: usize) -> usize {
        self.text[..offset].rfind('\n').map_or(0, |newline| newline + 1)
    }
}

/// Part of a line that is quoted, limited in length.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Excerpt {
    /// Quoted text, with `…` where the line is cut.
    pub text: String,
    /// Number of its characters before the mark.
    pub indent: usize,
    /// Number of marked characters, at least one.
    pub marked: usize,
}

impl Excerpt {
    /// Returns the excerpt of a line around the marked characters, which are `width` characters
    /// from `column` on.
    pub fn of(line: &str, column: usize, width: usize) -> Self {
        let width = width.max(1);
        let length = line.chars().count();
        let window = window(length, column, width);
        let (cut_before, cut_after) = (window.start > 0, window.end < length);
        let marked = width.min(window.end.saturating_sub(column)).max(1);
        let indent = column.saturating_sub(window.start) + usize::from(cut_before);
        let mut text: String = line.chars().skip(window.start).take(window.len()).map(printable).collect();
        if cut_before {
            text.insert(0, '…');
        }
        if cut_after {
            text.push('…');
        }
        Excerpt { text, indent, marked }
    }
}

/// Returns the range of characters of a long line that are shown: up to half of them before a short
/// mark, a fifth before a long one.
fn window(length: usize, column: usize, width: usize) -> std::ops::Range<usize> {
    if length <= QUOTED {
        return 0..length;
    }
    let room_before = if width > QUOTED / 3 { QUOTED / 5 } else { QUOTED / 2 };
    let start = column.saturating_sub(room_before).min(length - QUOTED);
    start..start + QUOTED
}

/// Replaces characters that a terminal does not show in exactly one column.
fn printable(c: char) -> char {
    match c {
        '\t' => ' ',
        c if c.is_control() => '\u{fffd}',
        c => c,
    }
}
