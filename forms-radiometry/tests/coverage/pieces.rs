//! Pieces: shapes become parallelograms, triangles, spheres, disks and sides of cones, which provide
//! intersections with rays and points on their surface.

use crate::world::Shape;
use forms_radiometry::geometry::Vector;
use std::f64::consts::{FRAC_1_PI, PI};

/// Distances below this count as zero.
pub(crate) const NEAR: f64 = 1e-7;

/// Piece of a surface that rays meet.
pub(crate) struct Piece {
    pub(crate) surface: usize,
    shape: PieceShape,
    pub(crate) area: f64,
    /// Bounding sphere.
    pub(crate) middle: Vector,
    pub(crate) reach: f64,
}

enum PieceShape {
    /// Corner, two edges, the unit normal, and whether it is a triangle.
    Flat {
        corner: Vector,
        edges: [Vector; 2],
        normal: Vector,
        is_triangle: bool,
    },
    Round {
        center: Vector,
        radius: f64,
    },
    /// Disk with a hole: centre, unit normal, and the radii of its borders.
    Disk {
        center: Vector,
        normal: Vector,
        radii: [f64; 2],
    },
    Turned(Turned),
}

/// Side of a cone or cylinder: the points at the distance r = r₀ + k z from the axis, z from 0 to the
/// height.
#[derive(Clone, Copy)]
struct Turned {
    base: Vector,
    axis: Vector,
    height: f64,
    radii: [f64; 2],
    /// 1 where the front is outside, −1 where it is inside.
    side: f64,
}

impl Turned {
    /// Returns k.
    fn slope(&self) -> f64 {
        (self.radii[1] - self.radii[0]) / self.height
    }

    /// Returns the height z of a point above the base, and the way to it from the axis.
    fn split(&self, place: Vector) -> (f64, Vector) {
        let z = self.axis.dot(place - self.base);
        (z, place - self.base - z * self.axis)
    }

    fn normal(&self, place: Vector) -> Vector {
        let outward = self.split(place).1.unit().expect("a point beside the axis") - self.slope() * self.axis;
        self.side * outward.unit().expect("a direction")
    }

    /// Returns the point where r² grows evenly with `u`, as the area does.
    fn place(&self, u: f64, v: f64) -> Vector {
        let [first, last] = self.radii;
        let radius = ((1.0 - u) * first * first + u * last * last).sqrt();
        let z = if first == last { u * self.height } else { (radius - first) / self.slope() };
        self.base + z * self.axis + radius * around(self.axis, 0.0, v)
    }

    /// Solves |o + t w|² = (r + k t wz)², with o and w beside the axis, and r the radius at the
    /// origin's height.
    fn distance(&self, origin: Vector, way: Vector) -> Option<f64> {
        let slope = self.slope();
        let (z, beside) = self.split(origin);
        let along = self.axis.dot(way);
        let across = way - along * self.axis;
        let radius = self.radii[0] + slope * z;
        let a = across.dot(across) - (slope * along).powi(2);
        let b = beside.dot(across) - slope * along * radius;
        let c = beside.dot(beside) - radius * radius;
        let root = (b * b - a * c).sqrt();
        let is_met = |&distance: &f64| {
            let met = z + distance * along;
            distance > NEAR && met >= 0.0 && met <= self.height && radius + slope * distance * along >= 0.0
        };
        [(-b - root) / a, (-b + root) / a].into_iter().filter(is_met).reduce(f64::min)
    }
}

impl Piece {
    fn flat(surface: usize, corner: Vector, edges: [Vector; 2], is_triangle: bool) -> Self {
        let across = edges[0].cross(edges[1]);
        let normal = across.unit().expect("a normal");
        let area = if is_triangle { 0.5 } else { 1.0 } * across.length();
        let corners = [corner, corner + edges[0], corner + edges[1], corner + edges[0] + edges[1]];
        let corners = if is_triangle { &corners[..3] } else { &corners };
        let sum = corners.iter().fold(Vector::new(0.0, 0.0, 0.0), |sum, &corner| sum + corner);
        let middle = (1.0 / corners.len() as f64) * sum;
        let reach =
            corners.iter().map(|&corner| (corner - middle).length()).fold(0.0, f64::max) * (1.0 + 1e-9);
        let shape = PieceShape::Flat { corner, edges, normal, is_triangle };
        Self { surface, shape, area, middle, reach }
    }

    /// Returns the point of the piece for two numbers from 0 to 1, uniformly by area, and its
    /// normal.
    pub(crate) fn place(&self, u: f64, v: f64) -> (Vector, Vector) {
        match self.shape {
            PieceShape::Flat { corner, edges: [a, b], normal, is_triangle } => {
                let (u, v) = if is_triangle && u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
                (corner + u * a + v * b, normal)
            }
            PieceShape::Round { center, radius } => {
                let normal = around(Vector::new(0.0, 0.0, 1.0), 2.0 * u - 1.0, v);
                (center + radius * normal, normal)
            }
            PieceShape::Disk { center, normal, radii: [hole, radius] } => {
                let radius = ((1.0 - u) * hole * hole + u * radius * radius).sqrt();
                (center + radius * around(normal, 0.0, v), normal)
            }
            PieceShape::Turned(turned) => {
                let place = turned.place(u, v);
                (place, turned.normal(place))
            }
        }
    }

