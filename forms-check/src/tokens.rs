//! Lexer and reader: a text as numbers, names and signs, and a cursor over them.

use crate::{Stop, malformed};
use num_bigint::BigInt;
use num_rational::BigRational;
use std::rc::Rc;

/// Number, name or sign.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Token {
    Number(BigRational),
    Name(String),
    Sign(&'static str),
    /// Character unknown to the checker: an item that contains it is not covered.
    Unknown(char),
}

/// Maximum number of digits of a number, and of the magnitude of its power of ten.
const LONGEST_NUMBER: usize = 10_000;

const SIGNS: [&str; 25] = [
    "**", "==", "<=", ">=", "!=", "->", "..", "+", "-", "*", "/", "^", "(", ")", "[", "]", "{", "}", ",",
    ";", ":", "=", "<", ">", "@",
];

/// Cursor in a text.
#[derive(Clone, Debug)]
pub(crate) struct Reader {
    /// Tokens with their places in the text.
    tokens: Rc<Vec<(Token, usize)>>,
    pub(crate) place: usize,
    /// Number of open brackets and signs.
    pub(crate) depth: usize,
}

/// Characters that end a line, and with it a comment, in at least one editor.
const LINE_ENDS: [char; 7] = ['\n', '\r', '\u{b}', '\u{c}', '\u{85}', '\u{2028}', '\u{2029}'];

impl Reader {
    pub(crate) fn new(text: &str) -> Result<Self, Stop> {
        let mut tokens = Vec::new();
        let mut rest = text.trim_start();
        while let Some(first) = rest.chars().next() {
            let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
            let length = match first {
                '/' if rest.starts_with("//") => rest.find(LINE_ENDS).unwrap_or(rest.len()),
                '0'..='9' => number_length(rest.as_bytes()),
                _ => rest.find(|c| !is_word(c)).unwrap_or(rest.len()),
            };
            let place = text.len() - rest.len();
            let (word, after) = rest.split_at(length);
            rest = after;
            if first.is_ascii_digit() {
                let value = number(word).ok_or_else(|| malformed(format!("invalid number `{word}`")))?;
                tokens.push((Token::Number(value), place));
            } else if is_word(first) {
                tokens.push((Token::Name(word.to_string()), place));
            } else if word.is_empty() {
                let sign = SIGNS.iter().find(|sign| rest.starts_with(**sign));
                tokens.push((sign.map_or(Token::Unknown(first), |sign| Token::Sign(sign)), place));
                rest = &rest[sign.map_or(first.len_utf8(), |sign| sign.len())..];
            }
            rest = rest.trim_start();
        }
        Ok(Reader { tokens: Rc::new(tokens), place: 0, depth: 0 })
    }

    pub(crate) fn peek(&self) -> Option<&Token> {
        self.tokens.get(self.place).map(|token| &token.0)
    }

    /// Returns the place of the next token in the text.
    pub(crate) fn offset(&self) -> usize {
        self.tokens.get(self.place).map_or(0, |token| token.1)
    }

    /// Returns the variables of the ranges `, u = a..b` before the closing bracket.
    pub(crate) fn ranged_names(&self) -> Vec<String> {
        let (mut open, mut names) = (0_usize, Vec::new());
        for (place, (token, _)) in self.tokens.iter().enumerate().skip(self.place) {
            match token {
                Token::Sign("(" | "[") => open += 1,
                Token::Sign(")" | "]") if open == 0 => break,
                Token::Sign(")" | "]") => open -= 1,
                Token::Sign(",") if open == 0 => {
                    if let [(Token::Name(name), _), (Token::Sign("="), _), ..] = &self.tokens[place + 1..] {
                        names.push(name.clone());
                    }
                }
                _ => {}
            }
        }
        names
    }

    pub(crate) fn take(&mut self, sign: &str) -> bool {
        let found = matches!(self.peek(), Some(Token::Sign(s)) if *s == sign);
        self.place += usize::from(found);
        found
    }

