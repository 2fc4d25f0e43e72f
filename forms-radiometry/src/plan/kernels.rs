//! Kernels that a plan lists: those that its simulation runs.

use crate::effects::SimulatedEffects;
use crate::faces::faces;
use crate::paths::driver::Computable;
use crate::paths::{self, Limits};
use crate::radiosity::driver::readings::Reading;
use crate::radiosity::{Question, is_precise, kernels};
use crate::scene::Scene;
use crate::used_kernel::UsedKernel;

/// Returns the kernels that their simulation runs.
pub(super) fn of_whole(effects: &SimulatedEffects, scene: &Scene) -> Vec<UsedKernel> {
    let merged = effects.merges_bands(scene).then(|| scene.with_one_band());
    let scene = merged.as_ref().unwrap_or(scene);
    let (faces, question) = (faces(scene, 0), Question::of(scene, effects));
    let readings =
        scene.receivers.iter().enumerate().map(|(index, receiver)| Reading::of(index, receiver).len());
    let is_precise = effects.orders == Some(0) && is_precise(scene, &faces, readings.sum());
    kernels(scene, &faces, &question, (effects.hiding, is_precise))
}

/// Returns the kernels that path tracing of a scene runs.
pub(super) fn of_paths(effects: &SimulatedEffects, scene: &Scene) -> Vec<UsedKernel> {
    let merged = effects.merges_bands(scene).then(|| scene.with_one_band());
    let scene = merged.as_ref().unwrap_or(scene);
    let computable = Computable::of(scene, &Limits::of(effects));
    paths::kernels(scene, &|receiver| computable.has(receiver))
}
