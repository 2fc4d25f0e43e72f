//! Report on a form: sentences, items of the language, and statements that were proved.

use std::fmt;

/// The lines of a report, in the order of the argument.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// The lines; each is a sentence, an item or a proved statement.
    pub lines: Vec<Line>,
}

/// A line of a report.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Line {
    /// A sentence.
    Words(String),
    /// A declaration in the language, to be appended to the file.
    Item(String),
    /// A statement in the language, proved after the file and the items above it.
    Proved {
        /// The statement.
        statement: String,
        /// Conditions it needs in addition to the conditions of the form's domain.
        beyond: Vec<String>,
    },
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for line in &self.lines {
            match line {
                Line::Words(words) => writeln!(f, "{words}")?,
                Line::Item(item) => writeln!(f, "    {item}")?,
                Line::Proved { statement, beyond } if beyond.is_empty() => {
                    writeln!(f, "    {statement}    (proved)")?;
                }
                Line::Proved { statement, beyond } => {
                    writeln!(f, "    {statement}    (proved where {})", beyond.join(", "))?;
                }
            }
        }
        Ok(())
    }
}
