//! Time, memory and error of scenes with more and more surfaces: the table of `docs/benchmarks.md` and the figure beside it.
//!
//! ```text
//! number of surfaces ─ room ─▶ text of a scene ─ a process of its own, with 1 or 2 threads ─▶ times, memory, errors
//!                                                   ─┬─ table ─▶ docs/benchmarks.md
//!                                                    └─ plot  ─▶ docs/figures/many_surfaces.svg
//! ```
//! `cargo run --release -p forms-radiometry --example many_surfaces [--write] [SURFACES…]` measures scenes of 10 to 100 000 surfaces, or
//! of the numbers that are given; with `--write` the page and the figure are written anew.

#[path = "../../../forms-core/benches/page/mod.rs"]
mod page;
#[path = "../../../forms-core/examples/scaling/plot.rs"]
#[expect(dead_code, reason = "its other scale is for other figures")]
mod plot;

mod measured;
mod room;

use measured::Measured;
use page::processor;
use plot::{Plot, Scale, Series};
use std::fmt::Write;
use std::io;
use std::path::PathBuf;

/// The numbers of surfaces that are measured.
const SURFACES: [usize; 5] = [10, 100, 1_000, 10_000, 100_000];
const THREADS: [usize; 2] = [1, 2];
/// What marks a process that measures one scene.
const ONE: &str = "--one";

fn main() -> io::Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let numbers: Vec<usize> = arguments.iter().filter_map(|word| word.parse().ok()).collect();
    if arguments.first().is_some_and(|word| word == ONE) {
        numbers.iter().for_each(|&surfaces| println!("{}", measured::here(surfaces).line()));
        return Ok(());
    }
    let numbers = if numbers.is_empty() { SURFACES.to_vec() } else { numbers };
    let mut rows = Vec::new();
    println!("{HEAD}");
    for surfaces in numbers {
        for threads in THREADS {
            let found = measured::elsewhere(surfaces, threads)?;
            println!("{}", row(threads, &found));
            rows.push((threads, found));
        }
    }
    if arguments.iter().any(|word| word == "--write") {
        write(&rows)?;
    }
    Ok(())
}

const HEAD: &str = "| surfaces | threads | reading | plan | answers | memory | error, largest of ten |\n\
                    |---|---|---|---|---|---|---|";

fn row(threads: usize, found: &Measured) -> String {
    let Measured { surfaces, reading, planning, answering, memory, error } = found;
    let mebibytes = memory / 1024.0;
    format!(
        "| {surfaces} | {threads} | {reading:.3} s | {planning:.3} s | {answering:.2} s | {mebibytes:.0} MiB | {error:.1e} |"
    )
}

fn write(rows: &[(usize, Measured)]) -> io::Result<()> {
    let documents = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../docs");
    let mut table = format!("Processor: {}.\n\n{HEAD}\n", processor());
    for (threads, found) in rows {
        writeln!(table, "{}", row(*threads, found)).expect("a String takes all text");
    }
    let path = documents.join("benchmarks.md");
    let page = page::replaced(&std::fs::read_to_string(&path)?, "many surfaces", &table);
    std::fs::write(path, page)?;
    std::fs::write(documents.join("figures/many_surfaces.svg"), figure(rows).svg())
}

fn figure(rows: &[(usize, Measured)]) -> Plot {
    let line = |name: &str, threads: usize, seconds: fn(&Measured) -> f64| {
        let points = rows.iter().filter(|(count, _)| *count == threads);
        let points = points.map(|(_, found)| [found.surfaces as f64, seconds(found)]);
        Series { name: name.to_string(), points: points.collect() }
    };
    Plot {
        title: "Time against the number of surfaces".into(),
        caption: format!("{}, ten receivers within 1%", processor()),
        across: "surfaces".into(),
        scale: Scale::Logarithmic,
        series: vec![
            line("plan and answers, 1 thread", 1, |found| found.planning + found.answering),
            line("plan and answers, 2 threads", 2, |found| found.planning + found.answering),
            line("reading the file", 1, |found| found.reading),
        ],
    }
}
