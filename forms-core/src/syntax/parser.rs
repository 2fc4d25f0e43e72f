//! Tokens in, syntax tree and diagnostics out.
//!
//! ```text
//! items ── kernels ──┐
//!   │                ├─▶ conditions ─▶ expressions ─▶ calls
//!   └────────────────┘
//! cursor: the next token, and what is wrong with it      recovery: where to go on after a mistake
//! ```
//! A mistake ends its item and the parser goes on with the next one, so each item reports what is wrong with it
//! and none reports the consequences. Mistakes whose meaning is plain (`=` for `==`) do not even end the item.

mod calls;
mod conditions;
mod cursor;
mod expressions;
mod items;
mod kernels;
mod recovery;

use super::ast;
use super::token::Token;
use crate::diagnostic::{Diagnostic, Span};
use cursor::{Parsed, Parser};

/// The height no expression's tree exceeds: what walks a tree may recurse this deep.
pub const MAXIMUM_DEPTH: usize = 2_000;

/// How deep expressions may be nested by brackets, signs, powers and `else if`, which the parser itself follows
/// by recursion. The greediest nesting, `f(f(f(…)))`, takes 5.3 KiB of stack a level without optimisation, so the
/// deepest takes two thirds of a thread's usual 2 MiB.
pub const MAXIMUM_NESTING: usize = 256;

/// The most tokens one source may have.
pub const MAXIMUM_TOKENS: usize = 1_000_000;

/// Parses a whole file. `end` is the place just behind the last token, for what is missing there.
pub fn parse_text(tokens: &[Token], end: Span) -> (ast::File, Vec<Diagnostic>) {
    items(Parser::new(tokens, end).map(Parser::with_keywords_as_names))
}

/// Parses a whole macro body, in which Rust keywords are no names: what is generated carries the names as they stand.
pub fn parse(tokens: &[Token], end: Span) -> (ast::File, Vec<Diagnostic>) {
    items(Parser::new(tokens, end))
}

fn items(parser: Result<Parser<'_>, Diagnostic>) -> (ast::File, Vec<Diagnostic>) {
    match parser {
        Ok(mut parser) => {
            let file = parser.file();
            (file, parser.diagnostics)
        }
        Err(too_long) => (ast::File::default(), vec![too_long]),
    }
}

/// Parses tokens that are one expression.
pub fn parse_expression(tokens: &[Token], end: Span) -> Result<ast::Expr, Vec<Diagnostic>> {
    whole(tokens, end, Parser::expression)
}

/// Parses tokens that are a statement without its name: `left == right where …`.
pub fn parse_equation(tokens: &[Token], end: Span) -> Result<ast::Equation, Vec<Diagnostic>> {
    whole(tokens, end, Parser::equation)
}

/// Runs `rule` over all of the tokens.
fn whole<'a, T>(
    tokens: &'a [Token],
    end: Span,
    rule: impl Fn(&mut Parser<'a>) -> Parsed<T>,
) -> Result<T, Vec<Diagnostic>> {
    let mut parser = Parser::new(tokens, end).map_err(|too_long| vec![too_long])?;
    let result = rule(&mut parser).and_then(|tree| parser.expect_end().map(|()| tree));
    match result {
        // An unknown token has been reported by whoever made it, so an error may come without a diagnostic.
        Ok(tree) if parser.diagnostics.is_empty() => Ok(tree),
        _ => Err(parser.diagnostics),
    }
}
