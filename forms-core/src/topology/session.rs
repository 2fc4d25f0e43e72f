//! A file with appended items: every query about it is written in the language.

use crate::check::read_theory;
use crate::decide::{Verdict, decide};
use crate::syntax::Source;
use crate::syntax::words::reserved;
use crate::theory::Theory;

/// A source without errors, and its declarations.
pub(super) struct Session {
    text: String,
    pub(super) theory: Theory,
}

impl Session {
    pub(super) fn new(source: &Source) -> Result<Self, String> {
        let (theory, errors) = read_theory(&source.text);
        match errors.first() {
            Some(error) => Err(source.render(error)),
            None => Ok(Session { text: source.text.clone(), theory }),
        }
    }

    /// Decides an equation after the file and some appended items; the error is the first one found
    /// in them.
    pub(super) fn decide(&self, items: &str, equation: &str) -> Result<Verdict, String> {
        let name = self.fresh("asked");
        let mut theory = self.extended(&format!("{items}\nprove {name}: {equation};"))?;
        let statement = theory.statements.iter().find(|statement| statement.name == name).cloned();
        let statement = statement.ok_or("the statement was not read")?;
        Ok(decide(&mut theory, &statement))
    }

    /// Returns the theory of the file with some appended items.
    pub(super) fn extended(&self, items: &str) -> Result<Theory, String> {
        let (theory, errors) = read_theory(&format!("{}\n{items}", self.text));
        errors.into_iter().next().map_or(Ok(theory), |error| Err(error.message))
    }

    /// Returns a name that is not taken: the given one, or the given one with a number appended.
    pub(super) fn fresh(&self, wished: &str) -> String {
        let is_free = |name: &String| {
            let differential = format!("d{name}");
            let taken = |name: &str| self.theory.named(name).is_some() || reserved(name).is_some();
            !taken(name) && !taken(&differential) && self.theory.statements.iter().all(|s| s.name != *name)
        };
        let numbered = (2..).map(|number| format!("{wished}{number}"));
        std::iter::once(wished.to_owned()).chain(numbered).find(is_free).unwrap_or_default()
    }
}
