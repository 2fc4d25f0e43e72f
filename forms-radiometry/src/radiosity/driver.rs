//! The solver: a scene and its plan become answers.
//!
//! ```text
//! elements ─▶ readings ─▶ finer elements ─▶ readings ─▶ … ─▶ maps
//!             until the readings change no more than the tolerance
//! ```
//! The error of a reading is estimated from its changes (see [`estimate`](super::driver::estimate)); the
//! error of the solution of the equations and rounding are added. For curved shapes, everything is
//! done with two polyhedra, one finer than the other, and the change between them is added too.

pub(crate) mod estimate;
mod goals;
pub(crate) mod grid;
pub(crate) mod images;
mod interpolation;
mod lists;
mod maps;
mod precision;
pub(crate) mod readings;
mod rounds;
pub(crate) mod scales;
mod tessellation;

use super::question::asks_for_rays;
use super::{FirstFaces, Lights, Question, Radiosity, Transport};
use crate::answer::{Answer, Moment, Simulation};
use crate::effects::{Hiding, SimulatedEffects};
use crate::faces::{faces, is_round};
use crate::parallelism::Parallelism;
use crate::progress::times::{Times, timed};
use crate::progress::{Outlook, Progress};
use crate::scene::{Effect, Scene};
use crate::visibility::{Face, Screens};
use crate::watch::Watch;
use estimate::Found;
use grid::Grid;
use images::Image;
use readings::{Reading, groups};
use scales::Pictures;
use std::sync::Arc;
use std::time::Instant;
use tessellation::Shapes;

/// Part of the tolerance left for rules of integration.
pub(crate) const RULES: f64 = 0.02;
/// Part of the tolerance left for integrals of direct light where nothing is reflected: nothing
/// else has an error there.
const STRAIGHT: f64 = 0.25;
/// Rounding error of an answer, relative to it.
pub(crate) const ROUNDING: f64 = 64.0 * f64::EPSILON;
/// Fineness of the finest polyhedra.
pub(crate) const FINEST: usize = 4;
/// Largest number of times that maps and images are computed: again only where their means are less
/// than the watched cells indicated.
const ATTEMPTS: usize = 2;
/// Solves a scene as a whole, in working units.
pub(crate) fn solved(
    scene: &Scene,
    effects: SimulatedEffects,
    first: &FirstFaces,
    progress: &Progress<'_>,
) -> Simulation {
    Work::new(scene, effects, first, progress).run()
}

/// Returns the faces that occlude light or that the rays of receivers meet. Where disks and spheres may be seen as whole shapes, occluders are
/// needed in any case: an occluder that hides nothing of the tessellated faces may hide some of
/// the rest of the shape.
fn screens(
    scene: &Scene,
    effects: &SimulatedEffects,
    faces: &[Face],
    all: impl Fn() -> Arc<Screens>,
) -> Arc<Screens> {
    let may_be_whole = effects.orders == Some(0) && is_round(scene);
    if effects.has(Effect::Occlusion) || may_be_whole {
        all()
    } else if asks_for_rays(scene) {
        Arc::new(Screens::met_by_rays(faces))
    } else {
        Arc::new(Screens::none(faces))
    }
}

/// State of the solver.
pub(crate) struct Work<'s> {
    pub(crate) scene: &'s Scene,
    effects: SimulatedEffects,
    first: &'s FirstFaces,
    pub(crate) watch: &'s dyn Watch,
    pub(crate) progress: &'s Progress<'s>,
    pub(crate) times: Times,
    pub(crate) readings: Vec<Reading>,
    /// Number of readings that are answers.
    pub(crate) answers: usize,
    /// Number of readings that are answers, or numbers at listed points or on listed faces; the
    /// readings after them are watched cells of maps and watched pixels.
    pub(crate) requested: usize,
    /// Group of each reading.
    pub(crate) groups: Vec<usize>,
    /// For each watched cell, the radiance emitted directly into it in each band; empty for cells
    /// of maps.
    pub(crate) emitted: Vec<Vec<f64>>,
    /// For each receiver, the scales of its map or image in all bands, once they are known.
    pub(crate) known_scales: Vec<Option<Vec<f64>>>,
}

