//! Parser: tokens in, syntax tree and diagnostics out.
//!
//! ```text
//! items ── kernels ──┐
//!   │                ├─▶ conditions ─▶ expressions ─▶ calls
//!   └──── declared ──┘
//! cursor: the next token, and errors about it     recovery: where to continue after an error
//! ```
//! An error ends its item and the parser continues with the next one, so each item reports its own
//! error and none reports the consequences. Errors whose intention is clear (`=` for `==`) do not
//! even end the item.

mod calls;
mod conditions;
mod cursor;
mod declared;
mod expressions;
mod items;
mod kernels;
mod recovery;

use super::ast;
use super::token::Token;
use crate::diagnostic::{Diagnostic, Span};
use cursor::{Parsed, Parser};

/// Maximum height of an expression's tree: code that walks a tree can recurse this deep.
pub const MAXIMUM_DEPTH: usize = 2_000;

/// Maximum nesting of expressions by brackets, signs, powers and `else if`, which the parser itself
/// handles by recursion. The most expensive nesting, `f(f(f(…)))`, takes 5.3 KiB of stack per level
/// without optimisation, so the deepest takes two thirds of a thread's usual 2 MiB.
pub const MAXIMUM_NESTING: usize = 256;

/// Maximum number of tokens of one source.
pub const MAXIMUM_TOKENS: usize = 1_000_000;

/// Parses a whole file. `end` is the place directly after the last token, where missing tokens are
/// reported.
pub fn parse_text(tokens: &[Token], end: Span) -> (ast::File, Vec<Diagnostic>) {
    items(Parser::new(tokens, end).map(Parser::with_keywords_as_names))
}

/// Parses a whole macro body, in which Rust keywords cannot be names, since the generated code uses
/// the names unchanged.
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
        // The producer of an unknown token has reported it, so an error can come without a
        // diagnostic.
        Ok(tree) if parser.diagnostics.is_empty() => Ok(tree),
        _ => Err(parser.diagnostics),
    }
}
