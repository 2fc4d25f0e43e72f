//! Time, memory and error of scenes with an increasing number of surfaces, and of receivers: the
//! tables of `docs/benchmarks.md` and the figures next to them.
//!
//! ```text
//! kind of scene, number ─▶ text of a scene ─ separate process, 1 or 2 threads
//!                              └─▶ times, memory, errors ─┬─ table ─▶ docs/benchmarks.md
//!                                                         └─ Plot  ─▶ docs/figures/many_*.svg
//! ```
//! `cargo run --release -p forms-radiometry --example large_scenes [--write] [surfaces|receivers]
//! [NUMBER…]` measures scenes of 10 to 100 000 surfaces and of 100 to 1 000 000 receivers, or the
//! given ones; with `--write` the page and the figures are rewritten.

mod measured;
mod points;
mod room;
mod series;

use std::io;

/// Argument of a process that measures one scene.
const ONE: &str = "--one";

fn main() -> io::Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let numbers: Vec<usize> = arguments.iter().filter_map(|word| word.parse().ok()).collect();
    if let [first, kind, ..] = &arguments[..]
        && first == ONE
    {
        let text = series::text(kind, numbers[0]).expect("a kind of scene");
        println!("{}", measured::here(numbers[0], text).line());
        return Ok(());
    }
    let is_named = |word: &str| arguments.iter().any(|argument| argument == word);
    let all = series::all();
    let is_all = !all.iter().any(|series| is_named(series.name));
    for series in all.iter().filter(|series| is_all || is_named(series.name)) {
        let numbers = if numbers.is_empty() { series.numbers } else { &numbers };
        let rows = series.measured(numbers)?;
        if is_named("--write") {
            series.write(&rows)?;
        }
    }
    Ok(())
}
