//! Tessellation: readings with finer and finer flat faces in place of curved shapes become an
//! estimate of the remaining change.
//!
//! ```text
//! values at each fineness ─▶ the last changes c₁, c₂
//!                         ─▶ remaining change: S max(c₂, r₀ c₁) r/(1 − r),  r = c₂/c₁
//! ```
//! r₀ is the factor by which each step lessens the error where the shape is far: 1/16 for disks,
//! 1/4 for curved shapes, whose silhouettes are polygons. A change may be small by chance, so it counts
//! as no less than r₀ times the change before. Where light is reflected, or passes from spheres to
//! surfaces, fine tessellations take long: there, one change is the estimate.

use super::estimate::{Estimate, Found};
use super::readings::Reading;
use crate::faces::{is_round, round_surfaces};
use crate::geometry::{Round, Vector};
use crate::scene::{Scene, Shape};

/// Safety factor of the estimate.
const SAFETY: f64 = 3.0;
/// Slowest convergence that is assumed: the largest ratio of successive errors.
const SLOWEST: f64 = 0.75;
/// Points nearer to the boundary of a shape than this many times the deviation of its faces may be
/// on the wrong side of them.
const NEAR: f64 = 4.0;
/// Points count as lying on the boundary if they are no farther from it than this many rounding
/// errors.
const ON: f64 = 8.0;

/// Readings with coarser tessellations, from the coarsest on.
pub(crate) struct Shapes<'s> {
    scene: &'s Scene,
    /// Whether a shape is curved, and not only its border.
    is_curved: bool,
    /// Change of an answer by the rounding of the faces' corners, relative to the answer.
    rounding: f64,
    /// Whether finer tessellations are cheap.
    is_quick: bool,
    coarser: Vec<Vec<Found>>,
}

impl<'s> Shapes<'s> {
    /// Begins without any reading of a scene, whose light is direct (`is_straight`) or reflected.
    pub(crate) fn new(scene: &'s Scene, is_straight: bool, readings: &[Reading]) -> Self {
        let is_curved = scene.surfaces.iter().any(|surface| surface.shape.is_curved());
        let has_means = readings.iter().any(Reading::is_mean);
        let is_quick = is_straight && !(is_curved && has_means);
        let roundings = round_surfaces(scene).map(|(_, shape)| shape.rounding() / shape.radius());
        Self { scene, is_curved, rounding: roundings.fold(0.0, f64::max), is_quick, coarser: Vec::new() }
    }

    pub(crate) fn are_round(&self) -> bool {
        is_round(self.scene)
    }

    /// Compares the readings with those of coarser tessellations, or returns to those if not
    /// everything was reached. Returns whether the errors then include the error by tessellation.
    pub(crate) fn compare(&mut self, found: &mut Vec<Found>, readings: &[Reading]) -> bool {
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

    pub(crate) fn remember(&mut self, found: Vec<Found>) {
        self.coarser.push(found);
    }

    /// Returns the remaining change by finer tessellations, from the values of the last ones.
    fn left(&self, before: [Option<f64>; 2], value: f64) -> f64 {
        let [before, Some(last)] = before else { return 0.0 };
        let change = (value - last).abs();
        let Some(before) = before.filter(|_| self.is_quick) else { return change };
        let earlier = (last - before).abs();
        let fastest = if self.is_curved { 0.25 } else { 0.0625 };
        let change = change.max(fastest * earlier);
        let ratio = if earlier > 0.0 { (change / earlier).min(SLOWEST) } else { SLOWEST };
        SAFETY * change * ratio / (1.0 - ratio)
    }

    /// Adds the largest possible light of every shape for which it is not known whether the point
    /// is in front of it.
    fn add_unseen(&self, estimate: &mut Estimate, reading: &Reading, fineness: usize, band: usize) {
        let Some((position, largest)) = reading.at_point() else { return };
        let near = self.scene.surfaces.iter().filter(|surface| is_near(&surface.shape, position, fineness));
        let radiance: f64 = near.map(|surface| surface.radiance[band]).sum();
        estimate.floor.quadrature += largest * radiance;
    }
}

/// Whether a point is so near to the boundary of a shape that its faces may have it on the wrong
/// side. Points that lie on the boundary are on the right side.
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

    /// Returns the remaining change of a quantity whose error falls by this ratio at each step, and
    /// its error.
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
            // faster than assumed, or small by chance
            let [left, error] = left(shape, 1e-3);
            assert!(error <= left, "{shape}: {left}");
        }
    }
}
