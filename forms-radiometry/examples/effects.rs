//! Time saved by the plan: simulates every scene of the gallery as planned, and with every omitted
//! effect forced on that can be.
//!
//! ```text
//! scenes/*.toml ─┬─ as they are ────────── plan ─▶ answers, time ┐
//!                └─ omitted effects on ─── plan ─▶ answers, time ┴─▶ row of docs/benchmarks.md
//! ```
//! `cargo run --release -p forms-radiometry --example effects` prints the table; with `--write` the
//! page is rewritten. Effects that the file of a scene forces stay as they are: without them the
//! scene would be a different problem.

use forms_radiometry::scene::{Effect, Force, Scene};
use forms_radiometry::simulation::{Answer, Rated};
use forms_radiometry_testing::gallery::{self, Problem, scene};
use forms_radiometry_testing::timed_run::{Run, forced};
use forms_testing::page;
use std::fmt::Write;
use std::path::Path;

const HEAD: &str = "| scene | simulated | omitted | bound on omitted effects | \
                    forced on | time as planned | time forced on | forced on / planned | \
                    largest relative difference | sum of reported relative errors |\n\
                    |---|---|---|---|---|---|---|---|---|---|\n";

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

/// Returns the row of one scene.
fn row(file: &Path) -> Result<String, Problem> {
    let scene = scene(&std::fs::read_to_string(file)?, &gallery::name(file))?;
    let planned = Run::of(&scene)?;
    let left_out = left_out(&scene, &planned);
    let names = |on: bool| {
        let chosen = planned.plan.effects().iter().filter(|effect| effect.on == on);
        words(chosen.map(|effect| effect.effect))
    };
    let bound: f64 =
        planned.plan.effects().iter().filter(|effect| !effect.on).filter_map(|effect| effect.bound).sum();
    let mut row = format!(
        "| {} | {} | {} | {bound:.0e} | {} | {:.2e} s |",
        gallery::name(file),
        names(true),
        names(false),
        words(left_out.iter().copied()),
        planned.seconds
    );
    if left_out.is_empty() {
        writeln!(row, " | | | {:.1e} |", planned.error())?;
        return Ok(row);
    }
    let full = Run::of(&forced(&scene, &left_out, Force::On))?;
    writeln!(
        row,
        " {:.2e} s | {:.2} | {:.1e} | {:.1e} |",
        full.seconds,
        full.seconds / planned.seconds,
        difference(&planned, &full),
        planned.error() + full.error(),
    )?;
    Ok(row)
}

fn words(effects: impl Iterator<Item = Effect>) -> String {
    effects.map(Effect::name).collect::<Vec<_>>().join(", ")
}

/// Returns the omitted effects that have code to run when they are forced on: the effects of
/// diffuse surfaces in a vacuum if the scene is solved as a whole, the effects of paths if it is
/// path traced, and bands, if there are any.
fn left_out(scene: &Scene, planned: &Run) -> Vec<Effect> {
    let acts = |effect: Effect| match effect {
        Effect::Direct | Effect::Occlusion | Effect::Interreflection => !planned.plan.is_by_paths(),
        Effect::Bands => scene.band_count() > 1,
        Effect::Dispersion => scene.band_count() > 1 && planned.plan.is_by_paths(),
        _ => planned.plan.is_by_paths(),
    };
    let is_named = |effect: Effect| scene.solve.forced.iter().any(|forced| forced.effect == effect);
    let off = planned.plan.effects().iter().filter(|effect| !effect.on).map(|effect| effect.effect);
    off.filter(|&effect| acts(effect) && !is_named(effect)).collect()
}

/// Returns the largest difference between an answer and the same answer of another run, relative to
/// the answer.
fn difference(run: &Run, other: &Run) -> f64 {
    let relative = |(own, other): (Rated, &Answer)| {
        (own.answer.value - other.value).abs() / own.scale.max(f64::MIN_POSITIVE)
    };
    run.found.accuracy().answers().zip(&other.found.answers).map(relative).fold(0.0, f64::max)
}
