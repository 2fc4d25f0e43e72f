//! Cells of tables: rows in Markdown, times and ratios in few figures.

use crate::elsewhere::Line;
use std::fmt::Write;

/// A row of cells.
pub(crate) fn row(text: &mut String, cells: &[String]) {
    writeln!(text, "| {} |", cells.join(" | ")).expect("a String takes all text");
}

/// The row of heads, and the line below it.
pub(crate) fn heads(text: &mut String, heads: &[&str]) {
    row(text, &heads.iter().map(ToString::to_string).collect::<Vec<_>>());
    row(text, &vec!["---".to_string(); heads.len()]);
}

/// The time of another program, if it took part.
pub(crate) fn time(line: Option<&Line>) -> String {
    line.map_or_else(|| "–".to_string(), |line| shown(line.seconds))
}

/// How many times as long as so many seconds another program took, if it took part.
pub(crate) fn ratio(line: Option<&Line>, seconds: f64) -> String {
    line.map_or_else(|| "–".to_string(), |line| in_figures(line.seconds / seconds))
}

/// A time in the unit that suits it.
pub(crate) fn shown(seconds: f64) -> String {
    let units = [(1.0, "s"), (1e-3, "ms"), (1e-6, "µs")];
    let (unit, name) = units.into_iter().find(|(unit, _)| seconds >= *unit).unwrap_or((1e-9, "ns"));
    format!("{} {name}", in_figures(seconds / unit))
}

/// Two figures, or all before the point.
fn in_figures(value: f64) -> String {
    if value >= 10.0 { format!("{value:.0}") } else { format!("{value:.1}") }
}
