//! Derivations: the reasons why a statement holds or fails, in steps that a person can follow.
//!
//! ```text
//! source ─ resolve, every value noted ─▶ definitions, calculus ─┐
//! statement ─ decide ─▶ verdict ─ account of the proof ─────────┴─▶ steps ─▶ text · LaTeX
//! ```
//! A derivation decides nothing: it shows the steps of the engine in the order in which a reader
//! would check them.

mod calculus;
mod conclusion;
mod definitions;
mod proof;
mod render;
mod scribe;

pub(crate) use conclusion::{assignment, digits};
pub use scribe::Formula;

use crate::decide::{Verdict, decide};
use crate::expression::Condition;
use crate::resolve::resolve_traced;
use crate::syntax::ast::{File, Item, ItemKind};
use crate::syntax::{Source, read};
use crate::theory::Theory;
use scribe::Scribe;

/// The steps that decide one statement.
#[derive(Clone, Debug)]
pub struct Derivation {
    /// The statement's name.
    pub name: String,
    /// The verdict on the statement.
    pub verdict: Verdict,
    /// Whether the verdict agrees with the claim of the statement.
    pub ok: bool,
    /// The steps in order.
    pub steps: Vec<Step>,
}

/// One step: an action and its result.
#[derive(Clone, Debug)]
pub struct Step {
    /// Title that names the action.
    pub title: String,
    /// Lines of the result.
    pub lines: Vec<Line>,
}

/// A line of a step.
#[derive(Clone, Debug)]
pub enum Line {
    /// A sentence.
    Words(String),
    /// A formula, usually an equation.
    Formula(Formula),
}

impl Step {
    fn new(title: impl Into<String>, lines: Vec<Line>) -> Self {
        Step { title: title.into(), lines }
    }
}

/// Derives one statement of a source that has no errors; `None` if it has no statement of that
/// name.
///
/// ```
/// use forms_core::derivation::derive;
/// use forms_core::syntax::Source;
/// let source = Source::new("example.forms", "chart R2(x, y); prove closed: d(x*dx + y*dy) == 0;");
/// let derivation = derive(&source, "closed").expect("the statement is there");
/// assert!(derivation.ok);
/// assert!(derivation.text().contains("d(x*dx + y*dy) = 0"));
/// ```
pub fn derive(source: &Source, name: &str) -> Option<Derivation> {
    let (mut file, _) = read(&source.text);
    let (mut theory, trace, _) = resolve_traced(&file);
    let claims = claims_of_warps(&file, &theory);
    file.items.extend(claims);
    let statement = theory.statements.iter().find(|statement| statement.name == name)?.clone();
    let verdict = decide(&mut theory, &statement);
    let claim = claim(&file, name)?;
    let assumptions: Vec<Condition> = statement.conditions.iter().chain(&statement.domain).copied().collect();
    let mut scribe = Scribe { source, theory: &mut theory, trace: &trace, assumptions: &assumptions };
    let mut steps = vec![conclusion::claim(&scribe, claim)];
    let items = definitions::needed(&file, claim);
    steps.extend(definitions::step(&scribe, &items));
    steps.extend(calculus::step(&mut scribe, &items, claim));
    match &verdict {
        Verdict::Proved(_) => {
            steps.extend(proof::steps(&mut scribe, &statement));
            steps.push(conclusion::proved(&mut scribe, &statement));
        }
        Verdict::Refuted(witness) => steps.push(conclusion::refuted(&mut scribe, &statement, witness)),
        Verdict::Unknown { reason } => steps.push(conclusion::open(reason.to_string())),
        Verdict::Empty { reason } => steps.push(conclusion::open(reason.to_string())),
    }
    let ok = verdict.bears_out(statement.claim);
    Some(Derivation { name: name.to_owned(), verdict, ok, steps })
}

/// Returns the statements that follow from the warps of a source.
fn claims_of_warps(file: &File, theory: &Theory) -> Vec<Item> {
    let claims = |item: &Item| {
        let ItemKind::Warp(warp) = &item.kind else { return Vec::new() };
        let known = theory.warps.iter().find(|known| known.name == warp.name.text);
        known.map_or(Vec::new(), |known| warp.claims(item, known.reverses))
    };
    file.items.iter().flat_map(claims).collect()
}

/// Returns the item of a statement.
fn claim<'a>(file: &'a File, wanted: &str) -> Option<&'a ItemKind> {
    let kinds = file.items.iter().map(|item| &item.kind);
    kinds.into_iter().find(|kind| matches!(kind, ItemKind::Statement { name, .. } if name.text == wanted))
}
