//! Estimands: receivers become questions, each with its replicates and their target number of
//! samples.

use super::analytic::{Computed, Computing};
use super::neighbours::Spread;
use super::pixels::shown;
use super::radiances::{brightest, by_chance, outside, passed_on};
use crate::answer::{ErrorKind, ErrorParts};
use crate::effects::EffectSet;
use crate::faces::faces;
use crate::job::{Budget, MOST_SAMPLES, REPLICATES, Share};
use crate::paths::{Bins, Estimand, FirstHit, LEFT_OUT, PathSampler, Replicates, World};
use crate::progress::times::scale;
use crate::radiosity::driver::ROUNDING;
use crate::radiosity::driver::grid::Grid;
use crate::radiosity::{Transport, most_reflected_of_beams};
use crate::sampling::key;
use crate::scene::{Effect, Receiver, ReceiverKind, Scene, TimeBins};
use crate::visibility::Screens;
use rayon::prelude::*;
use std::time::Instant;

/// First samples of each replicate of a number.
const FIRST: u32 = 32;
/// First samples of each replicate for all cells of a receiver together, as long as none has more
/// than a number; and the least for a pixel that sees several surfaces.
const FIRST_OF_CELLS: usize = 1024;
const FIRST_OF_SEVERAL: u32 = 8;
/// Samples of a replicate between two checks for a pause.
const STEP: u32 = 1 << 12;
/// Samples of each replicate after which more are useless, if all of them found nothing.
const NOTHING: u32 = 1 << 14;
/// Difference between the values of samples by rounding, relative to their mean.
const SAME: f64 = 1e-12;
/// Rule of three: an event that none of n samples met is rarer than this over n, as a rule.
const UNMET: f64 = 3.0;
/// The speed of light, in m/s.
const LIGHT: f64 = 299_792_458.0;

/// Estimand of a receiver.
pub(crate) struct Request {
    pub(crate) receiver: usize,
    /// The cell of a map or the pixel of an image, if it is one.
    pub(crate) cell: Option<usize>,
    /// Direct view of a pixel or a ray.
    pub(crate) seen: FirstHit,
    /// Part of a pixel in which surfaces that send light may be visible.
    shown: f64,
    pub(crate) estimand: Estimand,
    pub(crate) replicates: Replicates,
    /// Analytic values by number and band, where no samples are needed.
    pub(crate) computed: Option<Vec<Computed>>,
    /// Largest light of omitted image sources in a value, relative to it.
    left_out: f64,
    /// For each band, the largest number that light of the brightest radiance causes: light of
    /// surfaces, from outside, or reflected light of point and distant lights.
    brightest: Vec<f64>,
    /// For each band, the largest number caused by light that is found only by chance: light from
    /// outside, and of surfaces via curved mirrors and glass.
    by_chance: Vec<f64>,
    /// For a cell, the number of first samples of each replicate: its part of the receiver's
    /// number.
    share_of_first: Option<u32>,
    /// Number of samples that each replicate is to reach before the error is checked again.
    pub(crate) target: u32,
    /// Spread of each of its values among the cells around it; empty where there is none.
    pub(super) spreads: Vec<Spread>,
    /// Part of the time of the work that it took.
    pub(crate) seconds: f64,
    /// Time that it took in the present loop over questions, of which several run at once.
    elapsed: f64,
}

/// Part of the work that belongs to a shard: questions, or with a budget their replicates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Division {
    pub(crate) share: Share,
    pub(crate) budget: Option<Budget>,
}

impl Division {
    /// Whether any part of a question belongs to it.
    pub(crate) fn has(self, estimand: usize) -> bool {
        match self.budget {
            Some(_) => (0..REPLICATES).any(|replicate| self.has_replicate(estimand, replicate)),
            None => self.share.has(estimand),
        }
    }

    /// Returns the number of units of work that belong to it, and the number of all units.
    pub(crate) fn units(self, estimands: usize) -> [usize; 2] {
        let all = if self.budget.is_some() { estimands * REPLICATES } else { estimands };
        [(0..all).filter(|&unit| self.share.has(unit)).count(), all]
    }

    /// Whether a replicate of a question gets samples, if any of the replicates do.
    pub(crate) fn has_replicate(self, estimand: usize, replicate: usize) -> bool {
        self.budget.is_none() || self.share.has(estimand * REPLICATES + replicate)
    }
}

