//! The public surface of a crate: the items that a program can name.
//!
//! An item counts where it is declared `pub` in modules that are all `pub`, or re-exported from such
//! a module. Methods and fields belong to their types and do not count. Items behind a feature for
//! the repository itself, or for tests, are skipped.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use proc_macro2::{Delimiter, TokenStream, TokenTree};

use crate::imports::read_imports;

/// Feature behind which a crate shows its internals to the tests of the repository.
const INTERNALS: &str = "internals";

/// Returns the paths of the public items of a crate, from the folder of its sources.
///
/// # Panics
/// If a source cannot be read or is not valid Rust tokens.
pub fn public_items(src: &Path) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    collect(read(&src.join("lib.rs")), src, &mut Vec::new(), &mut found);
    found
}

fn read(file: &Path) -> TokenStream {
    let text = fs::read_to_string(file).expect("sources are readable");
    text.parse().unwrap_or_else(|error| panic!("{}: {error}", file.display()))
}

/// Collects the public items of a public module.
fn collect(tokens: TokenStream, src: &Path, path: &mut Vec<String>, found: &mut BTreeSet<String>) {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    let (mut at, mut is_hidden) = (0, false);
    while at < trees.len() {
        let rest = &trees[at..];
        match rest {
            [TokenTree::Punct(hash), TokenTree::Group(attribute), ..] if hash.as_char() == '#' => {
                is_hidden |= hides(&attribute.stream().to_string().replace(' ', ""));
                at += 2;
                continue;
            }
            [TokenTree::Punct(hash), TokenTree::Punct(bang), TokenTree::Group(_), ..]
                if hash.as_char() == '#' && bang.as_char() == '!' =>
            {
                at += 3;
                continue;
            }
            [TokenTree::Ident(public), next, ..] if public == "pub" && !is_hidden && !is_group(next) => {
                declare(rest, src, path, found);
            }
            _ => {}
        }
        is_hidden = false;
        at += item_length(rest);
    }
}

/// Records the public item that tokens begin to declare.
fn declare(trees: &[TokenTree], src: &Path, path: &mut Vec<String>, found: &mut BTreeSet<String>) {
    let words: Vec<String> = trees[1..].iter().take(3).map(ToString::to_string).collect();
    let is_modifier =
        |word: &&String| matches!(word.as_str(), "unsafe" | "async") || **word == "const" && words[1] == "fn";
    let skipped = words.iter().take_while(is_modifier).count();
    let (keyword, name) = (words[skipped].as_str(), &words[skipped + 1]);
    let named = |name: &str, path: &[String]| [path, &[name.to_owned()]].concat().join("::");
    match keyword {
        "mod" => {
            path.push(name.clone());
            let file = src.join(path.iter().collect::<std::path::PathBuf>()).with_extension("rs");
            let inside = match trees.get(3) {
                Some(TokenTree::Group(body)) => body.stream(),
                _ => read(&file),
            };
            collect(inside, src, path, found);
            path.pop();
        }
        "use" => {
            let end = item_length(trees);
            let reexports = read_imports(&trees[..end]).reexports;
            found.extend(reexports.iter().map(|import| named(&import.name, path)));
        }
        _ => {
            found.insert(named(name, path));
        }
    }
}

/// Whether an attribute hides an item from programs.
fn hides(attribute: &str) -> bool {
    attribute == "cfg(test)"
        || attribute.starts_with("cfg(all(test")
        || attribute == format!("cfg(feature=\"{INTERNALS}\")")
        || attribute == "doc(hidden)"
}

fn is_group(tree: &TokenTree) -> bool {
    matches!(tree, TokenTree::Group(group) if group.delimiter() == Delimiter::Parenthesis)
}

/// Returns the number of tokens of an item: up to its `;`, or its braces, which end no `use`,
/// constant or type.
fn item_length(trees: &[TokenTree]) -> usize {
    let to_semicolon = trees.iter().take(3).any(|tree| {
        matches!(tree, TokenTree::Ident(word) if ["use", "const", "static", "type"].iter().any(|known| word == known))
    }) && !trees.iter().take(4).any(|tree| matches!(tree, TokenTree::Ident(word) if word == "fn"));
    let ends = |tree: &TokenTree| match tree {
        TokenTree::Punct(punct) => punct.as_char() == ';',
        TokenTree::Group(group) => group.delimiter() == Delimiter::Brace && !to_semicolon,
        _ => false,
    };
    trees.iter().position(ends).map_or(trees.len(), |end| end + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_count_where_all_modules_around_them_are_public() {
        let source = r#"
            //! A crate.
            mod a { pub struct Hidden; }
            pub mod b { pub fn f() {} pub const fn g() {} pub(crate) fn h() {} impl X { pub fn i() {} } }
            #[cfg(feature = "internals")] pub mod c { pub fn j() {} }
            #[cfg(not(feature = "internals"))] mod c { pub fn j() {} }
            /// A type.
            pub use a::{Hidden, Other as Shown};
            pub const K: [u8; 1] = { [0] };
            pub enum E { A, B }
        "#;
        let mut found = BTreeSet::new();
        collect(source.parse().expect("tokens"), Path::new(""), &mut Vec::new(), &mut found);
        let found: Vec<&str> = found.iter().map(String::as_str).collect();
        assert_eq!(found, ["E", "Hidden", "K", "Shown", "b::f", "b::g"]);
    }
}
