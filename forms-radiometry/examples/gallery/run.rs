//! Runs: a scene is planned and simulated, and the time of both is taken.

use super::gallery::{Problem, said};
use forms_radiometry::scene::{Effect, Force, ForcedEffect, Place, Scene};
use forms_radiometry::simulation::{Plan, Simulation, Unwatched, plan, simulate};
use std::time::Instant;

/// Runs of which the median is taken: an odd number.
const RUNS: usize = 3;
/// A run that takes longer, in seconds, is not repeated.
const LONG: f64 = 5.0;

/// A simulation and how long plan and answers took.
pub(crate) struct Run {
    pub(crate) plan: Plan,
    pub(crate) found: Simulation,
    pub(crate) seconds: f64,
}

impl Run {
    /// The median of some runs, or a long one.
    pub(crate) fn of(scene: &Scene) -> Result<Self, Problem> {
        let mut runs = Vec::new();
        for _ in 0..RUNS {
            let start = Instant::now();
            let plan = plan(scene).map_err(said)?;
            let found = simulate(scene, &plan, &Unwatched);
            let run = Self { plan, found, seconds: start.elapsed().as_secs_f64() };
            if run.seconds > LONG {
                return Ok(run);
            }
            runs.push(run);
        }
        runs.sort_by(|one, other| one.seconds.total_cmp(&other.seconds));
        Ok(runs.swap_remove(RUNS / 2))
    }

    /// The largest error of an answer, a cell or a pixel, relative to it.
    pub(crate) fn error(&self) -> f64 {
        self.found.accuracy().largest_error()
    }
}

/// The scene with these effects forced, whatever its file says of them.
pub(crate) fn forced(scene: &Scene, effects: &[Effect], force: Force) -> Scene {
    let mut scene = scene.clone();
    scene.solve.forced.retain(|forced| !effects.contains(&forced.effect));
    let forced = |&effect| ForcedEffect { effect, force, place: Place::default() };
    scene.solve.forced.extend(effects.iter().map(forced));
    scene
}
