//! Damaged files: nothing panics, every place is in the text, and one defect gives one report.

use crate::files;
use forms_core::syntax::token::Symbol;
use forms_core::syntax::{Source, end_of, lex, parse, read};
use proptest::prelude::*;

/// Reads a text and renders all its diagnostics.
fn survives(text: &str) {
    let source = Source::new("damaged", text);
    for diagnostic in read(text).1 {
        let span = diagnostic.span;
        assert!(span.start <= span.end && span.end as usize <= text.len(), "{diagnostic:?} in {text:?}");
        let rendered = source.render(&diagnostic);
        assert!(rendered.starts_with("error: ") && rendered.contains('^'), "{rendered}");
    }
}

#[test]
fn to_lose_one_token_is_at_most_one_mistake_and_at_most_one_item() {
    for source in files::sources() {
        let tokens = lex(&source.text).0;
        for three in files::items(&tokens).windows(3) {
            for lost in 0..three[1].len() {
                let (before, after) = (&three[1][..lost], &three[1][lost + 1..]);
                let (file, diagnostics) =
                    parse(&[three[0], before, after, three[2]].concat(), end_of(&source.text));
                assert!(
                    diagnostics.len() <= 1,
                    "{}: {diagnostics:?} without {:?}",
                    source.name,
                    three[1][lost]
                );
                assert!(file.items.len() >= 2, "{}: {diagnostics:?}", source.name);
            }
        }
    }
}

#[test]
fn a_file_may_end_behind_any_token() {
    for source in files::sources() {
        for token in lex(&source.text).0.iter().step_by(5) {
            let (_, diagnostics) = read(&source.text[..token.span.end as usize]);
            assert!(diagnostics.len() <= 1, "{}: {diagnostics:?}", source.name);
        }
    }
}

/// Pieces of text, both inside and outside the language.
fn piece() -> impl Strategy<Value = String> {
    let words =
        ["x", "d", "if", "else", "where", "effects", "kernel", "prove", "pub", "jump", "chart", "on", "fn"];
    let others =
        ["1", "0.5", "2x", ".5", "1e9", "///", "//", "/*", "*/", "\n", " ", "\"", "é", "∧", "$", "\0", "!"];
    let symbols = Symbol::ALL.iter().map(|symbol| symbol.text());
    let pieces: Vec<&str> = words.into_iter().chain(others).chain(symbols).collect();
    prop::sample::select(pieces).prop_map(str::to_owned)
}

proptest! {
    #[test]
    fn damaged_case_files_are_read_to_the_end(
        file in any::<prop::sample::Index>(),
        wounds in prop::collection::vec((any::<prop::sample::Index>(), 0_usize..6, piece()), 1..6),
    ) {
        let sources = files::sources();
        let mut characters: Vec<char> = sources[file.index(sources.len())].text.chars().collect();
        for (place, length, piece) in wounds {
            let start = place.index(characters.len());
            let end = (start + length).min(characters.len());
            characters.splice(start..end, piece.chars());
        }
        survives(&characters.into_iter().collect::<String>());
    }

    #[test]
    fn any_pieces_in_any_order_are_read_to_the_end(pieces in prop::collection::vec(piece(), 0..80)) {
        survives(&pieces.join(" "));
        survives(&pieces.concat());
    }

    #[test]
    fn any_text_is_read_to_the_end(text in "\\PC{0,200}") {
        survives(&text);
    }
}
