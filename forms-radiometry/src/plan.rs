//! Plans: decisions about the effects that are simulated.

pub(crate) mod decision;
mod kernels;
pub(crate) mod method;
mod occlusion_bound;
pub(crate) mod reduced_scene;
mod reflection_bound;
mod solver;
mod survey;
pub(crate) mod working_scene;

use crate::effects::PlannedEffect;
use crate::used_kernel::UsedKernel;

/// Decision about the effects that are simulated.
#[derive(Clone, Debug)]
pub struct Plan {
    /// All effects, in the order of [`Effect::ALL`](crate::scene::Effect::ALL).
    pub effects: Vec<PlannedEffect>,
    /// Kernels that the simulation runs with these effects.
    pub kernels: Vec<UsedKernel>,
    /// Error budget spent on omitted effects: the largest change of an answer, relative to it, by
    /// all effects that were omitted because they matter less than the tolerance.
    pub dropped: f64,
}
