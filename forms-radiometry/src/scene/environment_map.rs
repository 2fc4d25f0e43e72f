//! Environment map: radiance from outside that depends on the direction, as an image in longitude and
//! latitude.
//!
//! ```text
//! direction ─ axes ─▶ x, y, z ─▶ u = atan2(x, −z)/2π, v = acos(y)/π ─ bilinear between pixels ─▶ value
//! ```
//! Pixel (i, j) lies at u = (i + ½)/width and v = j/(height − 1), so the first and the last row are the
//! poles. Values are relative to the largest of their band.

use super::midrange::middle;
use crate::geometry::Vector;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// An image of the radiance from outside.
#[derive(Clone, Debug, PartialEq)]
pub struct EnvironmentMap {
    resolution: [usize; 2],
    /// Radiance relative to the largest of each band, from 0 to 1: row by row from v = 0, the bands of
    /// a pixel next to each other.
    values: Arc<Vec<f32>>,
    bands: usize,
    /// Unit vectors along x, y and z.
    axes: [Vector; 3],
}

/// The pixels between which a value is interpolated, and their weights.
pub(crate) struct Lookup {
    pixels: [usize; 4],
    weights: [f64; 4],
}

impl EnvironmentMap {
    /// Creates the map of radiances, which are finite and not negative: row by row, the bands of a
    /// pixel next to each other. Also returns the largest radiance of each band. `None` if the image
    /// has fewer than two rows or columns, or not as many values.
    pub fn new(
        resolution: [usize; 2],
        bands: usize,
        radiances: &[f64],
        axes: [Vector; 3],
    ) -> Option<(Self, Vec<f64>)> {
        let [width, height] = resolution;
        if width < 2 || height < 2 || bands == 0 || radiances.len() != width * height * bands {
            return None;
        }
        let of_band = |band: usize| radiances.iter().skip(band).step_by(bands).copied().fold(0.0, f64::max);
        let largest: Vec<f64> = (0..bands).map(of_band).collect();
        let relative = |(index, &value): (usize, &f64)| {
            (value / largest[index % bands].max(f64::MIN_POSITIVE)).min(1.0) as f32
        };
        let values = radiances.iter().enumerate().map(relative).collect();
        Some((Self { resolution, values: Arc::new(values), bands, axes }, largest))
    }

    /// Returns the numbers of columns and rows.
    pub fn resolution(&self) -> [usize; 2] {
        self.resolution
    }

    /// Returns the same map in a single band, the midrange of all bands, and its largest radiance.
    /// `radiance` is the largest radiance of each band before.
    pub(super) fn with_one_band(&self, radiance: &[f64]) -> (Self, Vec<f64>) {
        let pixel = |values: &[f32]| {
            let radiances = values.iter().zip(radiance).map(|(&value, most)| f64::from(value) * most);
            middle(&radiances.collect::<Vec<_>>())
        };
        let radiances: Vec<f64> = self.values.chunks_exact(self.bands).map(pixel).collect();
        Self::new(self.resolution, 1, &radiances, self.axes).expect("the resolution is that of a map")
    }

    /// Returns where the map shows a direction, a unit vector.
    pub(crate) fn lookup(&self, direction: Vector) -> Lookup {
        let [x, y, z] = self.axes.map(|axis| axis.dot(direction));
        let [width, height] = self.resolution;
        let column = x.atan2(-z) / TAU * width as f64 - 0.5;
        let row = y.clamp(-1.0, 1.0).acos() / PI * (height - 1) as f64;
        let (left, upper) = (column.floor(), (row.floor() as usize).min(height - 2));
        let (p, q) = (column - left, row - upper as f64);
        let at = |offset: f64| (left + offset).rem_euclid(width as f64) as usize % width;
        let pixel = |column: usize, row: usize| width * row + column;
        let columns = [at(0.0), at(1.0)];
        Lookup {
            pixels: [
                pixel(columns[0], upper),
                pixel(columns[1], upper),
                pixel(columns[0], upper + 1),
                pixel(columns[1], upper + 1),
            ],
            weights: [(1.0 - p) * (1.0 - q), p * (1.0 - q), (1.0 - p) * q, p * q],
        }
    }

    /// Returns the radiance of a band relative to its largest one.
    pub(crate) fn value(&self, lookup: &Lookup, band: usize) -> f64 {
        let pixels = lookup.pixels.iter().zip(lookup.weights);
        pixels.map(|(&pixel, weight)| weight * f64::from(self.values[pixel * self.bands + band])).sum()
    }

    /// Returns the sum over all bands of the relative values of a pixel.
    pub(crate) fn sum_of_bands(&self, column: usize, row: usize) -> f64 {
        let first = (self.resolution[0] * row + column % self.resolution[0]) * self.bands;
        self.values[first..first + self.bands].iter().map(|&value| f64::from(value)).sum()
    }

    /// Returns the direction with these u and cos πv.
    pub(crate) fn direction(&self, u: f64, y: f64) -> Vector {
        let (sine, cosine) = (TAU * u).sin_cos();
        let radius = (1.0 - y * y).max(0.0).sqrt();
        radius * sine * self.axes[0] + y * self.axes[1] - radius * cosine * self.axes[2]
    }

    /// Returns u and cos πv of a direction, with u from 0 to 1.
    pub(crate) fn coordinates(&self, direction: Vector) -> [f64; 2] {
        let [x, y, z] = self.axes.map(|axis| axis.dot(direction));
        [(x.atan2(-z) / TAU).rem_euclid(1.0), y.clamp(-1.0, 1.0)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values of Mitsuba 3.9.1 for the same image, turned as in a scene.
    #[test]
    fn values_lie_between_pixels_and_coordinates_return() {
        let axes = [Vector::new(1.0, 0.0, 0.0), Vector::new(0.0, 1.0, 0.0), Vector::new(0.0, 0.0, 1.0)];
        let radiances: Vec<f64> = (0..12).map(f64::from).collect();
        let (map, largest) = EnvironmentMap::new([4, 3], 1, &radiances, axes).unwrap();
        assert_eq!(largest, [11.0]);
        let value = |direction: Vector| 11.0 * map.value(&map.lookup(direction), 0);
        // the pole is the mean of the pixels on both sides of u = 0 in the first row
        for (direction, expected) in [
            (Vector::new(0.0, 0.0, -1.0), 5.5),
            (Vector::new(1.0, 0.0, 0.0), 4.5),
            (Vector::new(0.0, 0.0, 1.0), 5.5),
            (Vector::new(0.0, -1.0, 0.0), 9.5),
        ] {
            let found = value(direction);
            assert!((found - expected).abs() < 1e-5, "{direction:?}: {found}");
        }
        let direction = Vector::new(0.6, -0.48, 0.64);
        let [u, y] = map.coordinates(direction);
        assert!((map.direction(u, y) - direction).length() < 1e-15);
    }
}
