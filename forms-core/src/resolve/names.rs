//! The one namespace of a file, and the nearest known name to a misspelt one.

use super::theory::Named;
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::syntax::ast::Name;
use crate::syntax::words::FUNCTIONS;
use rustc_hash::FxHashMap;

/// What each name stands for and where it was declared.
#[derive(Clone, Debug, Default)]
pub(crate) struct Names {
    table: FxHashMap<String, (Named, Span)>,
}

impl Names {
    pub(super) fn get(&self, name: &str) -> Option<&Named> {
        self.table.get(name).map(|entry| &entry.0)
    }

    /// Declares a name, or says that it is taken.
    pub(super) fn declare(&mut self, name: &Name, meaning: Named) -> Result<(), Diagnostic> {
        self.declare_text(&name.text, name.span, meaning)
    }

    pub(super) fn declare_text(&mut self, text: &str, span: Span, meaning: Named) -> Result<(), Diagnostic> {
        if let Some((known, _)) = self.table.get(text) {
            let help = match known {
                Named::Differential(_) => {
                    format!(
                        "`{text}` is the differential of the coordinate `{}`",
                        text.strip_prefix('d').unwrap_or(text)
                    )
                }
                known => format!("it already names {}", describe(known)),
            };
            return Err(Diagnostic::new(span, format!("`{text}` is declared twice")).with_help(help));
        }
        self.table.insert(text.to_string(), (meaning, span));
        Ok(())
    }

    /// Replaces the meaning of a declared name.
    pub(super) fn set(&mut self, name: &Name, meaning: Named) {
        self.table.insert(name.text.clone(), (meaning, name.span));
    }

    pub(super) fn remove(&mut self, text: &str) {
        self.table.remove(text);
    }

    /// The error for a name nobody declared, with the nearest one that is, or with the items that would declare it.
    pub(super) fn unknown(&self, text: &str, span: Span, items: &str) -> Diagnostic {
        if FUNCTIONS.contains(&text) {
            return Diagnostic::new(span, format!("`{text}` is a function and has no value by itself"))
                .with_help(format!("write what it is of in brackets behind it: `{text}(…)`"));
        }
        let diagnostic = not_declared(text, span);
        match self.nearest(text) {
            Some(near) => diagnostic.with_help(format!("did you mean `{near}`?")),
            None => diagnostic.with_help(format!("declare it with {items} above this line")),
        }
    }

    /// A name that differs in a third of its characters or fewer, or in the case of its letters: of a single letter
    /// nothing else is left to go by.
    fn nearest(&self, text: &str) -> Option<String> {
        let length = text.chars().count();
        let is_near = |distance: usize, known: &str| {
            (distance <= length.div_ceil(3) && distance < length) || known.eq_ignore_ascii_case(text)
        };
        self.table
            .keys()
            .map(String::as_str)
            .chain(FUNCTIONS.iter().copied())
            .map(|known| (edit_distance(text, known), known))
            .filter(|&(distance, known)| is_near(distance, known))
            .min()
            .map(|(_, known)| known.to_string())
    }
}

/// The items that declare what has a value.
pub(super) const VALUES: &str = "`chart`, `param`, `fn` or `let`";

/// The error for a name nobody declared, without help.
pub(super) fn not_declared(text: &str, span: Span) -> Diagnostic {
    Diagnostic::new(span, format!("`{text}` is not declared")).of(Kind::UnknownName)
}

/// What a name stands for, in words.
pub(super) fn describe(named: &Named) -> &'static str {
    match named {
        Named::Chart(_) => "a chart",
        Named::Coordinate(_) => "a coordinate",
        Named::Differential(_) => "a differential",
        Named::Parameter(_) => "a param",
        Named::Function(_) => "an unknown function",
        Named::Object(_) => "a scalar, form or field",
        Named::Map(_) => "a map",
        Named::Metric(_) => "a metric",
        Named::Kernel(_) => "a kernel",
        Named::Poisoned => "something with an error in it",
    }
}

/// The number of single-character changes between two words (Levenshtein).
fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, ca) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, &cb) in b.iter().enumerate() {
            let substituted = diagonal + usize::from(ca != cb);
            diagonal = row[j + 1];
            row[j + 1] = substituted.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}
