//! Sets of effects of light transport: the effects that a scene contains, and those that a plan
//! turns on.

mod planned;
mod simulated;

pub use planned::PlannedEffect;
pub(crate) use simulated::{Hiding, SimulatedEffects, forced, forcing, reflects_nothing};

use crate::scene::{Effect, Filling, MaterialKind, Scene};
use std::ops::BitOr;

/// A set of effects.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct EffectSet(u16);

impl EffectSet {
    /// Returns the set of the effects that satisfy a condition.
    pub(crate) fn of(is_in: impl Fn(Effect) -> bool) -> Self {
        let all = Effect::ALL.iter().filter(|&&(_, effect)| is_in(effect));
        Self(all.fold(0, |bits, &(_, effect)| bits | bit(effect)))
    }

    /// Whether an effect is in the set.
    pub(crate) fn has(self, effect: Effect) -> bool {
        self.0 & bit(effect) != 0
    }

    /// Returns the effects of mirrors, media and time in a scene: those of the materials of its
    /// surfaces, and of the media that fill any part of it.
    pub(crate) fn of_scene(scene: &Scene) -> Self {
        let materials = || scene.surfaces.iter().map(|surface| &scene.materials[surface.material].kind);
        let fillings = fillings(scene);
        let media = || fillings.iter().flatten().map(|&medium| &scene.media[medium]);
        let any = |values: &[f64]| values.iter().any(|&value| value > 0.0);
        let index = |filling: &Filling| filling.map_or(&[1.0][..], |medium| &scene.media[medium].index);
        let differs = |a: &Filling| {
            (0..scene.band_count()).any(|band| {
                let of = |filling: &Filling| *index(filling).get(band).unwrap_or(&1.0);
                of(a) != of(&scene.ambient.medium)
            })
        };
        let has_spread = |values: &[f64]| values.iter().any(|value| *value != values[0]);
        Self::of(|effect| match effect {
            Effect::Absorption => media().any(|medium| any(&medium.absorption)),
            Effect::Scattering => media().any(|medium| any(&medium.scattering)),
            Effect::Mirror => materials().any(|kind| match kind {
                MaterialKind::Mirror { .. } | MaterialKind::Conductor { .. } => true,
                MaterialKind::Plastic { specular, .. } => any(specular),
                MaterialKind::Diffuse { .. } | MaterialKind::Dielectric { .. } | MaterialKind::Rough(_) => {
                    false
                }
            }),
            Effect::Refraction => fillings.iter().any(differs),
            // also for one medium everywhere: metals in it reflect by their index relative to the
            // medium, and light takes the time n d/c
            Effect::Dispersion => media().any(|medium| has_spread(&medium.index)),
            Effect::Time => scene.receivers.iter().any(|receiver| receiver.time.is_some()),
            Effect::Direct | Effect::Occlusion | Effect::Interreflection | Effect::Bands => false,
        })
    }
}

/// Returns what fills any part of a scene: the media inside its surfaces, and the ambient medium.
pub(crate) fn fillings(scene: &Scene) -> Vec<Filling> {
    let inside = scene.surfaces.iter().filter_map(|surface| match scene.materials[surface.material].kind {
        MaterialKind::Dielectric { inside } => Some(Some(inside)),
        _ => None,
    });
    inside.chain([scene.ambient.medium]).collect()
}

impl BitOr for EffectSet {
    type Output = Self;

    /// Returns the effects of either set.
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

fn bit(effect: Effect) -> u16 {
    1 << effect as u16
}
