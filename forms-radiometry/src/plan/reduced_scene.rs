//! Reduced scene: a scene becomes the same scene without the effects that a plan turns off.
//!
//! ```text
//! mirror       mirrors and metals are black, coats of plastic do not reflect
//! absorption   σₐ = 0
//! scattering   σₛ = 0
//! refraction   every index is that of the ambient medium
//! dispersion   every index is the middle of its bands
//! time         receivers are not resolved in time
//! ```
//! A boundary with a vacuum on both sides is removed, so that the reduced scene may have only
//! diffuse surfaces in a vacuum.

use crate::effects::{PlannedEffect, fillings, forced};
use crate::scene::{Effect, Force, MaterialKind, ReceiverKind, Scene, middle};

/// Returns the scene without the effects that the plan turns off.
pub(super) fn without(scene: &Scene, effects: &[PlannedEffect]) -> Scene {
    let is_off = |effect| effects.iter().any(|planned| planned.effect == effect && !planned.on);
    leave_out(scene, &is_off)
}

/// Returns the scene without the effects that its file turns off.
pub(super) fn without_forced(scene: &Scene) -> Scene {
    leave_out(scene, &|effect| forced(scene, effect) == Some(Force::Off))
}

fn leave_out(scene: &Scene, is_off: &dyn Fn(Effect) -> bool) -> Scene {
    let mut scene = scene.clone();
    if is_off(Effect::Mirror) {
        let bands = scene.band_count();
        for material in &mut scene.materials {
            if let MaterialKind::Plastic { specular, .. } = &mut material.kind {
                specular.fill(0.0);
            }
            if matches!(material.kind, MaterialKind::Mirror { .. } | MaterialKind::Conductor { .. }) {
                material.kind = MaterialKind::Diffuse { reflectance: vec![0.0; bands] };
            }
        }
    }
    let around = scene.ambient.medium.map(|medium| scene.media[medium].index.clone());
    for medium in &mut scene.media {
        if is_off(Effect::Absorption) {
            medium.absorption.fill(0.0);
        }
        if is_off(Effect::Scattering) {
            medium.scattering.fill(0.0);
        }
        if is_off(Effect::Refraction) {
            match &around {
                Some(around) => medium.index.clone_from(around),
                None => medium.index.fill(1.0),
            }
        }
        if is_off(Effect::Dispersion) {
            let middle = middle(&medium.index);
            medium.index.fill(middle);
        }
    }
    if is_off(Effect::Time) {
        scene.receivers.iter_mut().for_each(|receiver| receiver.time = None);
    }
    if fillings(&scene).into_iter().flatten().all(|medium| scene.media[medium].is_vacuum()) {
        remove_boundaries(&mut scene);
    }
    scene
}

/// Removes surfaces that are only boundaries, unless they emit light or are receivers.
fn remove_boundaries(scene: &mut Scene) {
    let is_asked_for = |index: usize| {
        scene.receivers.iter().any(|receiver| receiver.kind.side().is_some_and(|side| side.surface == index))
    };
    let is_boundary = |index: &usize| {
        let surface = &scene.surfaces[*index];
        let kind = &scene.materials[surface.material].kind;
        matches!(kind, MaterialKind::Dielectric { .. }) && !surface.emits() && !is_asked_for(*index)
    };
    let kept: Vec<usize> = (0..scene.surfaces.len()).filter(|index| !is_boundary(index)).collect();
    for receiver in &mut scene.receivers {
        if let ReceiverKind::Surface { surface, .. } | ReceiverKind::Faces { surface, .. } =
            &mut receiver.kind
        {
            *surface = kept.iter().position(|kept| kept == surface).expect("what is asked about is kept");
        }
    }
    scene.surfaces = kept.into_iter().map(|index| scene.surfaces[index].clone()).collect();
}
