//! Elements: faces become triangles and parallelograms, with the nodes at which irradiance is
//! known. Elements are divided into smaller ones.

use super::contact::ConvexPiece;
use super::reference::{MOST_NODES, Reference, Shape, reference};
use crate::geometry::Vector;
use crate::visibility::Face;
use forms_kernels::uniform_triangle_sample;

/// Polynomials on elements have degrees below this, where memory allows.
pub(super) const HIGHEST_ORDER: usize = 3;
/// Maximum ratio of length to width of an element, where it can be cut.
const LONGEST: f64 = 2.0;

/// Position of the cut next to a side from which another face rises. Irradiance there is like a
/// power xᵝ with 0 < β < 1 of the distance. Polynomials on parts that shrink fast towards the side
/// converge fast to it.
///
/// Source: W. Gui, I. Babuška, The h, p and h-p versions of the finite element method in one
/// dimension, part II (1986).
const CREASE: f64 = 0.2;
/// Position of the cuts where other faces rise from both sides.
const CREASES: f64 = 0.15;

/// Maximum distance outside an element at which a point counts as on it, in the element's
/// coordinates.
const BESIDE: f64 = 1e-9;
/// Tolerance for the fourth corner of a parallelogram, relative to the length of its edges.
const PARALLEL: f64 = 1e-12;

/// A triangle or a parallelogram of a face: x(u, v) = corner + u along + v across.
#[derive(Clone, Debug)]
pub(super) struct Element {
    /// The face that it is part of.
    pub(super) face: usize,
    pub(super) shape: Shape,
    /// Polynomials on it have a degree below this.
    pub(super) order: usize,
    corner: Vector,
    along: Vector,
    across: Vector,
    /// The unit normal of its face.
    pub(super) normal: Vector,
    pub(super) area: f64,
    /// Vectors whose dot products with the offset of a point from the corner are its coordinates
    /// along and across.
    dual: [Vector; 2],
    /// For a parallelogram: whether another face rises from the side where each coordinate is 0,
    /// and where it is 1.
    creases: [[bool; 2]; 2],
}

impl Element {
    fn new(face: usize, shape: Shape, normal: Vector, [corner, along, across]: [Vector; 3]) -> Self {
        let twice = normal.dot(along.cross(across));
        let dual = [(1.0 / twice) * across.cross(normal), (1.0 / twice) * normal.cross(along)];
        let area = if shape == Shape::Triangle { 0.5 * twice } else { twice };
        let creases = [[false; 2]; 2];
        Self { face, shape, order: HIGHEST_ORDER, corner, along, across, normal, area, dual, creases }
    }

    /// Returns the initial elements of a convex piece of a face: a parallelogram if the piece is
    /// one, otherwise triangles.
    pub(super) fn of(index: usize, face: &Face, piece: &ConvexPiece) -> Vec<Self> {
        let element = |shape, corners| Self::new(index, shape, face.normal, corners);
        let mut elements = Vec::new();
        let v = &piece.outline;
        if let [a, b, c, d] = v[..] {
            let (along, across) = (b - a, d - a);
            if ((a - b) + (c - d)).largest() <= PARALLEL * along.largest().max(across.largest()) {
                let side = |number: usize| piece.creases[number];
                let creases = [[side(3), side(1)], [side(0), side(2)]];
                elements.push(Self { creases, ..element(Shape::Square, [a, along, across]) });
            }
        }
        if elements.is_empty() {
            let fan = v[1..].windows(2).map(|pair| [v[0], pair[0] - v[0], pair[1] - v[0]]);
            // a triangle whose area is no more than rounding relative to its face has no
            // coordinates
            let is_some = |[_, along, across]: &[Vector; 3]| {
                face.normal.dot(along.cross(*across)) > f64::EPSILON * face.area
            };
            let fan = fan.filter(is_some);
            elements.extend(fan.map(|corners| element(Shape::Triangle, corners)));
        }
        elements.into_iter().flat_map(Self::into_compact).collect()
    }

    /// Splits an element into parts that are not much longer than wide.
    fn into_compact(self) -> Vec<Self> {
        if self.shape == Shape::Triangle {
            return vec![self];
        }
        let [along, across] = [self.along.length(), self.across.length()];
        let parts = |ratio: f64| (ratio / LONGEST).ceil().clamp(1.0, 64.0) as usize;
        let (columns, rows) = (parts(along / across), parts(across / along));
        let equal = |count: usize| (0..=count).map(|part| part as f64 / count as f64).collect::<Vec<_>>();
        self.cut([&equal(columns), &equal(rows)])
    }

    /// Returns the coordinates in which the element can be divided: a triangle is divided in both
    /// at once.
    pub(super) fn is_divisible(&self) -> [bool; 2] {
        [true, self.shape == Shape::Square]
    }

    /// Returns the parts of the element when some coordinates are divided: a triangle into four of
    /// half the size, a side of a parallelogram in the middle, or near those ends from which
    /// another face rises.
    pub(super) fn divided(&self, is_divided: [bool; 2]) -> Vec<Self> {
        match self.shape {
            Shape::Triangle => self.quarters().to_vec(),
            Shape::Square => self.cut(self.cuts(is_divided)),
        }
    }

