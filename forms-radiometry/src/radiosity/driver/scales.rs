//! Scales: the values that the tolerances of readings, and of the cells of maps, are relative to.
//!
//! ```text
//! answers          |value|; for the components of a vector, the largest of them
//! cells            max(mean of all cells, |value|)
//! points, faces    the same; for vectors, the mean of the fluence rate
//! pixels           max(mean of the pixels in which no emitter is seen directly, |value|)
//! watched cells    the same with a lower estimate: the mean of watched cells, and |value − Lₑ|
//! ```
//! While elements are refined, a mean is known from watched cells alone. The mean of all cells is
//! known at the end. Where it is so much less that errors miss the tolerance, the work is done once
//! more with it. Emission is exact: the errors of watched pixels are those of the reflected light.

use super::Work;
use super::estimate::{Estimate, Found};
use super::images::Image;
use crate::answer::{DARK, Map, Quantity};
use crate::scene::ReceiverKind;

/// Part of the mean of watched cells that serves as scale: the mean of all cells may be less than
/// their mean.
const BELOW: f64 = 0.9;
/// The same part for a mean of all cells, which may change a little when elements are refined.
const BELOW_KNOWN: f64 = 0.97;
/// Part of the tolerance of cells left for elements; the rest is for the quadrature of pixels and
/// for interpolation.
const OF_ELEMENTS: f64 = 0.75;

/// Returns the scale of cells, each given by its value and whether an emitter is seen in it
/// directly.
pub(crate) fn mean_scale(cells: impl Iterator<Item = (f64, bool)>) -> f64 {
    Mean::of(cells).value
}

/// Mean of the cells in which no emitter is seen directly, or of all cells where those are dark or
/// missing.
pub(crate) struct Mean {
    pub(crate) value: f64,
    /// Whether it is the mean of all cells.
    pub(crate) is_of_all: bool,
}

impl Mean {
    pub(crate) fn of(cells: impl Iterator<Item = (f64, bool)>) -> Self {
        let (mut sums, mut counts) = ([0.0; 2], [0.0_f64; 2]);
        for (value, sees_emitter) in cells {
            sums[usize::from(sees_emitter)] += value;
            counts[usize::from(sees_emitter)] += 1.0;
        }
        let [own, all] = [(sums[0], counts[0]), (sums[0] + sums[1], counts[0] + counts[1])]
            .map(|(sum, count)| if count > 0.0 { f64::abs(sum) / count } else { 0.0 });
        let is_of_all = counts[0] == 0.0 || own <= DARK * all;
        Self { value: if is_of_all { all } else { own }, is_of_all }
    }
}

/// Errors of all cells of a map in one band, as estimated from its watched cells. They equal the
/// largest error of a watched cell, relative to the scale of each cell.
pub(crate) struct Watched {
    /// Scale of the map, as known while elements were refined.
    pub(crate) scale: f64,
    relative: f64,
    /// Largest error, where there is no scale.
    absolute: f64,
}

impl Watched {
    /// Returns the error of a cell that gets this much light.
    pub(crate) fn error(&self, value: f64) -> f64 {
        if self.scale > 0.0 { self.relative * self.scale.max(value.abs()) } else { self.absolute }
    }
}

/// Maps and images of a simulation, with the indices of their receivers.
pub(crate) struct Pictures {
    pub(crate) maps: Vec<(usize, Map)>,
    pub(crate) images: Vec<Image>,
}

impl Pictures {
    fn all(&self) -> impl Iterator<Item = (usize, &Map)> {
        let images = self.images.iter().map(|image| (image.receiver, &image.map));
        self.maps.iter().map(|(receiver, map)| (*receiver, map)).chain(images)
    }
}

