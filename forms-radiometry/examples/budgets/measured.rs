//! Measurements of a scene: runs with decreasing tolerances, one run with half the error, and one
//! run without each effect.

use forms_radiometry::scene::{Effect, Force, Scene};
use forms_radiometry::simulation::{Answer, ErrorParts, plan};
use forms_radiometry_testing::gallery::{self, Problem, said, scene};
use forms_radiometry_testing::known_answers::{GALLERY, Known};
use forms_radiometry_testing::timed_run::{Run, forced};
use std::path::Path;

/// Ratio of each tolerance to the one before.
const STEP: f64 = 0.5;
/// Loosest and tightest tolerance, relative to the tolerance of the file; then the loosest
/// tolerance overall.
const RANGE: [f64; 2] = [16.0, 0.1];
const LOOSEST: f64 = 0.5;
/// The runs with decreasing tolerances end with the first that takes longer than this, in seconds.
/// The number below is the least number of these runs; the scene as it is always is among them.
const LONG: f64 = 2.0;
const FEWEST: usize = 3;

/// Run of the scene with some tolerance.
pub(crate) struct Rung {
    pub(crate) tolerance: f64,
    pub(crate) seconds: f64,
    /// Largest relative error of an answer, a cell or a pixel.
    pub(crate) said: f64,
    /// Rounding part of the error of the worst answer, relative to it, and whether sampling is the
    /// largest part.
    pub(crate) rounding: f64,
    pub(crate) is_sampled: bool,
    /// Largest relative deviation from the known values.
    pub(crate) off: Option<f64>,
}

/// Attempt to halve the error.
pub(crate) struct Halved {
    /// Change of the request: a tolerance, or an omitted effect that is kept.
    pub(crate) what: String,
    pub(crate) seconds: f64,
    pub(crate) error: f64,
}

/// Costs of effects: for one tolerance, the time as planned and the time without each effect.
pub(crate) struct Costs {
    pub(crate) tolerance: f64,
    pub(crate) seconds: f64,
    pub(crate) without: Vec<(Effect, f64)>,
}

/// All measurements of a scene.
pub(crate) struct Measured {
    pub(crate) name: String,
    pub(crate) planned: Run,
    /// Attempts to halve the error; empty if rounding is at least half of the error and nothing is
    /// omitted.
    pub(crate) halved: Vec<Halved>,
    /// Runs, from the loosest tolerance to the tightest.
    pub(crate) rungs: Vec<Rung>,
    pub(crate) costs: Costs,
}

impl Measured {
    pub(crate) fn of(file: &Path) -> Result<Self, Problem> {
        let name = gallery::name(file);
        let scene = scene(&std::fs::read_to_string(file)?, &name)?;
        let own = format!("{name}.toml");
        let known = GALLERY.iter().find(|exhibit| exhibit.file == own).map_or(&[][..], |it| it.known);
        let planned = Run::of(&scene)?;
        let rungs = rungs(&scene, known, &planned)?;
        let halved = halved(&scene, &planned)?;
        let costs = costs(&scene, &rungs)?;
        Ok(Self { name, planned, halved, rungs, costs })
    }

    /// Returns the answer with the worst error.
    pub(crate) fn worst(&self) -> Result<&Answer, Problem> {
        let worst = self.planned.found.accuracy().worst_answer().map(|worst| worst.answer);
        worst.ok_or_else(|| format!("{}: there is no light", self.name).into())
    }

    /// Returns the fastest attempt that halves the error.
    pub(crate) fn cheapest(&self) -> Option<&Halved> {
        let half = 0.5 * self.planned.error();
        let halves = self.halved.iter().filter(|halved| halved.error <= half);
        halves.min_by(|one, other| one.seconds.total_cmp(&other.seconds))
    }
}

fn with_tolerance(scene: &Scene, tolerance: f64) -> Scene {
    let mut scene = scene.clone();
    scene.solve.tolerance = tolerance;
    scene
}

/// Runs the scene with decreasing tolerances; the run as planned is among them.
fn rungs(scene: &Scene, known: &[Known], planned: &Run) -> Result<Vec<Rung>, Problem> {
    let own = scene.solve.tolerance;
    let mut rungs = Vec::new();
    let mut factor = RANGE[0];
    while factor >= RANGE[1] {
        let tolerance = factor * own;
        factor *= STEP;
        if tolerance > LOOSEST {
            continue;
        }
        if tolerance == own {
            rungs.push(rung(own, planned, known));
        } else {
            rungs.push(rung(tolerance, &Run::of(&with_tolerance(scene, tolerance))?, known));
        }
        if rungs.len() >= FEWEST && rungs.last().is_some_and(|rung: &Rung| rung.seconds > LONG) {
            break;
        }
    }
    if rungs.last().is_some_and(|rung| rung.tolerance > own) {
        rungs.push(rung(own, planned, known));
    }
    Ok(rungs)
}