impl<'s> Work<'s> {
    fn new(
        scene: &'s Scene,
        effects: SimulatedEffects,
        first: &'s FirstFaces,
        progress: &'s Progress<'s>,
    ) -> Self {
        let (readings, answers) = Reading::requested(scene);
        let groups = groups(&readings, answers);
        Self {
            scene,
            effects,
            first,
            watch: progress,
            progress,
            times: Times::new(scene.receivers.len()),
            requested: readings.len(),
            readings,
            answers,
            groups,
            emitted: Vec::new(),
            known_scales: vec![None; scene.receivers.len()],
        }
    }

    fn run(mut self) -> Simulation {
        let mut shapes = Shapes::new(self.scene, self.effects.orders == Some(0), &self.readings);
        let is_round_anywhere = shapes.are_round();
        let mut history = Vec::new();
        let mut attempts = 1;
        for fineness in 0.. {
            let (found, pictures) = self.at_fineness(fineness, &mut shapes, &mut history);
            if let Some(pictures) = pictures {
                let is_final = attempts == ATTEMPTS || fineness == FINEST;
                if is_final || !self.rescale(&pictures, &found) {
                    return self.simulation(&found, pictures, history);
                }
                attempts += 1;
            }
            if is_round_anywhere {
                shapes.remember(found);
            }
        }
        unreachable!("the finest polyhedra are the last")
    }

    /// Returns the readings with polyhedra of this fineness, and the maps and images if no finer
    /// polyhedra are needed.
    fn at_fineness(
        &mut self,
        fineness: usize,
        shapes: &mut Shapes,
        history: &mut Vec<Moment>,
    ) -> (Vec<Found>, Option<Pictures>) {
        let is_round_anywhere = shapes.are_round();
        self.progress.begin(Outlook::Unknown);
        let transport = self.transport(fineness);
        let lights = Lights::of(self.scene, &transport);
        let grids = self.grids(&transport);
        let own_sight = self.sight(&transport);
        let sight = own_sight.as_ref().unwrap_or(&transport);
        if fineness == 0 {
            let is_watched = is_round_anywhere || !self.is_straight();
            self.watch_some(if is_watched { &grids } else { &[] }, sight);
        }
        let parallelism = self.parallelism(&lights, &transport, &grids);
        parallelism.enter(|| {
            let straight = || self.straight(&grids, &lights, &transport);
            // these are the last faces: the direct light of cells waits for no solution
            let ((radiosity, mut found), known) = self.both(
                parallelism,
                || self.refined(&transport, &lights, history),
                || (!is_round_anywhere).then(straight),
            );
            let is_compared = self.compare(shapes, &mut found);
            // includes readings that were settled, and the error by tessellation
            if let Some(now) = history.last_mut() {
                now.error = self.relative_errors(&found).fold(0.0, f64::max);
            }
            let is_whole = grids.is_empty()
                && self.cameras().next().is_none()
                && !found.iter().any(|found| found.has_pieces);
            let is_last = !is_round_anywhere
                || is_whole
                || self.watch.is_stopped()
                || fineness == FINEST
                || (is_compared && self.is_enough(&found));
            let pictures = is_last.then(|| {
                let grids = (&grids[..], known.unwrap_or_else(straight));
                self.pictures(&radiosity, grids, sight, &found)
            });
            (found, pictures)
        })
    }

    /// Returns the maps and images of a solution on elements. `grids` are the maps, with the direct
    /// light of their cells.
    fn pictures(
        &self,
        radiosity: &Radiosity,
        grids: (&[(usize, Grid)], Vec<Vec<f64>>),
        sight: &Transport,
        found: &[Found],
    ) -> Pictures {
        let cameras = self.cameras().count();
        self.progress.begin(Outlook::Stages(1 + cameras));
        let maps = self.maps(radiosity, grids, found);
        self.progress.begin(Outlook::Stages(cameras));
        let images = self.images(radiosity, sight, found);
        Pictures { maps, images }
    }

    /// Returns the results of two tasks that do not depend on each other. Where they run at the
    /// same time, their receivers divide the elapsed time.
    fn both<A: Send, B: Send>(
        &self,
        parallelism: Parallelism,
        one: impl FnOnce() -> A + Send,
        other: impl FnOnce() -> B + Send,
    ) -> (A, B) {
        let (begin, before) = (Instant::now(), self.times.all());
        let ((one, first), (other, second)) = parallelism.both(|| timed(one), || timed(other));
        self.times.rejoin(begin, &before, [first, second]);
        (one, other)
    }

