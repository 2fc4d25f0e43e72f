//! What the plan saves: every scene of the gallery as planned, and with every effect forced on that is simulated.
//!
//! ```text
//! scenes/*.toml ─┬─ as they are ────────── plan ─▶ answers, time ─┐
//!                └─ all effects forced on ─ plan ─▶ answers, time ─┴─▶ a row of docs/benchmarks.md
//! ```
//! `cargo run --release -p forms-radiometry --example effects` prints the table; with `--write` the page is written anew.

#[path = "gallery/mod.rs"]
mod gallery;
#[path = "../../forms-core/benches/page/mod.rs"]
mod page;

use forms_radiometry::scene::Scene;
use forms_radiometry::simulation::{Plan, Simulation, Unwatched, plan, simulate};
use gallery::{Problem, said, scene};
use std::fmt::Write;
use std::path::Path;
use std::time::Instant;

/// Runs of which the median is taken: an odd number.
const RUNS: usize = 3;
const FORCED: &str =
    "effects = { direct = \"on\", occlusion = \"on\", interreflection = \"on\", bands = \"on\" }";
const HEAD: &str = "| scene | simulated | dropped | bound of what is dropped | as planned | all on | all on / planned | largest difference, relative | errors said, relative |\n\
                    |---|---|---|---|---|---|---|---|---|\n";

fn main() -> Result<(), Problem> {
    let mut table = format!("Processor: {}.\n\n{HEAD}", page::processor());
    for file in gallery::files()? {
        let row = row(&file)?;
        print!("{row}");
        table += &row;
    }
    if std::env::args().any(|word| word == "--write") {
        let path = gallery::folder().join("../docs/benchmarks.md");
        std::fs::write(&path, page::replaced(&std::fs::read_to_string(&path)?, "effects", &table))?;
    }
    Ok(())
}

/// The row of one scene.
fn row(file: &Path) -> Result<String, Problem> {
    let text = std::fs::read_to_string(file)?;
    let name = gallery::name(file);
    let planned = Run::of(&scene(&text, &name)?)?;
    let full = Run::of(&scene(&with_all_effects(&text), &name)?)?;
    let names = |on: bool| {
        let chosen = planned.plan.effects.iter().filter(|effect| effect.on == on);
        chosen.map(|effect| effect.effect.name()).collect::<Vec<_>>().join(", ")
    };
    let bound: f64 =
        planned.plan.effects.iter().filter(|effect| !effect.on).filter_map(|effect| effect.bound).sum();
    let mut row = String::new();
    writeln!(
        row,
        "| {name} | {} | {} | {bound:.0e} | {:.2e} s | {:.2e} s | {:.2} | {:.1e} | {:.1e} |",
        names(true),
        names(false),
        planned.seconds,
        full.seconds,
        full.seconds / planned.seconds,
        planned.difference(&full),
        planned.error() + full.error(),
    )?;
    Ok(row)
}

/// The text of a scene in which every effect that is simulated is on.
fn with_all_effects(text: &str) -> String {
    let lines = text.lines().filter(|line| !line.starts_with("effects = "));
    let text: String = lines.flat_map(|line| [line, "\n"]).collect();
    text.replace("[solve]\n", &format!("[solve]\n{FORCED}\n"))
}

/// A simulation and how long plan and answers took.
struct Run {
    plan: Plan,
    found: Simulation,
    seconds: f64,
}

impl Run {
    fn of(scene: &Scene) -> Result<Self, Problem> {
        let mut runs = Vec::new();
        for _ in 0..RUNS {
            let start = Instant::now();
            let plan = plan(scene).map_err(said)?;
            let found = simulate(scene, &plan, &Unwatched);
            runs.push(Self { plan, found, seconds: start.elapsed().as_secs_f64() });
        }
        runs.sort_by(|one, other| one.seconds.total_cmp(&other.seconds));
        Ok(runs.swap_remove(RUNS / 2))
    }

    /// The largest answer of the same quantity, which differences and errors are relative to.
    fn scale(&self, index: usize) -> f64 {
        let answer = &self.found.answers[index];
        let same = self.found.answers.iter().filter(|other| other.receiver == answer.receiver);
        same.map(|other| other.value.abs()).fold(f64::MIN_POSITIVE, f64::max)
    }

    /// The largest difference of an answer to that of another run, relative to the answer.
    fn difference(&self, other: &Self) -> f64 {
        let pairs = self.found.answers.iter().zip(&other.found.answers).enumerate();
        pairs.map(|(index, (a, b))| (a.value - b.value).abs() / self.scale(index)).fold(0.0, f64::max)
    }

    /// The largest error of an answer, relative to it.
    fn error(&self) -> f64 {
        let answers = self.found.answers.iter().enumerate();
        answers.map(|(index, answer)| answer.error / self.scale(index)).fold(0.0, f64::max)
    }
}
