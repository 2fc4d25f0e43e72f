//! Maps of a simulation: receivers with a grid become cells, some of which are watched while elements become finer, and these maps.

use super::answer::{Map, Quantity};
use super::estimate::{Estimate, Found};
use super::map::Grid;
use super::readings::Reading;
use super::solver::{ROUNDING, Work, groups};
use crate::radiosity::{Radiosity, Transport};
use crate::scene::ReceiverKind;

/// One in so many cells of a map is watched while elements become finer, and at least so many in all.
const WATCHED: [usize; 2] = [36, 9];
/// What cells that are interpolated may be off by, as a part of the largest error of those that are watched.
const INTERPOLATED: f64 = 0.1;

impl Work<'_> {
    /// The maps that are asked for: the index of the receiver and its cells.
    pub(super) fn grids(&self, transport: &Transport) -> Vec<(usize, Grid)> {
        let receivers = self.scene.receivers.iter().enumerate();
        let grid = |(index, receiver): (usize, &crate::scene::Receiver)| match receiver.kind {
            ReceiverKind::Surface { surface, grid: Some(size) } => {
                Grid::over(transport, surface, size).map(|grid| (index, grid))
            }
            _ => None,
        };
        receivers.filter_map(grid).collect()
    }

    /// Adds readings in some cells of each of these maps and in some pixels of each image, so that elements are refined until these are
    /// exact enough, and maps have errors.
    pub(super) fn watch_some(&mut self, grids: &[(usize, Grid)], sight: &Transport) {
        for (index, grid) in grids {
            let reading = |cell| Reading::irradiance(*index, cell, grid.normal());
            self.readings.extend(grid.some(WATCHED).map(reading));
        }
        let pixels = self.watched_pixels(sight);
        self.readings.extend(pixels);
        self.groups = groups(&self.readings, self.answers);
    }

    /// The maps with the numbers of their receivers, cell by cell, each with the largest error of those of its cells that were watched.
    pub(super) fn maps(
        &self,
        radiosity: &Radiosity,
        grids: &[(usize, Grid)],
        found: &[Found],
    ) -> Vec<(usize, Map)> {
        let bands = self.scene.band_count();
        let map = |&(receiver, ref grid): &(usize, Grid)| {
            let watched = || {
                let own =
                    (self.answers..found.len()).filter(|&other| self.readings[other].receiver == receiver);
                own.map(|other| &found[other])
            };
            let of_cell =
                |cell: &Found, band: usize| cell.bands.get(band).map_or(f64::INFINITY, Estimate::error);
            let largest = |band: usize| watched().map(|cell| of_cell(cell, band)).reduce(f64::max);
            let largest: Vec<Option<f64>> = (0..bands).map(largest).collect();
            let allowed: Vec<f64> = largest.iter().map(|error| INTERPOLATED * error.unwrap_or(0.0)).collect();
            let values = grid.irradiance(radiosity, &allowed, self.watch);
            let error = |(band, values): (usize, &Vec<f64>)| {
                // where none is watched, closed forms leave nothing but rounding
                let brightest = || values.iter().fold(0.0, |m: f64, value| m.max(value.abs()));
                let error = largest[band].unwrap_or_else(|| ROUNDING * brightest()) + allowed[band];
                values.iter().map(|value| if value.is_nan() { f64::NAN } else { error }).collect()
            };
            let errors = values.iter().enumerate().map(error).collect();
            let (name, size) = (self.scene.receivers[receiver].name.clone(), grid.size());
            let quantity = Quantity::Irradiance;
            (receiver, Map { receiver: name, quantity, size, values, errors, is_image: false })
        };
        grids.iter().map(map).collect()
    }
}
