//! The table: a row for each kernel with nanoseconds per value, and the ratios for which goals are
//! set.

use crate::catalogue::Author;
use crate::page::processor;
use std::fmt::Write;

/// Kernel and the seconds per value of each of its functions.
pub(crate) struct Row {
    pub(crate) name: &'static str,
    pub(crate) seconds: Vec<(Author, f64)>,
}

impl Row {
    /// Returns the time of that author's function, if the kernel has one.
    pub(crate) fn of(&self, author: Author) -> Option<f64> {
        self.seconds.iter().find(|(name, _)| *name == author).map(|(_, seconds)| *seconds)
    }

    fn ratio(&self, above: Author, below: Author) -> Option<f64> {
        Some(self.of(above)? / self.of(below)?)
    }
}

/// Ratios of times that are shown, with the headers of their columns.
const RATIOS: [(&str, Author, Author); 3] = [
    ("generated / expert", Author::Generated, Author::Expert),
    ("wrenfold / generated", Author::Wrenfold, Author::Generated),
    ("SymPy / generated", Author::SymPy, Author::Generated),
];

fn shown(value: Option<f64>) -> String {
    value.map_or_else(|| "–".to_string(), |value| format!("{value:.2}"))
}

/// Returns the rows in Markdown, after the name of the processor.
pub(crate) fn markdown(rows: &[Row], instructions: &str) -> String {
    let heads = Author::ALL.iter().map(|author| author.name()).chain(RATIOS.iter().map(|ratio| ratio.0));
    let heads: Vec<&str> = heads.collect();
    let mut table = format!("Processor: {}; {instructions}.\n\n", processor());
    writeln!(table, "| kernel | {} |\n|---|{}", heads.join(" | "), "---|".repeat(heads.len()))
        .expect("a String takes all text");
    for row in rows {
        let times = Author::ALL.iter().map(|author| shown(row.of(*author).map(|seconds| seconds * 1e9)));
        let ratios = RATIOS.iter().map(|(_, above, below)| shown(row.ratio(*above, *below)));
        let cells: Vec<String> = times.chain(ratios).collect();
        writeln!(table, "| {} | {} |", row.name, cells.join(" | ")).expect("a String takes all text");
    }
    table
}
