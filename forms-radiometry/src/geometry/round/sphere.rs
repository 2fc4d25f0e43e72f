//! Spheres, and the closed polyhedra that approximate them.

use super::{ROUNDING, Round, WITHIN};
use crate::geometry::Vector;
use std::f64::consts::PI;

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

impl Sphere {
    /// Returns the sphere with all lengths multiplied by this factor.
    pub(crate) fn scaled(self, factor: f64) -> Self {
        Self { center: factor * self.center, radius: factor * self.radius, ..self }
    }

    pub(crate) fn area(&self) -> f64 {
        4.0 * PI * self.radius * self.radius
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
