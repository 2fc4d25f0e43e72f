//! Images of diffuse surfaces: the visible parts of surfaces become pixels, computed from the same
//! solution that receivers gather from.
//!
//! ```text
//! pinhole ─▶ visible parts ─▶ polygons on the film ─▶ mean radiance of each pixel, exact borders
//!            some pixels are watched while elements are refined ─▶ errors, scale of radiance
//! ```
//! The tolerance is relative to the mean of the pixels in which no emitter is seen; for each pixel,
//! at least to its own value (see [`scales`](super::scales)). The error by elements is the same for
//! all pixels, relative to the light that they reflect. In addition, each pixel has an error of its
//! own by the quadrature of its integral.

mod block;
mod film;

pub(crate) use film::add_parts;

use super::estimate::Found;
use super::readings::Reading;
use super::scales::{Watched, mean_scale};
use super::{ROUNDING, Work};
use crate::answer::{Answer, ErrorKind, ErrorParts, Map, Quantity};
use crate::camera::Camera;
use crate::parallelism::Parallelism;
use crate::radiosity::{Radiosity, Scratch, Transport};
use crate::scene::ReceiverKind;
use crate::visibility::Screens;
use block::View;
use film::{Block, blocks};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

/// One in this many pixels is watched, but no fewer and no more pixels than these limits.
const WATCHED: usize = 36;
const FEWEST: usize = 64;
const MOST: usize = 512;
/// Part of the tolerance left for quadrature, in addition to the error by elements.
const RULES: f64 = 0.25;

/// An image and its mean.
pub(crate) struct Image {
    pub(crate) receiver: usize,
    pub(crate) map: Map,
    pub(crate) means: Vec<Answer>,
}

