//! Answers by paths: receivers become questions, and these get more samples until they are exact enough.
//!
//! ```text
//! receivers ─▶ questions ─▶ replicates ─ twice as many samples where the error is too large ─▶ answers, maps, images
//! ```
//! The tolerance is of one standard error, relative to the answer; of the components of a vector, the bins of a time, the cells of a map
//! and the pixels of an image to the largest of them.
//!
//! Where no sample found anything, one more could: the error is then what a sample of the same receiver brings that finds something, on average,
//! over the number of samples; and if none did, what light of the brightest radiance would bring.

use super::answer::{Answer, ErrorKind, Map, Moment, Quantity, Simulation};
use super::effects::Effects;
use super::map::Grid;
use super::solver::ROUNDING;
use super::watch::Watch;
use crate::faces::faces;
use crate::geometry::Screens;
use crate::monte_carlo::{self, Bins, Follow, LEFT_OUT, Limits, Question, Replicates, World, follower};
use crate::radiosity::Transport;
use crate::sampling::key;
use crate::scene::{MaterialKind, Medium, Receiver, ReceiverKind, Scene, TimeBins};
use rayon::prelude::*;
use std::time::Instant;

/// The first samples of each replicate of a number, and of a cell or a pixel.
const FIRST: [u32; 2] = [32, 1];
/// The most samples of a replicate.
const MOST: u32 = 1 << 31;
/// Samples of a replicate after which it is asked whether to stop.
const STEP: u32 = 1 << 12;
/// The speed of light, in m/s.
const LIGHT: f64 = 299_792_458.0;

/// Answers the questions of a scene in working units by paths. `metres` is the working unit of length.
pub(super) fn followed(scene: &Scene, effects: &Effects, metres: f64, watch: &dyn Watch) -> Simulation {
    let world = World::new(scene);
    let limits =
        Limits { reflections: effects.orders, scatterings: effects.scatterings, direct: effects.direct };
    let followers = follower(&world, monte_carlo::Effects::of(scene), limits);
    let mut work =
        Work { scene, followers, asked: Vec::new(), watch, start: Instant::now(), history: Vec::new() };
    work.ask(metres);
    work.run();
    Simulation {
        answers: work.answers(),
        maps: work.maps(),
        history: work.history,
        stopped: watch.is_stopped(),
    }
}

/// Whether a scene asks for more than diffuse surfaces in a clear medium and numbers and maps of them.
pub(super) fn is_followed(scene: &Scene) -> bool {
    let is_diffuse = |kind: &MaterialKind| matches!(kind, MaterialKind::Diffuse { .. });
    let is_number =
        |receiver: &Receiver| receiver.time.is_none() && !matches!(receiver.kind, ReceiverKind::Camera(_));
    let ambient = scene.ambient.medium.map(|medium| &scene.media[medium]);
    !(scene.surfaces.iter().all(|surface| is_diffuse(&scene.materials[surface.material].kind))
        && scene.receivers.iter().all(is_number)
        && ambient.is_none_or(Medium::is_clear))
}

struct Work<'w> {
    scene: &'w Scene,
    followers: Vec<Box<dyn Follow + 'w>>,
    asked: Vec<Asked>,
    watch: &'w dyn Watch,
    start: Instant,
    history: Vec<Moment>,
}

/// A question of a receiver.
struct Asked {
    receiver: usize,
    /// The cell of a map or the pixel of an image, if it is one.
    cell: Option<usize>,
    question: Question,
    replicates: Replicates,
    /// For each band the value and its error, where no samples are needed.
    expanded: Option<Vec<[f64; 2]>>,
    /// What a sample may bring where none has found anything yet.
    unseen: f64,
    /// What rounding and images that are left out may make of a value, relative to it.
    floor: f64,
    seconds: f64,
}

