//! Tokens as delivered by the lexer and by the macros: brackets are plain tokens; comments and
//! spaces are removed.

use crate::diagnostic::Span;

/// Token with its place in the source.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Token {
    /// Its kind.
    pub kind: TokenKind,
    /// Its place.
    pub span: Span,
}

/// Kind of a token, with its text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TokenKind {
    /// Name or word: `[A-Za-z_][A-Za-z_0-9]*`.
    Name(String),
    /// Number as written: `12`, `0.5`, `1e-3`.
    Number(String),
    /// Text of one `///` line, without the slashes.
    Doc(String),
    /// Punctuation.
    Symbol(Symbol),
    /// Text that is not part of the language. The producer of the token has reported it, so the
    /// parser does not.
    Unknown,
}

macro_rules! symbols {
    ($($name:ident $text:literal,)*) => {
        /// Punctuation of the language.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Symbol { $(#[doc = concat!("`", $text, "`")] $name,)* }

        impl Symbol {
            /// All symbols, longer spellings first, so that the first match of a text is the right
            /// one.
            pub const ALL: &'static [Symbol] = &[$(Symbol::$name,)*];

            /// Returns its spelling.
            pub fn text(self) -> &'static str {
                match self { $(Symbol::$name => $text,)* }
            }
        }
    };
}

symbols! {
    Power "**", Equal "==", NotEqual "!=", LessEqual "<=", GreaterEqual ">=", Arrow "->", Range "..",
    Less "<", Greater ">", Assign "=", Plus "+", Minus "-", Star "*", Slash "/", Wedge "^", At "@",
    Comma ",", Semicolon ";", Colon ":", OpenParen "(", CloseParen ")", OpenBracket "[", CloseBracket "]",
    OpenBrace "{", CloseBrace "}",
}
