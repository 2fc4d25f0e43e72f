//! Cones: the directions in which a convex polygon is seen from a point.

use super::Vector;
use super::clip::{Pieces, split_beyond};
use super::sides::sides;

/// What rounding leaves of the scalar product of two vectors, in units of their largest coordinates.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// The directions from an apex that meet a convex polygon.
///
/// The plane through the apex and the edge from a to b (both relative to the apex) has the normal a × b. A
/// convex polygon whose plane does not pass through the apex is met by exactly those x with ±(a × b)·x ≥ 0
/// for every edge, with the upper sign where the apex lies behind the polygon. Two polygons with a common
/// edge share its plane to the last bit, because the cross product is antisymmetric in floating point too: no
/// direction slips between them.
#[derive(Clone, Debug, Default)]
pub(super) struct Cone {
    sides: Vec<Vector>,
}

impl Cone {
    /// Makes this the cone over another polygon, whose vertices are relative to the apex.
    pub(super) fn set(&mut self, polygon: &[Vector], seen_from_front: bool) {
        self.set_sides(sides(polygon.iter().copied(), seen_from_front));
    }

    /// Makes this the cone with these normals to the inside of its sides.
    pub(super) fn set_sides(&mut self, sides: impl Iterator<Item = Vector>) {
        self.sides.clear();
        self.sides.extend(sides);
    }

    /// The normals to the inside of its sides.
    pub(super) fn sides(&self) -> &[Vector] {
        &self.sides
    }

    /// Whether some side of the cone has all points beyond it or on it: then the cone does not meet their
    /// hull.
    pub(super) fn misses(&self, points: &[Vector]) -> bool {
        self.sides.iter().any(|side| points.iter().all(|&point| side.dot(point) <= 0.0))
    }

    /// Appends to `rest` the convex pieces of a polygon that lie outside the cone: one a side at most.
    pub(super) fn cut_from(&self, polygon: &[Vector], scratch: &mut Scratch, rest: &mut Pieces) {
        if self.misses(polygon) {
            rest.push(polygon);
            return;
        }
        scratch.whole.clear();
        scratch.whole.extend_from_slice(polygon);
        let reach = polygon.iter().fold(0.0, |reach: f64, &v| reach.max(v.largest()));
        for side in &self.sides {
            let Scratch { whole, inside, outside } = scratch;
            split_beyond(whole, |x| side.dot(x), ROUNDING * side.largest() * reach, inside, outside);
            if !scratch.outside.is_empty() {
                rest.push(&scratch.outside);
            }
            std::mem::swap(&mut scratch.whole, &mut scratch.inside);
        }
    }
}

/// Lists of points that are reused from cut to cut.
#[derive(Clone, Debug, Default)]
pub(super) struct Scratch {
    whole: Vec<Vector>,
    pub(super) inside: Vec<Vector>,
    pub(super) outside: Vec<Vector>,
}
