//! Cells of tables: rows in Markdown, and times and ratios with few digits.

use super::scripts::Line;
use std::fmt::Write;

/// Writes a row of cells.
pub fn row(text: &mut String, cells: &[String]) {
    writeln!(text, "| {} |", cells.join(" | ")).expect("a String takes all text");
}

/// Writes the header row, and the line below it.
pub fn heads(text: &mut String, heads: &[&str]) {
    row(text, &heads.iter().map(ToString::to_string).collect::<Vec<_>>());
    row(text, &vec!["---".to_string(); heads.len()]);
}

/// Returns the time of another program, if it took part.
pub fn time(line: Option<&Line>) -> String {
    line.map_or_else(|| "–".to_string(), |line| shown(line.seconds))
}

/// Returns the time of another program divided by these seconds, if it took part.
pub fn ratio(line: Option<&Line>, seconds: f64) -> String {
    line.map_or_else(|| "–".to_string(), |line| in_figures(line.seconds / seconds))
}

/// Returns a time in a suitable unit.
pub fn shown(seconds: f64) -> String {
    let units = [(1.0, "s"), (1e-3, "ms"), (1e-6, "µs")];
    let (unit, name) = units.into_iter().find(|(unit, _)| seconds >= *unit).unwrap_or((1e-9, "ns"));
    format!("{} {name}", in_figures(seconds / unit))
}

/// Returns a number with two digits, or with all digits before the decimal point.
fn in_figures(value: f64) -> String {
    if value >= 10.0 { format!("{value:.0}") } else { format!("{value:.1}") }
}