    /// Adds the error by tessellation of curved shapes. Returns whether it is known.
    fn compare(&self, shapes: &mut Shapes, found: &mut Vec<Found>) -> bool {
        let is_compared = shapes.compare(found, &self.readings);
        if shapes.are_round() && self.watch.is_stopped() && !is_compared {
            let of_pieces = found.iter_mut().filter(|found| found.has_pieces);
            let estimates = of_pieces.flat_map(|found| &mut found.bands);
            estimates.for_each(|estimate| estimate.floor.quadrature = f64::INFINITY);
        }
        is_compared
    }

    /// Whether all light at points is direct light, in closed forms.
    fn is_straight(&self) -> bool {
        self.effects.orders == Some(0)
    }

    /// Returns whether the loops over readings and cells are worth more than one thread.
    fn parallelism(&self, lights: &Lights, transport: &Transport, grids: &[(usize, Grid)]) -> Parallelism {
        if !self.is_straight() {
            return Parallelism::Shared;
        }
        if self.cameras().next().is_some() {
            return Parallelism::Shared;
        }
        let cells: usize = grids.iter().map(|(_, grid)| grid.count()).sum();
        Parallelism::of(lights.operations(self.readings.len() + cells, transport))
    }

    fn transport(&self, fineness: usize) -> Transport {
        let (scene, first) = (self.scene, self.first);
        let is_first = fineness == 0;
        let faces = if is_first { first.faces(scene) } else { Arc::new(faces(scene, fineness)) };
        let all = || if is_first { first.screens(scene) } else { Arc::new(Screens::of(&faces)) };
        let screens = screens(scene, &self.effects, &faces, all);
        let part = if self.effects.orders == Some(0) { STRAIGHT } else { RULES };
        let accuracy = (part * self.scene.solve.tolerance).clamp(1e-12, 1e-2);
        let hides_outside = self.effects.hiding != Hiding::LeftOut;
        Transport { faces, screens, occlusion: self.effects.has(Effect::Occlusion), hides_outside, accuracy }
    }

    pub(crate) fn question(&self) -> Question {
        Question::of(self.scene, &self.effects)
    }

    /// Returns the results, in the order of the receivers.
    fn simulation(&self, found: &[Found], pictures: Pictures, history: Vec<Moment>) -> Simulation {
        let Pictures { mut maps, images } = pictures;
        let mut answers = self.answered(found);
        let (lists, means) = self.lists(found);
        maps.extend(lists);
        answers.extend(means);
        for Image { receiver, map, means } in images {
            answers.extend(means.into_iter().map(|mean| (receiver, mean)));
            maps.push((receiver, map));
        }
        answers.iter_mut().for_each(|(receiver, answer)| answer.seconds = self.times.of(*receiver));
        answers.sort_by_key(|(receiver, _)| *receiver);
        maps.sort_by_key(|(receiver, _)| *receiver);
        Simulation {
            answers: answers.into_iter().map(|(_, answer)| answer).collect(),
            maps: maps.into_iter().map(|(_, map)| map).collect(),
            history,
            seconds: self.progress.seconds(),
            stopped: self.watch.is_stopped(),
            ..Simulation::default()
        }
    }

    /// Returns the answers that are readings, each with the index of its receiver.
    fn answered(&self, found: &[Found]) -> Vec<(usize, Answer)> {
        let mut answers = Vec::new();
        let is_round = is_round(self.scene);
        for (reading, found) in self.readings[..self.answers].iter().zip(found) {
            for (band, estimate) in found.bands.iter().enumerate() {
                let answer = Answer {
                    receiver: self.scene.receivers[reading.receiver].name.clone(),
                    quantity: reading.quantity,
                    band: (found.bands.len() > 1).then_some(band),
                    bin: None,
                    value: estimate.value,
                    error: estimate.error(),
                    parts: estimate.parts(),
                    kind: estimate.kind(found.has_pieces && is_round),
                    seconds: 0.0,
                };
                answers.push((reading.receiver, answer));
            }
        }
        answers
    }
}
