//! Executed code by effect: runs every scene of the gallery with its plan and with every effect on,
//! and counts the instructions of each effect.
//!
//! ```text
//! scenes/*.toml ─ plan ─┬─ as it is ─┬─ this program under Callgrind ─▶ instructions by effect
//!                       └─ all on ───┘
//! instructions by effect ─▶ the terminal, docs/benchmarks.md
//! ```
//! `cargo run --profile counted -p forms-radiometry --example effects_code` prints the table; with
//! `--write` the page is rewritten. It is an error if a disabled effect executes instructions, and
//! if a kernel runs that is not in the plan's list.

use forms_radiometry::scene::{Effect, ReceiverKind, Scene};
use forms_radiometry::simulation::{Plan, PlannedEffect, Unwatched, plan, simulate};
use forms_radiometry_testing::effects_code::callgrind::{self, Counts};
use forms_radiometry_testing::effects_code::parts;
use forms_radiometry_testing::gallery::{self, Problem, said, scene};
use forms_testing::page;
use std::fmt::Write;
use std::path::Path;

/// First argument with which this program starts itself under Valgrind; the file of a scene, the
/// effects that are on and the solver follow.
const COUNTED: &str = "--counted";
const SOLVERS: [&str; 2] = ["whole", "paths"];
/// Tolerance of the simulations, or the scene's own where that is larger; then the largest number
/// of cells of a map and of pixels of an image along each side. Under Valgrind everything takes fifty
/// times as long.
const TOLERANCE: f64 = 0.3;
const CELLS: usize = 8;
const PIXELS: usize = 16;
const HEAD: &str =
    "| scene | effect | plan | instructions, as planned | instructions, all on |\n|---|---|---|---|---|\n";

fn main() -> Result<(), Problem> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let [mode, file, on, solver] = arguments.as_slice()
        && mode == COUNTED
    {
        return run(Path::new(file), on, solver == SOLVERS[1]);
    }
    if !forms_testing::is_installed("valgrind") {
        println!("valgrind is not installed: no instructions were counted");
        return Ok(());
    }
    let mut table = format!("Processor: {}.\n\n{HEAD}", page::processor());
    for file in gallery::files()? {
        let rows = rows(&file)?;
        print!("{rows}");
        table += &rows;
    }
    if arguments.iter().any(|word| word == "--write") {
        let path = gallery::folder().join("../docs/benchmarks.md");
        std::fs::write(
            &path,
            page::replaced(&std::fs::read_to_string(&path)?, "effects in the code", &table),
        )?;
    }
    Ok(())
}

/// Simulates a scene with these effects, without planning, so that only the simulation is counted.
fn run(file: &Path, on: &str, by_paths: bool) -> Result<(), Problem> {
    let scene = coarse(file)?;
    let planned = |(name, effect): (&str, Effect)| {
        let mut words = on.split(',').filter_map(|word| word.split_once('='));
        let orders = words.find(|(other, _)| *other == name).map(|(_, orders)| orders.parse().ok());
        PlannedEffect {
            effect,
            on: orders.is_some(),
            orders: orders.flatten(),
            why: String::new(),
            bound: None,
        }
    };
    let plan = Plan::with_effects(&scene, Effect::ALL.into_iter().map(planned).collect(), by_paths);
    let found = simulate(&plan, &Unwatched);
    let are_numbers = found.answers.iter().all(|answer| answer.value.is_finite());
    if are_numbers { Ok(()) } else { Err("an answer is not finite".into()) }
}

fn coarse(file: &Path) -> Result<Scene, Problem> {
    let mut scene = scene(&std::fs::read_to_string(file)?, &gallery::name(file))?;
    scene.solve.tolerance = scene.solve.tolerance.max(TOLERANCE);
    for receiver in &mut scene.receivers {
        match &mut receiver.kind {
            ReceiverKind::Surface { grid: Some(size), .. } => *size = size.map(|cells| cells.min(CELLS)),
            ReceiverKind::Camera(camera) => {
                camera.resolution = camera.resolution.map(|pixels| pixels.min(PIXELS));
            }
            _ => {}
        }
    }
    Ok(scene)
}

