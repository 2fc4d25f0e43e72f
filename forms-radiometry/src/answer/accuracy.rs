//! Accuracy: errors of answers, cells and pixels, relative to the scale of the tolerance of each.
//!
//! ```text
//! a number                          |value|
//! a component of a vector, a bin    the largest of all components, of all bins
//! a cell, a pixel                   max(scale of its map, |value|)          see Map::scales
//! a net flux                        the flux, or its own |value| if that is larger
//! dark numbers                      at least 1e-9 of the largest number, and of the irradiance by the
//!                                   brightest source
//! ```
//! Printed errors, the list of missed tolerances, and the last point of a convergence plot are all
//! taken from this module, so that they agree. The scales of all answers are found once, in time
//! linear in their number.

use super::quantity::Quantity;
use super::results::{Answer, Map, Simulation};
use std::collections::HashMap;

/// Answers below this part of the largest one, or of the brightest light of the sources, are dark.
pub(crate) const DARK: f64 = 1e-9;

/// Answers of a simulation with the scale of each.
pub struct Accuracy<'s> {
    found: &'s Simulation,
    /// Scale of each answer: the value that its error is relative to.
    scales: Vec<f64>,
    /// Lower limit of all scales.
    dark: f64,
}

/// An answer and its error relative to its scale.
#[derive(Clone, Copy, Debug)]
pub struct Rated<'s> {
    /// The answer.
    pub answer: &'s Answer,
    /// Scale that its error is relative to.
    pub scale: f64,
    /// Its relative error.
    pub error: f64,
}

/// Cells of a map, or pixels of an image, whose errors exceed a tolerance in one band.
#[derive(Clone, Copy, Debug)]
pub struct MissedCells<'s> {
    /// The map.
    pub map: &'s Map,
    /// The band, counted from 0; `None` where the scene has a single band.
    pub band: Option<usize>,
    /// Number of these cells, and number of all cells that have a value.
    pub counts: [usize; 2],
    /// Largest of their errors, relative to their scales.
    pub worst: f64,
}

impl Simulation {
    /// Returns the accuracy of the results.
    pub fn accuracy(&self) -> Accuracy<'_> {
        let mut largest: HashMap<_, f64> = HashMap::new();
        for answer in &self.answers {
            let scale = largest.entry(group(answer)).or_default();
            *scale = scale.max(answer.value.abs());
        }
        let scales = self.answers.iter().map(|answer| largest[&group(answer)]).collect();
        let cells = self.maps.iter().flat_map(|map| map.values.iter().flatten());
        let values = self.answers.iter().map(|answer| &answer.value).chain(cells);
        let dark = DARK * values.fold(self.brightest, |most: f64, value| most.max(value.abs()));
        Accuracy { found: self, scales, dark }
    }
}

/// Returns the key of the answers that share one scale: the answers of one receiver, band and
/// quantity, the components of a vector, and a net flux with the flux that it is the balance of.
fn group(answer: &Answer) -> (&str, Option<usize>, Quantity) {
    let quantity = match answer.quantity {
        Quantity::VectorIrradiance(_) => Quantity::FluenceRate,
        Quantity::NetFlux => Quantity::Flux,
        quantity => quantity,
    };
    (&answer.receiver, answer.band, quantity)
}

impl<'s> Accuracy<'s> {
    /// Returns all answers in their order.
    pub fn answers(&self) -> impl DoubleEndedIterator<Item = Rated<'s>> {
        let rated = |(answer, &scale): (&'s Answer, &f64)| Rated {
            answer,
            scale,
            error: self.relative(answer.error, scale),
        };
        self.found.answers.iter().zip(&self.scales).map(rated)
    }

    /// Returns for each answer, in their order, whether its error exceeds this tolerance.
    pub fn missed(&self, tolerance: f64) -> Vec<bool> {
        self.answers().map(|rated| rated.error > with_rounding(tolerance)).collect()
    }

    /// Returns the maps and images, band by band, that have errors above this tolerance.
    pub fn missed_cells(&self, tolerance: f64) -> Vec<MissedCells<'s>> {
        let of_band = |map: &'s Map, band: usize| {
            let (mut missed, mut all, mut worst) = (0, 0, 0.0_f64);
            for error in self.of_cells(map, band) {
                all += 1;
                missed += usize::from(error > with_rounding(tolerance));
                worst = worst.max(error);
            }
            let band = (map.values.len() > 1).then_some(band);
            (missed > 0).then_some(MissedCells { map, band, counts: [missed, all], worst })
        };
        self.bands_of_maps().filter_map(|(map, band)| of_band(map, band)).collect()
    }

    /// Returns all bands of all maps that are judged. The net flux of a face is as accurate as its
    /// irradiance, which is judged.
    fn bands_of_maps(&self) -> impl Iterator<Item = (&'s Map, usize)> {
        let judged = self.found.maps.iter().filter(|map| map.quantity != Quantity::NetFlux);
        judged.flat_map(|map| (0..map.values.len()).map(move |band| (map, band)))
    }

    /// Returns the answer whose relative error is the largest, the first of several; `None` where
    /// there is no light.
    pub fn worst_answer(&self) -> Option<Rated<'s>> {
        let lit = self.answers().filter(|rated| rated.scale > 0.0);
        lit.rev().max_by(|one, other| one.error.total_cmp(&other.error))
    }

    /// Returns the largest relative error of the cells and pixels of all maps and images.
    pub fn largest_of_cells(&self) -> f64 {
        self.bands_of_maps().flat_map(|(map, band)| self.of_cells(map, band)).fold(0.0, f64::max)
    }

    /// Returns the largest relative error of all answers, cells and pixels.
    pub fn largest_error(&self) -> f64 {
        self.answers().map(|rated| rated.error).fold(self.largest_of_cells(), f64::max)
    }

    /// Returns the relative errors of the cells of a map that have a value.
    fn of_cells(&self, map: &'s Map, band: usize) -> impl Iterator<Item = f64> {
        let cells = map.values[band].iter().zip(&map.errors[band]).filter(|(value, _)| !value.is_nan());
        cells.map(move |(value, &error)| self.relative(error, map.scales[band].max(value.abs())))
    }

    /// Returns an error relative to a scale. Where no source sends light either, every error other
    /// than zero is infinite.
    fn relative(&self, error: f64, scale: f64) -> f64 {
        relative(error, scale.max(self.dark))
    }
}

/// Returns an error relative to a scale. An error of zero stays zero, even where there is no light.
pub(crate) fn relative(error: f64, scale: f64) -> f64 {
    if error == 0.0 { 0.0 } else { error / scale }
}

/// Returns a tolerance that an error still meets after the rounding of the sum of its parts.
fn with_rounding(tolerance: f64) -> f64 {
    tolerance * (1.0 + 4.0 * f64::EPSILON)
}
