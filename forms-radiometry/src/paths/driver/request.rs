//! Estimands: receivers become questions, each with its replicates and their target number of
//! samples.

mod errors;

use super::Task;
use super::analytic::{Computed, Computing};
use super::darkness::Darkness;
use super::neighbours::Spread;
use super::pixels::shown;
use super::radiances::Radiances;
use crate::effects::EffectSet;
use crate::faces::faces;
use crate::job::{Budget, REPLICATES, Share};
use crate::paths::{Bins, Estimand, FirstHit, LEFT_OUT, PathSampler, Replicates};
use crate::progress::times::scale;
use crate::radiosity::Transport;
use crate::radiosity::driver::grid::Grid;
use crate::sampling::key;
use crate::scene::{Effect, Receiver, ReceiverKind, Scene, TimeBins};
use crate::visibility::Screens;
use rayon::prelude::*;
use std::sync::Arc;
use std::time::Instant;

/// First samples of each replicate of a number.
const FIRST: u32 = 32;
/// First samples of each replicate for all cells of a receiver together, as long as none has more
/// than a number; and the least for a pixel that sees several surfaces.
const FIRST_OF_CELLS: usize = 1024;
const FIRST_OF_SEVERAL: u32 = 8;
/// Samples of a replicate between two checks for a pause, at most; and the time in seconds after which
/// the next step has fewer.
const STEP: u32 = 1 << 12;
const LONG: f64 = 0.05;
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
    /// For a cell of a raster, the number of first samples of each replicate: its part of the
    /// receiver's number.
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

/// Returns all questions of a task; `computing` answers those that need no samples.
pub(crate) fn requests(task: Task<'_>, computing: &Computing<'_>) -> Vec<Request> {
    some_requests(task, computing, usize::MAX).0
}

/// Returns evenly chosen questions of a task, at most this number of them, and the number of all.
pub(super) fn some_requests(task: Task<'_>, computing: &Computing<'_>, most: usize) -> (Vec<Request>, usize) {
    let Task { world, metres, .. } = task;
    let scene = &*world.scene;
    let effects = EffectSet::of_scene(scene);
    let has_images =
        !scene.lights.is_empty() && (effects.has(Effect::Mirror) || effects.has(Effect::Refraction));
    let left_out = if has_images { LEFT_OUT * scene.solve.tolerance } else { 0.0 };
    let mut all: Vec<Request> = Vec::new();
    let mut numbers = 0..;
    let unhidden = unhidden(scene);
    let radiances = Radiances::of(task, &unhidden);
    let of_receivers: Vec<_> =
        scene.receivers.iter().map(|receiver| estimands(receiver, scene, &unhidden)).collect();
    let count = of_receivers.iter().map(Vec::len).sum();
    let step = usize::div_ceil(count, most).max(1);
    for (index, (receiver, own)) in scene.receivers.iter().zip(of_receivers).enumerate() {
        let bins = receiver.time.as_ref().map(|time| bins(time, metres));
        let own_key = key(scene.solve.seed, index as u64);
        let shown = match &receiver.kind {
            ReceiverKind::Camera(camera) => shown(scene, &unhidden.faces, camera),
            _ => Vec::new(),
        };
        let own = own.into_iter().zip(&mut numbers);
        for ((cell, estimand), _) in own.filter(|(_, number): &(_, usize)| number.is_multiple_of(step)) {
            let key = cell.map_or(own_key, |cell| key(own_key, 1 + cell as u64));
            let replicates = Replicates::new(key, &estimand, scene.band_count(), bins);
            let is_in_raster = cell.is_some() && receiver.kind.raster().is_some();
            let [brightest, by_chance] = radiances.largest(&estimand, is_in_raster);
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
                share_of_first: cell.and_then(|_| receiver.kind.raster()).map(share_of_first),
                target: 0,
                spreads: Vec::new(),
                seconds: 0.0,
                elapsed: 0.0,
            });
        }
    }
    look(&mut all, task);
    compute(&mut all, (scene, &unhidden), computing);
    (all, count)
}

/// Finds what questions along rays see first.
fn look(all: &mut [Request], task: Task<'_>) {
    let counts_direct = task.effects.has(Effect::Direct);
    all.par_iter_mut().for_each(|request| {
        let seen = request.estimand.seen(task.world);
        // without direct light, a ray sees of an emitter what it reflects
        request.seen = FirstHit { is_emitter: seen.is_emitter && counts_direct, ..seen };
    });
}

