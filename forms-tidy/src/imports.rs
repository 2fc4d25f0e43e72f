//! The paths that tokens mention: in `use` declarations and everywhere else.

use proc_macro2::{Delimiter, TokenTree};

/// A name that a `use` declaration brings in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Import {
    /// The path as written, segments from the left.
    pub path: Vec<String>,
    /// The name under which it is known afterwards; `*` for all names.
    pub name: String,
}

/// The paths of a module.
#[derive(Clone, Debug, Default)]
pub struct Imports {
    /// What `use` declarations with a visibility bring in.
    pub reexports: Vec<Import>,
    /// All other paths of at least two segments.
    pub mentions: Vec<Vec<String>>,
}

/// Reads the paths of some tokens, those inside groups included.
pub fn read_imports(trees: &[TokenTree]) -> Imports {
    let mut imports = Imports::default();
    let mut at = 0;
    while at < trees.len() {
        if is_ident(&trees[at], "use") {
            let mut found = Vec::new();
            let end = read_use(trees, at + 1, &[], &mut found);
            if is_public(&trees[..at]) {
                imports.reexports.extend(found);
            } else {
                imports.mentions.extend(found.into_iter().map(|import| import.path));
            }
            at = end;
        } else if let Some((path, end)) = read_path(trees, at) {
            if path.len() > 1 {
                imports.mentions.push(path);
            }
            at = end;
        } else {
            if let TokenTree::Group(group) = &trees[at] {
                let inside = read_imports(&group.stream().into_iter().collect::<Vec<_>>());
                imports.mentions.extend(inside.mentions);
                imports.mentions.extend(inside.reexports.into_iter().map(|import| import.path));
            }
            at += 1;
        }
    }
    imports
}

/// Reads a tree of a `use` declaration behind a prefix, and returns the place after it.
fn read_use(trees: &[TokenTree], from: usize, prefix: &[String], found: &mut Vec<Import>) -> usize {
    let mut path = prefix.to_vec();
    let mut at = from;
    while at < trees.len() {
        match &trees[at] {
            TokenTree::Ident(name) if name == "as" => {
                let name = trees.get(at + 1).map(ToString::to_string).unwrap_or_default();
                found.push(Import { path, name });
                return at + 2;
            }
            TokenTree::Ident(name) => path.push(name.to_string()),
            TokenTree::Punct(punct) if punct.as_char() == '*' => path.push("*".to_owned()),
            TokenTree::Punct(punct) if punct.as_char() == ':' => {}
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
                let inside: Vec<TokenTree> = group.stream().into_iter().collect();
                let mut next = 0;
                while next < inside.len() {
                    next = read_use(&inside, next, &path, found) + 1;
                }
                return at + 1;
            }
            _ => break,
        }
        at += 1;
    }
    if path.last().is_some_and(|last| last == "self") && path.len() > 1 {
        path.pop();
    }
    if let Some(name) = path.last().cloned() {
        found.push(Import { path, name });
    }
    at
}

/// Reads a path `a::b::c` and returns it with the place after it.
fn read_path(trees: &[TokenTree], from: usize) -> Option<(Vec<String>, usize)> {
    let TokenTree::Ident(first) = &trees[from] else { return None };
    // What follows `.` is a field or a method, what follows `::` continues a path that began with a type.
    let before = from.checked_sub(1).map(|at| &trees[at]);
    if matches!(before, Some(TokenTree::Punct(punct)) if matches!(punct.as_char(), '.' | ':') && is_joined(trees, from))
    {
        return None;
    }
    let mut path = vec![first.to_string()];
    let mut at = from + 1;
    while is_colon(trees.get(at)) && is_colon(trees.get(at + 1)) {
        let Some(TokenTree::Ident(next)) = trees.get(at + 2) else { break };
        path.push(next.to_string());
        at += 3;
    }
    Some((path, at))
}

/// Whether an identifier continues what stands before it: `.name` or `::name`.
fn is_joined(trees: &[TokenTree], at: usize) -> bool {
    match trees.get(at - 1) {
        Some(TokenTree::Punct(punct)) if punct.as_char() == '.' => {
            // `..name` is a range.
            !matches!(at.checked_sub(2).map(|at| &trees[at]), Some(TokenTree::Punct(punct)) if punct.as_char() == '.')
        }
        _ => {
            at >= 2 && is_colon(trees.get(at - 2)) && at >= 3 && !matches!(trees[at - 3], TokenTree::Punct(_))
        }
    }
}

fn is_colon(tree: Option<&TokenTree>) -> bool {
    matches!(tree, Some(TokenTree::Punct(punct)) if punct.as_char() == ':')
}

fn is_ident(tree: &TokenTree, name: &str) -> bool {
    matches!(tree, TokenTree::Ident(ident) if ident == name)
}

/// Whether tokens end with a visibility: `pub`, `pub(crate)`.
fn is_public(before: &[TokenTree]) -> bool {
    match before {
        [.., last] if is_ident(last, "pub") => true,
        [.., before, TokenTree::Group(group)] => {
            is_ident(before, "pub") && group.delimiter() == Delimiter::Parenthesis
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn imports(source: &str) -> Imports {
        read_imports(
            &source.parse::<proc_macro2::TokenStream>().expect("tokens").into_iter().collect::<Vec<_>>(),
        )
    }

    #[test]
    fn every_branch_of_a_use_declaration_is_a_path() {
        let found = imports("use crate::a::{self, b::{C, D as E}, f::*};");
        let paths: Vec<String> = found.mentions.iter().map(|path| path.join("::")).collect();
        assert_eq!(paths, ["crate::a", "crate::a::b::C", "crate::a::b::D", "crate::a::f::*"]);
    }

    #[test]
    fn a_use_with_a_visibility_re_exports_its_names() {
        let found = imports("pub(crate) use a::{b as c, d}; use e::f;");
        assert_eq!(found.reexports.len(), 2);
        assert_eq!(found.reexports[0], Import { path: vec!["a".into(), "b".into()], name: "c".into() });
        assert_eq!(found.mentions, [["e", "f"]]);
    }

    #[test]
    fn paths_are_found_in_bodies_and_macros() {
        let found = imports("fn f() -> crate::a::B { vec![super::c::d(x.y)]; Vec::<u8>::new() }");
        let paths: Vec<String> = found.mentions.iter().map(|path| path.join("::")).collect();
        assert_eq!(paths, ["crate::a::B", "super::c::d"]);
    }
}
