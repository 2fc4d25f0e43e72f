//! Converts Rust tokens to tokens of the language, with the Rust spans of each.
//!
//! ```text
//! names, numbers ─────────────┐
//! runs of joint punctuation ──┼─ the text lexer ─▶ Token 0, Token 1, …
//! brackets, #[doc = "…"] ─────┘                    places[0], places[1], …
//! ```
//! The spelling of each piece goes through the lexer of `.forms` files. Macro bodies and files
//! therefore yield the same tokens and the same messages about invalid ones. The span of a token is
//! its index.

use forms_core::diagnostic::{Diagnostic, Span};
use forms_core::syntax::lex;
use forms_core::syntax::token::{Symbol, Token, TokenKind};
use proc_macro2::{Delimiter, Group, Punct, Spacing, TokenStream, TokenTree, token_stream};
use std::iter::Peekable;

/// Macro body as tokens of the language.
#[derive(Default)]
pub(crate) struct Body {
    pub(crate) tokens: Vec<Token>,
    /// Errors about text that is not part of the language.
    pub(crate) diagnostics: Vec<Diagnostic>,
    /// Start and end of each token in the user's source.
    pub(crate) places: Vec<(proc_macro2::Span, proc_macro2::Span)>,
}

impl Body {
    /// Returns the empty span after the last token.
    pub(crate) fn end(&self) -> Span {
        let end = number(self.tokens.len());
        Span::new(end, end)
    }

    fn push(&mut self, kind: TokenKind, first: proc_macro2::Span, last: proc_macro2::Span) -> Span {
        let here = number(self.tokens.len());
        let span = Span::new(here, here + 1);
        self.tokens.push(Token { kind, span });
        self.places.push((first, last));
        span
    }

    /// Lexes a spelling and appends its tokens. `parts` holds the first byte and the Rust span of
    /// each part of the spelling.
    fn spelled(&mut self, text: &str, parts: &[(usize, proc_macro2::Span)]) {
        let place = |offset: u32| {
            let after = parts.partition_point(|&(start, _)| start <= offset as usize);
            parts[after.saturating_sub(1)].1
        };
        let (tokens, diagnostics) = lex(text);
        let mut diagnostics = diagnostics.into_iter().peekable();
        for token in tokens {
            let Span { start, end } = token.span;
            let span = self.push(token.kind, place(start), place(end.saturating_sub(1)));
            if let Some(diagnostic) = diagnostics.next_if(|diagnostic| diagnostic.span == token.span) {
                self.diagnostics.push(Diagnostic { span, ..diagnostic });
            }
        }
    }

    /// Appends one Rust token. It becomes a single error if its spelling contains any.
    fn single(&mut self, text: &str, place: proc_macro2::Span) {
        let (tokens, diagnostics) = lex(text);
        match diagnostics.into_iter().next() {
            None => {
                for token in tokens {
                    self.push(token.kind, place, place);
                }
            }
            Some(diagnostic) => {
                let span = self.push(TokenKind::Unknown, place, place);
                self.diagnostics.push(Diagnostic { span, ..diagnostic });
            }
        }
    }

    /// Appends a doc comment, which can have several lines.
    fn docs(&mut self, text: &str, place: proc_macro2::Span) {
        for line in text.split('\n') {
            self.push(TokenKind::Doc(line.to_owned()), place, place);
        }
    }
}

/// Converts an index to 32 bits. The parser rejects a body that is too long for this, whatever its
/// spans.
fn number(place: usize) -> u32 {
    u32::try_from(place).unwrap_or(u32::MAX - 1)
}

/// Reads a macro's body.
pub(crate) fn read(stream: TokenStream) -> Body {
    let mut body = Body::default();
    let mut levels = vec![Level { rest: stream.into_iter().peekable(), close: None }];
    while let Some(level) = levels.last_mut() {
        match level.rest.next() {
            None => {
                if let Some((symbol, place)) = level.close {
                    body.push(TokenKind::Symbol(symbol), place, place);
                }
                levels.pop();
            }
            Some(TokenTree::Group(group)) => levels.push(open(&mut body, &group)),
            Some(TokenTree::Ident(name)) => body.single(&name.to_string(), name.span()),
            Some(TokenTree::Literal(literal)) => body.single(&literal.to_string(), literal.span()),
            Some(TokenTree::Punct(punct)) => punctuation(&mut body, punct, &mut level.rest),
        }
    }
    body
}

