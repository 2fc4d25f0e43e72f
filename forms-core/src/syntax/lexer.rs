//! Lexer: text in, tokens out. Comments and spaces are dropped; every token keeps its byte offsets.
//!
//! Each piece of text that is not part of the language becomes one diagnostic and one
//! [`TokenKind::Unknown`].

use super::number;
use super::token::{Symbol, Token, TokenKind};
use crate::diagnostic::{Diagnostic, Span};

/// Spelling in the language of each character of mathematical typesetting.
const TYPESET: &[(char, &str)] = &[
    ('∧', "`^`"),
    ('⋀', "`^`"),
    ('·', "`*`"),
    ('⋅', "`*`"),
    ('×', "`*`"),
    ('∗', "`*`"),
    ('÷', "`/`"),
    ('∕', "`/`"),
    ('⁄', "`/`"),
    ('−', "`-`"),
    ('–', "`-`"),
    ('—', "`-`"),
    ('√', "`sqrt(…)`"),
    ('≤', "`<=`"),
    ('≥', "`>=`"),
    ('⩽', "`<=`"),
    ('⩾', "`>=`"),
    ('≠', "`!=`"),
    ('→', "`->`"),
    ('↦', "`->`"),
    ('≡', "`==`"),
    ('…', "`..`"),
    ('²', "`**2`"),
    ('³', "`**3`"),
    ('¹', "`**1`"),
    ('⁰', "`**0`"),
    ('⁴', "`**4`"),
    ('⁵', "`**5`"),
    ('⁶', "`**6`"),
    ('⁷', "`**7`"),
    ('⁸', "`**8`"),
    ('⁹', "`**9`"),
    ('⁻', "`**-…`"),
    ('½', "`1/2`"),
    ('∂', "`diff(f, x)` or `@x`"),
    ('∇', "`grad`, `curl` or `div`"),
    ('∫', "`integral(w, x = a..b)`"),
    ('⋆', "`hodge[g](w)`"),
    ('★', "`hodge[g](w)`"),
    ('Δ', "`laplace[g](w)`"),
    ('♭', "`flat[g](X)`"),
    ('♯', "`sharp[g](w)`"),
    ('α', "`alpha`"),
    ('β', "`beta`"),
    ('γ', "`gamma`"),
    ('δ', "`delta`"),
    ('ε', "`epsilon`"),
    ('ϵ', "`epsilon`"),
    ('ζ', "`zeta`"),
    ('η', "`eta`"),
    ('θ', "`theta`"),
    ('ϑ', "`theta`"),
    ('ι', "`iota`"),
    ('κ', "`kappa`"),
    ('λ', "`lambda`"),
    ('μ', "`mu`"),
    ('µ', "`mu`"),
    ('ν', "`nu`"),
    ('ξ', "`xi`"),
    ('π', "`pi`"),
    ('ρ', "`rho`"),
    ('σ', "`sigma`"),
    ('ς', "`sigma`"),
    ('τ', "`tau`"),
    ('υ', "`upsilon`"),
    ('φ', "`phi`"),
    ('ϕ', "`phi`"),
    ('χ', "`chi`"),
    ('ψ', "`psi`"),
    ('ω', "`omega`"),
    ('Γ', "`Gamma`"),
    ('Θ', "`Theta`"),
    ('Λ', "`Lambda`"),
    ('Ξ', "`Xi`"),
    ('Π', "`Pi`"),
    ('Σ', "`Sigma`"),
    ('Φ', "`Phi`"),
    ('Ψ', "`Psi`"),
    ('Ω', "`Omega`"),
    ('\u{a0}', "an ordinary space"),
    ('\u{202f}', "an ordinary space"),
    ('\u{2009}', "an ordinary space"),
];

