//! Notebooks: display of a theory in cells, as typeset mathematics.
//!
//! ```text
//! text ─ read ─▶ Session ─┬─ show ───▶ Shown       a name with the object it denotes
//!                         ├─ decide ─▶ Decided     every claim with its verdict
//!                         └─ derive ─▶ Derivation  the steps that decide one claim
//! numbers ───────────────────────────▶ Table
//! ```
//! The kernel [evcxr](https://github.com/evcxr/evcxr) calls `evcxr_display` of the value at the end
//! of a cell, and reads the output between two marks as content of one MIME type. Formulas are
//! LaTeX, which Jupyter typesets, with a plain-text version for terminals.

mod session;
mod table;
mod verdict;

pub use session::{Decided, Session, Shown};
pub use table::Table;

use crate::derivation::{Derivation, Line};

/// Prints content of a MIME type between the marks that evcxr looks for. A cell has one content of
/// each type.
///
/// ```
/// // prints three lines
/// forms_core::notebook::print_content("text/latex", "$\\beta$");
/// ```
pub fn print_content(mime: &str, content: &str) {
    println!("EVCXR_BEGIN_CONTENT {mime}\n{}\nEVCXR_END_CONTENT", content.trim_end());
}

/// Prints Markdown, and plain text for front ends that cannot display Markdown.
fn print_markdown(markdown: &str, plain: &str) {
    print_content("text/markdown", markdown);
    print_content("text/plain", plain);
}

impl Derivation {
    /// Returns the steps in Markdown: titles in bold, formulas in LaTeX on lines of their own.
    pub fn markdown(&self) -> String {
        let mut markdown = String::new();
        for (number, step) in self.steps.iter().enumerate() {
            markdown.push_str(&format!("**{}. {}**\n\n", number + 1, escaped(&step.title)));
            for line in &step.lines {
                match line {
                    Line::Words(words) => markdown.push_str(&format!("{}\n\n", escaped(words))),
                    Line::Formula(formula) => markdown.push_str(&format!("$${}$$\n\n", formula.latex)),
                }
            }
        }
        markdown
    }

    /// Shows the steps in a cell of a notebook.
    pub fn evcxr_display(&self) {
        print_markdown(&self.markdown(), &self.text());
    }
}

/// Escapes the characters that have a meaning in Markdown or HTML.
fn escaped(words: &str) -> String {
    let mut text = String::new();
    for c in words.chars() {
        match c {
            '<' => text.push_str("&lt;"),
            '>' => text.push_str("&gt;"),
            '&' => text.push_str("&amp;"),
            '\\' | '`' | '*' | '_' | '$' | '[' | ']' | '|' => text.extend(['\\', c]),
            _ => text.push(c),
        }
    }
    text
}
