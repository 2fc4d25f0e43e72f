//! Effects: the plan, expressed as settings of the solver.

use super::followed::Computable;
use super::readings::Reading;
use super::survey::receiving;
use crate::effects::EffectSet;
use crate::faces::{faces, is_round};
use crate::geometry::{Face, Screens};
use crate::paths::{self, Limits};
use crate::plan::PlannedEffect;
use crate::radiosity::{Gathering, Hiding, Question, is_precise, kernels};
use crate::scene::{Effect, Force, ForcedEffect, Receiver, ReceiverKind, Scene};
use crate::used_kernel::UsedKernel;

/// Effects that the solver simulates.
#[derive(Clone, Copy, Debug)]
pub(super) struct SimulatedEffects {
    pub(super) on: EffectSet,
    /// Occlusion between surfaces: simulated, omitted, or absent.
    pub(super) hiding: Hiding,
    /// Maximum number of reflections; unlimited if `None`.
    pub(super) orders: Option<u32>,
    /// Maximum number of scattering events in media; unlimited if `None`.
    pub(super) scatterings: Option<u32>,
}

impl SimulatedEffects {
    pub(super) fn of(effects: &[PlannedEffect]) -> Self {
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

    /// Whether an effect is simulated.
    pub(super) fn has(&self, effect: Effect) -> bool {
        self.on.has(effect)
    }

    /// Returns the query that they pose to a solution.
    pub(super) fn question(&self, scene: &Scene) -> Question {
        Question {
            orders: self.orders,
            receives: receiving(scene),
            direct: self.has(Effect::Direct),
            is_seen: asks_for_rays(scene),
        }
    }

    /// Returns the kernels that their simulation runs.
    pub(super) fn kernels(&self, scene: &Scene) -> Vec<UsedKernel> {
        let merged = (!self.has(Effect::Bands) && scene.band_count() > 1).then(|| scene.with_one_band());
        let scene = merged.as_ref().unwrap_or(scene);
        let (faces, question) = (faces(scene, 0), self.question(scene));
        let readings =
            scene.receivers.iter().enumerate().map(|(index, receiver)| Reading::of(index, receiver).len());
        let is_precise = self.orders == Some(0) && is_precise(scene, &faces, readings.sum());
        kernels(scene, &faces, &question, (self.hiding, is_precise))
    }

    /// Returns the limits of paths.
    pub(super) fn limits(&self) -> Limits {
        Limits { reflections: self.orders, scatterings: self.scatterings, direct: self.has(Effect::Direct) }
    }

    /// Returns the kernels that path tracing of a scene runs.
    pub(super) fn kernels_of_paths(&self, scene: &Scene) -> Vec<UsedKernel> {
        let merged = (!self.has(Effect::Bands) && scene.band_count() > 1).then(|| scene.with_one_band());
        let scene = merged.as_ref().unwrap_or(scene);
        let computable = Computable::of(scene, &self.limits());
        paths::kernels(scene, &|receiver| computable.has(receiver))
    }

    /// Returns the faces that occlude light or that rays meet. The rays are those of receivers, or
    /// those that gather light. Where disks and spheres may be seen as whole shapes, occluders are
    /// needed in any case: an occluder that hides nothing of the tessellated faces may hide some of
    /// the rest of the shape.
    pub(super) fn screens(&self, scene: &Scene, faces: &[Face], gathering: Gathering) -> Screens {
        let may_be_whole = self.orders == Some(0) && gathering == Gathering::Pieces && is_round(scene);
        if self.has(Effect::Occlusion) || may_be_whole {
            Screens::of(faces)
        } else if asks_for_rays(scene) || gathering != Gathering::Pieces {
            Screens::met_by_rays(faces)
        } else {
            Screens::none(faces)
        }
    }
}

/// Whether a receiver is a ray or a camera, which needs the first surface along rays.
pub(super) fn asks_for_rays(scene: &Scene) -> bool {
    let is_seen =
        |receiver: &Receiver| matches!(receiver.kind, ReceiverKind::Ray { .. } | ReceiverKind::Camera(_));
    scene.receivers.iter().any(is_seen)
}

/// Returns how an effect is forced, if it is.
pub(super) fn forced(scene: &Scene, effect: Effect) -> Option<Force> {
    forcing(scene, effect).map(|forced| forced.force)
}

/// Returns the setting that forces an effect, if any.
pub(super) fn forcing(scene: &Scene, effect: Effect) -> Option<&ForcedEffect> {
    scene.solve.forced.iter().find(|forced| forced.effect == effect)
}
