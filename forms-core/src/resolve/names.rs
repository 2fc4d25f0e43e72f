//! The one namespace of a file, and the nearest known name to a misspelt one.

use super::theory::Named;
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::syntax::ast::Name;
use crate::syntax::words::FUNCTIONS;
use rustc_hash::FxHashMap;

/// Longer names are not compared with others: the work is the product of the lengths.
const LONGEST_COMPARED: usize = 64;

/// What each name stands for and where it was declared.
#[derive(Clone, Debug, Default)]
pub(crate) struct Names {
    table: FxHashMap<String, (Named, Span)>,
    /// The names that the item being read declares.
    pending: Vec<String>,
    /// Whether unknown names are no longer compared with all others, which takes time.
    is_terse: bool,
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
        if matches!(meaning, Named::Pending) {
            self.pending.push(text.to_string());
        }
        self.table.insert(text.to_string(), (meaning, span));
        Ok(())
    }

    /// Makes no suggestions from here on.
    pub(super) fn be_terse(&mut self) {
        self.is_terse = true;
    }

    /// Ends an item: what it should have declared and did not has an error in it.
    pub(super) fn end_item(&mut self) {
        for name in self.pending.drain(..) {
            if let Some((named @ Named::Pending, _)) = self.table.get_mut(&name) {
                *named = Named::Poisoned;
            }
        }
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
        let near = if self.is_terse { None } else { self.nearest(text) };
        match near {
            Some(near) => diagnostic.with_help(format!("did you mean `{near}`?")),
            None => diagnostic.with_help(format!("declare it with {items} above this line")),
        }
    }

    /// A name that differs in a third of its characters or fewer, or in the case of its letters: of a single letter
    /// nothing else is left to go by.
    fn nearest(&self, text: &str) -> Option<String> {
        let length = text.chars().count();
        if length > LONGEST_COMPARED {
            return None;
        }
        let is_near = |distance: usize, known: &str| {
            (distance <= length.div_ceil(3) && distance < length) || known.eq_ignore_ascii_case(text)
        };
        self.table
            .keys()
            .map(String::as_str)
            .chain(FUNCTIONS.iter().copied())
            .filter(|known| known.len() <= LONGEST_COMPARED)
            .map(|known| (edit_distance(text, known), known))
            .filter(|&(distance, known)| is_near(distance, known))
            .min()
            .map(|(_, known)| known.to_string())
    }
}

/// The error of using a name that has no value: that of the declaration it is used in, or one whose declaration failed.
/// The latter only follows from another error, and is not shown beside it.
pub(super) fn unusable(named: &Named, text: &str, span: Span) -> Diagnostic {
    if matches!(named, Named::Pending) {
        return Diagnostic::new(span, format!("the declaration of `{text}` uses its own name"))
            .with_help("a name can be used behind its declaration; choose another name for one of the two");
    }
    Diagnostic::new(span, "this depends on a declaration with an error in it").of(Kind::Consequence)
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
        Named::Pending | Named::Poisoned => "something with an error in it",
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
