//! Units: numbers in working units are converted to the units of their quantities.

use super::error_budget::ErrorParts;
use super::quantity::Quantity;
use super::results::{Answer, Simulation};
use crate::scene::WorkingUnits;

impl Simulation {
    /// Converts all numbers to the units of their quantities.
    pub(crate) fn leave_working_units(&mut self, units: &WorkingUnits) {
        for answer in &mut self.answers {
            answer.multiply(units.light);
            if answer.quantity == Quantity::Flux {
                answer.multiply(units.square_metres);
            }
        }
        self.brightest *= units.light;
        if units.light != 1.0 {
            for map in &mut self.maps {
                let numbers = map.values.iter_mut().chain(&mut map.errors).chain([&mut map.scales]);
                numbers.flatten().for_each(|number| *number *= units.light);
            }
        }
    }
}

impl Quantity {
    /// Converts a number in working units to the unit of this quantity.
    pub(crate) fn in_unit(self, number: f64, units: &WorkingUnits) -> f64 {
        let area = if self == Self::Flux { units.square_metres } else { 1.0 };
        number * units.light * area
    }
}

impl Answer {
    /// Multiplies by a factor above zero. Where the product is beyond the range of `f64`, the error
    /// shows it.
    pub(crate) fn multiply(&mut self, factor: f64) {
        if factor == 1.0 {
            return;
        }
        let value = factor * self.value;
        let lost = match value.abs() {
            size if !size.is_finite() => f64::INFINITY,
            // below the normal numbers, rounding is not relative
            size if size < f64::MIN_POSITIVE && self.value != 0.0 => f64::MIN_POSITIVE,
            size => f64::EPSILON * size,
        };
        self.value = value;
        self.parts = self.parts.scaled(factor);
        self.add(ErrorParts { rounding: lost, ..ErrorParts::default() });
    }

    /// Adds to the error.
    pub(crate) fn add(&mut self, parts: ErrorParts) {
        self.parts = self.parts + parts;
        self.error = self.parts.error(self.kind);
    }
}
