//! The table of a page: a row for each workload, between two marks of the page.

use super::clock::seconds;
use super::workload::{Work, processor};
use std::fmt::Write;

const BEGIN: &str = "<!-- measured -->\n";
const END: &str = "<!-- end -->";

/// The rows, each measured.
pub(crate) fn rows(works: Vec<Work>) -> String {
    let mut rows = format!("Processor: {}.\n\n| work | goal | measured |\n|---|---|---|\n", processor());
    for mut work in works {
        let time = shown(seconds(&mut work.run));
        println!("{time:>9}  {}", work.name);
        let name = work.name.replace('|', "\\|");
        let goal = if work.goal.is_empty() { "–" } else { work.goal };
        writeln!(rows, "| {name} | {goal} | {time} |").expect("a String takes all text");
    }
    rows
}

/// The page with these rows instead of what stands between the marks; as it is if it has no marks.
pub(crate) fn replaced(page: &str, rows: &str) -> String {
    let parts = page.split_once(BEGIN).and_then(|(head, rest)| Some((head, rest.split_once(END)?.1)));
    parts.map_or_else(|| page.to_string(), |(head, tail)| format!("{head}{BEGIN}{rows}{END}{tail}"))
}

/// Two figures or three, with a unit.
fn shown(seconds: f64) -> String {
    let (value, unit) = match seconds {
        s if s < 1e-3 => (s * 1e6, "µs"),
        s if s < 1.0 => (s * 1e3, "ms"),
        s => (s, "s"),
    };
    let decimals = usize::from(value < 10.0) + usize::from(value < 1.0);
    format!("{value:.decimals$} {unit}")
}
