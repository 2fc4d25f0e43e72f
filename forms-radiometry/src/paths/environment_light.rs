//! Environment light: samples directions to the bright parts of an environment map.
//!
//! ```text
//! cells between four pixels ─ chosen by their mean value × solid angle ─▶ uniform over the solid angle
//! ```
//! The density is that of the cell, per solid angle. It is positive wherever the map is.

use crate::geometry::Vector;
use crate::sampling::{chosen, shares};
use crate::scene::EnvironmentMap;
use std::f64::consts::{PI, TAU};

/// An environment map, and the selection of its cells.
pub(super) struct EnvironmentLight {
    map: EnvironmentMap,
    /// The share of each cell, row by row, and the running sums.
    shares: Vec<f64>,
    sums: Vec<f64>,
}

impl EnvironmentLight {
    pub(super) fn of(map: &EnvironmentMap) -> Self {
        let [width, height] = map.resolution();
        let cell = |index: usize| {
            let (column, row) = (index % width, index / width);
            let corners = [(column, row), (column + 1, row), (column, row + 1), (column + 1, row + 1)];
            let sum: f64 = corners.iter().map(|&(column, row)| map.sum_of_bands(column, row)).sum();
            sum * solid_angle(row, [width, height])
        };
        let weights: Vec<f64> = (0..width * (height - 1)).map(cell).collect();
        let [shares, sums] = shares(&weights);
        Self { map: map.clone(), shares, sums }
    }

    /// Samples a direction by a point of the unit square, and returns its density.
    pub(super) fn sample(&self, [u, v]: [f64; 2]) -> Option<(Vector, f64)> {
        let [width, height] = self.map.resolution();
        let cell = chosen(&self.sums, u)?;
        let share = self.shares[cell];
        let before = self.sums[cell] - share;
        let p = if share > 0.0 { ((u - before) / share).clamp(0.0, 1.0) } else { 0.5 };
        let (column, row) = (cell % width, cell / width);
        let [upper, lower] = [row, row + 1].map(|row| height_of(row, height));
        let direction =
            self.map.direction((column as f64 + 0.5 + p) / width as f64, upper + v * (lower - upper));
        let density = self.density_of(cell);
        (density > 0.0).then_some((direction, density))
    }

    /// Returns the density with which a direction is sampled.
    pub(super) fn density(&self, direction: Vector) -> f64 {
        let [width, height] = self.map.resolution();
        let [u, y] = self.map.coordinates(direction);
        let column = (u * width as f64 - 0.5).rem_euclid(width as f64) as usize % width;
        let row = ((y.acos() / PI * (height - 1) as f64) as usize).min(height - 2);
        self.density_of(row * width + column)
    }

    fn density_of(&self, cell: usize) -> f64 {
        let resolution = self.map.resolution();
        self.shares[cell] / solid_angle(cell / resolution[0], resolution)
    }
}

/// Returns cos πv of a row of pixels.
fn height_of(row: usize, height: usize) -> f64 {
    (PI * row as f64 / (height - 1) as f64).cos()
}

/// Returns the solid angle of each cell of a row.
fn solid_angle(row: usize, [width, height]: [usize; 2]) -> f64 {
    TAU / width as f64 * (height_of(row, height) - height_of(row + 1, height))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_sampled_with_their_density() {
        let axes = [Vector::new(0.0, 1.0, 0.0), Vector::new(0.0, 0.0, 1.0), Vector::new(1.0, 0.0, 0.0)];
        let radiances: Vec<f64> = (0..5 * 4).map(|pixel| f64::from(pixel * pixel % 7)).collect();
        let (map, _) = EnvironmentMap::new([5, 4], 1, &radiances, axes).unwrap();
        let light = EnvironmentLight::of(&map);
        let number = |i: usize, base: f64| (0.5 + i as f64 * base).fract();
        let (mut sum, mut values) = (0.0, 0.0);
        const COUNT: usize = 20_000;
        for i in 0..COUNT {
            let square = [number(i, 0.754_877_666_246_692_8), number(i, 0.569_840_290_998_053_2)];
            let (direction, density) = light.sample(square).unwrap();
            assert!((light.density(direction) - density).abs() < 1e-9 * density, "{square:?}");
            sum += 1.0 / density;
            values += map.value(&map.lookup(direction), 0) / density;
        }
        // ∫ dω over the cells that are not black, and ∫ L dω by the midpoint rule
        let (mut covered, mut integral) = (0.0, 0.0);
        const STEPS: usize = 400;
        for i in 0..STEPS * STEPS {
            let [u, y] = [i % STEPS, i / STEPS].map(|step| (step as f64 + 0.5) / STEPS as f64);
            let direction = map.direction(u, 2.0 * y - 1.0);
            let solid = 4.0 * PI / (STEPS * STEPS) as f64;
            covered += if light.density(direction) > 0.0 { solid } else { 0.0 };
            integral += solid * map.value(&map.lookup(direction), 0);
        }
        assert!((sum / COUNT as f64 - covered).abs() < 0.02 * covered, "{sum}, {covered}");
        assert!((values / COUNT as f64 - integral).abs() < 0.01 * integral, "{values}, {integral}");
    }
}
