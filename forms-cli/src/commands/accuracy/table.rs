//! The report as a table for the terminal.

use super::report::{Report, Row};
use crate::palette::Palette;
use forms::core::accuracy::Statistics;
use std::io::{self, Write};

/// Writes the table of one kernel.
pub(super) fn write(report: &Report, output: &mut dyn Write) -> io::Result<()> {
    let palette = Palette::of_output();
    writeln!(output, "{}", palette.heading(&report.kernel))?;
    if let Some(form) = report.form.as_ref().filter(|form| form.len() <= 120) {
        writeln!(output, "  {}", palette.quiet(&format!("stable: {form}")))?;
    }
    let heads = format!(
        "  {:<17}{:>9}  {:^20}  {:^27}",
        "", "ns/value", "typical, bits lost", "hardest regime, bits lost"
    );
    writeln!(output, "{}", palette.quiet(heads.trim_end()))?;
    let heads = format!(
        "  {:<17}{:>9}  {:>6}{:>7}{:>7}  {:<11}{:>5}{:>7}",
        "", "", "mean", "p99", "max", "", "mean", "max"
    );
    writeln!(output, "{}", palette.quiet(&heads))?;
    for row in &report.rows {
        let text = line(row);
        writeln!(output, "{}", if row.pareto { palette.good(&text) } else { text })?;
    }
    writeln!(output)
}

fn line(row: &Row) -> String {
    let mark = if row.pareto { "*" } else { " " };
    let time = row.time();
    let typical = row.line.typical().map_or(" ".repeat(20), |score| numbers(&score.bits));
    let hardest = row.hardest().map_or(String::new(), |score| {
        format!("{:<11}{:>5.1}{:>7.1}", score.regime.name(), score.bits.mean, score.bits.maximum)
    });
    format!("{mark} {:<17}{time:>9}  {typical}  {hardest}", row.variant().name())
}

fn numbers(bits: &Statistics) -> String {
    format!("{:>6.2}{:>7.1}{:>7.1}", bits.mean, bits.percentile, bits.maximum)
}

/// Writes the explanation of the columns.
pub(super) fn legend(timed: bool, output: &mut dyn Write) -> io::Result<()> {
    let palette = Palette::of_output();
    let mut lines = vec![
        "Bits lost are log2(1 + floating-point numbers between the result and the correctly",
        "rounded value); of dd, log2(1 + error / 2**-106 of the value). Rounding error alone.",
    ];
    lines.push(if timed {
        "* no other variant is as fast and as accurate, on average over all regimes."
    } else {
        "Times were not measured: --no-times was given, or rustc is not available."
    });
    lines.iter().try_for_each(|line| writeln!(output, "{}", palette.quiet(line)))
}
