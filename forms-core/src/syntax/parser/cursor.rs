//! Cursor of the parser: access to the next tokens, and errors about unexpected ones.

use super::MAXIMUM_TOKENS;
use crate::diagnostic::{Diagnostic, Span};
use crate::syntax::ast::Name;
use crate::syntax::token::{Symbol, Token, TokenKind};
use crate::syntax::words::{self, Word};

/// Token stream being read, with the errors found so far.
pub(super) struct Parser<'a> {
    pub(super) tokens: &'a [Token],
    /// Index of the next token.
    pub(super) position: usize,
    end: Span,
    /// Number of nesting levels around the next token.
    pub(super) nesting: usize,
    pub(super) diagnostics: Vec<Diagnostic>,
    /// Whether words that only Rust reserves can be names.
    keywords_are_names: bool,
}

/// Error that has been reported; a function that receives it only has to return.
#[derive(Debug)]
pub(super) struct Reported;

pub(super) type Parsed<T> = Result<T, Reported>;

impl<'a> Parser<'a> {
    pub(super) fn new(tokens: &'a [Token], end: Span) -> Result<Self, Diagnostic> {
        match tokens.get(MAXIMUM_TOKENS) {
            None => Ok(Parser {
                tokens,
                position: 0,
                end,
                nesting: 0,
                diagnostics: Vec::new(),
                keywords_are_names: false,
            }),
            Some(surplus) => {
                let message = format!("a source has at most {MAXIMUM_TOKENS} names, numbers and symbols");
                Err(Diagnostic::new(surplus.span, message).with_help("split it into several files"))
            }
        }
    }

    /// Allows the words that only Rust reserves as names.
    pub(super) fn with_keywords_as_names(self) -> Self {
        Parser { keywords_are_names: true, ..self }
    }

    /// Returns the reason why `text` cannot be a name here; `None` if it can.
    pub(super) fn reserved(&self, text: &str) -> Option<Word> {
        words::reserved(text).filter(|word| !(self.keywords_are_names && *word == Word::Rust))
    }

