//! Simulations in parts: from a state on, in shares, and from these put together.
//!
//! ```text
//! light along paths      every number, cell and pixel is a unit of work, and the shares deal them out
//! solved as a whole      all of it is one unit: surfaces light each other, and every answer needs all of them
//! ```

use super::answer::{Plan, Simulation};
use super::followed::{followed, merged};
use super::job::{Budget, Job, Share};
use super::prepared::Prepared;
use super::progress::Progress;
use super::solver::solved;
use super::state::{Misfit, Of, Snapshot, State};
use super::watch::{Unwatched, Watch};
use crate::radiosity::Gathering;
use crate::scene::{Scene, WorkingScene};

/// Whether light is followed along paths. Other scenes are solved as a whole.
pub fn is_by_paths(scene: &Scene, plan: &Plan) -> bool {
    Prepared::of(scene, plan).is_followed()
}

/// Answers the questions of a scene with the effects of a plan.
pub fn simulate(scene: &Scene, plan: &Plan, watch: &dyn Watch) -> Simulation {
    let found = simulate_job(scene, plan, Job::default(), watch);
    found.expect("there is no state that could be of another simulation")
}

/// Does what a job says of a scene. A share to which nothing belongs finds nothing.
///
/// # Errors
/// The state of the job is not of this scene.
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

/// What one simulation of all the work would have found, from the states at the end of its shares.
///
/// # Errors
/// A share is missing or not done, or its state is not of this scene.
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

/// The single unit of work on a scene that is solved as a whole.
const PIECE: usize = 0;

/// What a share finds of a scene that is solved as a whole, which is kept at the end, and only there.
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

/// What a state says that a share found of a scene that is solved as a whole.
fn piece(share: Share, state: State) -> Result<Option<Simulation>, Misfit> {
    state.of_whole().filter(|found| found.is_some() == share.has(PIECE)).ok_or(Misfit)
}