/// Answers the questions that need no samples. Light in time bins is sampled.
fn compute(all: &mut [Request], (scene, unhidden): (&Scene, &Transport), computing: &Computing<'_>) {
    let begin = Instant::now();
    let darkness = Darkness::of(scene, unhidden, all.len());
    let instant = all.par_iter_mut().filter(|request| scene.receivers[request.receiver].time.is_none());
    instant.for_each(|request| {
        let begin = Instant::now();
        let dark = darkness.as_ref().and_then(|darkness| darkness.answer(&request.estimand));
        request.computed = dark.or_else(|| computing.answer(&request.estimand));
        request.elapsed = begin.elapsed().as_secs_f64();
    });
    divide_time(all, begin);
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
        ReceiverKind::Points(points) => {
            let at = |(cell, (position, normal)): (usize, (_, Option<_>))| match normal {
                Some(normal) => (Some(cell), Estimand::Plane { position, normal }),
                None => (Some(cell), Estimand::Sphere { position }),
            };
            points.iter().enumerate().map(at).collect()
        }
        ReceiverKind::Surface { .. } | ReceiverKind::Faces { .. } => {
            let mean = receiver.kind.side().map(|area| (None, Estimand::Surface { area }));
            let faces = receiver.kind.faces(scene).enumerate();
            let faces = faces.map(|(cell, area)| (Some(cell), Estimand::Surface { area }));
            mean.into_iter().chain(faces).chain(cells_of_grid(receiver, scene, unhidden)).collect()
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

/// Returns the cells of the map of a surface, if the receiver asks for one.
fn cells_of_grid(receiver: &Receiver, scene: &Scene, unhidden: &Transport) -> Vec<(Option<usize>, Estimand)> {
    let ReceiverKind::Surface { surface, grid: Some(size), .. } = receiver.kind else { return Vec::new() };
    let side = receiver.kind.side();
    let grid = side.and_then(|side| Grid::over(unhidden, (side, &scene.surfaces[surface].shape), size));
    let Some(grid) = grid else { return Vec::new() };
    let normal = grid.normal();
    let cell = |(cell, position): (usize, Option<_>)| {
        position.map(|position| (Some(cell), Estimand::Plane { position, normal }))
    };
    grid.cells().into_iter().enumerate().filter_map(cell).collect()
}

impl Request {
    /// Whether there is an answer, however large its error.
    pub(crate) fn is_answered(&self) -> bool {
        self.computed.is_some() || self.replicates.samples > 0
    }

    /// Whether it has reached its target number of samples.
    pub(crate) fn is_there(&self) -> bool {
        self.replicates.samples >= self.target
    }

    /// Adds samples up to the target, or until a pause is requested, but at least one step. `note`
    /// receives the number of samples of each step. Where the work is stopped, a step of one sample
    /// that is not done is given up.
    pub(crate) fn reach(
        &mut self,
        samplers: &[Box<dyn PathSampler + '_>],
        is_meant: impl Fn(usize) -> bool + Sync,
        (is_paused, is_stopped): (impl Fn() -> bool, &(dyn Fn() -> bool + Sync)),
        note: impl Fn(u32),
    ) {
        let begin = Instant::now();
        let mut step = 1;
        loop {
            let (before, started) = (self.replicates.samples, Instant::now());
            let next = self.target.min(before.saturating_add(step));
            let kept = (step == 1).then(|| self.replicates.clone());
            self.replicates.extend(next, &self.estimand, samplers, &is_meant, is_stopped);
            if let Some(kept) = kept.filter(|_| is_stopped() && self.replicates.are_cut()) {
                self.replicates = kept;
                break;
            }
            note(next - before);
            if self.is_there() || is_paused() {
                break;
            }
            let is_long = started.elapsed().as_secs_f64() > LONG;
            step = if is_long { (step / 2).max(1) } else { (2 * step).min(STEP) };
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
}

/// Returns the number of first samples of each replicate of a cell or a pixel of a raster.
fn share_of_first([columns, rows]: [usize; 2]) -> u32 {
    (FIRST_OF_CELLS / (columns * rows).max(1)).clamp(1, FIRST as usize) as u32
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
    Transport {
        faces: Arc::new(faces),
        screens: Arc::new(screens),
        occlusion: false,
        hides_outside: true,
        accuracy: 1.0,
    }
}
