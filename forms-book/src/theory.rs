//! The theories of a page: reads the blocks, decides their statements and collects all errors.
//!
//! ```text
//! blocks ─┬─ forms ─▶ one theory, with the line numbers of the page ─┐
//!         └─ forms,alone ─▶ one theory per block ────────────────────┴─ read, decide, generate ─▶ Findings
//! ```

use crate::page::{Block, Page};
use forms_core::check::{objection, read_theory};
use forms_core::compile::compile_kernel;
use forms_core::decide::decide;
use forms_core::diagnostic::Diagnostic;
use forms_core::generation::specialisations;
use forms_core::syntax::Source;
use std::ops::AddAssign;

/// Result of checking a text.
#[derive(Clone, Debug, Default)]
pub(crate) struct Findings {
    /// Errors, statements that are not as claimed, and kernels that cannot be generated: the line
    /// and the rendered message.
    pub(crate) complaints: Vec<(usize, String)>,
    /// Numbers of checked items.
    pub(crate) counted: Counted,
}

/// Numbers of checked items, by kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counted {
    /// Decided statements, including those of exercises with their answers.
    pub statements: usize,
    /// Generated kernels.
    pub kernels: usize,
    /// Exercises, each checked with its answer and with its hole.
    pub exercises: usize,
    /// Quoted errors.
    pub errors: usize,
    /// Checked links between files.
    pub links: usize,
}

impl AddAssign for Counted {
    fn add_assign(&mut self, other: Self) {
        self.statements += other.statements;
        self.kernels += other.kernels;
        self.exercises += other.exercises;
        self.errors += other.errors;
        self.links += other.links;
    }
}

/// Returns the theories of a page as texts; every line keeps its line number in the page.
pub(crate) fn sources(page: &Page, blocks: &[Block]) -> Vec<Source> {
    let common: Vec<&Block> = blocks.iter().filter(|block| block.kind == "forms").collect();
    let alone = blocks.iter().filter(|block| block.kind == "forms,alone").map(|block| vec![block]);
    let theories = std::iter::once(common).chain(alone).filter(|blocks| !blocks.is_empty());
    theories.map(|blocks| Source::new(&page.path, placed(&blocks))).collect()
}

/// Joins the texts of blocks, with empty lines before each block up to its line in the page.
fn placed(blocks: &[&Block]) -> String {
    let (mut text, mut line) = (String::new(), 1);
    for block in blocks {
        text.extend(std::iter::repeat_n('\n', (block.line + 1).saturating_sub(line)));
        text.push_str(&block.text);
        line = block.line + 1 + block.text.lines().count();
    }
    text
}

/// Joins the blocks of a page's common theory among the given blocks.
pub fn common_text(blocks: &[Block]) -> String {
    blocks.iter().filter(|block| block.kind == "forms").map(|block| block.text.as_str()).collect()
}

/// Reads a text, and checks its statements and kernels from a byte offset onwards.
pub(crate) fn findings(source: &Source, from: usize) -> Findings {
    let (mut theory, mut diagnostics) = read_theory(&source.text);
    let mut counted = Counted::default();
    if diagnostics.is_empty() {
        let is_new = |start: u32| usize::try_from(start).is_ok_and(|start| start >= from);
        let statements = theory.statements.clone();
        for statement in statements.iter().filter(|statement| is_new(statement.span.start)) {
            let verdict = decide(&mut theory, statement);
            diagnostics.extend(objection(statement, &verdict));
            counted.statements += 1;
        }
        let kernels = theory.kernels.clone();
        for kernel in kernels.iter().filter(|kernel| is_new(kernel.span.start)) {
            let compiled = compile_kernel(&mut theory.pool, kernel).map(|_| ());
            let found = compiled.and_then(|()| specialisations(&mut theory.pool, kernel).map(|_| ()));
            diagnostics.extend(found.err().into_iter().flatten());
            counted.kernels += 1;
        }
    }
    let shown =
        |diagnostic: &Diagnostic| (source.position(diagnostic.span.start).line, source.render(diagnostic));
    Findings { complaints: diagnostics.iter().map(shown).collect(), counted }
}

/// Returns all messages for a text that is a theory of its own.
pub(crate) fn message(text: &str) -> String {
    let complaints = findings(&Source::new("example.forms", text), 0).complaints;
    let shown: Vec<String> = complaints.into_iter().map(|(_, shown)| shown).collect();
    shown.join("\n").lines().map(|line| format!("{}\n", line.trim_end())).collect()
}