fn rung(tolerance: f64, run: &Run, known: &[Known]) -> Rung {
    let worst = run.found.accuracy().worst_answer();
    let part = |of: fn(&ErrorParts) -> f64| worst.map_or(0.0, |worst| of(&worst.answer.parts) / worst.scale);
    let off = |known: &Known| {
        let [value, _] = known.found(&run.found.answers);
        (value - known.value).abs() / scale(known, &run.found.answers)
    };
    Rung {
        tolerance,
        seconds: run.seconds,
        said: run.found.history.last().map_or(0.0, |moment| moment.error),
        rounding: part(|parts| parts.rounding),
        is_sampled: part(|parts| parts.sampling) > 0.5 * run.error(),
        off: known.iter().map(off).reduce(f64::max),
    }
}

/// Returns the value to which the error of a known sum is relative: the largest of its value and
/// its summands.
fn scale(known: &Known, answers: &[Answer]) -> f64 {
    let of_receiver = |receiver: &str| {
        let own = answers.iter().filter(move |answer| answer.receiver == receiver);
        own.map(|answer| answer.value.abs()).fold(0.0, f64::max)
    };
    let summands = known.sum.iter().map(|(factor, receiver, _)| factor.abs() * of_receiver(receiver));
    summands.fold(known.value.abs(), f64::max)
}

/// Makes the attempts to halve the error: keeping each omitted effect, and simulating the receiver
/// of the worst answer alone, with half of the error as its tolerance.
fn halved(scene: &Scene, planned: &Run) -> Result<Vec<Halved>, Problem> {
    let Some(worst) = planned.found.accuracy().worst_answer() else { return Ok(Vec::new()) };
    let worst = worst.answer;
    let parts = worst.parts;
    let mut tried = Vec::new();
    let mut run = |what: String, scene: &Scene| -> Result<(), Problem> {
        let run = Run::of(scene)?;
        tried.push(Halved { what, seconds: run.seconds, error: run.error() });
        Ok(())
    };
    if parts.effects > 0.0 {
        let dropped = planned.plan.effects().iter().filter(|planned| !planned.on);
        for effect in dropped.filter(|planned| planned.bound > Some(0.0)).map(|planned| planned.effect) {
            run(format!("keep {}", effect.name()), &forced(scene, &[effect], Force::On))?;
        }
    }
    if 2.0 * parts.rounding < worst.error {
        let tolerance = 0.5 * planned.error();
        let more = [
            (parts.quadrature, "finer quadrature"),
            (parts.orders, "more orders"),
            (parts.sampling, "more samples"),
            (parts.effects, "fewer omitted effects"),
        ];
        let largest = more.into_iter().max_by(|one, other| one.0.total_cmp(&other.0));
        let what = largest.map_or("", |(_, what)| what);
        let mut alone = with_tolerance(scene, tolerance);
        alone.receivers.retain(|receiver| receiver.name == worst.receiver);
        run(format!("{what}, this receiver alone with tolerance {tolerance:.1e}"), &alone)?;
    }
    Ok(tried)
}

/// Measures the time without each effect that can be off, with the tightest tolerance that does not
/// take long.
fn costs(scene: &Scene, rungs: &[Rung]) -> Result<Costs, Problem> {
    let short = rungs.iter().rev().find(|rung| rung.seconds <= LONG);
    let Some(rung) = short.or(rungs.first()) else { return Err("there is no tolerance to run with".into()) };
    let scene = with_tolerance(scene, rung.tolerance);
    let plan = plan(&scene).map_err(said)?;
    let mut without = Vec::new();
    for effect in plan.effects().iter().filter(|planned| planned.on).map(|planned| planned.effect) {
        let scene = forced(&scene, &[effect], Force::Off);
        // an effect that cannot be off is refused: without occlusion rays would pass through the
        // surfaces they meet
        if let Ok(run) = Run::of(&scene) {
            without.push((effect, run.seconds));
        }
    }
    Ok(Costs { tolerance: rung.tolerance, seconds: rung.seconds, without })
}
