//! Where an item ends, and where the next one begins after a mistake.

use super::cursor::{Parsed, Parser};
use crate::syntax::token::{Symbol, Token, TokenKind};
use crate::syntax::words::ITEMS;

impl Parser<'_> {
    /// Takes the `;` of an item. Where it is missing and the next item follows, that is all that is wrong.
    pub(super) fn end_item(&mut self) -> Parsed<()> {
        if self.eat(Symbol::Semicolon).is_some() {
            return Ok(());
        }
        let complete = self.at_end() || self.starts_item(self.position) || self.at_doc();
        let reported = self.unexpected_at(self.gap(), "`;` after the statement", self.help_at_end());
        if complete { Ok(()) } else { Err(reported) }
    }

    /// Makes sure that all tokens are used, but for one last `;`.
    pub(super) fn expect_end(&mut self) -> Parsed<()> {
        self.eat(Symbol::Semicolon);
        if self.at_end() { Ok(()) } else { Err(self.unexpected("the end of the text", self.help_at_end())) }
    }

    /// What the token that stands where nothing should may have been meant as.
    fn help_at_end(&self) -> Option<&'static str> {
        match self.peek()? {
            _ if self.starts_item(self.position) => None,
            TokenKind::Symbol(Symbol::CloseParen | Symbol::CloseBracket | Symbol::CloseBrace) => {
                Some("no bracket is open here")
            }
            TokenKind::Symbol(Symbol::Comma) => Some("several values are written in brackets: `(a, b)`"),
            TokenKind::Symbol(Symbol::Equal) => Some("an equation is claimed: `prove name: left == right;`"),
            TokenKind::Name(word) if word == "where" => {
                Some("separate conditions with `,`, behind one `where`")
            }
            _ if self.looks_like_factor() => Some("write `*` between factors"),
            _ => None,
        }
    }

    fn at_doc(&self) -> bool {
        matches!(self.peek(), Some(TokenKind::Doc(_)))
    }

    /// Whether an item begins at token `at`: its word with a name behind it. The words of items are no names, so
    /// this cannot be the middle of an expression.
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

    /// After a mistake in the item that began at token `start`, goes behind its `;` or to where the next item
    /// begins. A `;` between the braces of `effects` is not the end; one in an unclosed round bracket is.
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

    /// Whether a semicolon stands in front of names alone and a closing bracket, as that in the head of a warp.
    fn is_before_names(&self, semicolon: usize) -> bool {
        let is_of_list =
            |token: &&Token| matches!(token.kind, TokenKind::Name(_) | TokenKind::Symbol(Symbol::Comma));
        let names = self.tokens[semicolon + 1..].iter().take_while(is_of_list).count();
        let end = self.tokens.get(semicolon + 1 + names).map(|token| &token.kind);
        names > 0 && end == Some(&TokenKind::Symbol(Symbol::CloseParen))
    }
}
