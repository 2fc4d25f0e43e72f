//! Syntax: from characters or macro tokens to a syntax tree.
//!
//! ```text
//! text ── lexer ──┐
//!                 ├─▶ tokens ── parser ──▶ ast::File + diagnostics
//! macro tokens ───┘
//! ```
//! The parser sees tokens only, so a `.forms` file and a macro body have the same meaning.

pub mod ast;
mod claims;
mod lexer;
mod number;
mod parser;
mod source;
pub mod token;
pub mod words;

pub use lexer::lex;
#[cfg(feature = "internals")]
pub use parser::{MAXIMUM_DEPTH, MAXIMUM_NESTING, MAXIMUM_TOKENS};
#[cfg(not(feature = "internals"))]
pub(crate) use parser::{MAXIMUM_DEPTH, MAXIMUM_NESTING, MAXIMUM_TOKENS};
pub use parser::{parse, parse_equation, parse_expression, parse_text};
pub use source::{Excerpt, Position, Source};

use crate::diagnostic::{Diagnostic, Span};

/// Reads a whole text; returns its items, and all errors in the order of the text.
pub fn read(text: &str) -> (ast::File, Vec<Diagnostic>) {
    let (tokens, mut diagnostics) = lex(text);
    let (file, found) = parse_text(&tokens, end_of(text));
    diagnostics.extend(found);
    diagnostics.sort_by_key(|diagnostic| diagnostic.span);
    (file, diagnostics)
}

/// Returns the empty place directly after a text's last character.
pub fn end_of(text: &str) -> Span {
    let end = u32::try_from(text.len()).unwrap_or(u32::MAX);
    Span::new(end, end)
}