    pub(crate) fn one_of(&mut self, signs: &[&'static str]) -> Option<&'static str> {
        signs.iter().find(|sign| self.take(sign)).copied()
    }

    pub(crate) fn expect(&mut self, sign: &str) -> Result<(), Stop> {
        if self.take(sign) { Ok(()) } else { Err(self.wrong(sign)) }
    }

    /// Checks that a sign is next, without taking it.
    pub(crate) fn following(&self, sign: &str) -> Result<(), Stop> {
        self.clone().expect(sign)
    }

    pub(crate) fn wrong(&self, wanted: &str) -> Stop {
        malformed(format!("expected {wanted}, found {:?} (token {})", self.peek(), self.place))
    }

    pub(crate) fn word(&mut self, word: &str) -> bool {
        let found = matches!(self.peek(), Some(Token::Name(name)) if name == word);
        self.place += usize::from(found);
        found
    }

    pub(crate) fn name(&mut self) -> Result<String, Stop> {
        let Some(Token::Name(name)) = self.peek().cloned() else { return Err(self.wrong("a name")) };
        self.place += 1;
        Ok(name)
    }

    /// Whether a name occurs after the first equals sign between a place and the current one.
    pub(crate) fn defines_by(&self, name: &str, from: usize) -> bool {
        let body = self.tokens[from..self.place].iter().map(|token| &token.0);
        let mut body = body.skip_while(|token| **token != Token::Sign("="));
        body.any(|token| matches!(token, Token::Name(own) if own == name))
    }

    /// Takes the names of a declaration, separated by a sign; units are skipped.
    pub(crate) fn names(&mut self, separator: &str) -> Result<Vec<String>, Stop> {
        let mut names = Vec::new();
        while names.is_empty() || self.take(separator) {
            names.push(self.name()?);
            self.pass_unit();
        }
        Ok(names)
    }

    /// Skips `: unit`, which can have an exponent in brackets.
    pub(crate) fn pass_unit(&mut self) {
        if !self.take(":") {
            return;
        }
        let is = |token: &Token, sign: &'static str| *token == Token::Sign(sign);
        let mut open = 0_usize;
        while let Some(token) = self.peek() {
            let ends = match token {
                Token::Name(name) => name == "where",
                other => [",", ")", ";"].iter().any(|sign| is(other, sign)),
            };
            if open == 0 && ends {
                return;
            }
            open = (open + usize::from(is(token, "("))).saturating_sub(usize::from(is(token, ")")));
            self.place += 1;
        }
    }

    /// Skips past the end of an item; semicolons in brackets do not end it.
    pub(crate) fn pass_item(&mut self) {
        let mut open = 0_usize;
        while let Some(token) = self.peek() {
            open += usize::from(["{", "("].iter().any(|bracket| *token == Token::Sign(bracket)));
            open -= usize::from(["}", ")"].iter().any(|bracket| *token == Token::Sign(bracket))).min(open);
            let ends = open == 0 && *token == Token::Sign(";");
            self.place += 1;
            if ends {
                break;
            }
        }
    }
}

/// Returns the length of a number: digits, a fraction, an exponent. The dots of a range are not
/// part of it.
fn number_length(text: &[u8]) -> usize {
    let is_digit = |at: usize| text.get(at).is_some_and(u8::is_ascii_digit);
    let digits = |from: usize| (from..).find(|at| !is_digit(*at)).unwrap_or(from);
    let mut end = digits(0);
    if text.get(end) == Some(&b'.') && is_digit(end + 1) {
        end = digits(end + 1);
    }
    let sign = usize::from(matches!(text.get(end + 1), Some(b'+' | b'-')));
    let has_exponent = matches!(text.get(end), Some(b'e' | b'E')) && is_digit(end + 1 + sign);
    if has_exponent { digits(end + 1 + sign) } else { end }
}

fn number(text: &str) -> Option<BigRational> {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let exponent: i32 =
        exponent.parse().ok().filter(|e: &i32| e.unsigned_abs() as usize <= LONGEST_NUMBER)?;
    if whole.len() + part.len() > LONGEST_NUMBER {
        return None;
    }
    let digits: BigInt = format!("{whole}{part}").parse().ok()?;
    Some(
        BigRational::from_integer(digits)
            * BigRational::from_integer(10.into()).pow(exponent - part.len() as i32),
    )
}