    /// Returns the number of these parts.
    pub(super) fn part_count(&self, is_divided: [bool; 2]) -> usize {
        match self.shape {
            Shape::Triangle if is_divided == [false; 2] => 1,
            Shape::Triangle => 4,
            Shape::Square => self.cuts(is_divided).map(|cuts| cuts.len() - 1).iter().product(),
        }
    }

    /// Returns the cuts of the sides of a parallelogram, in its coordinates.
    fn cuts(&self, is_divided: [bool; 2]) -> [&'static [f64]; 2] {
        [0, 1].map(|coordinate| -> &[f64] {
            match (is_divided[coordinate], self.creases[coordinate]) {
                (false, _) => &[0.0, 1.0],
                (true, [false, false]) => &[0.0, 0.5, 1.0],
                (true, [true, false]) => &[0.0, CREASE, 1.0],
                (true, [false, true]) => &[0.0, 1.0 - CREASE, 1.0],
                (true, [true, true]) => &[0.0, CREASES, 1.0 - CREASES, 1.0],
            }
        })
    }

    /// Returns the parts of a parallelogram between these values of its coordinates, row by row.
    fn cut(&self, [columns, rows]: [&[f64]; 2]) -> Vec<Self> {
        let mut parts = Vec::with_capacity((columns.len() - 1) * (rows.len() - 1));
        for (j, v) in rows.windows(2).enumerate() {
            for (i, u) in columns.windows(2).enumerate() {
                let corner = self.corner + u[0] * self.along + v[0] * self.across;
                let [along, across] = [(u[1] - u[0]) * self.along, (v[1] - v[0]) * self.across];
                let ends = |sides: [bool; 2], index: usize, count: usize| {
                    [sides[0] && index == 0, sides[1] && index + 1 == count]
                };
                let [of_u, of_v] = self.creases;
                let creases = [ends(of_u, i, columns.len() - 1), ends(of_v, j, rows.len() - 1)];
                let part = Self::new(self.face, self.shape, self.normal, [corner, along, across]);
                parts.push(Self { order: self.order, creases, ..part });
            }
        }
        parts
    }

    /// Returns the length along each coordinate.
    pub(super) fn extent(&self) -> [f64; 2] {
        [self.along.length(), self.across.length()]
    }

    /// Returns the four parts of half the size of a triangle.
    fn quarters(&self) -> [Self; 4] {
        let [along, across] = [0.5 * self.along, 0.5 * self.across];
        let at = |u: f64, v: f64| self.corner + u * along + v * across;
        let part = |corner, along, across| {
            let part = Self::new(self.face, self.shape, self.normal, [corner, along, across]);
            Self { order: self.order, ..part }
        };
        [
            part(at(0.0, 0.0), along, across),
            part(at(1.0, 0.0), along, across),
            part(at(0.0, 1.0), along, across),
            part(at(1.0, 1.0), -along, -across),
        ]
    }

    /// Returns the image of a point of the unit square on the element; the map preserves area
    /// ratios.
    pub(super) fn image(&self, [u, v]: [f64; 2]) -> Vector {
        let [u, v] = if self.shape == Shape::Triangle { uniform_triangle_sample(u, v) } else { [u, v] };
        self.corner + u * self.along + v * self.across
    }

    pub(super) fn reference(&self) -> &'static Reference {
        reference(self.shape, self.order)
    }

    /// Returns the number of nodes.
    pub(super) fn count(&self) -> usize {
        self.reference().nodes.len()
    }

    /// Returns the number of nodes with polynomials of no higher order than this.
    pub(super) fn count_with(&self, order: usize) -> usize {
        reference(self.shape, self.order.min(order)).nodes.len()
    }

    /// Returns the positions of the nodes.
    pub(super) fn nodes(&self) -> impl Iterator<Item = Vector> {
        self.reference().nodes.iter().map(|&[u, v]| self.corner + u * self.along + v * self.across)
    }

    /// Returns the area of each node.
    pub(super) fn areas(&self) -> impl Iterator<Item = f64> {
        self.reference().weights.iter().map(|weight| weight * self.area)
    }

    /// Returns the corners, counter-clockwise seen from the front.
    pub(super) fn outline(&self) -> Vec<Vector> {
        let (a, b, d) = (self.corner, self.corner + self.along, self.corner + self.across);
        match self.shape {
            Shape::Triangle => vec![a, b, d],
            Shape::Square => vec![a, b, b + self.across, d],
        }
    }

    /// Returns the values of the nodes' polynomials at a point of the plane of the element.
    pub(super) fn basis(&self, point: Vector) -> [f64; MOST_NODES] {
        self.reference().basis(self.coordinates(point))
    }

    /// Whether a point of its plane lies on the element, or just outside it.
    pub(super) fn contains(&self, point: Vector) -> bool {
        let [u, v] = self.coordinates(point);
        let beyond = match self.shape {
            Shape::Triangle => u + v - 1.0,
            Shape::Square => u.max(v) - 1.0,
        };
        beyond.max(-u).max(-v) <= BESIDE
    }

    fn coordinates(&self, point: Vector) -> [f64; 2] {
        let way = point - self.corner;
        [self.dual[0].dot(way), self.dual[1].dot(way)]
    }
}
