//! Curved shapes: spheres, disks and annuli, and quadrics of revolution (cylinders, cones,
//! paraboloids), and their tessellation into flat pieces.
//!
//! ```text
//! disk ─▶ regular polygon of 24·2ᵏ edges         annulus, quadric ─▶ rings of 24·2ᵏ trapezoids
//! sphere ─▶ icosahedron, its triangles quartered k + 1 times
//! ```
//! A regular polygon with the disk's area extends as far outside the circle as inside: the terms
//! that are linear in the deviation average out, also for a receiver off the axis, up to the N-th
//! harmonic, which is (R/d)ᴺ. A closed convex polyhedron with the sphere's area has the sphere's
//! mean projected area over all directions, a quarter of the area (Cauchy 1832). The rims of a
//! quadric are those polygons too, so that a cylinder and the disks at its ends are closed.

mod disk;
mod quadric;
mod sphere;

pub use disk::Disk;
pub(crate) use quadric::Crossing;
pub use quadric::{Profile, Quadric};
pub use sphere::Sphere;

use super::Vector;
use std::f64::consts::PI;

/// Rounding error of a coordinate of a vertex, relative to the lengths that it is the sum of.
const ROUNDING: f64 = 2.0 * f64::EPSILON;
/// Fraction of the radius within which a point is inside the shape for certain, whatever the
/// rounding errors.
const WITHIN: f64 = 1.0 - 1e-12;
/// Number of edges of the coarsest polygon that approximates a disk.
const EDGES: usize = 24;

/// A curved shape, from which the flat pieces of its tessellation deviate.
pub(crate) trait Round {
    fn center(&self) -> Vector;
    /// Returns how far the shape reaches from its centre along a unit vector, relative to its
    /// radius.
    fn reach(&self, along: Vector) -> f64;
    /// Whether a segment that is not inside intersects the shape by more than rounding. A segment
    /// that only begins or ends on the shape does not intersect it.
    fn meets(&self, segment: [Vector; 2]) -> bool;
    /// Returns the distance of a point from the places where the pieces deviate from the shape.
    fn distance(&self, point: Vector) -> f64;
    fn radius(&self) -> f64;
    /// Bounds the displacement of the pieces' vertices along the shape by rounding.
    fn rounding(&self) -> f64;
    /// Bounds the distance of the pieces from the shape.
    fn deviation(&self, fineness: usize) -> f64;
    /// Bounds the radius of the part of the shape that reaches at most `depth` beyond a plane, where
    /// all of it reaches to this times the radius.
    ///
    /// Of a sphere it is a cap whose rim has the radius √(2R·depth).
    fn cap(&self, depth: f64, reach: f64) -> f64 {
        (2.0 * self.radius() * (depth / reach)).sqrt().min(self.radius())
    }
    /// Whether the shape hides a convex outline from a point. What a ball or disk hides is convex.
    fn hides(&self, point: Vector, outline: &[Vector]) -> bool {
        outline.iter().all(|&corner| self.meets([point, corner]))
    }
    /// Whether a point sees all of a convex outline beside the shape or through its openings, up to the
    /// deviation of its pieces.
    fn shows_through(&self, _: Vector, _: &[Vector]) -> bool {
        false
    }
}

/// A circle in which a shape ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rim {
    pub(crate) center: Vector,
    /// The unit normal of the plane of the circle.
    pub(crate) axis: Vector,
    pub(crate) radius: f64,
    /// The unit vector from the circle into the shape: its components away from the axis and along
    /// it.
    pub(crate) into: [f64; 2],
    /// The unit normal of the shape's front, in the same components.
    pub(crate) normal: [f64; 2],
}

/// Returns the regular polygon of a disk of this centre, unit normal and radius: the polygon has the
/// area of the disk. Each step of `fineness` doubles the number of edges.
///
/// A polygon of N edges with its vertices at the distance ρ has the area N/2 ρ² sin(2π/N).
fn circle(center: Vector, normal: Vector, radius: f64, fineness: usize) -> Vec<Vector> {
    let count = EDGES << fineness;
    let step = 2.0 * PI / count as f64;
    regular(center, normal, radius * (step / step.sin()).sqrt(), count)
}

/// Returns the corners of a regular polygon, at this distance from its centre.
pub(crate) fn regular(center: Vector, normal: Vector, reach: f64, count: usize) -> Vec<Vector> {
    let step = 2.0 * PI / count as f64;
    let [u, v] = across(normal);
    let corner = |place: usize| {
        let (sine, cosine) = (step * place as f64).sin_cos();
        center + (reach * cosine) * u + (reach * sine) * v
    };
    (0..count).map(corner).collect()
}

/// Returns the flat pieces between two such polygons, each counter-clockwise seen from outside where
/// the polygons are counter-clockwise seen from the second one. Pieces without area are left out.
fn ring([lower, upper]: [&[Vector]; 2]) -> Vec<Vec<Vector>> {
    let piece = |place: usize| {
        let next = (place + 1) % lower.len();
        let mut piece = vec![lower[place], lower[next], upper[next], upper[place]];
        piece.dedup();
        if piece.first() == piece.last() {
            piece.pop();
        }
        piece
    };
    (0..lower.len()).map(piece).filter(|piece| piece.len() > 2).collect()
}

/// Returns unit vectors u and v that form a right-handed basis u, v, `normal` with this unit
/// vector.
pub(crate) fn across(normal: Vector) -> [Vector; 2] {
    let Vector { x, y, z } = normal;
    let least = x.abs().min(y.abs()).min(z.abs());
    let axis = [x, y, z].map(|c| f64::from(u8::from(c.abs() == least)));
    let u = Vector::new(axis[0], axis[1], axis[2]).cross(normal).unit();
    let u = u.expect("an axis at a right angle, or nearly so, to a unit vector");
    [u, normal.cross(u)]
}

#[cfg(test)]
mod tests;
