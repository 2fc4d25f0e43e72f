//! Cones: the directions in which a convex polygon is seen from a point.

use super::Vector;
use super::clip::{Pieces, split};

/// The directions from an apex that meet a convex polygon.
///
/// The plane through the apex and the edge from a to b (both relative to the apex) has the normal a × b. A
/// convex polygon whose plane does not pass through the apex is met by exactly those x with ±(a × b)·x ≥ 0
/// for every edge, with the upper sign where the apex lies behind the polygon. Two polygons with a common
/// edge share its plane to the last bit, because the cross product is antisymmetric in floating point too: no
/// direction slips between them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Cone {
    sides: Vec<Vector>,
}

impl Cone {
    /// The cone over a polygon whose vertices are relative to the apex.
    pub(crate) fn over(polygon: &[Vector], seen_from_front: bool) -> Self {
        let mut cone = Self::default();
        cone.set(polygon, seen_from_front);
        cone
    }

    /// Makes this the cone over another polygon.
    pub(super) fn set(&mut self, polygon: &[Vector], seen_from_front: bool) {
        self.sides.clear();
        let Some(&last) = polygon.last() else { return };
        let mut a = last;
        for &b in polygon {
            self.sides.push(if seen_from_front { b.cross(a) } else { a.cross(b) });
            a = b;
        }
    }

    /// Whether the direction lies in the cone or on its boundary.
    pub(crate) fn contains(&self, direction: Vector) -> bool {
        self.sides.iter().all(|side| side.dot(direction) >= 0.0)
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
        for side in &self.sides {
            split(&scratch.whole, |x| side.dot(x), &mut scratch.inside, &mut scratch.outside);
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