type Rest = Peekable<token_stream::IntoIter>;

/// Unread tokens between two brackets, and the closing bracket.
struct Level {
    rest: Rest,
    close: Option<(Symbol, proc_macro2::Span)>,
}

/// Appends an opening bracket. An expression that a `macro_rules!` macro passes on as one group is
/// wrapped in round brackets, unless it is a single token.
fn open(body: &mut Body, group: &Group) -> Level {
    let rest = group.stream().into_iter().peekable();
    let symbols = match group.delimiter() {
        Delimiter::Parenthesis => Some((Symbol::OpenParen, Symbol::CloseParen)),
        Delimiter::Bracket => Some((Symbol::OpenBracket, Symbol::CloseBracket)),
        Delimiter::Brace => Some((Symbol::OpenBrace, Symbol::CloseBrace)),
        Delimiter::None if group.stream().into_iter().nth(1).is_none() => None,
        Delimiter::None => Some((Symbol::OpenParen, Symbol::CloseParen)),
    };
    let close = symbols.map(|(open, close)| {
        body.push(TokenKind::Symbol(open), group.span_open(), group.span_open());
        (close, group.span_close())
    });
    Level { rest, close }
}

/// Appends a run of punctuation without spaces, or a doc comment.
fn punctuation(body: &mut Body, first: Punct, rest: &mut Rest) {
    let mut text = String::from(first.as_char());
    let mut parts = vec![(0, first.span())];
    let mut spacing = first.spacing();
    while let Some(TokenTree::Punct(next)) = rest.peek() {
        let begins_inner_attribute = text == "#" && next.as_char() == '!';
        let place = next.span();
        if spacing == Spacing::Alone && !begins_inner_attribute && !touch(parts[parts.len() - 1].1, place) {
            break;
        }
        parts.push((text.len(), place));
        text.push(next.as_char());
        spacing = next.spacing();
        rest.next();
    }
    match rest.peek() {
        Some(TokenTree::Group(group)) if text == "#" || text == "#!" => {
            if let Some(lines) = doc_text(group) {
                // `//!` is an ordinary comment of the language.
                if text == "#" {
                    body.docs(&lines, group.span());
                }
                rest.next();
                return;
            }
        }
        // `.5` is meant as one number.
        Some(TokenTree::Literal(literal)) if text.ends_with('.') && !text.ends_with("..") => {
            parts.push((text.len(), literal.span()));
            text.push_str(&literal.to_string());
            rest.next();
        }
        _ => {}
    }
    body.spelled(&text, &parts);
}

/// Whether one token begins where the other ends. A `macro_rules!` macro does not record that the
/// two signs of `**` are joint.
fn touch(first: proc_macro2::Span, next: proc_macro2::Span) -> bool {
    first.end() == next.start()
}

