//! Effects: what the solver does of the plan.

use super::answer::Plan;
use crate::scene::{Effect, Force, Scene};

/// What the solver does.
#[derive(Clone, Copy, Debug)]
pub(super) struct Effects {
    pub(super) direct: bool,
    pub(super) occlusion: bool,
    /// How often light is reflected at most; as often as it happens, if nothing is said.
    pub(super) orders: Option<u32>,
    pub(super) bands: bool,
}

impl Effects {
    pub(super) fn of(plan: &Plan) -> Self {
        let planned = |effect| plan.effects.iter().find(|planned| planned.effect == effect);
        let is_on = |effect| planned(effect).is_some_and(|planned| planned.on);
        let orders = match planned(Effect::Interreflection) {
            Some(planned) if planned.on => planned.orders,
            _ => Some(0),
        };
        Self {
            direct: is_on(Effect::Direct),
            occlusion: is_on(Effect::Occlusion),
            orders,
            bands: is_on(Effect::Bands),
        }
    }
}

/// How the scene forces an effect, if it does.
pub(super) fn forced(scene: &Scene, effect: Effect) -> Option<Force> {
    scene.solve.forced.iter().find(|forced| forced.effect == effect).map(|forced| forced.force)
}