    pub(crate) fn is_flat(&self) -> bool {
        matches!(self.shape, PieceShape::Flat { .. })
    }

    pub(crate) fn normal(&self, place: Vector) -> Vector {
        match self.shape {
            PieceShape::Flat { normal, .. } | PieceShape::Disk { normal, .. } => normal,
            PieceShape::Round { center, radius } => (1.0 / radius) * (place - center),
            PieceShape::Turned(turned) => turned.normal(place),
        }
    }

    pub(crate) fn distance(&self, origin: Vector, way: Vector) -> Option<f64> {
        match self.shape {
            PieceShape::Flat { corner, edges: [a, b], normal, is_triangle } => {
                let slope = way.dot(normal);
                let distance = (corner - origin).dot(normal) / slope;
                let place = origin + distance * way - corner;
                let whole = a.cross(b).dot(normal);
                let (u, v) = (place.cross(b).dot(normal) / whole, a.cross(place).dot(normal) / whole);
                let is_in =
                    u >= 0.0 && v >= 0.0 && if is_triangle { u + v <= 1.0 } else { u <= 1.0 && v <= 1.0 };
                (slope != 0.0 && distance > NEAR && is_in).then_some(distance)
            }
            PieceShape::Round { center, radius } => {
                let to = center - origin;
                let along = to.dot(way);
                let beside = (to - along * way).length();
                let half = (radius * radius - beside * beside).max(0.0).sqrt();
                let near = [along - half, along + half].into_iter().find(|&distance| distance > NEAR);
                near.filter(|_| beside < radius)
            }
            PieceShape::Disk { center, normal, radii: [hole, radius] } => {
                let slope = way.dot(normal);
                let distance = (center - origin).dot(normal) / slope;
                let off = (origin + distance * way - center).length();
                (slope != 0.0 && distance > NEAR && off >= hole && off <= radius).then_some(distance)
            }
            PieceShape::Turned(turned) => turned.distance(origin, way),
        }
    }
}

/// Returns the pieces of a surface that has a shape.
pub(crate) fn pieces(surface: usize, shape: &Shape) -> Vec<Piece> {
    match shape {
        Shape::Rectangle([corner, a, b]) => vec![Piece::flat(surface, *corner, [*a, *b], false)],
        Shape::Mesh(triangles) => {
            triangles.iter().map(|&[a, b, c]| Piece::flat(surface, a, [b - a, c - a], true)).collect()
        }
        &Shape::Sphere { center, radius } => {
            let shape = PieceShape::Round { center, radius };
            let area = 4.0 * PI * radius * radius;
            vec![Piece { surface, shape, area, middle: center, reach: radius }]
        }
        &Shape::Disk { center, normal, hole, radius } => {
            let normal = normal.unit().expect("a direction");
            let shape = PieceShape::Disk { center, normal, radii: [hole, radius] };
            let area = PI * (radius * radius - hole * hole);
            vec![Piece { surface, shape, area, middle: center, reach: radius }]
        }
        &Shape::Turned { ends: [base, top], radii, is_inward } => {
            let height = (top - base).length();
            let axis = (1.0 / height) * (top - base);
            let side = if is_inward { -1.0 } else { 1.0 };
            let shape = PieceShape::Turned(Turned { base, axis, height, radii, side });
            let area = PI * (radii[0] + radii[1]) * height.hypot(radii[1] - radii[0]);
            let reach = (0.5 * height).hypot(radii[0].max(radii[1]));
            vec![Piece { surface, shape, area, middle: 0.5 * (base + top), reach }]
        }
    }
}

/// Returns the direction at this cosine from an axis, rotated around it by a part of a turn.
pub(crate) fn around(axis: Vector, cosine: f64, turn: f64) -> Vector {
    let least = if axis.x.abs() < 0.6 { Vector::new(1.0, 0.0, 0.0) } else { Vector::new(0.0, 1.0, 0.0) };
    let a = axis.cross(least).unit().expect("across");
    let b = axis.cross(a);
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    let (sin, cos) = (2.0 * PI * turn).sin_cos();
    cosine * axis + (sine * cos) * a + (sine * sin) * b
}

/// Returns a direction distributed like its cosine, and its density.
pub(crate) fn cosine_direction(normal: Vector, u: f64, v: f64) -> (Vector, f64) {
    let cosine = (1.0 - u).sqrt();
    (around(normal, cosine, v), cosine * FRAC_1_PI)
}