impl Work<'_> {
    /// Returns the cameras with the indices of their receivers.
    pub(crate) fn cameras(&self) -> impl Iterator<Item = (usize, &Camera)> {
        let receivers = self.scene.receivers.iter().enumerate();
        receivers.filter_map(|(index, receiver)| match &receiver.kind {
            ReceiverKind::Camera(camera) => Some((index, camera)),
            _ => None,
        })
    }

    /// Returns the geometry with all occluders of a camera's view: an eye sees nothing through
    /// surfaces, even where none occludes light. `None` if the transport geometry is the same, or
    /// there is no camera.
    pub(crate) fn sight(&self, transport: &Transport) -> Option<Transport> {
        let is_another = !transport.occlusion && self.cameras().next().is_some();
        is_another.then(|| Transport {
            faces: Arc::clone(&transport.faces),
            screens: Arc::new(Screens::of(&transport.faces)),
            occlusion: true,
            hides_outside: true,
            accuracy: transport.accuracy,
        })
    }

    /// Returns readings of watched pixels, spread over each image. Elements are refined until these
    /// are accurate enough, and they provide the errors of the images.
    pub(crate) fn watched_pixels(&self) -> Vec<Reading> {
        let of_camera = |(index, camera): (usize, &Camera)| {
            let [columns, rows] = camera.resolution;
            let count = columns * rows;
            let some = (count / WATCHED).clamp(FEWEST.min(count), MOST);
            let reading = |number: usize| {
                let pixel = (2 * number + 1) * count / (2 * some);
                let [x, y] = [pixel % columns, pixel / columns].map(|place| place as f64 + 0.5);
                let direction = camera.direction(x, y).unit();
                direction.map(|direction| Reading::radiance(index, camera.origin, direction))
            };
            (0..some).filter_map(reading).collect::<Vec<_>>()
        };
        self.cameras().flat_map(of_camera).collect()
    }

    /// Returns the images with the means of their pixels.
    pub(crate) fn images(&self, radiosity: &Radiosity, sight: &Transport, found: &[Found]) -> Vec<Image> {
        let images = self.cameras().map(|(index, camera)| {
            let begin = Instant::now();
            let watched = self.watched(index, found).unwrap_or_default();
            let map = self.image((index, camera), radiosity, sight, &watched);
            let means = self.means(&map);
            self.times.add_since(begin, index);
            Image { receiver: index, map, means }
        });
        images.collect()
    }

    /// Computes the pixels of a camera; NaN where the work was stopped before.
    fn image(
        &self,
        (receiver, camera): (usize, &Camera),
        radiosity: &Radiosity,
        sight: &Transport,
        watched: &[Watched],
    ) -> Map {
        let seen = radiosity.question.seen_part();
        let outside: Vec<f64> = self.scene.ambient.radiance.iter().map(|outside| seen * outside).collect();
        let bands = outside.len();
        let is_seen_past = outside.iter().any(|&radiance| radiance > 0.0);
        let pieces = radiosity.seen_from(camera.origin, sight, is_seen_past);
        // where every watched pixel is dark, no part is subdivided: the first rule tells how bright
        // others are
        let scale = |watched: &Watched| if watched.scale > 0.0 { watched.scale } else { f64::INFINITY };
        let scales: Vec<f64> = watched.iter().map(scale).collect();
        let tolerance = RULES * self.scene.solve.tolerance;
        let view = View { camera, radiosity, pieces: &pieces, outside: &outside, tolerance, scales: &scales };
        let blocks = blocks(camera, &pieces);
        let done = AtomicUsize::new(0);
        let of_block = |scratch: &mut Scratch, block: &Block| {
            if self.watch.is_stopped() {
                return None;
            }
            let pixels = view.pixels(block, scratch);
            self.watch.progress("images", done.fetch_add(1, Ordering::Relaxed) as f64 / blocks.len() as f64);
            Some(pixels).filter(|_| !self.watch.is_stopped())
        };
        let found = Parallelism::Shared.map(&blocks, of_block);
        let [columns, rows] = camera.resolution;
        let nothing = vec![vec![f64::NAN; columns * rows]; bands];
        let (mut values, mut errors) = (nothing.clone(), nothing);
        let mut sees_emitter = vec![false; columns * rows];
        for (block, pixels) in blocks.iter().zip(found) {
            let width = block.to[0] - block.from[0];
            for (index, found) in pixels.iter().flatten().enumerate() {
                let (pixel, band) = (index / bands, index % bands);
                let place = (block.from[1] + pixel / width) * columns + block.from[0] + pixel % width;
                sees_emitter[place] |= found.emitted > 0.0;
                values[band][place] = found.value;
                let of_elements = watched[band].error(found.value - found.emitted);
                let rounding = ROUNDING * found.value.abs().max(watched[band].scale);
                errors[band][place] = found.error + of_elements + rounding;
            }
        }
        let lit = |values: &Vec<f64>| mean_scale(values.iter().copied().zip(sees_emitter.iter().copied()));
        let scales = values.iter().map(lit).collect();
        let numbers = (values, errors, scales);
        Map::of_cells(&self.scene.receivers[receiver], Quantity::Radiance, numbers, ErrorKind::Estimate)
    }

    /// Returns the mean of an image for each band; empty if the image is not complete.
    fn means(&self, map: &Map) -> Vec<Answer> {
        let bands = map.values.len();
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        let answer = |band: usize| {
            let error = mean(&map.errors[band]);
            let rounding = (ROUNDING * mean(&map.values[band]).abs()).min(error);
            let parts = ErrorParts { rounding, quadrature: error - rounding, ..ErrorParts::default() };
            Answer {
                receiver: map.receiver.clone(),
                quantity: Quantity::Radiance,
                band: (bands > 1).then_some(band),
                bin: None,
                value: mean(&map.values[band]),
                error: parts.error(ErrorKind::Estimate),
                parts,
                kind: ErrorKind::Estimate,
                seconds: 0.0,
            }
        };
        let is_whole = map.values.iter().flatten().all(|value| !value.is_nan());
        if is_whole { (0..bands).map(answer).collect() } else { Vec::new() }
    }
}
