//! Shapes: readings with finer and finer flat pieces in the place of round shapes become an estimate of what finer ones still change.
//!
//! ```text
//! values with each fineness ─▶ the last changes c₁, c₂ ─▶ what is left: S max(c₂, r₀ c₁) r/(1 − r),  r = c₂/c₁
//! ```
//! r₀ is the factor by which each step lessens the error where the shape is far: 1/16 for disks, 1/4 for spheres, whose silhouettes are polygons. A change
//! may be small by chance: it counts as no less than r₀ times the one before. Where light is reflected, or goes from spheres to surfaces, fine shapes take
//! long: there one change is the estimate.

use super::estimate::{Estimate, Found};
use super::readings::Reading;
use crate::faces::{is_round, round_surfaces};
use crate::geometry::{Round, Vector};
use crate::scene::{Scene, Shape};

/// The safety of the estimate.
const SAFETY: f64 = 3.0;
/// The least that a step lessens errors by is taken to be.
const SLOWEST: f64 = 0.75;
/// Points that are nearer to the border of a shape than so many times what pieces are off it may be on the wrong side of them.
const NEAR: f64 = 4.0;
/// Points lie on the border if they are no farther from it than so many roundings.
const ON: f64 = 8.0;

/// The readings with shapes that were coarser, from the coarsest on.
pub(super) struct Shapes<'s> {
    scene: &'s Scene,
    has_spheres: bool,
    /// What the rounding of their pieces' corners changes of an answer, relative to it.
    rounding: f64,
    /// Whether finer shapes take little.
    is_quick: bool,
    coarser: Vec<Vec<Found>>,
}

impl<'s> Shapes<'s> {
    /// Nothing is found yet of the readings of a scene, whose light comes straight from lights or is reflected.
    pub(super) fn new(scene: &'s Scene, is_straight: bool, readings: &[Reading]) -> Self {
        let has_spheres = scene.surfaces.iter().any(|surface| matches!(surface.shape, Shape::Sphere(_)));
        let has_means = readings.iter().any(Reading::is_mean);
        let is_quick = is_straight && !(has_spheres && has_means);
        let roundings = round_surfaces(scene).map(|(_, shape)| shape.rounding() / shape.radius());
        Self { scene, has_spheres, rounding: roundings.fold(0.0, f64::max), is_quick, coarser: Vec::new() }
    }

    pub(super) fn are_round(&self) -> bool {
        is_round(self.scene)
    }

    /// Compares what was found with what coarser shapes gave, or takes that back if not everything was reached; whether the errors then tell what the
    /// shape changes.
    pub(super) fn compare(&mut self, found: &mut Vec<Found>, readings: &[Reading]) -> bool {
        let fineness = self.coarser.len();
        let Some(last) = self.coarser.last() else { return false };
        if found.iter().any(Found::is_missing) {
            found.clone_from(last);
            return fineness > 1;
        }
        let before = self.coarser.iter().rev().nth(1);
        for (index, found) in found.iter_mut().enumerate().filter(|(_, found)| found.has_pieces) {
            for (band, estimate) in found.bands.iter_mut().enumerate() {
                let value = |of: &Vec<Found>| of[index].bands[band].value;
                estimate.floor.quadrature +=
                    self.left([before.map(value), Some(value(last))], estimate.value);
                estimate.floor.rounding += self.rounding * estimate.value.abs();
                self.add_unseen(estimate, &readings[index], fineness, band);
            }
        }
        before.is_some() || !self.is_quick
    }

    pub(super) fn remember(&mut self, found: Vec<Found>) {
        self.coarser.push(found);
    }

    /// What finer shapes still change, by the values that the last ones gave.
    fn left(&self, before: [Option<f64>; 2], value: f64) -> f64 {
        let [before, Some(last)] = before else { return 0.0 };
        let change = (value - last).abs();
        let Some(before) = before.filter(|_| self.is_quick) else { return change };
        let earlier = (last - before).abs();
        let fastest = if self.has_spheres { 0.25 } else { 0.0625 };
        let change = change.max(fastest * earlier);
        let ratio = if earlier > 0.0 { (change / earlier).min(SLOWEST) } else { SLOWEST };
        SAFETY * change * ratio / (1.0 - ratio)
    }

    /// Adds what the light of a shape may be of which it is not known whether a point is before it.
    fn add_unseen(&self, estimate: &mut Estimate, reading: &Reading, fineness: usize, band: usize) {
        let Some((position, largest)) = reading.at_point() else { return };
        let near = self.scene.surfaces.iter().filter(|surface| is_near(&surface.shape, position, fineness));
        let radiance: f64 = near.map(|surface| surface.radiance[band]).sum();
        estimate.floor.quadrature += largest * radiance;
    }
}

/// Whether a point is so near to the border of a shape that its pieces may have it on the wrong side; points that lie on it are on the right one.
fn is_near(shape: &Shape, point: Vector, fineness: usize) -> bool {
    let is_within = |shape: &dyn Round| {
        let [distance, deviation] = [shape.distance(point), shape.deviation(fineness)];
        distance > ON * (shape.rounding() + f64::EPSILON * point.largest()) && distance <= NEAR * deviation
    };
    shape.as_round().is_some_and(is_within)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::read;

    /// What is left of a quantity whose error is this part of the one before at each step.
    fn left(shape: &str, ratio: f64) -> [f64; 2] {
        let text = format!(
            "[[material]]\nname = \"m\"\nkind = \"diffuse\"\nreflectance = 0\n[[surface]]\nname = \"s\"\nmaterial = \"m\"\n{shape}\n"
        );
        let scene = read(&text, "shape.toml").unwrap_or_else(|errors| panic!("{}", errors[0]));
        let errors = [1.0, ratio, ratio * ratio];
        let left = Shapes::new(&scene, true, &[])
            .left([Some(1.0 + errors[0]), Some(1.0 + errors[1])], 1.0 + errors[2]);
        [left, errors[2]]
    }

    #[test]
    fn what_is_left_is_no_less_than_the_error_and_not_much_more_at_any_rate_that_shapes_have() {
        const DISK: &str = "disk = { center = [0, 0, 0], normal = [0, 0, 1], radius = 1 }";
        const SPHERE: &str = "sphere = { center = [0, 0, 0], radius = 1 }";
        for (shape, fastest) in [(DISK, 0.0625), (SPHERE, 0.25)] {
            for ratio in [fastest, 0.3, 0.5, 0.7] {
                let [left, error] = left(shape, ratio);
                assert!(error <= left && left <= 3.1 * error, "{shape}, {ratio}: {left} for {error}");
            }
            // faster than it is meant to be, or by chance
            let [left, error] = left(shape, 1e-3);
            assert!(error <= left, "{shape}: {left}");
        }
    }
}
