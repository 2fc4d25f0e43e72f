//! Formulas of many fields (`tests/stability/applied.forms`): as written, by an expert, and generated with the
//! form that the search has found.
//!
//! ```text
//! applied.forms, applied.stable ─▶ generated ─┐            ┌─ measured ─▶ ns per value ─┐
//! as_written, by_hand ────────────────────────┴─▶ task ─▶ ─┴─ lost ─────▶ bits lost ────┴─▶ table
//! ```
//! `cargo bench -p forms-competitors --bench tasks -- [--write] [NAME…]` measures the tasks whose names
//! contain one of the words, or all. With `--write` and all tasks, the table of `docs/benchmarks.md` is
//! written anew.

mod as_written;
mod by_hand;
mod lost;
mod table;
mod task;

use forms_testing::alternation::seconds_per_call;
use std::hint::black_box;
use std::path::Path;
use task::{Author, Task};

/// Number of values of a call.
const VALUES: usize = 1024;

fn main() -> std::io::Result<()> {
    let (options, words): (Vec<String>, Vec<String>) =
        std::env::args().skip(1).partition(|argument| argument.starts_with('-'));
    let wanted = |name: &str| words.is_empty() || words.iter().any(|word| name.contains(word.as_str()));
    let tasks = task::all().into_iter().filter(|task| wanted(task.name));
    let rows: Vec<table::Row> = tasks.map(|task| row(&task)).collect();
    let table = table::markdown(&rows);
    print!("{table}");
    if words.is_empty() && options.iter().any(|option| option == "--write") {
        let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/benchmarks.md");
        let text = std::fs::read_to_string(&page)?;
        std::fs::write(&page, forms_testing::page::replaced(&text, "tasks", &table))?;
    }
    Ok(())
}

fn row(task: &Task) -> table::Row {
    let columns = task.columns(VALUES);
    let columns: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
    let calls = Author::ALL.map(|author| {
        let (function, columns, mut out) = (task.by(author), &columns, vec![0.0; VALUES]);
        move || function(black_box(columns), black_box(&mut out))
    });
    let seconds = seconds_per_call(calls).into_iter().map(|seconds| seconds / VALUES as f64).collect();
    table::Row { name: task.name, seconds, lost: lost::by_each(task) }
}
