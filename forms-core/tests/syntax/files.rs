//! Case files of the workspace.

use forms_core::syntax::token::{Symbol, Token, TokenKind};
use forms_core::syntax::{Source, lex, read};
use std::path::Path;

/// Folders of the workspace with `.forms` files.
const FOLDERS: &[&str] = &["../tests/cases", "../forms-kernels/theory", "../forms-kernels/kernels"];

/// Returns the text of every `.forms` file of the workspace.
pub(crate) fn sources() -> Vec<Source> {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut sources: Vec<Source> = FOLDERS
        .iter()
        .flat_map(|folder| {
            std::fs::read_dir(workspace.join(folder)).expect("the workspace has its case files")
        })
        .map(|entry| entry.expect("the folder can be read").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "forms"))
        .map(|path| {
            let text = std::fs::read_to_string(&path).expect("case files are UTF-8");
            Source::new(path.file_name().expect("it has a name").to_string_lossy(), text)
        })
        .collect();
    sources.sort_by(|a, b| a.name.cmp(&b.name));
    sources
}

/// Returns the tokens of each item, up to a semicolon outside of brackets.
pub(crate) fn items(tokens: &[Token]) -> Vec<&[Token]> {
    let mut depth = 0_usize;
    let is_end = |token: &Token| {
        match token.kind {
            TokenKind::Symbol(Symbol::OpenParen | Symbol::OpenBrace) => depth += 1,
            TokenKind::Symbol(Symbol::CloseParen | Symbol::CloseBrace) => depth -= 1,
            _ => {}
        }
        depth == 0 && token.kind == TokenKind::Symbol(Symbol::Semicolon)
    };
    tokens.split_inclusive(is_end).collect()
}

#[test]
fn every_case_file_parses_into_one_item_for_each_semicolon() {
    let sources = sources();
    assert!(sources.len() >= 20, "only {} case files", sources.len());
    for source in sources {
        let (file, diagnostics) = read(&source.text);
        let shown: String = diagnostics.iter().map(|diagnostic| source.render(diagnostic)).collect();
        assert_eq!(shown, "", "{}", source.name);
        assert_eq!(file.items.len(), items(&lex(&source.text).0).len(), "{}", source.name);
    }
}
