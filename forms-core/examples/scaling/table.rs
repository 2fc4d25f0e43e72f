//! Table of a page, with a row for each workload.

use forms_core_testing::workload::Work;
use forms_testing::page::processor;
use forms_testing::processor_clock::seconds;
use std::fmt::Write;

/// Measures every workload and returns the rows.
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

/// Formats a time with two or three digits and a unit.
fn shown(seconds: f64) -> String {
    let (value, unit) = match seconds {
        s if s < 1e-3 => (s * 1e6, "µs"),
        s if s < 1.0 => (s * 1e3, "ms"),
        s => (s, "s"),
    };
    let decimals = usize::from(value < 10.0) + usize::from(value < 1.0);
    format!("{value:.decimals$} {unit}")
}
