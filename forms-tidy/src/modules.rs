//! The modules of a crate: their tree, the names that each defines or re-exports, and the paths
//! that its code mentions.
//!
//! A file is read as tokens. Items under `#[cfg(test)]` are skipped: tests may import anything.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use proc_macro2::{Delimiter, TokenStream, TokenTree};

use crate::imports::{Import, read_imports};
use crate::workspace::files;

/// A module's path below the crate root; the root itself is empty.
pub type ModulePath = Vec<String>;

/// A module.
#[derive(Clone, Debug, Default)]
pub struct Module {
    /// Names of the items defined in it.
    pub items: BTreeSet<String>,
    /// `use` declarations with visibility, which re-export names.
    pub reexports: Vec<Import>,
    /// Paths mentioned in its code, those of private `use` declarations included.
    pub mentions: Vec<Vec<String>>,
}

/// The modules of a crate by path.
#[derive(Clone, Debug, Default)]
pub struct Modules(pub BTreeMap<ModulePath, Module>);

impl Modules {
    /// Reads the modules of a crate from its `src` folder.
    pub fn read(src: &Path) -> Modules {
        let mut modules = Modules::default();
        for file in files(src, "rs") {
            let relative = file.strip_prefix(src).expect("files lie below the folder");
            let mut path: ModulePath =
                relative.with_extension("").iter().map(|part| part.to_string_lossy().into_owned()).collect();
            if matches!(path.last().map(String::as_str), Some("mod" | "lib" | "main")) {
                path.pop();
            }
            let text = fs::read_to_string(&file).expect("sources are readable");
            let tokens: TokenStream =
                text.parse().unwrap_or_else(|error| panic!("{}: {error}", file.display()));
            if is_for_tests(&tokens) {
                continue;
            }
            modules.add(path, tokens);
        }
        modules
    }

    /// Adds the tokens of a module and of the modules inside it.
    pub fn add(&mut self, path: ModulePath, tokens: TokenStream) {
        let mut rest: Vec<TokenTree> = Vec::new();
        let mut inner: Vec<(String, TokenStream)> = Vec::new();
        let mut tested: BTreeSet<String> = BTreeSet::new();
        let trees: Vec<TokenTree> = tokens.into_iter().collect();
        let mut at = 0;
        while at < trees.len() {
            if is_test_attribute(&trees[at..]) {
                let end = item_end(&trees, at + 2);
                if let Some(name) = declared_module(&trees[at + 2..end]) {
                    tested.insert(name);
                }
                at = end;
            } else if let (Some(name), Some(TokenTree::Group(body))) =
                (module_name(&trees[at..]), trees.get(at + 2))
            {
                inner.push((name, body.stream()));
                at += 3;
            } else {
                rest.push(trees[at].clone());
                at += 1;
            }
        }
        let module = self.0.entry(path.clone()).or_default();
        let found = read_imports(&rest);
        module.items.extend(item_names(&rest));
        module.reexports.extend(found.reexports);
        module.mentions.extend(found.mentions);
        for (name, body) in inner {
            self.add([path.as_slice(), &[name]].concat(), body);
        }
        // A file behind `#[cfg(test)] mod tests;` belongs to the tests.
        self.0.retain(|other, _| {
            !(other.len() > path.len() && other.starts_with(&path) && tested.contains(&other[path.len()]))
        });
    }

    /// Returns the module that defines what a path names, seen from a module; `None` for a path into another crate.
    pub fn resolve(&self, from: &[String], path: &[String]) -> Option<ModulePath> {
        let (start, rest) = self.base(from, path)?;
        self.walk(start, rest, &mut Vec::new())
    }

    /// Splits a path into the module that it starts from and the rest.
    fn base<'a>(&self, from: &[String], path: &'a [String]) -> Option<(ModulePath, &'a [String])> {
        let mut start = match path.first()?.as_str() {
            "crate" => ModulePath::new(),
            "self" => from.to_vec(),
            "super" => from[..from.len().checked_sub(1)?].to_vec(),
            child => {
                let below = [from, &[child.to_owned()]].concat();
                return self.0.contains_key(&below).then_some((from.to_vec(), path));
            }
        };
        let mut rest = &path[1..];
        while rest.first().is_some_and(|part| part == "super") {
            start.pop()?;
            rest = &rest[1..];
        }
        Some((start, rest))
    }

    /// Follows the segments of a path from a module, through re-exports, to the module that defines the item.
    fn walk(
        &self,
        module: ModulePath,
        path: &[String],
        seen: &mut Vec<(ModulePath, String)>,
    ) -> Option<ModulePath> {
        let Some(name) = path.first() else { return Some(module) };
        let below = [module.as_slice(), std::slice::from_ref(name)].concat();
        if self.0.contains_key(&below) {
            return self.walk(below, &path[1..], seen);
        }
        let known = self.0.get(&module)?;
        let key = (module.clone(), name.clone());
        if known.items.contains(name) || name == "*" || seen.contains(&key) {
            return Some(module);
        }
        seen.push(key);
        for reexport in &known.reexports {
            let target = if reexport.name == *name {
                reexport.path.clone()
            } else if reexport.name == "*" {
                let parent = &reexport.path[..reexport.path.len() - 1];
                match self.base(&module, parent).and_then(|(start, rest)| self.walk(start, rest, seen)) {
                    Some(glob) if self.0.get(&glob).is_some_and(|glob| glob.defines(name)) => {
                        [parent, std::slice::from_ref(name)].concat()
                    }
                    _ => continue,
                }
            } else {
                continue;
            };
            // A re-export of another crate's item belongs to the module that re-exports it.
            let Some((start, rest)) = self.base(&module, &target) else { return Some(module) };
            return self.walk(start, rest, seen);
        }
        Some(module)
    }
}

