//! Plans: decisions about the effects that are simulated and about the methods that find the
//! answers.
//!
//! ```text
//! scene ─ decision ─▶ effects ─ working scene ─▶ simulated scene ─ method ─▶ solver, methods, kernels
//! ```
//! A plan owns the scene as it is simulated, and for path tracing the walls that rays hit. So a
//! solver cannot be given the plan of another scene, takes every choice from the plan, and builds
//! nothing again.

mod comparison;
pub(crate) mod decision;
mod kernels;
pub(crate) mod method;
mod occlusion_bound;
mod reduced_scene;
mod reflection_bound;
mod survey;
pub(crate) mod working_scene;

use crate::effects::PlannedEffect;
use crate::scene::Scene;
use crate::used_kernel::UsedKernel;
use method::{Choice, Method, ReceiverMethod, Solver, distinct};
use reduced_scene::without;
use working_scene::SimulatedScene;

/// Decision about the effects that are simulated and the methods, with the simulated scene.
#[derive(Clone, Debug)]
pub struct Plan {
    effects: Vec<PlannedEffect>,
    methods: Vec<ReceiverMethod>,
    kernels: Vec<UsedKernel>,
    pub(crate) simulated: SimulatedScene,
    pub(crate) solver: Solver,
}

impl Plan {
    /// Returns the plan of a scene that is simulated with these effects as they are, by path tracing
    /// if that is asked for or if the effects need it: nothing is surveyed, compared, decided or
    /// refused. The effects are those of [`Effect::ALL`](crate::scene::Effect::ALL), in this order.
    pub fn with_effects(scene: &Scene, effects: Vec<PlannedEffect>, by_paths: bool) -> Self {
        let needed = method::reason_for_paths(&without(scene, &effects));
        let choice = match needed.or_else(|| by_paths.then(|| "it was asked for".to_owned())) {
            Some(reason) => Choice::Paths(reason),
            None => Choice::Whole,
        };
        Self::new(scene, (effects, 0.0), choice)
    }

    /// Returns the plan with these effects and the error budget spent on omitted effects.
    fn new(scene: &Scene, (effects, dropped): (Vec<PlannedEffect>, f64), choice: Choice) -> Self {
        let mut simulated = SimulatedScene::of(scene, &effects, dropped);
        let (solver, methods) = method::decide(&mut simulated, choice);
        let kernels = kernels::of(&simulated, &solver);
        Self { effects, methods, kernels, simulated, solver }
    }

    /// All effects, in the order of [`Effect::ALL`](crate::scene::Effect::ALL).
    pub fn effects(&self) -> &[PlannedEffect] {
        &self.effects
    }

    /// The methods that find the answers of each receiver, in the order of the scene.
    pub fn receiver_methods(&self) -> &[ReceiverMethod] {
        &self.methods
    }

    /// Returns the methods of all receivers, the main one first. There are several where receivers
    /// differ, or where only the work shows which one suffices.
    pub fn methods(&self) -> Vec<Method> {
        distinct(&self.methods, self.is_by_paths())
    }

    /// Whether the scene is simulated by path tracing. Other scenes are solved as a whole.
    pub fn is_by_paths(&self) -> bool {
        matches!(self.solver, Solver::Paths { .. })
    }

    /// Kernels that the simulation runs with these effects.
    pub fn kernels(&self) -> &[UsedKernel] {
        &self.kernels
    }

    /// Error budget spent on omitted effects: the largest change of an answer, relative to it, by
    /// all effects that were omitted because they matter less than the tolerance.
    pub fn dropped(&self) -> f64 {
        self.simulated.dropped
    }
}
