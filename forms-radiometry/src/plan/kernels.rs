//! Kernels that a plan lists: those that its simulation runs.

use super::method::Solver;
use super::working_scene::SimulatedScene;
use crate::faces::faces;
use crate::paths;
use crate::radiosity::driver::readings::Reading;
use crate::radiosity::{Question, Shells, is_precise, kernels};
use crate::scene::{Receiver, Scene};
use crate::used_kernel::UsedKernel;

/// Returns the kernels that the simulation of a scene by this solver runs.
pub(super) fn of(simulated: &SimulatedScene, solver: &Solver) -> Vec<UsedKernel> {
    let scene = simulated.scene();
    match solver {
        Solver::Paths { computable, .. } if !computable.is_straight() => {
            paths::kernels(scene, &|receiver| computable.has(receiver))
        }
        Solver::Paths { computable, .. } => {
            let mut kernels = of_radiosity(simulated);
            let is_sampled = |receiver: &Receiver| !computable.has(receiver);
            let receivers = scene.receivers.iter().filter(|receiver| is_sampled(receiver)).cloned().collect();
            let sampled = paths::kernels(&Scene { receivers, ..scene.clone() }, &|_| false);
            let is_new = |kernel: &UsedKernel| kernels.iter().all(|known| known.name != kernel.name);
            let more: Vec<UsedKernel> = sampled.into_iter().filter(is_new).collect();
            kernels.extend(more);
            kernels
        }
        Solver::Radiosity => of_radiosity(simulated),
        Solver::Shells(_) => Shells::kernels(scene),
    }
}

/// Returns the kernels of a solution as a whole.
fn of_radiosity(simulated: &SimulatedScene) -> Vec<UsedKernel> {
    let (scene, effects) = (simulated.scene(), &simulated.effects);
    let (faces, question) = (faces(scene, 0), Question::of(scene, effects));
    let (readings, _) = Reading::requested(scene);
    let is_precise = effects.orders == Some(0) && is_precise(scene, &faces, readings.len());
    kernels(scene, &faces, &question, is_precise)
}