impl Work<'_> {
    /// Returns the scale of the tolerance of each reading in each band.
    pub(crate) fn scales(&self, found: &[Found]) -> Vec<Vec<f64>> {
        let bands = self.scene.band_count();
        let mut largest = vec![vec![0.0_f64; bands]; self.answers];
        for (found, &group) in found[..self.answers].iter().zip(&self.groups) {
            largest[group].iter_mut().zip(&found.bands).for_each(|(m, e)| *m = m.max(e.value.abs()));
        }
        let of_answers = self.groups[..self.answers].iter().map(|&group| largest[group].clone());
        let mut scales: Vec<Vec<f64>> = of_answers.collect();
        let watched: Vec<usize> = (self.answers..found.len()).collect();
        for own in watched.chunk_by(|&one, &other| self.groups[one] == self.groups[other]) {
            let of_map = self.scales_of_map(own, found);
            let of_cell = |&cell: &usize| {
                let of_band = |(band, scale): (usize, &f64)| scale.max(self.reflected(cell, found, band));
                of_map.iter().enumerate().map(of_band).collect()
            };
            scales.extend(own.iter().map(of_cell));
        }
        scales
    }

    /// Returns the targets whose tolerance bounds the errors of readings: their scales, or the part
    /// of the scales left for elements. Answers below 1e-9 of the largest, such as those of a
    /// receiver in the dark, are judged by their error relative to the largest.
    pub(crate) fn targets(&self, found: &[Found]) -> Vec<Vec<f64>> {
        let mut targets = self.scales(found);
        let watched: Vec<usize> = (self.answers..found.len()).collect();
        for own in watched.chunk_by(|&one, &other| self.groups[one] == self.groups[other]) {
            for band in 0..self.scene.band_count() {
                let of_elements = if self.is_watched(own) { OF_ELEMENTS } else { 1.0 };
                let part = of_elements * self.of_mean(own, band, (found, &targets));
                own.iter().for_each(|&cell| targets[cell][band] *= part);
            }
        }
        let dark = DARK * targets.iter().flatten().copied().fold(0.0, f64::max);
        targets.iter_mut().flatten().for_each(|target| *target = target.max(dark));
        targets
    }

    /// Returns the part of the scales of pixels or points that keeps their mean within the tolerance
    /// of its own value. Scales are no less than a mean, and their mean may be more. The mean over a
    /// surface is an answer of its own.
    fn of_mean(&self, own: &[usize], band: usize, (found, scales): (&[Found], &[Vec<f64>])) -> f64 {
        let kind = own.first().map(|&cell| &self.scene.receivers[self.readings[cell].receiver].kind);
        let is_mean = matches!(kind, Some(ReceiverKind::Camera(_) | ReceiverKind::Points(_)));
        let own: Vec<usize> = self.leading(own).collect();
        let value = |&cell: &usize| found[cell].bands.get(band).map_or(0.0, |estimate| estimate.value.abs());
        let [values, scales] =
            [own.iter().map(value).sum(), own.iter().map(|&cell| scales[cell][band]).sum::<f64>()];
        if is_mean && values > 0.0 { f64::min(1.0, values / scales) } else { 1.0 }
    }

    /// Returns the errors indicated by the watched cells of a map for each band; `None` where no
    /// cell is watched.
    pub(crate) fn watched(&self, receiver: usize, found: &[Found]) -> Option<Vec<Watched>> {
        let is_own = |&reading: &usize| self.readings[reading].receiver == receiver;
        let own: Vec<usize> = (self.requested..found.len()).filter(is_own).collect();
        let of_band = |(band, scale): (usize, f64)| {
            let mut watched = Watched { scale, relative: 0.0, absolute: 0.0 };
            for &cell in &own {
                let error = found[cell].bands.get(band).map_or(f64::INFINITY, Estimate::error);
                watched.absolute = watched.absolute.max(error);
                watched.relative = watched.relative.max(error / scale.max(self.reflected(cell, found, band)));
            }
            watched
        };
        let scales = self.scales_of_map(&own, found).into_iter().enumerate();
        (!own.is_empty()).then(|| scales.map(of_band).collect())
    }

    /// Stores the scales of finished maps and images where they are so much less than the watched
    /// cells indicated that errors miss the tolerance. Returns whether there are any.
    pub(crate) fn rescale(&mut self, pictures: &Pictures, found: &[Found]) -> bool {
        if self.watch.is_stopped() {
            return false;
        }
        let mut is_any = false;
        for (receiver, map) in pictures.all() {
            let Some(watched) = self.watched(receiver, found) else { continue };
            let mut pairs = map.scales.iter().zip(watched);
            let is_less = pairs.any(|(scale, Watched { scale: told, .. })| *scale < told || told == 0.0);
            if is_less && misses(map, self.scene.solve.tolerance) {
                let known = map.scales.iter().map(|scale| BELOW_KNOWN * scale);
                self.known_scales[receiver] = Some(known.collect());
                is_any = true;
            }
        }
        is_any
    }

    /// Returns, for each band, the scale of the map that these readings watch.
    fn scales_of_map(&self, own: &[usize], found: &[Found]) -> Vec<f64> {
        let receiver = own.first().map(|&cell| self.readings[cell].receiver);
        if let Some(known) = receiver.and_then(|receiver| self.known_scales[receiver].clone()) {
            return known;
        }
        let leading: Vec<usize> = self.leading(own).collect();
        let of_band = |band: usize| {
            let cell = |&cell: &usize| {
                let sees_emitter = self.emitted(cell).iter().any(|&emitted| emitted > 0.0);
                found[cell].bands.get(band).map(|estimate| (estimate.value, sees_emitter))
            };
            let below = if self.is_watched(own) { BELOW } else { 1.0 };
            below * mean_scale(leading.iter().filter_map(cell))
        };
        (0..self.scene.band_count()).map(of_band).collect()
    }

    /// Returns the light in a watched cell without the light emitted directly into it.
    fn reflected(&self, cell: usize, found: &[Found], band: usize) -> f64 {
        let emitted = self.emitted(cell).get(band).copied().unwrap_or(0.0);
        found[cell].bands.get(band).map_or(0.0, |estimate| (estimate.value - emitted).abs())
    }

    /// Returns, for each band, the radiance emitted directly into a watched cell; empty where there
    /// can be none.
    fn emitted(&self, cell: usize) -> &[f64] {
        cell.checked_sub(self.requested).map_or(&[], |watched| &self.emitted[watched])
    }

    /// Whether these readings of one map represent other cells.
    fn is_watched(&self, own: &[usize]) -> bool {
        own.first().is_some_and(|&cell| cell >= self.requested)
    }

    /// Returns those of some readings that determine scales: all but the components of vectors.
    fn leading<'o>(&'o self, own: &'o [usize]) -> impl Iterator<Item = usize> + 'o {
        let is_component =
            |cell: &usize| matches!(self.readings[*cell].quantity, Quantity::VectorIrradiance(_));
        own.iter().copied().filter(move |cell| !is_component(cell))
    }
}

/// Whether the error of any cell exceeds the tolerance.
fn misses(map: &Map, tolerance: f64) -> bool {
    let of_band = |((values, errors), scale): ((&Vec<f64>, &Vec<f64>), &f64)| {
        values.iter().zip(errors).any(|(value, error)| *error > tolerance * scale.max(value.abs()))
    };
    map.values.iter().zip(&map.errors).zip(&map.scales).any(of_band)
}
