//! Simulated effects: the decisions of a plan, as both solvers take them.

use super::EffectSet;
use super::planned::PlannedEffect;
use crate::scene::{Effect, Force, ForcedEffect, Scene};

/// Occlusion between surfaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Hiding {
    /// Surfaces can occlude each other, and this is simulated.
    Simulated,
    /// Surfaces can occlude each other, and this is omitted.
    LeftOut,
    /// No surface occludes another one.
    Nothing,
}

/// Effects that the solver simulates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SimulatedEffects {
    pub(crate) on: EffectSet,
    /// Occlusion between surfaces: simulated, omitted, or absent.
    pub(crate) hiding: Hiding,
    /// Maximum number of reflections; unlimited if `None`.
    pub(crate) orders: Option<u32>,
    /// Maximum number of scattering events in media; unlimited if `None`.
    pub(crate) scatterings: Option<u32>,
}

impl SimulatedEffects {
    pub(crate) fn of(effects: &[PlannedEffect]) -> Self {
        let planned = |effect| effects.iter().find(|planned| planned.effect == effect);
        let is_on = |effect| planned(effect).is_some_and(|planned| planned.on);
        let orders = |effect| match planned(effect) {
            Some(planned) if planned.on => planned.orders,
            _ => Some(0),
        };
        let occlusion = is_on(Effect::Occlusion);
        // a bound of 0 means that occlusion was found to be absent: omitting it changes nothing for
        // certain
        let is_absent = planned(Effect::Occlusion).is_some_and(|planned| planned.bound == Some(0.0));
        let hiding = match (occlusion, is_absent) {
            (true, _) => Hiding::Simulated,
            (false, true) => Hiding::Nothing,
            (false, false) => Hiding::LeftOut,
        };
        Self {
            on: EffectSet::of(is_on),
            hiding,
            orders: orders(Effect::Interreflection),
            scatterings: orders(Effect::Scattering),
        }
    }

    /// Whether all bands of a scene are simulated as one.
    pub(crate) fn merges_bands(&self, scene: &Scene) -> bool {
        !self.has(Effect::Bands) && scene.band_count() > 1
    }

    /// Whether an effect is simulated.
    pub(crate) fn has(&self, effect: Effect) -> bool {
        self.on.has(effect)
    }
}

/// Returns how an effect is forced, if it is.
pub(crate) fn forced(scene: &Scene, effect: Effect) -> Option<Force> {
    forcing(scene, effect).map(|forced| forced.force)
}

/// Returns the setting that forces an effect, if any.
pub(crate) fn forcing(scene: &Scene, effect: Effect) -> Option<&ForcedEffect> {
    scene.solve.forced.iter().find(|forced| forced.effect == effect)
}

/// Whether the file turns all reflections off.
pub(crate) fn reflects_nothing(scene: &Scene) -> bool {
    matches!(forced(scene, Effect::Interreflection), Some(Force::Off | Force::Orders(0)))
}
