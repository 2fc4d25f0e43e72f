//! The tokens both doors deliver: brackets are plain tokens, comments and spaces are gone.

use crate::diagnostic::Span;

/// A token and the place it came from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Token {
    /// What it is.
    pub kind: TokenKind,
    /// Where it stands.
    pub span: Span,
}

/// What a token is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TokenKind {
    /// A name or word: `[A-Za-z_][A-Za-z_0-9]*`.
    Name(String),
    /// A number as written: `12`, `0.5`, `1e-3`.
    Number(String),
    /// The text of one `///` line, without the slashes.
    Doc(String),
    /// Punctuation.
    Symbol(Symbol),
    /// Something that is not of the language; whoever made the token has reported it, so the parser is silent.
    Unknown,
}

macro_rules! symbols {
    ($($name:ident $text:literal,)*) => {
        /// Punctuation of the language.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Symbol { $(#[doc = concat!("`", $text, "`")] $name,)* }

        impl Symbol {
            /// Every symbol, the longer spellings first, so that the first match of a text is the right one.
            pub const ALL: &'static [Symbol] = &[$(Symbol::$name,)*];

            /// How it is written.
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