impl Work<'_> {
    fn ask(&mut self, metres: f64) {
        let effects = monte_carlo::Effects::of(self.scene);
        let has_images = !self.scene.lights.is_empty() && (effects.mirror || effects.refraction);
        let floor = ROUNDING + if has_images { LEFT_OUT * self.scene.solve.tolerance } else { 0.0 };
        for (index, receiver) in self.scene.receivers.iter().enumerate() {
            let bins = receiver.time.as_ref().map(|time| bins(time, metres));
            let own = key(self.scene.solve.seed, index as u64);
            let mut add = |cell: Option<usize>, question: Question| {
                let key = cell.map_or(own, |cell| key(own, 1 + cell as u64));
                let replicates = Replicates::new(key, &question, self.scene.band_count(), bins);
                let begin = Instant::now();
                let groups = self.followers.iter().map(|follower| follower.expanded(&question));
                let expanded: Option<Vec<_>> = groups.collect();
                let expanded = expanded.filter(|_| bins.is_none()).map(|groups| groups.concat());
                let seconds = begin.elapsed().as_secs_f64();
                self.asked.push(Asked {
                    receiver: index,
                    cell,
                    question,
                    replicates,
                    expanded,
                    unseen: 0.0,
                    floor,
                    seconds,
                });
            };
            if !matches!(receiver.kind, ReceiverKind::Camera(_)) {
                add(None, question(receiver));
            }
            match &receiver.kind {
                ReceiverKind::Surface { surface, grid: Some(size) } => {
                    let Some(grid) = grid(self.scene, *surface, *size) else { continue };
                    let normal = grid.normal();
                    for (cell, position) in grid.cells().iter().enumerate() {
                        if let Some(position) = *position {
                            add(Some(cell), Question::Plane { position, normal });
                        }
                    }
                }
                ReceiverKind::Camera(camera) => {
                    let [columns, rows] = camera.resolution;
                    for cell in 0..columns * rows {
                        let pixel = [cell % columns, cell / columns];
                        add(Some(cell), Question::Pixel { camera: camera.clone(), pixel });
                    }
                }
                _ => {}
            }
        }
    }

    /// Rounds of samples, until all is exact enough, or nothing can be gained.
    fn run(&mut self) {
        if self.asked.iter().all(|asked| asked.expanded.is_some()) {
            let scales = self.scales();
            let errors = self.asked.iter().zip(&scales).map(|(asked, scales)| asked.error(scales));
            let seconds = self.start.elapsed().as_secs_f64();
            self.history.push(Moment { seconds, error: errors.fold(0.0, f64::max) });
        }
        let mut pending: Vec<usize> =
            (0..self.asked.len()).filter(|&index| self.asked[index].expanded.is_none()).collect();
        while !pending.is_empty() && !self.watch.is_stopped() {
            let mut is_pending = vec![false; self.asked.len()];
            pending.iter().for_each(|&index| is_pending[index] = true);
            let (followers, watch) = (&self.followers, self.watch);
            let asked = self.asked.par_iter_mut().zip(&is_pending).filter(|(_, is_pending)| **is_pending);
            asked.for_each(|(asked, _)| asked.double(followers, watch));
            self.estimate_unseen();
            let scales = self.scales();
            let tolerance = self.scene.solve.tolerance;
            let worst = |(asked, scales): (&Asked, &Vec<f64>)| asked.error(scales);
            let error = self.asked.iter().zip(&scales).map(worst).fold(0.0, f64::max);
            self.history.push(Moment { seconds: self.start.elapsed().as_secs_f64(), error });
            watch.progress("paths", (tolerance / error).powi(2).min(1.0));
            // among all: what others of its receiver found may change what is asked of one that was exact enough
            let may_go_on = |&index: &usize| {
                let asked = &self.asked[index];
                asked.expanded.is_none() && asked.error(&scales[index]) > tolerance && asked.may_go_on()
            };
            pending = (0..self.asked.len()).filter(may_go_on).collect();
        }
    }

    /// For each question what a sample brings that finds something, on average over all cells of its map.
    fn estimate_unseen(&mut self) {
        let brightest = self.scene.surfaces.iter().map(|surface| &surface.radiance);
        let brightest =
            brightest.chain([&self.scene.ambient.radiance]).flatten().copied().fold(0.0, f64::max);
        let mut of_receivers = vec![[[0.0; 2]; 2]; self.scene.receivers.len()];
        for asked in &self.asked {
            let [sizes, count] = asked.replicates.added();
            let sums = &mut of_receivers[asked.receiver][usize::from(asked.cell.is_some())];
            *sums = [sums[0] + sizes, sums[1] + count];
        }
        for asked in &mut self.asked {
            let [sizes, count] = of_receivers[asked.receiver][usize::from(asked.cell.is_some())];
            asked.unseen = if count > 0.0 { sizes / count } else { asked.question.largest(brightest) };
        }
    }

    /// For each question what its tolerance is relative to in each band: the largest of its values, and of all cells of its map.
    fn scales(&self) -> Vec<Vec<f64>> {
        let bands = self.scene.band_count();
        let mut of_receivers = vec![[vec![0.0_f64; bands], vec![0.0_f64; bands]]; self.scene.receivers.len()];
        for asked in &self.asked {
            let scales = &mut of_receivers[asked.receiver][usize::from(asked.cell.is_some())];
            for (scale, largest) in scales.iter_mut().zip(asked.largest(bands)) {
                *scale = scale.max(largest);
            }
        }
        let of = |asked: &Asked| of_receivers[asked.receiver][usize::from(asked.cell.is_some())].clone();
        self.asked.iter().map(of).collect()
    }

    fn answers(&self) -> Vec<Answer> {
        let mut answers = Vec::new();
        for (index, receiver) in self.scene.receivers.iter().enumerate() {
            match &receiver.kind {
                ReceiverKind::Camera(_) => answers.extend(self.mean_of_pixels(index)),
                _ => {
                    let is_number = |asked: &&Asked| asked.receiver == index && asked.cell.is_none();
                    if let Some(asked) = self.asked.iter().find(is_number) {
                        answers.extend(self.numbers(asked));
                    }
                }
            }
        }
        answers
    }

    /// The answers of a question that is no cell.
    fn numbers(&self, asked: &Asked) -> Vec<Answer> {
        let receiver = &self.scene.receivers[asked.receiver];
        let bands = self.scene.band_count();
        let quantities: Vec<(Quantity, usize, f64)> = match receiver.kind {
            ReceiverKind::Point { .. } => vec![(Quantity::Irradiance, 0, 1.0)],
            ReceiverKind::Surface { surface, .. } => {
                vec![(Quantity::Irradiance, 0, 1.0), (Quantity::Flux, 0, area(self.scene, surface))]
            }
            ReceiverKind::Ray { .. } | ReceiverKind::Camera(_) => vec![(Quantity::Radiance, 0, 1.0)],
            ReceiverKind::Sphere { .. } => std::iter::once((Quantity::FluenceRate, 0, 1.0))
                .chain((0..3).map(|axis| (Quantity::VectorIrradiance(axis), axis + 1, 1.0)))
                .collect(),
        };
        let bins = receiver.time.as_ref().map_or(1, |time| time.bins);
        let mut answers = Vec::with_capacity(quantities.len() * bands * bins);
        for (quantity, number, factor) in quantities {
            for band in 0..bands {
                for bin in 0..bins {
                    let [value, error] = asked.found((number * bands + band) * bins + bin);
                    answers.push(Answer {
                        receiver: receiver.name.clone(),
                        quantity,
                        band: (bands > 1).then_some(band),
                        bin: receiver.time.is_some().then_some(bin),
                        value: factor * value,
                        error: factor * error,
                        kind: if asked.expanded.is_some() { ErrorKind::Bound } else { ErrorKind::Sigma },
                        seconds: asked.seconds,
                    });
                }
            }
        }
        answers
    }

    /// The mean radiance of an image, for each band.
    fn mean_of_pixels(&self, receiver: usize) -> Vec<Answer> {
        let bands = self.scene.band_count();
        let pixels: Vec<&Asked> = self.asked.iter().filter(|asked| asked.receiver == receiver).collect();
        let count = pixels.len() as f64;
        let of_band = |band: usize| {
            let found = pixels.iter().map(|pixel| pixel.found(band));
            let [sum, squares] =
                found.fold([0.0; 2], |[sum, squares], [value, error]| [sum + value, squares + error * error]);
            Answer {
                receiver: self.scene.receivers[receiver].name.clone(),
                quantity: Quantity::Radiance,
                band: (bands > 1).then_some(band),
                bin: None,
                value: sum / count,
                error: squares.sqrt() / count,
                kind: ErrorKind::Sigma,
                seconds: pixels.iter().map(|pixel| pixel.seconds).sum(),
            }
        };
        (0..bands).map(of_band).collect()
    }

    fn maps(&self) -> Vec<Map> {
        let map = |(index, receiver): (usize, &Receiver)| {
            let (size, quantity, is_image) = match &receiver.kind {
                ReceiverKind::Surface { grid: Some(size), .. } => (*size, Quantity::Irradiance, false),
                ReceiverKind::Camera(camera) => (camera.resolution, Quantity::Radiance, true),
                _ => return None,
            };
            let bands = self.scene.band_count();
            let nothing = vec![vec![f64::NAN; size[0] * size[1]]; bands];
            let (mut values, mut errors) = (nothing.clone(), nothing);
            for asked in self.asked.iter().filter(|asked| asked.receiver == index) {
                let Some(cell) = asked.cell.filter(|_| asked.replicates.samples > 0) else { continue };
                for band in 0..bands {
                    [values[band][cell], errors[band][cell]] = asked.found(band);
                }
            }
            Some(Map { receiver: receiver.name.clone(), quantity, size, values, errors, is_image })
        };
        self.scene.receivers.iter().enumerate().filter_map(map).collect()
    }
}

