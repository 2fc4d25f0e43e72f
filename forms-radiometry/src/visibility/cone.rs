//! Cones: the directions in which a point sees a convex polygon.

use crate::geometry::Vector;
use crate::geometry::clip::{Pieces, split_beyond};
use crate::geometry::sides::sides;

/// Buffers for clipping, reused from receiver to receiver.
#[derive(Clone, Debug, Default)]
pub(super) struct Cutting {
    pub(super) screen: Vec<Vector>,
    pub(super) luminaire_cone: Cone,
    pub(super) screen_cone: Cone,
    pub(super) seen: Vec<bool>,
    pub(super) scratch: Scratch,
    pub(super) rest: Pieces,
}

/// Rounding error of the scalar product of two vectors, relative to the product of their largest
/// coordinates.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// The cone of directions from an apex that meet a convex polygon.
///
/// The plane through the apex and the edge from a to b (both relative to the apex) has the normal a
/// × b. If the plane of a convex polygon does not pass through the apex, exactly those directions x
/// meet the polygon that satisfy ±(a × b)·x ≥ 0 for every edge, with the upper sign where the apex
/// lies behind the polygon. Two polygons with a common edge share its plane to the last bit,
/// because the cross product is antisymmetric in floating point too: no direction slips between
/// them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Cone {
    sides: Vec<Vector>,
}

impl Cone {
    /// Sets this to the cone over another polygon, whose vertices are relative to the apex.
    pub(crate) fn set(&mut self, polygon: &[Vector], seen_from_front: bool) {
        self.set_sides(sides(polygon.iter().copied(), seen_from_front));
    }

    /// Sets this to the cone whose sides have these inward normals.
    pub(crate) fn set_sides(&mut self, sides: impl Iterator<Item = Vector>) {
        self.sides.clear();
        self.sides.extend(sides);
    }

    /// Returns the inward normals of the sides.
    pub(crate) fn sides(&self) -> &[Vector] {
        &self.sides
    }

    /// Whether all points lie beyond one side of the cone or on it. Then the cone does not meet
    /// their convex hull.
    pub(crate) fn misses(&self, points: &[Vector]) -> bool {
        self.sides.iter().any(|side| points.iter().all(|&point| side.dot(point) <= 0.0))
    }

    /// Appends to `rest` the convex pieces of a polygon that lie outside the cone, at most one for
    /// each side.
    pub(crate) fn cut_from(&self, polygon: &[Vector], scratch: &mut Scratch, rest: &mut Pieces) {
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

/// Buffers that are reused from cut to cut.
#[derive(Clone, Debug, Default)]
pub(crate) struct Scratch {
    whole: Vec<Vector>,
    pub(crate) inside: Vec<Vector>,
    pub(crate) outside: Vec<Vector>,
}
