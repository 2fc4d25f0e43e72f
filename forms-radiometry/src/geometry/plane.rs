//! Planes, and distances that count as none: of vertices from their plane, and of vertices from each
//! other.

use super::Vector;
use super::bounds::Bounds;

/// Rounding error of a distance, relative to the largest coordinate.
pub(crate) const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// The plane through a point with this unit normal.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plane {
    pub(crate) point: Vector,
    pub(crate) normal: Vector,
}

impl Plane {
    /// Returns the signed distance of a point, positive on the side to which the normal points.
    pub(crate) fn distance(self, point: Vector) -> f64 {
        self.normal.dot(point - self.point)
    }

    /// Reflects a point at the plane, for a unit normal: x − 2 ((x − a)·n) n.
    pub(crate) fn mirrored(self, point: Vector) -> Vector {
        point - (2.0 * self.distance(point)) * self.normal
    }

    /// Returns the plane with its normal on this side.
    pub(crate) fn facing(self, is_front: bool) -> Self {
        if is_front { self } else { Self { normal: -self.normal, ..self } }
    }
}

/// Returns the largest distance of vertices from the plane through the first of them.
pub(crate) fn flatness(vertices: &[Vector], normal: Vector) -> f64 {
    let plane = Plane { point: vertices[0], normal };
    vertices.iter().map(|&vertex| plane.distance(vertex).abs()).fold(0.0, f64::max)
}

/// Returns the distance below which vertices that are given in decimals count as coincident: 10⁻⁹
/// of the extent of all points, or the rounding of their coordinates where they are far from the
/// origin. Visibility does not depend on it.
pub(crate) fn closeness(points: impl Iterator<Item = Vector>) -> f64 {
    let bounds = Bounds::of(points);
    if bounds.low.x > bounds.high.x {
        return 0.0;
    }
    (1e-9 * bounds.extent()).max(ROUNDING * bounds.largest())
}
