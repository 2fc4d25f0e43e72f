//! Simulations by paths in parts: from a state on, in shares, and from these put together.

use super::answer::{Plan, Simulation};
use super::followed::{Misfit, State, followed, merged};
use super::job::{Budget, Job, Share};
use super::prepared::Prepared;
use super::watch::{Unwatched, Watch};
use crate::scene::Scene;

/// Whether light is followed along paths: then there are states to keep, and shares. Other scenes are solved as a whole.
pub fn is_by_paths(scene: &Scene, plan: &Plan) -> bool {
    Prepared::of(scene, plan).is_followed()
}

/// Does what a job says of a scene whose light is followed along paths.
///
/// # Errors
/// The state of the job is not of this scene.
///
/// # Panics
/// The scene is not simulated by paths.
pub fn simulate_job(
    scene: &Scene,
    plan: &Plan,
    job: Job<'_>,
    watch: &dyn Watch,
) -> Result<Simulation, Misfit> {
    let prepared = Prepared::of(scene, plan);
    assert!(prepared.is_followed(), "only what is simulated by paths has jobs");
    let working = prepared.working();
    followed(prepared.task(&working), job, watch).map(|found| prepared.finished(found, &working))
}

/// What one simulation of all the work would have found, from the states at the end of its shares.
///
/// # Errors
/// A share is missing or not done, or its state is not of this scene.
///
/// # Panics
/// The scene is not simulated by paths.
pub fn merge(
    scene: &Scene,
    plan: &Plan,
    budget: Option<Budget>,
    parts: Vec<(Share, State)>,
) -> Result<Simulation, Misfit> {
    let prepared = Prepared::of(scene, plan);
    assert!(prepared.is_followed(), "only what is simulated by paths has shares");
    let job = Job { budget, ..Job::default() };
    let working = prepared.working();
    let found = merged(prepared.task(&working), &job, parts, &Unwatched)?;
    Ok(prepared.finished(found, &working))
}
