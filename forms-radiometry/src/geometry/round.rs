//! Round shapes: centre, radius and side of a sphere or a disk, and the flat pieces of the same area that stand for them.
//!
//! ```text
//! disk ─▶ regular polygon of 24·2ᵏ edges          sphere ─▶ icosahedron, its triangles quartered k + 1 times
//! ```
//! A regular polygon of the disk's area is as far outside of the circle as inside: what is linear in the deviation averages out, also for a
//! receiver at the side, up to the harmonic of N turns, which is (R/d)ᴺ. A closed convex polyhedron of the sphere's area has the sphere's
//! projected area in the mean over all directions, a quarter of it (Cauchy 1832).

use super::Vector;
use std::f64::consts::PI;

/// What a coordinate of a corner is rounded by, relative to the lengths that it is the sum of.
const ROUNDING: f64 = 2.0 * f64::EPSILON;
/// What is within this part of a radius is within it, whatever rounding does.
const WITHIN: f64 = 1.0 - 1e-12;
/// The edges of the coarsest polygon that stands for a disk.
const EDGES: usize = 24;

/// A sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Its centre.
    pub center: Vector,
    /// Its radius, above zero.
    pub radius: f64,
    /// Whether its front is the inside.
    pub inward: bool,
}

/// A flat disk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disk {
    /// Its centre.
    pub center: Vector,
    /// The unit normal, which points to the front.
    pub normal: Vector,
    /// Its radius, above zero.
    pub radius: f64,
}

impl Disk {
    /// The disk with all lengths multiplied by this.
    pub(crate) fn scaled(self, factor: f64) -> Self {
        Self { center: factor * self.center, radius: factor * self.radius, ..self }
    }

    /// The same disk that looks to the other side.
    pub(super) fn reversed(self) -> Self {
        Self { normal: -self.normal, ..self }
    }

    /// Opposite corners of the least box around it.
    pub(crate) fn corners(&self) -> [Vector; 2] {
        let reach =
            self.normal.coordinates().map(|across| self.radius * (1.0 - across * across).max(0.0).sqrt());
        let [x, y, z] = reach;
        let reach = Vector::new(x, y, z);
        [self.center - reach, self.center + reach]
    }

    /// A regular polygon of the disk's area, counter-clockwise seen from its front. Each step of fineness doubles its edges.
    ///
    /// A polygon of N edges with its corners at the distance ρ has the area N/2 ρ² sin(2π/N).
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

/// A shape whose flat pieces are not where it is.
pub(crate) trait Round {
    fn center(&self) -> Vector;
    /// How far it reaches from its centre along a unit vector, relative to its radius.
    fn reach(&self, along: Vector) -> f64;
    /// Whether a segment that is not inside meets it, and by more than rounding: one that begins or ends on it does not by that.
    fn meets(&self, segment: [Vector; 2]) -> bool;
    /// How far a point is from where the pieces are off the shape.
    fn distance(&self, point: Vector) -> f64;
    fn radius(&self) -> f64;
    /// How far rounding moves the corners of the pieces along the shape.
    fn rounding(&self) -> f64;
    /// How far the pieces are off it at most.
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

    /// The distance from the rim.
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

    /// Above both (1 − cos(π/N)) r and what the corners are outside.
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

    /// Above what the middle of a triangle is inside: its edges subtend no more than those of the icosahedron, halved each time.
    fn deviation(&self, fineness: usize) -> f64 {
        let edge = 2.0_f64.atan() / f64::from(2_u32 << fineness);
        self.radius * 0.25 * edge * edge
    }
}

/// Unit vectors u and v for which u, v and this unit vector are right-handed.
pub(super) fn across(normal: Vector) -> [Vector; 2] {
    let Vector { x, y, z } = normal;
    let least = x.abs().min(y.abs()).min(z.abs());
    let axis = [x, y, z].map(|c| f64::from(u8::from(c.abs() == least)));
    let u = Vector::new(axis[0], axis[1], axis[2]).cross(normal).unit();
    let u = u.expect("an axis at a right angle, or nearly so, to a unit vector");
    [u, normal.cross(u)]
}

impl Sphere {
    /// The sphere with all lengths multiplied by this.
    pub(crate) fn scaled(self, factor: f64) -> Self {
        Self { center: factor * self.center, radius: factor * self.radius, ..self }
    }

    /// The triangles of a closed polyhedron of the sphere's area, each counter-clockwise seen from the sphere's front. Each step of fineness
    /// quarters them.
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

/// The triangles of the regular icosahedron with corners at the distance 1, counter-clockwise seen from outside: corners at the poles and on two
/// circles of latitude ±atan ½.
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

/// The triangles that halving each edge of a triangle on the unit sphere gives, with all corners on the sphere.
fn quarters([a, b, c]: [Vector; 3]) -> [[Vector; 3]; 4] {
    let middle =
        |a: Vector, b: Vector| (a + b).unit().expect("corners of an edge are not opposite each other");
    let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
    [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
}

#[cfg(test)]
mod tests;
