//! Syntax highlighting: words, numbers and comments of the language are marked for a style sheet.

use crate::escape::escaped;
use forms_core::syntax::lex;
use forms_core::syntax::token::TokenKind;
use forms_core::syntax::words::{Word, reserved};

/// Returns the text as HTML: `<b>` for words of the language, `<i>` comments, `<u>` numbers, `<em>`
/// functions, `<mark>` holes.
pub(crate) fn highlighted(text: &str) -> String {
    let (tokens, _) = lex(text);
    let (mut html, mut end) = (String::new(), 0);
    for token in tokens {
        let [start, behind] = [token.span.start, token.span.end].map(|place| place as usize);
        let element = match &token.kind {
            TokenKind::Name(name) if name.chars().all(|c| c == '_') && name.len() > 1 => "mark",
            TokenKind::Name(name) => match reserved(name) {
                Some(Word::Item) => "b",
                Some(Word::Function) => "em",
                Some(Word::Rust) | None => "",
            },
            TokenKind::Number(_) => "u",
            TokenKind::Doc(_) => "i",
            TokenKind::Symbol(_) | TokenKind::Unknown => "",
        };
        let (Some(between), Some(written)) = (text.get(end..start), text.get(start..behind)) else {
            continue;
        };
        html.push_str(&comments(between));
        html.push_str(&marked(element, written));
        end = behind;
    }
    html + &comments(text.get(end..).unwrap_or_default())
}

/// Marks comments in the text between tokens. A comment ends with its line.
fn comments(text: &str) -> String {
    let line = |line: &str| match line.find("//") {
        Some(start) => escaped(&line[..start]) + &marked("i", &line[start..]),
        None => escaped(line),
    };
    text.split_inclusive('\n').map(line).collect()
}

fn marked(element: &str, text: &str) -> String {
    let text = escaped(text);
    if element.is_empty() { text } else { format!("<{element}>{text}</{element}>") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_lost_and_words_are_marked() {
        let text = "/// Doc < 1.\nprove p: sin(x) == ___ + 0.5; // note & more\n";
        let html = highlighted(text);
        for part in [
            "<b>prove</b>",
            "<em>sin</em>",
            "<mark>___</mark>",
            "<u>0.5</u>",
            "<i>// note &amp; more\n</i>",
            "<i>///",
        ] {
            assert!(html.contains(part), "{part}: {html}");
        }
        let plain = ["b", "em", "mark", "u", "i"].iter().fold(html, |html, element| {
            html.replace(&format!("<{element}>"), "").replace(&format!("</{element}>"), "")
        });
        assert_eq!(plain, escaped(text));
    }
}
