//! Curved shapes: centre, radius and side of a sphere or a disk, and its tessellation into flat
//! pieces of the same total area.
//!
//! ```text
//! disk ─▶ regular polygon of 24·2ᵏ edges
//! sphere ─▶ icosahedron, its triangles quartered k + 1 times
//! ```
//! A regular polygon with the disk's area extends as far outside the circle as inside: the terms
//! that are linear in the deviation average out, also for a receiver off the axis, up to the N-th
//! harmonic, which is (R/d)ᴺ. A closed convex polyhedron with the sphere's area has the sphere's
//! mean projected area over all directions, a quarter of the area (Cauchy 1832).

use super::Vector;
use std::f64::consts::PI;

/// Rounding error of a coordinate of a vertex, relative to the lengths that it is the sum of.
const ROUNDING: f64 = 2.0 * f64::EPSILON;
/// Fraction of the radius within which a point is inside the shape for certain, whatever the
/// rounding errors.
const WITHIN: f64 = 1.0 - 1e-12;
/// Number of edges of the coarsest polygon that approximates a disk.
const EDGES: usize = 24;

/// A sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// The centre.
    pub center: Vector,
    /// The radius, above zero.
    pub radius: f64,
    /// Whether the front is the inside.
    pub inward: bool,
}

/// A flat disk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disk {
    /// The centre.
    pub center: Vector,
    /// The unit normal, which points to the front.
    pub normal: Vector,
    /// The radius, above zero.
    pub radius: f64,
}

impl Disk {
    /// Returns the disk with all lengths multiplied by this factor.
    pub(crate) fn scaled(self, factor: f64) -> Self {
        Self { center: factor * self.center, radius: factor * self.radius, ..self }
    }

    /// Returns the disk with front and back swapped.
    pub(crate) fn reversed(self) -> Self {
        Self { normal: -self.normal, ..self }
    }

    /// Returns opposite corners of its axis-aligned bounding box.
    pub(crate) fn corners(&self) -> [Vector; 2] {
        let reach =
            self.normal.coordinates().map(|across| self.radius * (1.0 - across * across).max(0.0).sqrt());
        let [x, y, z] = reach;
        let reach = Vector::new(x, y, z);
        [self.center - reach, self.center + reach]
    }

    /// Returns a regular polygon with the disk's area, counter-clockwise seen from its front. Each
    /// step of `fineness` doubles the number of edges.
    ///
    /// A polygon of N edges with its vertices at the distance ρ has the area N/2 ρ² sin(2π/N).
    pub(crate) fn polygon(&self, fineness: usize) -> Vec<Vector> {
        let count = EDGES << fineness;
        let step = 2.0 * PI / count as f64;
        let reach = self.radius * (step / step.sin()).sqrt();
        let [u, v] = across(self.normal);
        let corner = |place: usize| {
            let (sine, cosine) = (step * place as f64).sin_cos();
            self.center + (reach * cosine) * u + (reach * sine) * v
        };
        (0..count).map(corner).collect()
    }
}

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
}

impl Round for Disk {
    fn center(&self) -> Vector {
        self.center
    }

    fn reach(&self, along: Vector) -> f64 {
        self.normal.cross(along).length()
    }

    fn meets(&self, [a, b]: [Vector; 2]) -> bool {
        let [alpha, beta] = [a, b].map(|end| self.normal.dot(end - self.center));
        let place = a + (alpha / (alpha - beta)) * (b - a);
        alpha * beta < 0.0 && (place - self.center).length() <= WITHIN * self.radius
    }

    /// Returns the distance from the rim.
    fn distance(&self, point: Vector) -> f64 {
        let way = point - self.center;
        let height = self.normal.dot(way);
        ((way - height * self.normal).length() - self.radius).hypot(height)
    }

    fn radius(&self) -> f64 {
        self.radius
    }

    fn rounding(&self) -> f64 {
        let along = self.normal.coordinates().map(|across| (1.0 - across * across).max(0.0).sqrt());
        let lengths = self.center.coordinates().map(|center| center.abs() + self.radius);
        let moved: f64 = lengths.into_iter().zip(along).map(|(length, along)| length * along).sum();
        ROUNDING * moved
    }