/// Splits a text into tokens; returns them with the diagnostics for unknown text. Doc comments keep
/// the space after their slashes.
pub fn lex(text: &str) -> (Vec<Token>, Vec<Diagnostic>) {
    if u32::try_from(text.len()).is_err() {
        let message = format!("a text has at most {} bytes", u32::MAX);
        return (Vec::new(), vec![Diagnostic::new(Span::default(), message)]);
    }
    let mut lexer =
        Lexer { text, position: 0, tokens: Vec::with_capacity(text.len() / 4), diagnostics: Vec::new() };
    lexer.skip_byte_order_mark();
    while lexer.position < text.len() {
        lexer.step();
    }
    (lexer.tokens, lexer.diagnostics)
}

struct Lexer<'a> {
    text: &'a str,
    position: usize,
    tokens: Vec<Token>,
    diagnostics: Vec<Diagnostic>,
}

impl<'a> Lexer<'a> {
    /// Skips the invisible byte order mark that some editors put before the first character.
    fn skip_byte_order_mark(&mut self) {
        if self.text.starts_with('\u{feff}') {
            self.position = '\u{feff}'.len_utf8();
        }
    }

    fn rest(&self) -> &'a str {
        &self.text[self.position..]
    }

    /// Takes one token, comment or run of spaces.
    fn step(&mut self) {
        let rest = self.rest();
        let length_while = |is: fn(u8) -> bool| rest.bytes().take_while(|&byte| is(byte)).count();
        match rest.as_bytes()[0] {
            byte if byte.is_ascii_whitespace() => self.position += length_while(|b| b.is_ascii_whitespace()),
            byte if byte.is_ascii_alphabetic() || byte == b'_' => {
                let length = length_while(|b| b.is_ascii_alphanumeric() || b == b'_');
                self.push(length, TokenKind::Name(rest[..length].to_owned()));
            }
            _ if starts_number(rest) => self.number(),
            b'/' if rest.starts_with("//") => self.line_comment(),
            b'/' if rest.starts_with("/*") => self.block_comment(),
            _ => match symbol(rest) {
                Some(symbol) => self.push(symbol.text().len(), TokenKind::Symbol(symbol)),
                None => self.unknown(),
            },
        }
    }

    /// Takes `length` bytes as one token.
    fn push(&mut self, length: usize, kind: TokenKind) {
        let span = self.span(length);
        self.tokens.push(Token { kind, span });
        self.position += length;
    }

    /// Takes `length` bytes as one error.
    fn reject(&mut self, length: usize, message: String, help: Option<String>) {
        let mut diagnostic = Diagnostic::new(self.span(length), message);
        diagnostic.help = help;
        self.diagnostics.push(diagnostic);
        self.push(length, TokenKind::Unknown);
    }

    fn span(&self, length: usize) -> Span {
        let place = |offset: usize| u32::try_from(offset).expect("the text's length was checked");
        Span::new(place(self.position), place(self.position + length))
    }

    fn number(&mut self) {
        let text = &self.rest()[..number::extent(self.rest())];
        match number::check(text) {
            Ok(()) => self.push(text.len(), TokenKind::Number(text.to_owned())),
            Err(malformed) => self.reject(text.len(), malformed.message, malformed.help),
        }
    }

    /// Drops `// …` and keeps `/// …`; four or more slashes are a plain comment, as in Rust. The
    /// comment ends where any editor ends a line, so that a statement that is displayed on its own
    /// line is never part of a comment.
    fn line_comment(&mut self) {
        let line = self.rest().split(LINE_ENDS).next().unwrap_or("");
        match line.strip_prefix("///").filter(|text| !text.starts_with('/')) {
            Some(text) => self.push(line.len(), TokenKind::Doc(text.to_owned())),
            None => self.position += line.len(),
        }
    }

    fn block_comment(&mut self) {
        let length = self.rest().find("*/").map_or(self.rest().len(), |end| end + "*/".len());
        let message = "block comments are not part of the language".to_owned();
        self.reject(length, message, Some("write `//` before each line".to_owned()));
    }

    /// Takes a run of characters with which no token begins; a quoted text is one error.
    fn unknown(&mut self) {
        let rest = self.rest();
        let first = rest.chars().next().expect("the lexer stops at the end of the text");
        let is_unknown = |(at, c): &(usize, char)| !begins_something(*c, &rest[*at..]);
        // The run is computed only if it is needed: in a sequence of many quoted texts, a run from
        // each of them would reach to the end.
        let run = || rest.char_indices().take_while(is_unknown).map(|(_, c)| c.len_utf8()).sum();
        let length = quotation(rest, first).unwrap_or_else(run);
        let shown = if first.is_control() || first.is_whitespace() || is_invisible(first) {
            format!("U+{:04X}", u32::from(first))
        } else {
            format!("`{first}`")
        };
        self.reject(
            length,
            format!("unexpected character {shown}"),
            replacement(&rest[..length], &rest[length..]),
        );
    }
}