impl Module {
    fn defines(&self, name: &str) -> bool {
        self.items.contains(name) || self.reexports.iter().any(|reexport| reexport.name == name)
    }
}

/// Whether a whole file is for tests: it opens with `#![cfg(test)]`.
fn is_for_tests(tokens: &TokenStream) -> bool {
    tokens.to_string().replace(' ', "").starts_with("#![cfg(test)]")
}

/// Whether tokens begin with an attribute `#[cfg(test)]`, or one that `test` is part of.
fn is_test_attribute(trees: &[TokenTree]) -> bool {
    let [TokenTree::Punct(hash), TokenTree::Group(attribute), ..] = trees else { return false };
    let text = attribute.stream().to_string().replace(' ', "");
    hash.as_char() == '#' && (text == "cfg(test)" || text.starts_with("cfg(all(test"))
}

/// Returns the name of the module that tokens begin to declare, `mod name`.
fn module_name(trees: &[TokenTree]) -> Option<String> {
    match trees {
        [TokenTree::Ident(keyword), TokenTree::Ident(name), ..] if keyword == "mod" => Some(name.to_string()),
        _ => None,
    }
}

fn declared_module(trees: &[TokenTree]) -> Option<String> {
    (0..trees.len()).find_map(|at| module_name(&trees[at..]))
}

/// Returns the place after an item: after its `;` or its braces.
fn item_end(trees: &[TokenTree], from: usize) -> usize {
    let ends = |tree: &TokenTree| match tree {
        TokenTree::Punct(punct) => punct.as_char() == ';',
        TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
        _ => false,
    };
    // `use a::{b};` ends after the semicolon behind its braces.
    let end = trees[from..].iter().position(ends).map_or(trees.len(), |length| from + length + 1);
    match trees.get(end) {
        Some(TokenTree::Punct(punct)) if punct.as_char() == ';' => end + 1,
        _ => end,
    }
}

/// Returns the names of the items that tokens define.
fn item_names(trees: &[TokenTree]) -> BTreeSet<String> {
    let keywords = ["fn", "struct", "enum", "trait", "const", "static", "type", "union", "macro_rules"];
    let mut names = BTreeSet::new();
    for at in 0..trees.len() {
        let TokenTree::Ident(keyword) = &trees[at] else { continue };
        if !keywords.iter().any(|known| keyword == known) {
            continue;
        }
        let name = trees[at + 1..].iter().take(2).find_map(|tree| match tree {
            TokenTree::Ident(name) if name != "fn" => Some(name.to_string()),
            _ => None,
        });
        names.extend(name);
    }
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    fn modules(sources: &[(&str, &str)]) -> Modules {
        let mut modules = Modules::default();
        for (path, source) in sources {
            let path = path.split("::").filter(|part| !part.is_empty()).map(str::to_owned).collect();
            modules.add(path, source.parse().expect("tokens"));
        }
        modules
    }

    fn resolved(modules: &Modules, from: &str, path: &str) -> String {
        let parts = |text: &str| {
            text.split("::").filter(|part| !part.is_empty()).map(str::to_owned).collect::<Vec<_>>()
        };
        modules.resolve(&parts(from), &parts(path)).map_or("elsewhere".to_owned(), |module| module.join("::"))
    }

    #[test]
    fn a_path_leads_through_re_exports_to_the_module_that_defines_the_item() {
        let modules = modules(&[
            ("", "mod geometry; mod scene;"),
            (
                "geometry",
                "mod vector; pub use vector::{Vector, dot as inner}; pub use self::polygon::*; mod polygon;",
            ),
            ("geometry::vector", "pub struct Vector; pub fn dot() {}"),
            ("geometry::polygon", "pub fn area() {} #[cfg(test)] mod tests { use crate::scene::Scene; }"),
            ("scene", "pub struct Scene; use std::fmt::Debug;"),
        ]);
        assert_eq!(resolved(&modules, "scene", "crate::geometry::Vector"), "geometry::vector");
        assert_eq!(resolved(&modules, "scene", "super::geometry::inner"), "geometry::vector");
        assert_eq!(resolved(&modules, "scene", "crate::geometry::area"), "geometry::polygon");
        assert_eq!(resolved(&modules, "geometry", "vector::dot"), "geometry::vector");
        assert_eq!(resolved(&modules, "scene", "crate::geometry"), "geometry");
        assert_eq!(resolved(&modules, "scene", "std::fmt::Debug"), "elsewhere");
    }

    #[test]
    fn tests_are_no_part_of_a_module() {
        let modules = modules(&[(
            "a",
            "#[cfg(test)] use crate::b::{C}; #[cfg(test)] mod tests { use crate::b::D; } fn f() {}",
        )]);
        assert_eq!(modules.0.len(), 1);
        assert!(modules.0[&vec!["a".to_owned()]].mentions.is_empty());
    }
}
