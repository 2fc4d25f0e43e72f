//! The table: a row for each task with nanoseconds per value, ratios, and bits lost.

use crate::lost::Lost;
use crate::task::Author;
use forms_competitors::expert::batch::InstructionSet;
use forms_testing::page::processor;
use std::fmt::Write;

/// Task with the seconds per value of its functions, in the order of [`Author::ALL`].
pub(crate) struct Row {
    pub(crate) name: &'static str,
    pub(crate) seconds: Vec<f64>,
    pub(crate) lost: Lost,
}

const HEAD: &str = "| task | as written | expert | generated | generated / expert | expert, batch | generated, batch | generated / expert | bits lost as written: mean, largest | expert | generated | promise |
|---|---|---|---|---|---|---|---|---|---|---|---|
";

/// Returns the rows in Markdown, after the name of the processor.
pub(crate) fn markdown(rows: &[Row]) -> String {
    let mut table = format!("Processor: {}; {}.\n\n{HEAD}", processor(), InstructionSet::detected().name());
    for row in rows {
        let of = |author: Author| row.seconds[author as usize];
        let shown = |author: Author| format!("{:.2}", of(author) * 1e9);
        let ratio = |above: Author, below: Author| format!("{:.2}", of(above) / of(below));
        let mut cells = vec![
            format!("`{}`", row.name),
            shown(Author::AsWritten),
            shown(Author::Expert),
            shown(Author::Generated),
            ratio(Author::Generated, Author::Expert),
            shown(Author::ExpertBatch),
            shown(Author::GeneratedBatch),
            ratio(Author::GeneratedBatch, Author::ExpertBatch),
        ];
        cells.extend(row.lost.bits.iter().map(|bits| format!("{:.2}, {:.1}", bits.mean, bits.maximum)));
        cells.push(
            row.lost.within.as_ref().map_or_else(|| "–".to_string(), |within| format!("within {within}")),
        );
        writeln!(table, "| {} |", cells.join(" | ")).expect("a String takes all text");
    }
    table
}
