//! Generated kernels compared with hand-written expert code and with the output of other
//! generators.
//!
//! ```text
//! inputs ─▶ columns ─────────────┐
//! forms-competitors ─ catalogue ─ measure ─▶ ns per value ─┬─ table ─▶ stdout, docs/benchmarks.md
//!                                                          └─ figure ─▶ docs/figures/kernels.svg
//! ```
//! `cargo bench --bench kernels -- [--write] [NAME…]` measures the kernels whose names contain one
//! of the words, or all. With `--write` and all kernels, the page and the figure are rewritten.
//! With `--instructions`, instructions are counted instead and compared with the record; `--write`
//! writes the record.

mod figure;
mod instructions;
mod measure;
mod table;

use forms_competitors::expert::batch::InstructionSet;
use forms_competitors::{catalogue, inputs};
use forms_testing::page;
use std::path::Path;
use std::process::ExitCode;
use table::Row;

fn main() -> std::io::Result<ExitCode> {
    if instructions::is_counted() {
        return Ok(ExitCode::SUCCESS);
    }
    let (options, words): (Vec<String>, Vec<String>) =
        std::env::args().skip(1).partition(|argument| argument.starts_with('-'));
    let has = |name: &str| options.iter().any(|option| option == name);
    if has("--instructions") {
        return instructions::check(has("--write"));
    }
    let set = InstructionSet::detected();
    let entries = catalogue::all(set);
    let wanted = |name: &str| words.is_empty() || words.iter().any(|word| name.contains(word.as_str()));
    let measured = entries.iter().filter(|entry| wanted(entry.name));
    let rows: Vec<Row> =
        measured.map(|entry| Row { name: entry.name, seconds: measure::seconds_per_value(entry) }).collect();
    let table = table::markdown(&rows, set.name());
    print!("{table}");
    let missing = forms_competitors::missing();
    for (tool, why) in &missing {
        forms_testing::skipped("kernels", tool, why);
    }
    if words.is_empty() && has("--write") {
        if !missing.is_empty() {
            return Err(std::io::Error::other(
                "the page has a column for each generator: none may be skipped",
            ));
        }
        write(&rows, &table)?;
    }
    Ok(ExitCode::SUCCESS)
}

fn write(rows: &[Row], table: &str) -> std::io::Result<()> {
    let documents = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs");
    std::fs::write(documents.join("figures/kernels.svg"), figure::svg(rows))?;
    let path = documents.join("benchmarks.md");
    let page = page::replaced(&std::fs::read_to_string(&path)?, "kernels", table);
    std::fs::write(path, page)
}
