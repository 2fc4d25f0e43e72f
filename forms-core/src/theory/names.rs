//! The single namespace of a file, and the search for the known name nearest to a misspelt one.

use super::named::{Named, describe};
use super::other_languages;
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::syntax::ast::Name;
use crate::syntax::words::{COMMON_FUNCTIONS, FUNCTIONS};
use rustc_hash::FxHashMap;

/// Maximum length of a name that is compared with others: the cost is the product of the lengths.
const LONGEST_COMPARED: usize = 64;

/// Meaning of each name, and where it was declared.
#[derive(Clone, Debug, Default)]
pub(crate) struct Names {
    table: FxHashMap<String, (Named, Span)>,
    /// Names declared by the item being read.
    pending: Vec<String>,
    /// Whether unknown names are no longer compared with all others, to save time.
    is_terse: bool,
}

impl Names {
    pub(crate) fn get(&self, name: &str) -> Option<&Named> {
        self.table.get(name).map(|entry| &entry.0)
    }

    /// Declares a name; an error if it is taken.
    pub(crate) fn declare(&mut self, name: &Name, meaning: Named) -> Result<(), Diagnostic> {
        self.declare_text(&name.text, name.span, meaning)
    }

    pub(crate) fn declare_text(&mut self, text: &str, span: Span, meaning: Named) -> Result<(), Diagnostic> {
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

    /// Stops suggesting similar names.
    pub(crate) fn be_terse(&mut self) {
        self.is_terse = true;
    }

    /// Ends an item: a name that is still pending becomes poisoned, since the item that should have
    /// declared it has an error.
    pub(crate) fn end_item(&mut self) {
        for name in self.pending.drain(..) {
            if let Some((named @ Named::Pending, _)) = self.table.get_mut(&name) {
                *named = Named::Poisoned;
            }
        }
    }

    /// Replaces the meaning of a declared name.
    pub(crate) fn set(&mut self, name: &Name, meaning: Named) {
        self.table.insert(name.text.clone(), (meaning, name.span));
    }

    pub(crate) fn remove(&mut self, text: &str) {
        self.table.remove(text);
    }

    /// Returns the error for an undeclared name. Its help suggests the nearest known name, or the
    /// items that can declare the name.
    pub(crate) fn unknown(&self, text: &str, span: Span, items: &str) -> Diagnostic {
        if FUNCTIONS.contains(&text) || COMMON_FUNCTIONS.contains(&text) {
            return Diagnostic::new(
                span,
                format!("`{text}` is a function and has no value without arguments"),
            )
            .with_help(format!("write its arguments in brackets: `{text}(…)`"));
        }
        let diagnostic = not_declared(text, span);
        if let Some(here) = other_languages::meaning(text) {
            return diagnostic.with_help(here);
        }
        let near = if self.is_terse { None } else { self.nearest(text) };
        match near {
            Some(near) => diagnostic.with_help(format!("did you mean `{near}`?")),
            None => diagnostic.with_help(format!("declare it with {items} above this line")),
        }
    }

    /// Returns the nearest known name, if it differs in at most a third of the characters, or only
    /// in the case of its letters. The case matters for single letters, where the edit distance
    /// cannot help.
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
            .chain(FUNCTIONS.iter().chain(COMMON_FUNCTIONS).copied())
            .filter(|known| known.len() <= LONGEST_COMPARED)
            .map(|known| (edit_distance(text, known), known))
            .filter(|&(distance, known)| is_near(distance, known))
            .min()
            .map(|(_, known)| known.to_string())
    }
}

/// Returns the error for a name that has no value yet, because it is used in its own declaration,
/// or because its declaration failed. In the second case the error only follows from another one,
/// and is not shown together with it.
pub(crate) fn unusable(named: &Named, text: &str, span: Span) -> Diagnostic {
    if matches!(named, Named::Pending) {
        return Diagnostic::new(span, format!("the declaration of `{text}` uses its own name"))
            .with_help("a name can be used only after its declaration; rename one of the two");
    }
    Diagnostic::new(span, "this depends on a declaration that has an error").of(Kind::Consequence)
}

/// Items that declare values.
pub(crate) const VALUES: &str = "`chart`, `param`, `fn` or `let`";

/// Returns the error for an undeclared name, without help.
pub(crate) fn not_declared(text: &str, span: Span) -> Diagnostic {
    Diagnostic::new(span, format!("`{text}` is not declared")).of(Kind::UnknownName)
}

/// Returns the number of single-character edits between two words (Levenshtein distance).
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