    pub(super) fn peek(&self) -> Option<&'a TokenKind> {
        self.peek_at(0)
    }

    /// Returns the token `ahead` places after the next one.
    pub(super) fn peek_at(&self, ahead: usize) -> Option<&'a TokenKind> {
        self.tokens.get(self.position + ahead).map(|token| &token.kind)
    }

    /// Returns the place of the next token.
    pub(super) fn span(&self) -> Span {
        self.tokens.get(self.position).map_or(self.end, |token| token.span)
    }

    /// Returns the empty place directly after the previous token.
    pub(super) fn gap(&self) -> Span {
        match self.position.checked_sub(1) {
            Some(before) => Span::new(self.tokens[before].span.end, self.tokens[before].span.end),
            None => self.span(),
        }
    }

    /// Returns the place from `start` to the end of the previous token.
    pub(super) fn since(&self, start: Span) -> Span {
        start.to(self.gap())
    }

    pub(super) fn at_end(&self) -> bool {
        self.position >= self.tokens.len()
    }

    pub(super) fn at(&self, symbol: Symbol) -> bool {
        self.peek() == Some(&TokenKind::Symbol(symbol))
    }

    pub(super) fn at_word(&self, word: &str) -> bool {
        matches!(self.peek(), Some(TokenKind::Name(text)) if text == word)
    }

    /// Takes the next token if it is `symbol`, and returns its place.
    pub(super) fn eat(&mut self, symbol: Symbol) -> Option<Span> {
        let span = self.span();
        self.at(symbol).then(|| {
            self.position += 1;
            span
        })
    }

    pub(super) fn eat_word(&mut self, word: &str) -> bool {
        let found = self.at_word(word);
        self.position += usize::from(found);
        found
    }

    pub(super) fn expect(&mut self, symbol: Symbol) -> Parsed<Span> {
        match self.eat(symbol) {
            Some(span) => Ok(span),
            None => Err(self.unexpected(&format!("`{}`", symbol.text()), None)),
        }
    }

    /// Takes the bracket that closes the one at `open`; `expected` describes the tokens that are
    /// allowed here.
    pub(super) fn close(&mut self, open: Span, close: Symbol, expected: &str) -> Parsed<Span> {
        self.closing(open, close, expected, None)
    }

    /// Takes the bracket that closes the one at `open` after an expression, which an operator can
    /// continue: the user may have omitted a `*`.
    pub(super) fn close_expression(&mut self, open: Span, close: Symbol, expected: &str) -> Parsed<Span> {
        let help = self.looks_like_factor().then_some("write `*` between factors");
        self.closing(open, close, expected, help)
    }

    fn closing(&mut self, open: Span, close: Symbol, expected: &str, help: Option<&str>) -> Parsed<Span> {
        if let Some(span) = self.eat(close) {
            return Ok(span);
        }
        let before = self.diagnostics.len();
        let reported = self.unexpected(expected, help);
        if let Some(diagnostic) = self.diagnostics.get_mut(before) {
            let opening = match close {
                Symbol::CloseBracket => "[",
                Symbol::CloseBrace => "{",
                _ => "(",
            };
            diagnostic.related = Some((open, format!("the `{opening}` to close")));
        }
        Err(reported)
    }

    /// Takes a name that is not reserved; `role` describes the object it would name.
    pub(super) fn name(&mut self, role: &str) -> Parsed<Name> {
        let name = self.label(role)?;
        match self.reserved(&name.text) {
            None => Ok(name),
            Some(word) => Err(self.report(taken(&name, word))),
        }
    }

    /// Takes the name of a coordinate, parameter or argument. The name `d` is allowed, for a
    /// distance: the exterior derivative is always followed by a bracket.
    pub(super) fn quantity(&mut self, role: &str) -> Parsed<Name> {
        match self.peek() {
            Some(TokenKind::Name(text)) if text == "d" => self.label(role),
            _ => self.name(role),
        }
    }

    /// Takes the name of a statement or effect. These names are separate from all others, so `curl`
    /// is allowed.
    pub(super) fn label(&mut self, role: &str) -> Parsed<Name> {
        let Some(TokenKind::Name(text)) = self.peek() else {
            return Err(self.unexpected(role, None));
        };
        let name = Name { text: text.clone(), span: self.span() };
        match self.reserved(text) {
            // The word begins the next item, so a name is missing here.
            Some(Word::Item) if self.starts_item(self.position) => return Err(self.unexpected(role, None)),
            Some(word @ (Word::Item | Word::Rust)) => {
                self.position += 1;
                return Err(self.report(taken(&name, word)));
            }
            Some(Word::Function) | None => self.position += 1,
        }
        Ok(name)
    }

    /// Records an error.
    pub(super) fn report(&mut self, diagnostic: Diagnostic) -> Reported {
        self.diagnostics.push(diagnostic);
        Reported
    }

    /// Records that `expected` was expected instead of the next token.
    pub(super) fn unexpected(&mut self, expected: &str, help: Option<&str>) -> Reported {
        self.unexpected_at(self.span(), expected, help)
    }

    /// Records that `expected` was expected instead of the next token, and reports it at `place`.
    pub(super) fn unexpected_at(&mut self, place: Span, expected: &str, help: Option<&str>) -> Reported {
        if self.peek() == Some(&TokenKind::Unknown) {
            return Reported;
        }
        let mut diagnostic = Diagnostic::new(place, format!("expected {expected}, found {}", self.found()));
        diagnostic.help = help.map(str::to_owned);
        self.report(diagnostic)
    }

    /// Describes the next token for a message.
    fn found(&self) -> String {
        match self.peek() {
            None => "the end of the text".to_owned(),
            Some(TokenKind::Name(text) | TokenKind::Number(text)) if text.chars().count() > 30 => {
                format!("`{}…`", text.chars().take(30).collect::<String>())
            }
            Some(TokenKind::Name(text) | TokenKind::Number(text)) => format!("`{text}`"),
            Some(TokenKind::Doc(_)) => "a `///` comment".to_owned(),
            Some(TokenKind::Symbol(symbol)) => format!("`{}`", symbol.text()),
            Some(TokenKind::Unknown) => "unknown text".to_owned(),
        }
    }

    /// Whether the next token can be a factor of a product, in case the user omitted the `*`.
    pub(super) fn looks_like_factor(&self) -> bool {
        match self.peek() {
            Some(TokenKind::Name(text)) => !matches!(self.reserved(text), Some(Word::Item | Word::Rust)),
            Some(TokenKind::Number(_)) => true,
            Some(TokenKind::Symbol(symbol)) => matches!(symbol, Symbol::OpenParen | Symbol::At),
            _ => false,
        }
    }
}

/// Returns the error for a name that is a reserved word of Rust or of the language.
fn taken(name: &Name, word: Word) -> Diagnostic {
    let reason = match word {
        Word::Rust => "a Rust keyword",
        Word::Item => "a reserved word of the language",
        Word::Function => "a function of the language",
    };
    let help = match word {
        Word::Rust => {
            "names in macros cannot be Rust keywords, nor reserved words or functions of the language"
        }
        Word::Item | Word::Function => "names cannot be reserved words or functions of the language",
    };
    Diagnostic::new(name.span, format!("`{}` is {reason} and cannot be a name", name.text)).with_help(help)
}
