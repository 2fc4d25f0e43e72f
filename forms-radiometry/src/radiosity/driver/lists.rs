//! Lists: readings at the points of a receiver, or on the faces of a surface, become maps, and the
//! readings at points also their means.

use super::Work;
use super::estimate::Found;
use super::scales::mean_scale;
use crate::answer::{Answer, ErrorKind, ErrorParts, Map, Quantity, mean_of_cells};
use crate::faces::is_round;
use crate::scene::ReceiverKind;

/// Maps and answers, each with the index of its receiver.
type Lists = (Vec<(usize, Map)>, Vec<(usize, Answer)>);

impl Work<'_> {
    /// Returns the maps of all receivers of points or faces, and the means over points.
    pub(crate) fn lists(&self, found: &[Found]) -> Lists {
        let (mut maps, mut means) = (Vec::new(), Vec::new());
        let cells: Vec<usize> = (self.answers..self.requested).collect();
        for own in cells.chunk_by(|&one, &other| self.readings[one].receiver == self.readings[other].receiver)
        {
            let receiver = self.readings[own[0]].receiver;
            let is_points = matches!(self.scene.receivers[receiver].kind, ReceiverKind::Points(_));
            let scales = self.scales_of_list(own, found);
            for first in own.iter().take(self.numbers_of_a_cell(own)) {
                let quantity = self.readings[*first].quantity;
                let of_quantity: Vec<&Found> = own
                    .iter()
                    .filter(|&&cell| self.readings[cell].quantity == quantity)
                    .map(|&cell| &found[cell])
                    .collect();
                if is_points {
                    means.extend(self.means_of_list(receiver, quantity, &of_quantity));
                }
                maps.push((receiver, self.list((receiver, quantity), &of_quantity, scales.clone())));
            }
        }
        (maps, means)
    }

    /// Returns the number of readings of each point or face.
    fn numbers_of_a_cell(&self, own: &[usize]) -> usize {
        let first = self.readings[own[0]].quantity;
        own.iter()
            .skip(1)
            .position(|&cell| self.readings[cell].quantity == first)
            .map_or(own.len(), |n| n + 1)
    }

    /// Returns the scale of the points or faces of a receiver in each band: the mean of the first
    /// quantity.
    fn scales_of_list(&self, own: &[usize], found: &[Found]) -> Vec<f64> {
        let first = self.readings[own[0]].quantity;
        let of_band = |band: usize| {
            let leading = own.iter().filter(|&&cell| self.readings[cell].quantity == first);
            let value = |&cell: &usize| found[cell].bands.get(band).map(|estimate| (estimate.value, false));
            mean_scale(leading.filter_map(value))
        };
        (0..self.scene.band_count()).map(of_band).collect()
    }

    /// Returns the map of one quantity; NaN where the work was stopped before.
    fn list(&self, (receiver, quantity): (usize, Quantity), cells: &[&Found], scales: Vec<f64>) -> Map {
        let numbers = |band: usize| {
            let number = |found: &&Found| {
                found.bands.get(band).map_or([f64::NAN; 2], |estimate| [estimate.value, estimate.error()])
            };
            cells.iter().map(number).map(|[value, error]| (value, error)).unzip()
        };
        let (values, errors) = (0..self.scene.band_count()).map(numbers).unzip();
        Map::of_cells(
            &self.scene.receivers[receiver],
            quantity,
            (values, errors, scales),
            self.kind_of(cells),
        )
    }

    /// Returns the means over the points of a receiver, for each band; none if the work was stopped
    /// before all points were reached.
    fn means_of_list(&self, receiver: usize, quantity: Quantity, cells: &[&Found]) -> Vec<(usize, Answer)> {
        if cells.iter().any(|found| found.is_missing()) {
            return Vec::new();
        }
        let bands = self.scene.band_count();
        let name = &self.scene.receivers[receiver].name;
        let of_band = |band: usize| {
            let numbers = cells.iter().map(|found| (found.bands[band].value, found.bands[band].parts()));
            let numbers: Vec<(f64, ErrorParts)> = numbers.collect();
            let place = (name.as_str(), quantity, (bands > 1).then_some(band));
            (receiver, mean_of_cells(place, &numbers, self.kind_of(cells), 0.0))
        };
        (0..bands).map(of_band).collect()
    }

    /// Returns the weakest kind of the errors of some readings.
    fn kind_of(&self, cells: &[&Found]) -> ErrorKind {
        let is_round = is_round(self.scene);
        let kinds = cells.iter().flat_map(|found| {
            found.bands.iter().map(move |estimate| estimate.kind(found.has_pieces && is_round))
        });
        kinds.max().unwrap_or(ErrorKind::Bound)
    }
}