/// Returns the text of `[doc = "…"]`, the form to which Rust converts `/// …`.
fn doc_text(group: &Group) -> Option<String> {
    let mut inside = group.stream().into_iter();
    let (Some(TokenTree::Ident(word)), Some(TokenTree::Punct(assign)), Some(TokenTree::Literal(text)), None) =
        (inside.next(), inside.next(), inside.next(), inside.next())
    else {
        return None;
    };
    if group.delimiter() != Delimiter::Bracket || word != "doc" || assign.as_char() != '=' {
        return None;
    }
    syn::parse_str::<syn::LitStr>(&text.to_string()).ok().map(|text| text.value())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::str::FromStr;

    fn kinds(tokens: Vec<Token>) -> Vec<TokenKind> {
        tokens.into_iter().map(|token| token.kind).collect()
    }

    fn from_rust(text: &str) -> Body {
        read(TokenStream::from_str(text).expect("Rust can read it"))
    }

    /// Lexes a text both as a file and as a macro body; returns the tokens and the messages of
    /// each.
    fn both(text: &str) -> [(Vec<TokenKind>, Vec<String>); 2] {
        let body = from_rust(text);
        let (tokens, diagnostics) = lex(text);
        let messages = |all: Vec<Diagnostic>| all.into_iter().map(|one| one.message).collect();
        [(kinds(tokens), messages(diagnostics)), (kinds(body.tokens), messages(body.diagnostics))]
    }

    #[test]
    fn every_case_file_has_the_same_tokens_through_both_doors() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/cases");
        let files: Vec<_> = std::fs::read_dir(folder).expect("the workspace has its case files").collect();
        assert!(files.len() >= 20, "only {} case files", files.len());
        for file in files {
            let path = file.expect("the folder can be read").path();
            let text = std::fs::read_to_string(&path).expect("case files are UTF-8");
            let [text_door, rust_door] = both(&text);
            assert_eq!(text_door, rust_door, "{}", path.display());
        }
    }

    #[test]
    fn spellings_that_rust_reads_differently_mean_the_same() {
        for text in [
            "r**-2",
            "x**-y",
            "x** -y",
            "x* *y",
            "x - -y",
            "x--y",
            "2**-1/2",
            "0..1",
            "0.5..1.5",
            "u = a..b",
            "dx^dy",
            "@x",
            "x*@x+y*@y",
            "d[R3](w)",
            "w[dy^dx]",
            "1e-3",
            "1E5",
            "1e+3*x",
            "0.5e10",
            "x<-1",
            "x<=-1",
            "a!=b",
            "a==-b",
            "F: A->B",
            "F:A -> B",
            "f(-1)",
            "0<theta<pi",
            "a>=b",
            "a> =b",
            "{ a: b = 0; }",
            "/// a line\n/// \"quoted\" \\ and é\n///\nlet r = 1;",
            "// gone\nx",
            "//! gone\nx",
            "x/y/z",
            "a::b",
            "_x1",
            "x<<y",
            "a=>b",
            "(((x)))",
            "[[x]]",
        ] {
            let [text_door, rust_door] = both(text);
            assert_eq!(text_door, rust_door, "{text}");
        }
    }

    #[test]
    fn what_is_not_of_the_language_is_the_same_mistake_through_both_doors() {
        for text in [
            "2x", "1_000", "0x10", "1.", ".5", "x*.5", "1.5f64", "a & b", "a && b", "a | b", "!a", "a % b",
            "θ", "xθ", "\"text\"", "'c'", "a ? b", "$x", "~x", "#x", "x.y",
        ] {
            let [text_door, rust_door] = both(text);
            assert_eq!(text_door.1.first(), rust_door.1.first(), "{text}");
            assert_eq!(rust_door.1.len(), 1, "{text}: {:?}", rust_door.1);
        }
    }

    #[test]
    fn a_span_is_the_number_of_its_token() {
        let body = from_rust(
            "x**-2 /// doc
 + (θ)",
        );
        for (number, token) in (0..).zip(&body.tokens) {
            assert_eq!(token.span, Span::new(number, number + 1));
        }
        assert_eq!(body.places.len(), body.tokens.len());
        let unknown = body.tokens.iter().find(|token| token.kind == TokenKind::Unknown);
        assert_eq!(unknown.map(|token| token.span), body.diagnostics.first().map(|mistake| mistake.span));
    }

    #[test]
    fn what_another_macro_passes_on_as_one_expression_stays_together() {
        let sum =
            TokenTree::Group(Group::new(Delimiter::None, TokenStream::from_str("a + b").expect("Rust")));
        let product: TokenStream =
            TokenStream::from_str("2 *").expect("Rust").into_iter().chain([sum]).collect();
        assert_eq!(kinds(read(product).tokens), kinds(lex("2*(a + b)").0));
        let name = TokenTree::Group(Group::new(Delimiter::None, TokenStream::from_str("a").expect("Rust")));
        assert_eq!(kinds(read(name.into()).tokens), kinds(lex("a").0));
    }

    #[test]
    fn a_negative_number_from_another_macro_is_a_sign_and_a_number() {
        let literal = TokenTree::Literal(proc_macro2::Literal::i32_unsuffixed(-2));
        assert_eq!(kinds(read(literal.into()).tokens), kinds(lex("-2").0));
    }
}