/// Returns all questions of a scene. `metres` is the working unit of length; `computing` answers
/// the questions that need no samples.
pub(crate) fn requests(world: &World, metres: f64, computing: &Computing<'_>) -> Vec<Request> {
    let scene = &*world.scene;
    let effects = EffectSet::of_scene(scene);
    let has_images =
        !scene.lights.is_empty() && (effects.has(Effect::Mirror) || effects.has(Effect::Refraction));
    let left_out = if has_images { LEFT_OUT * scene.solve.tolerance } else { 0.0 };
    let mut all: Vec<Request> = Vec::new();
    let unhidden = unhidden(scene);
    let outside = outside(scene);
    let of_beams = most_reflected_of_beams(scene, &unhidden);
    let brightest = [1.0, passed_on(scene, effects)].map(|part| brightest(scene, &of_beams, &outside, part));
    let by_chance = by_chance(world, outside);
    for (index, receiver) in scene.receivers.iter().enumerate() {
        let bins = receiver.time.as_ref().map(|time| bins(time, metres));
        let own_key = key(scene.solve.seed, index as u64);
        let shown = match &receiver.kind {
            ReceiverKind::Camera(camera) => shown(scene, &unhidden.faces, camera),
            _ => Vec::new(),
        };
        for (cell, estimand) in estimands(receiver, scene, &unhidden) {
            let key = cell.map_or(own_key, |cell| key(own_key, 1 + cell as u64));
            let replicates = Replicates::new(key, &estimand, scene.band_count(), bins);
            // luminaires are sampled by next-event estimation, but from nowhere along the first ray
            // of an eye
            let is_looked_for = !matches!(estimand, Estimand::Sight { .. } | Estimand::Pixel { .. });
            let [brightest, by_chance] = [&brightest[usize::from(is_looked_for)], &by_chance]
                .map(|radiances| radiances.iter().map(|&radiance| estimand.largest(radiance)).collect());
            all.push(Request {
                receiver: index,
                cell,
                seen: FirstHit::NOTHING,
                shown: cell.and_then(|cell| shown.get(cell).copied()).unwrap_or(1.0),
                estimand,
                replicates,
                computed: None,
                left_out,
                brightest,
                by_chance,
                share_of_first: cell.map(|_| share_of_first(receiver)),
                target: 0,
                spreads: Vec::new(),
                seconds: 0.0,
                elapsed: 0.0,
            });
        }
    }
    let begin = Instant::now();
    all.par_iter_mut().for_each(|request| request.seen = request.estimand.seen(world));
    // light in time bins is sampled
    let instant = all.par_iter_mut().filter(|request| scene.receivers[request.receiver].time.is_none());
    instant.for_each(|request| request.compute(computing));
    divide_time(&mut all, begin);
    all
}

/// Divides the time of a loop over questions, which began at this time and has just ended, among
/// them.
pub(crate) fn divide_time(all: &mut [Request], begin: Instant) {
    let scale = scale(begin, all.iter().map(|request| request.elapsed).sum());
    for request in all {
        request.seconds += scale * std::mem::take(&mut request.elapsed);
    }
}

/// Returns the questions of a scene, receiver by receiver.
pub(crate) fn all_estimands(scene: &Scene) -> Vec<Estimand> {
    let unhidden = unhidden(scene);
    let of_receiver =
        |receiver| estimands(receiver, scene, &unhidden).into_iter().map(|(_, estimand)| estimand);
    scene.receivers.iter().flat_map(of_receiver).collect()
}

/// Returns the questions of a receiver: its number, if it asks for one, and its cells or pixels.
fn estimands(receiver: &Receiver, scene: &Scene, unhidden: &Transport) -> Vec<(Option<usize>, Estimand)> {
    match &receiver.kind {
        ReceiverKind::Point { position, normal } => {
            vec![(None, Estimand::Plane { position: *position, normal: *normal })]
        }
        ReceiverKind::Ray { origin, direction } => {
            vec![(None, Estimand::Sight { origin: *origin, direction: *direction })]
        }
        ReceiverKind::Sphere { position } => vec![(None, Estimand::Sphere { position: *position })],
        ReceiverKind::Surface { surface, grid: size } => {
            let mean = (None, Estimand::Surface { surface: *surface });
            let Some(grid) = size.and_then(|size| grid(scene, unhidden, *surface, size)) else {
                return vec![mean];
            };
            let normal = grid.normal();
            let cell = |(cell, position): (usize, &Option<_>)| {
                position.map(|position| (Some(cell), Estimand::Plane { position, normal }))
            };
            std::iter::once(mean).chain(grid.cells().iter().enumerate().filter_map(cell)).collect()
        }
        ReceiverKind::Camera(camera) => {
            let [columns, rows] = camera.resolution;
            let pixel = |cell: usize| {
                let pixel = [cell % columns, cell / columns];
                (Some(cell), Estimand::Pixel { camera: camera.clone(), pixel })
            };
            (0..columns * rows).map(pixel).collect()
        }
    }
}

