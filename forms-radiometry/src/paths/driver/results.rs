//! Results: replicates become the answers of receivers, maps and images.

use super::Work;
use super::request::Request;
use crate::answer::{Answer, ErrorKind, ErrorParts, Map, Quantity};
use crate::faces::faces;
use crate::scene::{Receiver, ReceiverKind, Scene};

/// Part of the errors of pixels that they have in common. Sampling stops where samples agree, more
/// often where they have missed something bright. Where a medium scatters forwards, pixels are on
/// average too dark by up to 0.5 of their errors (`tests/paths/rare.rs`).
const STOPPED: f64 = 0.5;

impl Work<'_> {
    pub(crate) fn answers(&self) -> Vec<Answer> {
        let mut answers = Vec::new();
        for (index, receiver) in self.scene.receivers.iter().enumerate() {
            match &receiver.kind {
                ReceiverKind::Camera(_) => answers.extend(self.mean_of_pixels(index)),
                _ => {
                    let is_number = |request: &&Request| {
                        request.receiver == index && request.cell.is_none() && request.is_answered()
                    };
                    if let Some(request) = self.requests.iter().find(is_number) {
                        answers.extend(self.numbers(request));
                    }
                }
            }
        }
        answers
    }

    /// Returns the answers of a question that is not a cell.
    fn numbers(&self, request: &Request) -> Vec<Answer> {
        let receiver = &self.scene.receivers[request.receiver];
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
        let seconds = self.seconds_of(request.receiver);
        let mut answers = Vec::with_capacity(quantities.len() * bands * bins);
        for (quantity, number, factor) in quantities {
            for band in 0..bands {
                for bin in 0..bins {
                    let (value, parts) = request.found_in_parts((number * bands + band) * bins + bin);
                    let (parts, kind) = (parts.scaled(factor), request.kind());
                    answers.push(Answer {
                        receiver: receiver.name.clone(),
                        quantity,
                        band: (bands > 1).then_some(band),
                        bin: receiver.time.is_some().then_some(bin),
                        value: factor * value,
                        error: parts.error(kind),
                        parts,
                        kind,
                        seconds,
                    });
                }
            }
        }
        answers
    }

    /// Returns the seconds of a receiver, including those of the cells of its map.
    fn seconds_of(&self, receiver: usize) -> f64 {
        let own = self.requests.iter().filter(|request| request.receiver == receiver);
        own.map(|request| request.seconds).sum()
    }

    /// Returns the mean radiance of an image, for each band.
    fn mean_of_pixels(&self, receiver: usize) -> Vec<Answer> {
        let bands = self.scene.band_count();
        let pixels: Vec<&Request> =
            self.requests.iter().filter(|request| request.receiver == receiver).collect();
        if !pixels.iter().all(|pixel| pixel.is_answered()) {
            return Vec::new();
        }
        let count = pixels.len() as f64;
        let of_band = |band: usize| {
            let found = || pixels.iter().map(|pixel| pixel.found_in_parts(band));
            let sum: f64 = found().map(|(value, _)| value).sum();
            let common = if self.division.budget.is_some() { 0.0 } else { STOPPED };
            let parts = ErrorParts::of_mean(found().map(|(_, parts)| parts), common);
            Answer {
                receiver: self.scene.receivers[receiver].name.clone(),
                quantity: Quantity::Radiance,
                band: (bands > 1).then_some(band),
                bin: None,
                value: sum / count,
                error: parts.error(ErrorKind::Sigma),
                parts,
                kind: ErrorKind::Sigma,
                seconds: pixels.iter().map(|pixel| pixel.seconds).sum(),
            }
        };
        (0..bands).map(of_band).collect()
    }

    pub(crate) fn maps(&self) -> Vec<Map> {
        let mut scales_of_cells = self.scales_of_cells();
        let map = |(index, receiver): (usize, &Receiver)| {
            let (size, quantity, is_image) = match &receiver.kind {
                ReceiverKind::Surface { grid: Some(size), .. } => (*size, Quantity::Irradiance, false),
                ReceiverKind::Camera(camera) => (camera.resolution, Quantity::Radiance, true),
                _ => return None,
            };
            let bands = self.scene.band_count();
            let nothing = vec![vec![f64::NAN; size[0] * size[1]]; bands];
            let (mut values, mut errors) = (nothing.clone(), nothing);
            let mut kind = ErrorKind::Bound;
            for request in self.requests.iter().filter(|request| request.receiver == index) {
                kind = kind.max(request.kind());
                let Some(cell) = request.cell.filter(|_| request.is_answered()) else { continue };
                for band in 0..bands {
                    [values[band][cell], errors[band][cell]] = request.found(band);
                }
            }
            // where no cell was reached there are no scales
            let mut scales = std::mem::take(&mut scales_of_cells[index]);
            scales.resize(bands, 0.0);
            Some(Map {
                receiver: receiver.name.clone(),
                quantity,
                size,
                values,
                errors,
                scales,
                kind,
                is_image,
            })
        };
        self.scene.receivers.iter().enumerate().filter_map(map).collect()
    }
}

/// Returns the area of the front of a surface.
fn area(scene: &Scene, surface: usize) -> f64 {
    use crate::scene::Shape;
    match &scene.surfaces[surface].shape {
        Shape::Sphere(sphere) => sphere.area(),
        Shape::Disk(disk) => disk.area(),
        Shape::Quadric(quadric) => quadric.area(),
        Shape::Polygon(_) | Shape::Mesh(_) => {
            let faces = faces(scene, 0);
            faces.iter().filter(|face| face.is_front_of(surface)).map(|face| face.area).sum()
        }
    }
}
