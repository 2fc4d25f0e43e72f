//! Working scene: a scene and the decisions about its effects become the simulated scene in working
//! units, and its results become the requested answers.

use super::reduced_scene::without;
use crate::answer::{Answer, ErrorParts, NetFlux, Simulation};
use crate::effects::{PlannedEffect, SimulatedEffects};
use crate::paths::World;
use crate::paths::driver::{Computable, Task};
use crate::radiosity::FirstFaces;
use crate::scene::{Scene, WorkingUnits, brightest_source};
use std::sync::Arc;

/// Scene as it is simulated: reduced to the effects that are simulated, in working units.
#[derive(Clone, Debug)]
pub(crate) struct SimulatedScene {
    pub(crate) effects: SimulatedEffects,
    scene: Arc<Scene>,
    units: WorkingUnits,
    first_faces: FirstFaces,
    /// Number of bands that are simulated as a single one, if they are.
    merged: Option<usize>,
    /// Error budget spent on omitted effects, relative to every answer; the solver gets the
    /// remaining tolerance.
    pub(super) dropped: f64,
    /// Tolerance of the answers.
    pub(crate) tolerance: f64,
    /// Faces whose net flux follows from their irradiance.
    net_flux: NetFlux,
}

impl SimulatedScene {
    pub(super) fn of(scene: &Scene, planned: &[PlannedEffect], dropped: f64) -> Self {
        let effects = SimulatedEffects::of(planned);
        let reduced = without(scene, planned);
        let net_flux = NetFlux::of(&reduced);
        let merged = effects.merges_bands(scene).then_some(scene.band_count());
        let mut reduced = if merged.is_some() { reduced.with_one_band() } else { reduced };
        reduced.solve.tolerance -= dropped;
        let (scene_in_units, units) = reduced.into_working_units();
        Self {
            effects,
            scene: Arc::new(scene_in_units),
            units,
            first_faces: FirstFaces::default(),
            merged,
            dropped,
            tolerance: scene.solve.tolerance,
            net_flux,
        }
    }

    /// Returns the scene in working units.
    pub(crate) fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Returns the faces of the scene at the coarsest tessellation.
    pub(crate) fn first_faces(&self) -> &FirstFaces {
        &self.first_faces
    }

    /// Frees the memory of the faces, which are built again should they be needed.
    pub(super) fn forget_faces(&mut self) {
        self.first_faces = FirstFaces::default();
    }

    /// Returns the same scene, for a solver that keeps it.
    pub(crate) fn shared_scene(&self) -> Arc<Scene> {
        Arc::clone(&self.scene)
    }

    /// Returns the task of the path driver in the world of the scene. Receivers of these kinds need
    /// no samples.
    pub(crate) fn task<'s>(&'s self, world: &'s World, computable: Computable) -> Task<'s> {
        let metres = self.units.square_metres.sqrt();
        Task { world, effects: &self.effects, computable, first_faces: &self.first_faces, metres }
    }

    /// Converts the results to the units of their quantities and to all bands.
    pub(crate) fn finished(&self, mut simulation: Simulation) -> Simulation {
        simulation.brightest = brightest_source(&self.scene);
        simulation.leave_working_units(&self.units);
        if self.dropped > 0.0 {
            add_dropped(&mut simulation, self.dropped);
        }
        if let Some(bands) = self.merged {
            spread(&mut simulation, bands);
        }
        self.net_flux.add_to(&mut simulation);
        divide_times(&mut simulation);
        conclude(&mut simulation);
        simulation
    }
}

/// Adds the error budget of omitted effects to every error. It is a bound for the smallest answer
/// of a receiver. So the change of a component of a vector is at most the change of the
/// largest component, and the change of a cell at most the change of the mean, or relative to its
/// own value if that is larger.
fn add_dropped(simulation: &mut Simulation, dropped: f64) {
    let scales: Vec<f64> = simulation.accuracy().answers().map(|rated| rated.scale).collect();
    for (answer, scale) in simulation.answers.iter_mut().zip(scales) {
        answer.add(ErrorParts { effects: dropped * scale, ..ErrorParts::default() });
        answer.kind = answer.kind.with_estimate();
    }
    let Simulation { answers, maps, history, .. } = simulation;
    for map in maps {
        map.kind = map.kind.with_estimate();
        let is_mean = |answer: &&Answer| answer.receiver == map.receiver && answer.quantity == map.quantity;
        let bands = map.errors.iter_mut().zip(&map.values).zip(answers.iter().filter(is_mean));
        for ((errors, values), mean) in bands {
            let cells = errors.iter_mut().zip(values);
            cells.for_each(|(error, value)| *error += mean.parts.effects.max(dropped * value.abs()));
        }
    }
    history.iter_mut().for_each(|moment| moment.error += dropped);
}

/// Divides the time of each receiver among its answers, each of which holds all of it before.
fn divide_times(simulation: &mut Simulation) {
    for answers in simulation.answers.chunk_by_mut(|a, b| a.receiver == b.receiver) {
        let count = answers.len() as f64;
        answers.iter_mut().for_each(|answer| answer.seconds /= count);
    }
}

/// Copies the answers of one band to each band.
fn spread(simulation: &mut Simulation, bands: usize) {
    let of_bands = |answer: Answer| {
        (0..bands).map(move |band| Answer { band: Some(band), ..answer.clone() }).collect::<Vec<_>>()
    };
    simulation.answers = std::mem::take(&mut simulation.answers).into_iter().flat_map(of_bands).collect();
    for map in &mut simulation.maps {
        map.values = vec![map.values[0].clone(); bands];
        map.errors = vec![map.errors[0].clone(); bands];
        map.scales = vec![map.scales[0]; bands];
    }
}

/// Ends the history with the accuracy of the results. Where the work was stopped, receivers that
/// were not reached keep the error at that time.
fn conclude(simulation: &mut Simulation) {
    let error = simulation.accuracy().largest_error();
    let is_stopped = simulation.stopped;
    if let Some(last) = simulation.history.last_mut() {
        last.error = if is_stopped { error.max(last.error) } else { error };
    }
}
