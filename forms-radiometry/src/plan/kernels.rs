//! Kernels that a plan lists: those that its simulation runs.

use super::method::Solver;
use super::working_scene::SimulatedScene;
use crate::faces::faces;
use crate::paths;
use crate::radiosity::driver::readings::Reading;
use crate::radiosity::{Question, is_precise, kernels};
use crate::used_kernel::UsedKernel;

/// Returns the kernels that the simulation of a scene by this solver runs.
pub(super) fn of(simulated: &SimulatedScene, solver: &Solver) -> Vec<UsedKernel> {
    let (scene, effects) = (simulated.scene(), &simulated.effects);
    if let Solver::Paths { computable, .. } = solver {
        return paths::kernels(scene, &|receiver| computable.has(receiver));
    }
    let (faces, question) = (faces(scene, 0), Question::of(scene, effects));
    let readings =
        scene.receivers.iter().enumerate().map(|(index, receiver)| Reading::of(index, receiver).len());
    let is_precise = effects.orders == Some(0) && is_precise(scene, &faces, readings.sum());
    kernels(scene, &faces, &question, is_precise)
}