impl Asked {
    /// Twice as many samples, or the first ones, as long as nobody stops it.
    fn double(&mut self, followers: &[Box<dyn Follow + '_>], watch: &dyn Watch) {
        let begin = Instant::now();
        let first = FIRST[usize::from(self.cell.is_some())];
        let to = if self.replicates.samples == 0 { first } else { 2 * self.replicates.samples };
        while self.replicates.samples < to && !(self.replicates.samples > 0 && watch.is_stopped()) {
            let next = to.min(self.replicates.samples + STEP);
            self.replicates.extend(next, &self.question, followers);
        }
        self.seconds += begin.elapsed().as_secs_f64();
    }

    /// A value and its standard error, with rounding.
    fn found(&self, place: usize) -> [f64; 2] {
        if let Some(expanded) = &self.expanded {
            let [value, error] = expanded[place];
            return [value, error + self.floor * value.abs()];
        }
        let [value, error] = self.replicates.found(place);
        let is_nothing = value == 0.0 && error == 0.0;
        let unseen = if is_nothing && self.replicates.samples > 0 {
            self.unseen / self.replicates.count()
        } else {
            0.0
        };
        [value, error.hypot(self.floor * value) + unseen]
    }

    /// The largest value of each band.
    fn largest(&self, bands: usize) -> Vec<f64> {
        let bins = self.replicates.len() / (self.question.numbers() * bands);
        let mut largest = vec![0.0_f64; bands];
        for place in 0..self.replicates.len() {
            let band = place / bins % bands;
            largest[band] = largest[band].max(self.found(place)[0].abs());
        }
        largest
    }

    /// The largest error relative to the scales of bands; where nothing was found, to that of the brightest band, or to what a sample may bring.
    fn error(&self, scales: &[f64]) -> f64 {
        let bands = scales.len();
        let bins = self.replicates.len() / (self.question.numbers() * bands);
        let brightest = scales.iter().copied().fold(0.0, f64::max);
        let otherwise = if brightest > 0.0 { brightest } else { self.unseen };
        let relative = |place: usize| {
            let [_, error] = self.found(place);
            let scale = scales[place / bins % bands];
            if error == 0.0 { 0.0 } else { error / if scale > 0.0 { scale } else { otherwise } }
        };
        (0..self.replicates.len()).map(relative).fold(0.0, f64::max)
    }

    fn may_go_on(&self) -> bool {
        self.replicates.samples < MOST
    }
}

fn question(receiver: &Receiver) -> Question {
    match &receiver.kind {
        ReceiverKind::Point { position, normal } => Question::Plane { position: *position, normal: *normal },
        ReceiverKind::Surface { surface, .. } => Question::Surface { surface: *surface },
        ReceiverKind::Ray { origin, direction } => Question::Sight { origin: *origin, direction: *direction },
        ReceiverKind::Sphere { position } => Question::Sphere { position: *position },
        ReceiverKind::Camera(camera) => Question::Pixel { camera: camera.clone(), pixel: [0, 0] },
    }
}

/// Bins of time as bins of optical length.
fn bins(time: &TimeBins, metres: f64) -> Bins {
    let length = LIGHT / metres;
    Bins { start: time.start * length, width: time.width * length, count: time.bins }
}

/// The area of the front of a surface.
fn area(scene: &Scene, surface: usize) -> f64 {
    use crate::scene::Shape;
    use std::f64::consts::PI;
    match &scene.surfaces[surface].shape {
        Shape::Sphere(sphere) => 4.0 * PI * sphere.radius * sphere.radius,
        Shape::Disk(disk) => PI * disk.radius * disk.radius,
        Shape::Polygon(_) | Shape::Mesh(_) => {
            let faces = faces(scene, 0);
            faces.iter().filter(|face| face.is_front_of(surface)).map(|face| face.area).sum()
        }
    }
}

/// The grid over a surface.
fn grid(scene: &Scene, surface: usize, size: [usize; 2]) -> Option<Grid> {
    let faces = faces(scene, 2);
    let screens = Screens::none(&faces);
    Grid::over(&Transport { faces, screens, occlusion: false, accuracy: 1.0 }, surface, size)
}
