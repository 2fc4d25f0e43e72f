//! Sizes: lines of files and functions, columns of lines.

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::collections::BTreeSet;

/// A function and its number of lines, from `fn` to the closing brace.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Function {
    /// Name of the function.
    pub name: String,
    /// Line of its `fn`, from 1.
    pub line: usize,
    /// Number of lines.
    pub lines: usize,
}

/// Returns the functions of a source, those inside other items included.
///
/// # Panics
/// If the source is not valid Rust tokens.
pub fn functions(source: &str) -> Vec<Function> {
    let tokens: TokenStream = source.parse().expect("a source is valid tokens");
    let mut found = Vec::new();
    collect(&tokens.into_iter().collect::<Vec<_>>(), &mut found);
    found
}

fn collect(trees: &[TokenTree], found: &mut Vec<Function>) {
    for (at, tree) in trees.iter().enumerate() {
        if let Some(function) = function(&trees[at..]) {
            found.push(function);
        }
        if let TokenTree::Group(group) = tree {
            collect(&group.stream().into_iter().collect::<Vec<_>>(), found);
        }
    }
}

/// Returns the function that tokens begin to define.
fn function(trees: &[TokenTree]) -> Option<Function> {
    let [TokenTree::Ident(keyword), TokenTree::Ident(name), rest @ ..] = trees else { return None };
    if keyword != "fn" {
        return None;
    }
    let body = rest.iter().find_map(|tree| match tree {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
            Some(Some(group.span_close().end().line))
        }
        TokenTree::Punct(punct) if punct.as_char() == ';' => Some(None),
        _ => None,
    })??;
    let line = keyword.span().start().line;
    Some(Function { name: name.to_string(), line, lines: body + 1 - line })
}

/// Columns of a string literal that may make its line long.
const LONG_TEXT: usize = 50;

/// Returns the lines, from 1, that have more columns than a limit, except for lines of long string
/// literals, which would not read better in parts.
///
/// # Panics
/// If the source is not valid Rust tokens.
pub fn long_lines(source: &str, limit: usize) -> Vec<usize> {
    let tokens: TokenStream = source.parse().expect("a source is valid tokens");
    let mut texts = BTreeSet::new();
    collect_texts(tokens, &mut texts);
    let is_long = |(at, line): &(usize, &str)| line.chars().count() > limit && !texts.contains(&(at + 1));
    source.lines().enumerate().filter(is_long).map(|(at, _)| at + 1).collect()
}

/// Collects the lines of long string literals.
fn collect_texts(tokens: TokenStream, texts: &mut BTreeSet<usize>) {
    for tree in tokens {
        match tree {
            TokenTree::Group(group) => collect_texts(group.stream(), texts),
            TokenTree::Literal(literal) => {
                let (start, end) = (literal.span().start(), literal.span().end());
                if start.line < end.line || end.column - start.column > LONG_TEXT {
                    texts.extend(start.line..=end.line);
                }
            }
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_function_has_the_lines_from_its_keyword_to_its_brace() {
        let found = functions(
            "impl A {\n  fn one() {}\n  pub fn two(\n    a: [u8; 2],\n  ) where {\n  }\n}\ntrait B { fn c(); }",
        );
        let sizes: Vec<_> =
            found.iter().map(|function| (function.name.as_str(), function.line, function.lines)).collect();
        assert_eq!(sizes, [("one", 2, 1), ("two", 3, 4)]);
    }

    #[test]
    fn a_line_is_as_long_as_its_characters_unless_a_text_makes_it_long() {
        assert_eq!(long_lines("äöü\nabcd\n", 3), [2]);
        let text = format!("f(\"{}\");\nconst A: &str = \"a\nbbbbbbbb\";\n// cccccccc", "d".repeat(60));
        assert_eq!(long_lines(&text, 8), [4]);
    }
}
