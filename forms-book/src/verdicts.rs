//! The HTML below a block of the book: the verdict of each statement with the steps that decide it,
//! and the declarations in mathematical notation.
//!
//! ```text
//! block ─ items ─┬─ statements, warps ─ derive ─▶ one closed <details> each
//!                └─ forms, kernels ─ notation ──▶ one closed <details>
//! ```

use crate::escape::escaped;
use crate::mathml::{LONGEST_FORMULA, display};
use forms_core::check::read_file;
use forms_core::decide::Verdict;
use forms_core::derivation::{Derivation, Line, derive};
use forms_core::diagnostic::Span;
use forms_core::notation::{latex_of_name, latex_of_named};
use forms_core::syntax::Source;
use forms_core::syntax::ast::{File, ItemKind};
use forms_core::theory::{Named, Theory};
use rayon::prelude::*;
use std::ops::Range;

/// Theory that is shown in parts.
pub(crate) struct Shown {
    source: Source,
    file: File,
    theory: Theory,
}

impl Shown {
    /// Reads a text. A text with errors yields `None`.
    pub(crate) fn new(source: Source) -> Option<Self> {
        let (file, theory, diagnostics) = read_file(&source.text);
        diagnostics.is_empty().then_some(Shown { source, file, theory })
    }

    /// Returns the HTML below the block at this range of the text: one piece of HTML without empty
    /// lines.
    pub(crate) fn below(&self, part: Range<usize>) -> Result<String, String> {
        let is_inside = |span: Span| part.contains(&(span.start as usize));
        let statements = self.theory.statements.iter().filter(|statement| is_inside(statement.span));
        let names: Vec<&str> = statements.map(|statement| statement.name.as_str()).collect();
        let verdicts: Result<Vec<String>, String> = names
            .into_par_iter()
            .filter_map(|name| derive(&self.source, name))
            .map(|derivation| details(&derivation))
            .collect();
        let items = self.file.items.iter().filter(|item| is_inside(item.span));
        let declared: Vec<String> = items.filter_map(|item| self.declared(&item.kind)).collect();
        let mut below = String::new();
        if !declared.is_empty() {
            let formulas: Result<String, String> = declared.iter().map(|latex| formula(latex)).collect();
            below.push_str("<details class=\"declared\"><summary>in mathematical notation</summary>\n");
            below.push_str(&format!("{}</details>\n", formulas?));
        }
        Ok(below + &verdicts?.concat())
    }

    /// Returns a declared form or kernel in LaTeX, `name = value`.
    fn declared(&self, kind: &ItemKind) -> Option<String> {
        let (ItemKind::Form { name, .. } | ItemKind::Kernel { name, .. }) = kind else { return None };
        let mut theory = self.theory.clone();
        let value = latex_of_named(&mut theory, &name.text)?;
        let mut title = latex_of_name(&name.text);
        if let Some(Named::Kernel(number)) = theory.named(&name.text) {
            let parameters = theory.kernels[*number].signature.parameters.iter();
            let arguments: Vec<String> = parameters.map(|parameter| latex_of_name(&parameter.name)).collect();
            title = format!("{title}\\left({}\\right)", arguments.join(", "));
        }
        let written = format!("{title} = {value}");
        (written.len() <= LONGEST_FORMULA).then_some(written)
    }
}

/// Renders a statement with its verdict; when opened, it shows the steps that decide it.
fn details(derivation: &Derivation) -> Result<String, String> {
    let words = match &derivation.verdict {
        Verdict::Proved(_) => "proved",
        Verdict::Refuted(_) => "refuted",
        Verdict::Unknown { .. } => "undecided",
        Verdict::Empty { .. } => "vacuous",
    };
    let (class, mark) = if derivation.ok { ("verdict", "✓") } else { ("verdict wrong", "✗") };
    let summary =
        format!("<span class=\"mark\">{mark}</span> <code>{}</code> {words}", escaped(&derivation.name));
    Ok(format!("<details class=\"{class}\"><summary>{summary}</summary>\n{}</details>\n", steps(derivation)?))
}

/// Renders the steps of a derivation as a list, with formulas as MathML and without empty lines.
///
/// # Errors
/// If a formula cannot be written in MathML.
pub fn steps(derivation: &Derivation) -> Result<String, String> {
    let mut list = String::from("<ol class=\"steps\">\n");
    for step in &derivation.steps {
        list.push_str(&format!("<li><p class=\"step\">{}</p>\n", escaped(&step.title)));
        for line in &step.lines {
            match line {
                Line::Words(words) => list.push_str(&format!("<p>{}</p>\n", escaped(words))),
                Line::Formula(line) => list.push_str(&formula(&line.latex)?),
            }
        }
        list.push_str("</li>\n");
    }
    Ok(list + "</ol>\n")
}

/// Renders a displayed formula; it scrolls if it is wider than the page.
fn formula(latex: &str) -> Result<String, String> {
    Ok(format!("<div class=\"formula\">{}</div>\n", display(latex)?.replace('\n', " ")))
}
