//! Results: replicates become the answers of receivers, and the maps and images of their cells.

use super::Work;
use super::request::Request;
use crate::answer::{Answer, ErrorKind, Map, Quantity, mean_of_cells};
use crate::faces::faces;
use crate::scene::{Receiver, ReceiverKind, Scene};
use crate::visibility::ReceivingArea;

/// Part of the errors of pixels that they have in common. Sampling stops where samples agree, more
/// often where they have missed something bright. Where a medium scatters forwards, pixels are on
/// average too dark by up to 0.5 of their errors (`tests/paths/rare.rs`).
const STOPPED: f64 = 0.5;

impl Work<'_> {
    pub(crate) fn answers(&self) -> Vec<Answer> {
        let mut answers = Vec::new();
        for (index, receiver) in self.scene.receivers.iter().enumerate() {
            match &receiver.kind {
                ReceiverKind::Camera(_) | ReceiverKind::Points(_) => {
                    answers.extend(self.means_of_cells(index));
                }
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
        let unchanged = measured(&receiver.kind).iter().enumerate().map(|(n, &quantity)| (quantity, n, 1.0));
        let flux = receiver.kind.side().map(|side| (Quantity::Flux, 0, area(self.scene, side.surface)));
        let quantities: Vec<(Quantity, usize, f64)> = unchanged.chain(flux).collect();
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

    /// Returns the means over the pixels or points of a receiver, for each quantity and band; none
    /// if some of them have no answer.
    fn means_of_cells(&self, receiver: usize) -> Vec<Answer> {
        let bands = self.scene.band_count();
        let cells: Vec<&Request> =
            self.requests.iter().filter(|request| request.receiver == receiver).collect();
        if !cells.iter().all(|cell| cell.is_answered()) {
            return Vec::new();
        }
        let Receiver { name, kind, .. } = &self.scene.receivers[receiver];
        let is_image = matches!(kind, ReceiverKind::Camera(_));
        let common = if self.division.budget.is_some() { 0.0 } else { STOPPED };
        let own = cells.iter().map(|cell| cell.kind()).max().unwrap_or(ErrorKind::Sigma);
        let kind_of_errors = if is_image { ErrorKind::Sigma } else { own };
        let seconds = cells.iter().map(|cell| cell.seconds).sum();
        let mean = |(quantity, place, band)| {
            let found: Vec<_> = cells.iter().map(|cell| cell.found_in_parts(place)).collect();
            let place = (name.as_str(), quantity, (bands > 1).then_some(band));
            Answer { seconds, ..mean_of_cells(place, &found, kind_of_errors, common) }
        };
        let quantities = measured(kind).iter().enumerate();
        let places = quantities.flat_map(|(number, &quantity)| {
            (0..bands).map(move |band| (quantity, number * bands + band, band))
        });
        places.map(mean).collect()
    }

    pub(crate) fn maps(&self) -> Vec<Map> {
        let scales_of_cells = self.scales_of_cells();
        let mut maps = Vec::new();
        let mut first = 0;
        for (index, receiver) in self.scene.receivers.iter().enumerate() {
            let own = self.requests[first..].iter().take_while(|request| request.receiver == index).count();
            let requests = &self.requests[first..first + own];
            first += own;
            if receiver.kind.has_cells() {
                let quantities = measured(&receiver.kind).iter().enumerate();
                let map = |(number, &quantity)| {
                    self.map(receiver, requests, (quantity, number), scales_of_cells[index].clone())
                };
                maps.extend(quantities.map(map));
            }
        }
        maps
    }

    /// Returns the map of one of the numbers of each cell of a receiver.
    fn map(
        &self,
        receiver: &Receiver,
        requests: &[Request],
        (quantity, number): (Quantity, usize),
        mut scales: Vec<f64>,
    ) -> Map {
        let bands = self.scene.band_count();
        let listed = || requests.iter().filter(|request| request.cell.is_some()).count();
        let count = receiver.kind.raster().map_or_else(listed, |[columns, rows]| columns * rows);
        let nothing = vec![vec![f64::NAN; count]; bands];
        let (mut values, mut errors) = (nothing.clone(), nothing);
        let mut kind = ErrorKind::Bound;
        for request in requests {
            kind = kind.max(request.kind());
            let Some(cell) = request.cell.filter(|_| request.is_answered()) else { continue };
            for band in 0..bands {
                [values[band][cell], errors[band][cell]] = request.found(number * bands + band);
            }
        }
        // where no cell was reached there are no scales
        scales.resize(bands, 0.0);
        Map::of_cells(receiver, quantity, (values, errors, scales), kind)
    }
}

/// Returns the quantities of a receiver, or of each of its cells, that paths sample.
fn measured(kind: &ReceiverKind) -> &'static [Quantity] {
    match kind {
        ReceiverKind::Ray { .. } | ReceiverKind::Camera(_) => &[Quantity::Radiance],
        kind if kind.is_all_around() => &Quantity::ALL_AROUND,
        _ => &[Quantity::Irradiance],
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
            faces
                .iter()
                .filter(|face| ReceivingArea::front(surface).contains(face))
                .map(|face| face.area)
                .sum()
        }
    }
}