/// Returns the rows of one scene.
fn rows(file: &Path) -> Result<String, Problem> {
    let name = gallery::name(file);
    let scene = coarse(file)?;
    let plan = plan(&scene).map_err(said)?;
    let is_by_paths = plan.is_by_paths();
    let plan = Plan::with_effects(&scene, plan.effects().to_vec(), is_by_paths);
    let is_on = |effect: Effect| plan.effects().iter().any(|planned| planned.effect == effect && planned.on);
    let planned = words(plan.effects().iter().filter(|planned| planned.on));
    let all: Vec<String> = Effect::ALL.iter().map(|(name, _)| format!("{name}=")).collect();
    let (planned, all) = std::thread::scope(|scope| {
        let all = scope.spawn(|| counted(file, &all.join(","), is_by_paths));
        (counted(file, &planned, is_by_paths), all.join().expect("the other count does not panic"))
    });
    let (planned, all) = (planned?, all?);
    if !parts::has_lines(&all) {
        return Err("this program has no line information: build it with --profile counted".into());
    }
    let mut rows = String::new();
    for effect in parts::effects(is_by_paths) {
        let counts = [&planned, &all].map(|counts| parts::of_effect(counts, effect));
        if !is_on(effect) && counts[0] > 0 {
            return Err(
                format!("{name}: {} is off but executes {} instructions", effect.name(), counts[0]).into()
            );
        }
        let state = if is_on(effect) { "on" } else { "off" };
        let [planned, all] = counts.map(grouped);
        writeln!(rows, "| {name} | {} | {state} | {planned} | {all} |", effect.name())?;
    }
    if !is_by_paths {
        let [rays, rays_all] = [&planned, &all].map(|counts| grouped(parts::of_rays(counts)));
        writeln!(rows, "| {name} | along rays | | {rays} | {rays_all} |")?;
    }
    let [solver, solver_all] = [&planned, &all].map(|counts| grouped(parts::of_solver(counts)));
    writeln!(rows, "| {name} | whole solver | | {solver} | {solver_all} |")?;
    let names: Vec<&str> = plan.kernels().iter().map(|kernel| kernel.name).collect();
    let files: Vec<&str> = names.iter().filter_map(|name| parts::file_of(name)).collect();
    let unlisted = parts::kernels(&planned).into_iter().find(|name| !names.contains(&name.as_str()));
    let unlisted = unlisted
        .or(parts::kernel_files(&planned).into_iter().find(|file| !files.contains(file)).map(str::to_owned));
    match unlisted {
        Some(kernel) => {
            Err(format!("{name}: `{kernel}` runs but is not in the plan’s list of kernels").into())
        }
        None => Ok(rows),
    }
}

/// Formats a number with spaces between thousands.
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let groups = digits.as_bytes().rchunks(3).rev().map(String::from_utf8_lossy);
    groups.collect::<Vec<_>>().join(" ")
}

/// Returns the argument for the effects that are on: `direct=,interreflection=3`.
fn words<'p>(on: impl Iterator<Item = &'p PlannedEffect>) -> String {
    let word = |planned: &PlannedEffect| {
        let orders = planned.orders.map_or(String::new(), |orders| orders.to_string());
        format!("{}={orders}", planned.effect.name())
    };
    on.map(word).collect::<Vec<_>>().join(",")
}

/// Counts the instructions that this program executes for a scene with these effects, solved by
/// paths or as a whole.
fn counted(file: &Path, on: &str, by_paths: bool) -> std::io::Result<Counts> {
    let not_text = || std::io::Error::other("the path is not valid UTF-8");
    let file = file.to_str().ok_or_else(not_text)?;
    callgrind::counted(&std::env::current_exe()?, &[COUNTED, file, on, SOLVERS[usize::from(by_paths)]], &[])
}