    /// Exceeds both (1 − cos(π/N)) r and the distance of the vertices outside the circle.
    fn deviation(&self, fineness: usize) -> f64 {
        self.radius * (PI / (EDGES << fineness) as f64).powi(2)
    }
}

impl Round for Sphere {
    fn center(&self) -> Vector {
        self.center
    }

    fn reach(&self, _: Vector) -> f64 {
        1.0
    }

    fn meets(&self, [a, b]: [Vector; 2]) -> bool {
        let (along, to_center) = (b - a, self.center - a);
        let share = (to_center.dot(along) / along.dot(along)).clamp(0.0, 1.0);
        let is_inside = |end: Vector| (end - self.center).length() < self.radius;
        (share * along - to_center).length() <= WITHIN * self.radius && !(is_inside(a) && is_inside(b))
    }

    fn distance(&self, point: Vector) -> f64 {
        ((point - self.center).length() - self.radius).abs()
    }

    fn radius(&self) -> f64 {
        self.radius
    }

    fn rounding(&self) -> f64 {
        ROUNDING * (self.center.largest() + self.radius)
    }

    /// Exceeds the depth of a triangle's centre inside the sphere: its edges subtend no more than
    /// the edges of the icosahedron, halved at each step.
    fn deviation(&self, fineness: usize) -> f64 {
        let edge = 2.0_f64.atan() / f64::from(2_u32 << fineness);
        self.radius * 0.25 * edge * edge
    }
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

impl Sphere {
    /// Returns the sphere with all lengths multiplied by this factor.
    pub(crate) fn scaled(self, factor: f64) -> Self {
        Self { center: factor * self.center, radius: factor * self.radius, ..self }
    }

    /// Returns the triangles of a closed polyhedron with the sphere's area, each counter-clockwise
    /// seen from the sphere's front. Each step of `fineness` splits every triangle into four.
    pub(crate) fn triangles(&self, fineness: usize) -> Vec<[Vector; 3]> {
        let mut triangles = icosahedron();
        for _ in 0..=fineness {
            triangles = triangles.into_iter().flat_map(quarters).collect();
        }
        let area: f64 = triangles.iter().map(|&[a, b, c]| 0.5 * (b - a).cross(c - a).length()).sum();
        let reach = self.radius * (4.0 * PI / area).sqrt();
        let placed = |[a, b, c]: [Vector; 3]| {
            let outward = [a, b, c].map(|corner| self.center + reach * corner);
            let [a, b, c] = outward;
            if self.inward { [a, c, b] } else { outward }
        };
        triangles.into_iter().map(placed).collect()
    }
}

/// Returns the triangles of the regular icosahedron with vertices at the distance 1,
/// counter-clockwise seen from outside: vertices at the poles and on two circles of latitude ±atan
/// ½.
fn icosahedron() -> Vec<[Vector; 3]> {
    let pole = |up: f64| Vector::new(0.0, 0.0, up);
    let height = 0.2_f64.sqrt();
    let corner = |tenth: usize| {
        let (sine, cosine) = (PI / 5.0 * (tenth % 10) as f64).sin_cos();
        let up = if tenth.is_multiple_of(2) { height } else { -height };
        Vector::new(2.0 * height * cosine, 2.0 * height * sine, up)
    };
    let of_sector = |fifth: usize| {
        let [a, b, c, d] = [0, 1, 2, 3].map(|tenth| corner(2 * fifth + tenth));
        [[pole(1.0), a, c], [a, b, c], [b, d, c], [pole(-1.0), d, b]]
    };
    (0..5).flat_map(of_sector).collect()
}

/// Splits a triangle on the unit sphere into four at the midpoints of its edges, with all vertices
/// on the sphere.
fn quarters([a, b, c]: [Vector; 3]) -> [[Vector; 3]; 4] {
    let middle =
        |a: Vector, b: Vector| (a + b).unit().expect("corners of an edge are not opposite each other");
    let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
    [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
}

#[cfg(test)]
mod tests;
