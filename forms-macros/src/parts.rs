//! Parts of a source that are compiled and cached on their own: its statements, and each of its
//! kernels.
//!
//! ```text
//! File ─┬─ all items except kernels, and the kernels that these name ─▶ statements, warps
//!       └─ for each kernel: these items, this kernel, and the kernels that it names ─▶ the kernel
//! ```
//! A part is resolved without the rest of the source, and its tokens are its key. What a kernel
//! becomes therefore depends on no kernel that it does not name, and a change of one kernel leaves
//! the entries of the others valid. Only sources without errors have parts.

use crate::cache::Key;
use forms_core::check::resolve_parsed;
use forms_core::compile::{Compiled, Options, compile_theory};
use forms_core::stability::Choices;
use forms_core::syntax::ast::{File, Item, ItemKind};
use forms_core::syntax::token::{Token, TokenKind};
use std::collections::{HashMap, HashSet};
use std::ops::Range;

/// Source without errors, divided into parts.
pub(crate) struct Parts<'a> {
    tokens: &'a [Token],
    file: &'a File,
    /// Forms chosen for the kernels, and their text.
    choices: Option<(&'a Choices, &'a str)>,
    /// Places of the tokens of each item, with its documentation.
    places: Vec<Range<usize>>,
    /// Item of each kernel, by name.
    kernels: HashMap<&'a str, usize>,
}

impl<'a> Parts<'a> {
    pub(crate) fn new(tokens: &'a [Token], file: &'a File, choices: Option<(&'a Choices, &'a str)>) -> Self {
        let end = |item: &Item| tokens.partition_point(|token| token.span.start < item.span.end);
        let mut start = 0;
        let mut places = Vec::new();
        for item in &file.items {
            let own = start..end(item);
            start = own.end;
            places.push(own);
        }
        let items = file.items.iter().enumerate();
        let kernels = items.filter_map(|(place, item)| Some((kernel_name(item)?, place))).collect();
        Parts { tokens, file, choices, places, kernels }
    }

    /// Whether an item of its own declares this kernel, and not a warp.
    pub(crate) fn has_kernel(&self, name: &str) -> bool {
        self.kernels.contains_key(name)
    }

    /// Returns the key of the part of a kernel, or of the statements.
    pub(crate) fn key(&self, kernel: Option<&str>) -> Option<Key> {
        let own = kernel.unwrap_or("statements of the source");
        let choices = self.choices.map_or("", |(_, text)| text);
        Key::of(&self.tokens_of(&self.items(kernel)), &format!("{own}\n{choices}"))
    }

    /// Compiles the part of a kernel, or of the statements. Nothing if the part has no meaning
    /// without the rest of the source.
    pub(crate) fn compiled(&self, kernel: Option<&str>) -> Option<Compiled> {
        let places = self.items(kernel);
        let items = places.iter().map(|&place| self.file.items[place].clone()).collect();
        let (mut theory, diagnostics) = resolve_parsed(&self.tokens_of(&places), &File { items });
        if !diagnostics.is_empty() {
            return None;
        }
        if let Some((choices, _)) = self.choices {
            choices.apply(&mut theory);
        }
        match kernel {
            Some(name) => theory.kernels.retain(|kernel| kernel.name == name),
            None => theory.kernels.retain(|kernel| !self.has_kernel(&kernel.name)),
        }
        let options = Options { kernels_only: kernel.is_some(), ..Options::default() };
        Some(compile_theory(theory, diagnostics, &options))
    }

    /// Returns the items of a part, in order.
    fn items(&self, kernel: Option<&str>) -> Vec<usize> {
        let is_needed = |&place: &usize| {
            let name = kernel_name(&self.file.items[place]);
            name.is_none() || name == kernel
        };
        let mut open: Vec<usize> = (0..self.file.items.len()).filter(is_needed).collect();
        let mut needed: HashSet<usize> = open.iter().copied().collect();
        while let Some(place) = open.pop() {
            for token in &self.tokens[self.places[place].clone()] {
                let TokenKind::Name(name) = &token.kind else { continue };
                open.extend(self.kernels.get(name.as_str()).filter(|&&named| needed.insert(named)));
            }
        }
        let mut items: Vec<usize> = needed.into_iter().collect();
        items.sort_unstable();
        items
    }

    fn tokens_of(&self, items: &[usize]) -> Vec<Token> {
        items.iter().flat_map(|&place| self.tokens[self.places[place].clone()].iter().cloned()).collect()
    }
}

/// Returns the name of the kernel that an item declares.
fn kernel_name(item: &Item) -> Option<&str> {
    match &item.kind {
        ItemKind::Kernel { name, .. } | ItemKind::Derivatives { name, .. } => Some(&name.text),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use forms_core::check::read_file;
    use forms_core::emission::emit_formula;
    use forms_core::syntax::lex;

    const SOURCE: &str = "let twice(t) = 2*t;
kernel base(x, y) = twice(x)*y;
kernel slope = grad(base; x, y);
prove value: twice(3) == 6;
kernel alone(x) = sqrt(x**2 + 1) + base(x, 2);
kernel angle(x) = (1 - cos(x))/x**2 where 0 < x < 1 within 4;";

    /// Names of the kernels that belong to the part of a kernel.
    fn kernels(text: &str, kernel: Option<&str>) -> Vec<String> {
        let (tokens, (file, _, _)) = (lex(text).0, read_file(text));
        let parts = Parts::new(&tokens, &file, None);
        let items = parts.items(kernel).into_iter();
        items.filter_map(|place| Some(kernel_name(&file.items[place])?.to_owned())).collect()
    }

    #[test]
    fn a_part_has_the_kernels_that_it_names_and_no_others() {
        assert_eq!(kernels(SOURCE, Some("base")), ["base"]);
        assert_eq!(kernels(SOURCE, Some("slope")), ["base", "slope"]);
        assert_eq!(kernels(SOURCE, Some("alone")), ["base", "alone"]);
        assert!(kernels(SOURCE, None).is_empty());
        let named_by_a_statement = format!("{SOURCE} prove four: base(1, 2) == 4;");
        assert_eq!(kernels(&named_by_a_statement, None), ["base"]);
        assert_eq!(kernels(&named_by_a_statement, Some("angle")), ["base", "angle"]);
    }

    #[test]
    fn a_kernel_of_a_part_is_the_kernel_of_the_source() {
        let (tokens, (file, theory, diagnostics)) = (lex(SOURCE).0, read_file(SOURCE));
        assert!(diagnostics.is_empty(), "{diagnostics:?}");
        let parts = Parts::new(&tokens, &file, None);
        let whole = compile_theory(theory, diagnostics, &Options::default());
        for kernel in &whole.kernels {
            let name = &kernel.kernel().name;
            let part = parts.compiled(Some(name)).expect("a part has a meaning alone");
            let code = |compiled: &Compiled| {
                emit_formula(compiled.kernel(name).expect("the kernel").program(), "Stable", "math")
            };
            assert_eq!(code(&part), code(&whole), "{name}");
            assert_eq!((part.kernels.len(), part.statements.len()), (1, 0));
        }
        let claims = parts.compiled(None).expect("statements have a meaning alone");
        assert_eq!((claims.kernels.len(), claims.statements.len()), (0, 1));
    }
}
