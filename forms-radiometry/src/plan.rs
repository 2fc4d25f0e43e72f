//! Plans: decisions about the effects that are simulated.

use crate::scene::Effect;
use crate::used_kernel::UsedKernel;

/// Decision about the effects that are simulated.
#[derive(Clone, Debug)]
pub struct Plan {
    /// All effects, in the order of [`Effect::ALL`].
    pub effects: Vec<PlannedEffect>,
    /// Kernels that the simulation runs with these effects.
    pub kernels: Vec<UsedKernel>,
    /// Error budget spent on omitted effects: the largest change of an answer, relative to it, by
    /// all effects that were omitted because they matter less than the tolerance.
    pub dropped: f64,
}

/// Decision of a plan about one effect.
#[derive(Clone, Debug)]
pub struct PlannedEffect {
    /// The effect.
    pub effect: Effect,
    /// Whether it is simulated.
    pub on: bool,
    /// Number of orders that are simulated; all orders if `None`.
    pub orders: Option<u32>,
    /// Reason: the trigger in the scene, or that there is no trigger.
    pub why: String,
    /// Largest change of an answer, in the answer's unit, by omitting the effect or its higher
    /// orders; `None` where no bound is known.
    pub bound: Option<f64>,
}
