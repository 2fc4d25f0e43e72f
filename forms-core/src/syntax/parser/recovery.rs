//! Error recovery: the end of an item, and the start of the next one after an error.

use super::cursor::{Parsed, Parser};
use crate::syntax::token::{Symbol, Token, TokenKind};
use crate::syntax::words::ITEMS;

impl Parser<'_> {
    /// Takes the `;` of an item. If it is missing and the next item follows, the item is reported
    /// but kept.
    pub(super) fn end_item(&mut self) -> Parsed<()> {
        if self.eat(Symbol::Semicolon).is_some() {
            return Ok(());
        }
        let complete = self.at_end() || self.starts_item(self.position) || self.at_doc();
        let reported = self.unexpected_at(self.gap(), "`;` after the statement", self.help_at_end());
        if complete { Ok(()) } else { Err(reported) }
    }

    /// Checks that all tokens are used, except for one last `;`.
    pub(super) fn expect_end(&mut self) -> Parsed<()> {
        self.eat(Symbol::Semicolon);
        if self.at_end() { Ok(()) } else { Err(self.unexpected("the end of the text", self.help_at_end())) }
    }

    /// Guesses the intention of an unexpected token after the end.
    fn help_at_end(&self) -> Option<&'static str> {
        match self.peek()? {
            _ if self.starts_item(self.position) => None,
            TokenKind::Symbol(Symbol::CloseParen | Symbol::CloseBracket | Symbol::CloseBrace) => {
                Some("no bracket is open here")
            }
            TokenKind::Symbol(Symbol::Comma) => Some("several values are written in brackets: `(a, b)`"),
            TokenKind::Symbol(Symbol::Equal) => Some("an equation is claimed: `prove name: left == right;`"),
            TokenKind::Name(word) if word == "where" => {
                Some("separate conditions with `,` after a single `where`")
            }
            TokenKind::Name(word) if word == "approx" => {
                Some("an approximation has a formula before it: `= F by G approx 1e-10`")
            }
            TokenKind::Symbol(Symbol::Less | Symbol::LessEqual | Symbol::Greater | Symbol::GreaterEqual) => {
                Some("a choice is written `if x > 0 { a } else { b }`")
            }
            _ if self.looks_like_factor() => Some("write `*` between factors"),
            _ => None,
        }
    }

    fn at_doc(&self) -> bool {
        matches!(self.peek(), Some(TokenKind::Doc(_)))
    }

    /// Whether an item begins at token `at`: its keyword followed by a name. The keywords of items
    /// cannot be names, so this cannot be the middle of an expression.
    pub(super) fn starts_item(&self, at: usize) -> bool {
        let word = |at: usize| match self.tokens.get(at).map(|token| &token.kind) {
            Some(TokenKind::Name(text)) => Some(text.as_str()),
            _ => None,
        };
        match (word(at), word(at + 1)) {
            (Some("pub"), Some(next)) => ITEMS.contains(&next),
            (Some(first), Some(_)) => ITEMS.contains(&first),
            _ => false,
        }
    }

    /// Recovers from an error in the item that began at token `start`: skips past its `;`, or to
    /// the start of the next item. A `;` between the braces of `effects` is not the end; one in an
    /// unclosed round bracket is.
    pub(super) fn recover(&mut self, start: usize) {
        let mut braces = 0_usize;
        for at in start..self.tokens.len() {
            let is_behind = at >= self.position && at > start;
            if is_behind && self.starts_item(at) {
                self.position = at;
                return;
            }
            match self.tokens[at].kind {
                TokenKind::Symbol(Symbol::OpenBrace) => braces += 1,
                TokenKind::Symbol(Symbol::CloseBrace) => braces = braces.saturating_sub(1),
                TokenKind::Symbol(Symbol::Semicolon)
                    if at >= self.position && braces == 0 && !self.is_before_names(at) =>
                {
                    self.position = at + 1;
                    return;
                }
                _ => {}
            }
        }
        self.position = self.tokens.len();
    }

    /// Whether a semicolon is followed only by names and a closing bracket, as in the head of a
    /// warp.
    fn is_before_names(&self, semicolon: usize) -> bool {
        let is_of_list =
            |token: &&Token| matches!(token.kind, TokenKind::Name(_) | TokenKind::Symbol(Symbol::Comma));
        let names = self.tokens[semicolon + 1..].iter().take_while(is_of_list).count();
        let end = self.tokens.get(semicolon + 1 + names).map(|token| &token.kind);
        names > 0 && end == Some(&TokenKind::Symbol(Symbol::CloseParen))
    }
}
