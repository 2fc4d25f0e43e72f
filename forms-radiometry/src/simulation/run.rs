//! Runs: simulations that start from a checkpoint, are divided into shards, and are merged from
//! shards.
//!
//! ```text
//! path tracing        every number, cell and pixel is a unit of work, dealt out to the shards
//! solved as a whole   a single unit: surfaces illuminate each other, and all answers need them
//! ```

use super::job::Job;
use super::state::{State, Whole};
use crate::answer::Simulation;
use crate::checkpoint::{Misfit, Snapshot};
use crate::job::{Budget, Share};
use crate::paths::driver::{self, Division, Task};
use crate::plan::Plan;
use crate::plan::method::Solver;
use crate::progress::Progress;
use crate::radiosity::driver::solved;
use crate::watch::{Unwatched, Watch};

/// Simulates the scene of a plan with its effects.
pub fn simulate(plan: &Plan, watch: &dyn Watch) -> Simulation {
    let found = simulate_job(plan, Job::default(), watch);
    found.expect("there is no state that could be of another simulation")
}

/// Runs a job on the scene of a plan. The result of a shard without any unit of work is empty.
///
/// # Errors
/// The checkpoint of the job does not belong to this scene.
pub fn simulate_job(plan: &Plan, job: Job<'_>, watch: &dyn Watch) -> Result<Simulation, Misfit> {
    let progress = Progress::new(watch);
    let simulated = &plan.simulated;
    let found = match &plan.solver {
        Solver::Paths { world, computable } => by_paths(simulated.task(world, *computable), job, &progress)?,
        Solver::Radiosity => {
            let all = || solved(simulated.scene(), simulated.effects, simulated.first_faces(), &progress);
            in_one_piece(job, all)?
        }
        Solver::Shells(shells) => in_one_piece(job, || shells.simulation(simulated.scene(), &progress))?,
    };
    Ok(simulated.finished(found))
}

/// Merges the final checkpoints of all shards into the result of one undivided simulation.
///
/// # Errors
/// A shard is missing or not done, or its checkpoint does not belong to this scene.
pub fn merge(plan: &Plan, budget: Option<Budget>, parts: Vec<(Share, State)>) -> Result<Simulation, Misfit> {
    let simulated = &plan.simulated;
    let found = match &plan.solver {
        Solver::Paths { world, computable } => {
            let part = |(share, state): (Share, State)| Some((share, state.of_paths()?));
            let parts = parts.into_iter().map(part).collect::<Option<_>>().ok_or(Misfit)?;
            let division = Division { budget, share: Share::WHOLE };
            driver::merge(simulated.task(world, *computable), division, parts, &Progress::new(&Unwatched))?
        }
        Solver::Radiosity | Solver::Shells(_) => {
            let piece = parts.into_iter().map(|(share, state)| piece(share, state));
            let piece = piece.collect::<Result<Vec<_>, _>>()?;
            piece.into_iter().flatten().next().ok_or(Misfit)?
        }
    };
    Ok(simulated.finished(found))
}

/// Runs a job by path tracing.
fn by_paths(task: Task<'_>, job: Job<'_>, progress: &Progress<'_>) -> Result<Simulation, Misfit> {
    let division = Division { budget: job.budget, share: job.share };
    let state = match job.state {
        Some(state) => Some(state.of_paths().ok_or(Misfit)?),
        None => None,
    };
    driver::simulate(task, division, (state, job.keeper), progress)
}

/// The single unit of work of a scene that is solved as a whole.
const PIECE: usize = 0;

/// Solves a scene as a whole, if the shard has that unit of work. The checkpoint is kept at the
/// end, and only there.
fn in_one_piece(job: Job<'_>, all: impl FnOnce() -> Simulation) -> Result<Simulation, Misfit> {
    let found = match job.state {
        Some(state) => piece(job.share, state)?,
        None => job.share.has(PIECE).then(all),
    };
    let is_done = found.as_ref().is_none_or(|found| !found.stopped);
    if let Some(keeper) = job.keeper.filter(|_| is_done) {
        keeper.keep(&Snapshot(&Whole(found.as_ref())));
    }
    Ok(found.unwrap_or_default())
}

/// Returns the result of a shard, from its checkpoint, for a scene that is solved as a whole.
fn piece(share: Share, state: State) -> Result<Option<Simulation>, Misfit> {
    state.of_whole().filter(|found| found.is_some() == share.has(PIECE)).ok_or(Misfit)
}