impl Request {
    /// Computes the answer, if it needs no samples.
    fn compute(&mut self, computing: &Computing<'_>) {
        let begin = Instant::now();
        self.computed = computing.answer(&self.estimand);
        self.elapsed = begin.elapsed().as_secs_f64();
    }

    /// Whether there is an answer, however large its error.
    pub(crate) fn is_answered(&self) -> bool {
        self.computed.is_some() || self.replicates.samples > 0
    }

    /// Whether it has reached its target number of samples.
    pub(crate) fn is_there(&self) -> bool {
        self.replicates.samples >= self.target
    }

    /// Adds samples up to the target, or until a pause is requested, but at least one step. `note`
    /// receives the number of samples of each step.
    pub(crate) fn reach(
        &mut self,
        samplers: &[Box<dyn PathSampler + '_>],
        is_meant: impl Fn(usize) -> bool + Sync,
        is_paused: impl Fn() -> bool,
        note: impl Fn(u32),
    ) {
        let begin = Instant::now();
        loop {
            let before = self.replicates.samples;
            let next = self.target.min(before.saturating_add(STEP));
            self.replicates.extend(next, &self.estimand, samplers, &is_meant);
            note(next - before);
            if self.is_there() || is_paused() {
                break;
            }
        }
        self.elapsed = begin.elapsed().as_secs_f64();
    }

    /// Sets the next target: the first samples, or twice the present number, up to `most`.
    pub(crate) fn aim(&mut self, most: u32) {
        let doubled = self.replicates.samples.saturating_mul(2);
        self.target = doubled.max(self.first()).min(most);
    }

    /// Returns the number of first samples of each replicate.
    pub(super) fn first(&self) -> u32 {
        let several = if self.seen.surface.is_err() { FIRST_OF_SEVERAL } else { 1 };
        self.share_of_first.map_or(FIRST, |share| share.max(several))
    }

    /// Returns the kind of its errors.
    pub(crate) fn kind(&self) -> ErrorKind {
        match &self.computed {
            None => ErrorKind::Sigma,
            Some(computed) if computed.iter().all(|one| one.parts.quadrature == 0.0) => ErrorKind::Bound,
            Some(_) => ErrorKind::Estimate,
        }
    }

    /// Returns a value and its error.
    pub(crate) fn found(&self, place: usize) -> [f64; 2] {
        let (value, parts) = self.found_in_parts(place);
        [value, parts.error(self.kind())]
    }

    /// Returns a value and its error budget: truncated rays, path samples, omitted image sources,
    /// and rounding.
    pub(crate) fn found_in_parts(&self, place: usize) -> (f64, ErrorParts) {
        let (value, own) = match &self.computed {
            Some(computed) => (computed[place].value, computed[place].parts),
            None => {
                let [value, error] = self.replicates.found(place);
                let is_nothing = self.is_nothing([value, error]);
                // light of luminaires under next-event estimation that no random direction has met:
                // its part is the square of their probability per sample
                let unmet =
                    if is_nothing { (UNMET / self.replicates.count()).powi(2) * value.abs() } else { 0.0 };
                let told = self.spreads.get(place);
                let error = told.map_or(error, |told| told.error(error, self.replicates.samples));
                let sampling = error.hypot(self.unseen(place, is_nothing)).hypot(unmet);
                (value, ErrorParts { sampling, ..ErrorParts::default() })
            }
        };
        let [rounding, images] = [ROUNDING, self.left_out].map(|part| part * value.abs());
        (value, own + ErrorParts { rounding, orders: images, ..ErrorParts::default() })
    }

    /// Whether no sample found anything by chance: all samples have the same value, and it is not
    /// the value of an emitter that a ray sees.
    fn is_nothing(&self, [value, error]: [f64; 2]) -> bool {
        error <= SAME * value.abs() && (value == 0.0 || !self.seen.is_emitter)
    }

    /// Returns the largest amount that one more sample could add to a value: a luminaire that was
    /// hidden from all other samples, or light that is found only by chance. Where no sample found
    /// anything, it is the brightest light, in the part of a pixel that may show any.
    fn unseen(&self, place: usize, is_nothing: bool) -> f64 {
        if self.replicates.samples == 0 {
            return 0.0;
        }
        let rare = 1.0 / self.replicates.count();
        let band = self.replicates.band(place);
        let brightest = if is_nothing { self.brightest[band] * self.shown.min(rare) } else { 0.0 };
        brightest.max(rare * self.by_chance[band].max(self.replicates.missed(place)))
    }

    /// Returns the largest number that any light of the scene causes.
    pub(crate) fn brightest(&self) -> f64 {
        self.brightest.iter().copied().fold(0.0, f64::max)
    }

    /// Returns the largest value of each band.
    pub(crate) fn largest(&self, bands: usize) -> Vec<f64> {
        let mut largest = vec![0.0_f64; bands];
        for place in 0..self.replicates.len() {
            let band = self.replicates.band(place);
            largest[band] = largest[band].max(self.found(place)[0].abs());
        }
        largest
    }

    /// Returns the largest error relative to the scales of bands; for a cell, at least to its own
    /// value; where nothing was found, to the brightest light.
    pub(crate) fn error(&self, scales: &[f64]) -> f64 {
        let relative = |place: usize| {
            let [value, error] = self.found(place);
            let own = if self.cell.is_some() { value.abs() } else { 0.0 };
            let scale = scales[self.replicates.band(place)].max(own);
            if error == 0.0 { 0.0 } else { error / if scale > 0.0 { scale } else { self.brightest() } }
        };
        (0..self.replicates.len()).map(relative).fold(0.0, f64::max)
    }

    /// Predicts the samples of a replicate after which the error meets this tolerance with these
    /// scales. The error falls as the inverse square root of the number of samples, which is
    /// doubled until then.
    pub(crate) fn foreseen(&self, scales: &[f64], tolerance: f64) -> f64 {
        let (samples, most) = (f64::from(self.replicates.samples), f64::from(MOST_SAMPLES));
        let doublings = (2.0 * (self.error(scales) / tolerance).log2()).ceil().max(0.0);
        (samples * doublings.exp2()).min(most).max(f64::from(self.target))
    }

    pub(crate) fn may_go_on(&self) -> bool {
        if self.computed.is_some() {
            return false;
        }
        let is_nothing = || (0..self.replicates.len()).all(|place| self.replicates.found(place) == [0.0; 2]);
        self.replicates.samples < MOST_SAMPLES && !(self.replicates.samples >= NOTHING && is_nothing())
    }
}

/// Returns the number of first samples of each replicate of a cell or a pixel of a receiver.
fn share_of_first(receiver: &Receiver) -> u32 {
    let [columns, rows] = size(receiver);
    (FIRST_OF_CELLS / (columns * rows).max(1)).clamp(1, FIRST as usize) as u32
}

/// Returns the columns and rows of the map or image of a receiver; zeros where it has neither.
pub(crate) fn size(receiver: &Receiver) -> [usize; 2] {
    match &receiver.kind {
        ReceiverKind::Surface { grid: Some(size), .. } => *size,
        ReceiverKind::Camera(camera) => camera.resolution,
        _ => [0; 2],
    }
}

/// Converts time bins to bins of optical path length.
fn bins(time: &TimeBins, metres: f64) -> Bins {
    let length = LIGHT / metres;
    Bins { start: time.start * length, width: time.width * length, count: time.bins }
}

/// Returns the geometry of a scene without any occlusion.
fn unhidden(scene: &Scene) -> Transport {
    let faces = faces(scene, 2);
    let screens = Screens::none(&faces);
    Transport { faces, screens, occlusion: false, accuracy: 1.0 }
}

/// Returns the grid over a surface.
fn grid(scene: &Scene, unhidden: &Transport, surface: usize, size: [usize; 2]) -> Option<Grid> {
    Grid::over(unhidden, (surface, &scene.surfaces[surface].shape), size)
}
