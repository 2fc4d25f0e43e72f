//! Timed runs: each plans and simulates a scene.

use crate::gallery::{Problem, said};
use forms_radiometry::scene::{Effect, Force, ForcedEffect, Place, Scene};
use forms_radiometry::simulation::{Plan, Simulation, Unwatched, plan, simulate};
use std::time::Instant;

/// Number of runs whose median is used; it is odd.
const RUNS: usize = 3;
/// Runs that take longer than this, in seconds, are not repeated.
const LONG: f64 = 5.0;

/// Simulation with the time of plan and answers.
pub struct Run {
    /// The plan.
    pub plan: Plan,
    /// The results.
    pub found: Simulation,
    /// Time of plan and simulation in seconds.
    pub seconds: f64,
}

impl Run {
    /// Returns the median of several runs, or the first long run.
    pub fn of(scene: &Scene) -> Result<Self, Problem> {
        let mut runs = Vec::new();
        for _ in 0..RUNS {
            let start = Instant::now();
            let plan = plan(scene).map_err(said)?;
            let found = simulate(&plan, &Unwatched);
            let run = Self { plan, found, seconds: start.elapsed().as_secs_f64() };
            if run.seconds > LONG {
                return Ok(run);
            }
            runs.push(run);
        }
        runs.sort_by(|one, other| one.seconds.total_cmp(&other.seconds));
        Ok(runs.swap_remove(RUNS / 2))
    }

    /// Returns the largest relative error of an answer, a cell or a pixel.
    pub fn error(&self) -> f64 {
        self.found.accuracy().largest_error()
    }
}

/// Returns the scene with these effects forced, instead of the file's own settings for them.
pub fn forced(scene: &Scene, effects: &[Effect], force: Force) -> Scene {
    let mut scene = scene.clone();
    scene.solve.forced.retain(|forced| !effects.contains(&forced.effect));
    let forced = |&effect| ForcedEffect { effect, force, place: Place::default() };
    scene.solve.forced.extend(effects.iter().map(forced));
    scene
}
