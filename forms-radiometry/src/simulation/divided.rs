//! Runs: simulations that start from a checkpoint, are divided into shards, and are merged from
//! shards.
//!
//! ```text
//! path tracing        every number, cell and pixel is a unit of work, dealt out to the shards
//! solved as a whole   a single unit: surfaces illuminate each other, and all answers need them
//! ```

use super::followed::{followed, merged};
use super::job::{Budget, Job, Share};
use super::prepared::Prepared;
use super::progress::Progress;
use super::solver::solved;
use super::state::{Misfit, Of, Snapshot, State};
use crate::answer::Simulation;
use crate::plan::Plan;
use crate::radiosity::Gathering;
use crate::scene::{Scene, WorkingScene};
use crate::watch::{Unwatched, Watch};

/// Whether a scene is simulated by path tracing. Other scenes are solved as a whole.
pub fn is_by_paths(scene: &Scene, plan: &Plan) -> bool {
    Prepared::of(scene, plan).is_followed()
}

/// Simulates a scene with the effects of a plan.
pub fn simulate(scene: &Scene, plan: &Plan, watch: &dyn Watch) -> Simulation {
    let found = simulate_job(scene, plan, Job::default(), watch);
    found.expect("there is no state that could be of another simulation")
}

/// Runs a job on a scene. The result of a shard without any unit of work is empty.
///
/// # Errors
/// The checkpoint of the job does not belong to this scene.
pub fn simulate_job(
    scene: &Scene,
    plan: &Plan,
    job: Job<'_>,
    watch: &dyn Watch,
) -> Result<Simulation, Misfit> {
    let progress = Progress::new(watch);
    let prepared = Prepared::of(scene, plan);
    let working = prepared.working();
    let found = if prepared.is_followed() {
        followed(prepared.task(&working), job, &progress)?
    } else {
        in_one_piece(&prepared, &working, job, &progress)?
    };
    Ok(prepared.finished(found, &working))
}

/// Merges the final checkpoints of all shards into the result of one undivided simulation.
///
/// # Errors
/// A shard is missing or not done, or its checkpoint does not belong to this scene.
pub fn merge(
    scene: &Scene,
    plan: &Plan,
    budget: Option<Budget>,
    parts: Vec<(Share, State)>,
) -> Result<Simulation, Misfit> {
    let prepared = Prepared::of(scene, plan);
    let working = prepared.working();
    let found = if prepared.is_followed() {
        let part = |(share, state): (Share, State)| Some((share, state.of_paths()?));
        let parts = parts.into_iter().map(part).collect::<Option<_>>().ok_or(Misfit)?;
        let job = Job { budget, ..Job::default() };
        merged(prepared.task(&working), &job, parts, &Progress::new(&Unwatched))?
    } else {
        let piece =
            parts.into_iter().map(|(share, state)| piece(share, state)).collect::<Result<Vec<_>, _>>()?;
        piece.into_iter().flatten().next().ok_or(Misfit)?
    };
    Ok(prepared.finished(found, &working))
}

/// The single unit of work of a scene that is solved as a whole.
const PIECE: usize = 0;

/// Solves a scene as a whole, if the shard has that unit of work. The checkpoint is kept at the
/// end, and only there.
fn in_one_piece(
    prepared: &Prepared,
    working: &WorkingScene<'_>,
    job: Job<'_>,
    progress: &Progress<'_>,
) -> Result<Simulation, Misfit> {
    let found = match job.state {
        Some(state) => piece(job.share, state)?,
        None => job.share.has(PIECE).then(|| solved(Gathering::of, prepared, working, progress)),
    };
    let is_done = found.as_ref().is_none_or(|found| !found.stopped);
    if let Some(keeper) = job.keeper.filter(|_| is_done) {
        keeper.keep(&Snapshot(Of::Whole(found.as_ref())));
    }
    Ok(found.unwrap_or_default())
}

/// Returns the result of a shard, from its checkpoint, for a scene that is solved as a whole.
fn piece(share: Share, state: State) -> Result<Option<Simulation>, Misfit> {
    state.of_whole().filter(|found| found.is_some() == share.has(PIECE)).ok_or(Misfit)
}