/// Characters that end a line in at least one editor.
const LINE_ENDS: [char; 7] = ['\n', '\r', '\u{b}', '\u{c}', '\u{85}', '\u{2028}', '\u{2029}'];

/// Number of characters searched for a closing quotation mark.
const LONGEST_QUOTATION: usize = 100;

/// Returns the length of a quoted text, including the closing mark, if one begins here and ends on
/// the same line.
fn quotation(text: &str, open: char) -> Option<usize> {
    let close = match open {
        '"' | '\'' | '`' => open,
        '“' | '„' => '”',
        '‘' => '’',
        '«' => '»',
        _ => return None,
    };
    let mut inside = text.char_indices().skip(1).take(LONGEST_QUOTATION).take_while(|&(_, c)| c != '\n');
    inside.find(|&(_, c)| c == close).map(|(at, _)| at + close.len_utf8())
}

fn starts_number(text: &str) -> bool {
    text.strip_prefix('.').unwrap_or(text).starts_with(|c: char| c.is_ascii_digit())
}

/// Returns the longest symbol with which a text begins.
fn symbol(text: &str) -> Option<Symbol> {
    let first = text.as_bytes().first()?;
    let begins = |symbol: &&Symbol| symbol.text().as_bytes()[0] == *first && text.starts_with(symbol.text());
    Symbol::ALL.iter().find(begins).copied()
}

fn begins_something(c: char, rest: &str) -> bool {
    c.is_ascii_whitespace()
        || c.is_ascii_alphanumeric()
        || c == '_'
        || starts_number(rest)
        || symbol(rest).is_some()
}

/// Whether a character is a zero-width or direction mark, which would be invisible in a message.
fn is_invisible(c: char) -> bool {
    matches!(c, '\u{ad}' | '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}')
}

/// Suggests a replacement for a run of unknown characters, which is followed by `rest`.
fn replacement(run: &str, rest: &str) -> Option<String> {
    let first = run.chars().next()?;
    let is_before_name = rest.starts_with(|c: char| c.is_ascii_alphabetic());
    let mut after_first = rest.chars().skip(1);
    let is_before_component =
        rest.starts_with(['x', 'y', 'z', 'w']) && !after_first.next().is_some_and(char::is_alphanumeric);
    let written = |text: &str| Some(format!("write {text}"));
    let told = match run {
        "&" | "&&" => "separate conditions with `,`",
        "|" if is_before_name => "write `abs(x)` for an absolute value",
        "|" | "||" => "conditions all hold at once; state alternatives separately",
        "!" => "write `!=` for “not equal”",
        "." if is_before_component => "components of an array are numbered: `p[0]`, `p[1]`",
        "." if is_before_name => "a function stands before its argument: `sin(x)`",
        "." => "write `..` for a range",
        "?" => "write `if x > 0 { a } else { b }` for a choice",
        _ => "",
    };
    if !told.is_empty() {
        return Some(told.to_owned());
    }
    if let Some((_, text)) = TYPESET.iter().find(|(c, _)| *c == first) {
        return written(text);
    }
    match first {
        '"' | '\'' | '`' | '“' | '”' | '„' | '‘' | '’' | '«' | '»' | '′' => {
            Some("names and numbers are written without quotes".to_owned())
        }
        '%' => Some("there is no remainder or percentage".to_owned()),
        c if c.is_alphabetic() => Some("names are made of ASCII letters, digits and `_`".to_owned()),
        _ => None,
    }
}
