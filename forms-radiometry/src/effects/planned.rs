//! Decisions of a plan about effects.

use crate::scene::Effect;

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
