//! Planar polygons: a list of vertices is checked and becomes a polygon with a normal and convex
//! pieces. Other polygons and disks in its plane can be subtracted from it ([`difference`],
//! [`round_holes`]); the pieces then cover the remainder.

mod difference;
mod round_holes;

pub(crate) use difference::intersection;

use super::plane::ROUNDING;
use super::scale::{LARGEST_LENGTH, LEAST_LENGTH, lengths, power_of_two};
use super::triangulation::{triangulate, turn};
use super::{Disk, Vector};
use std::fmt;

/// Largest accepted distance of a vertex from the polygon's plane, as a fraction of the polygon's
/// extent.
pub(crate) const PLANARITY: f64 = 1e-6;

/// A simple planar polygon, counter-clockwise seen from its front, minus the holes that were cut
/// into it.
#[derive(Clone, Debug)]
pub struct Polygon {
    vertices: Vec<Vector>,
    normal: Vector,
    pieces: Vec<Vec<Vector>>,
    /// The outlines of the holes, also counter-clockwise.
    holes: Vec<Vec<Vector>>,
    round_holes: Vec<Disk>,
    /// The pieces before round holes are cut; empty if there are no round holes.
    straight: Vec<Vec<Vector>>,
}

/// Reason why a list of vertices is not a valid polygon. Vertices are counted from one.
#[derive(Clone, Debug, PartialEq)]
pub enum PolygonError {
    /// Fewer than three vertices.
    TooFewVertices(usize),
    /// Coordinates that are not finite, too large, or too close together for `f64` arithmetic.
    OutOfRange,
    /// This vertex and the one after it are the same point.
    RepeatedVertex(usize),
    /// All vertices lie on one line, or the enclosed areas cancel.
    NoArea,
    /// This vertex lies off the plane of the others.
    NotPlanar {
        /// The vertex farthest off the plane.
        vertex: usize,
        /// Its distance from the plane.
        distance: f64,
        /// The largest accepted distance.
        accepted: f64,
    },
    /// The edges that start at these two vertices cross.
    Crossing(usize, usize),
}

impl fmt::Display for PolygonError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFewVertices(count) => {
                write!(f, "a polygon needs at least three vertices, found {count}")
            }
            Self::OutOfRange => write!(f, "the polygon's coordinates are too large or too small"),
            Self::RepeatedVertex(vertex) => write!(f, "vertex {vertex} and the next vertex coincide"),
            Self::NoArea => write!(f, "the polygon encloses no area"),
            Self::NotPlanar { vertex, distance, accepted } => {
                write!(
                    f,
                    "the polygon is not planar: vertex {vertex} is {distance:.3e} away from its plane "
                )?;
                write!(f, "(tolerance: {accepted:.1e})")
            }
            Self::Crossing(a, b) => write!(f, "the edges from vertex {a} and from vertex {b} cross"),
        }
    }
}

impl std::error::Error for PolygonError {}

impl Polygon {
    /// Creates the polygon with these vertices, which must be planar within 10⁻⁶ of its extent and
    /// without self-intersections.
    pub fn new(vertices: Vec<Vector>) -> Result<Self, PolygonError> {
        if vertices.len() < 3 {
            return Err(PolygonError::TooFewVertices(vertices.len()));
        }
        let repeated = |i: &usize| vertices[*i] == vertices[(i + 1) % vertices.len()];
        if let Some(i) = (0..vertices.len()).find(repeated) {
            return Err(PolygonError::RepeatedVertex(i + 1));
        }
        let normal = checked_normal(&vertices)?;
        let near = near_one(&vertices);
        if let Some((i, j)) = crossing_edges(&near, normal) {
            return Err(PolygonError::Crossing(i + 1, j + 1));
        }
        let pieces = if is_convex(&near, normal) {
            vec![vertices.clone()]
        } else {
            let triangle = |corners: [usize; 3]| corners.map(|i| vertices[i]).to_vec();
            triangulate(&near, normal).into_iter().map(triangle).collect()
        };
        Ok(Self {
            vertices,
            normal,
            pieces,
            holes: Vec::new(),
            round_holes: Vec::new(),
            straight: Vec::new(),
        })
    }

    /// Returns the polygon with all coordinates multiplied by a power of two, which rounds nothing.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        let scaled = |outline: &Vec<Vector>| outline.iter().map(|&v| factor * v).collect();
        Self {
            vertices: scaled(&self.vertices),
            normal: self.normal,
            pieces: self.pieces.iter().map(scaled).collect(),
            holes: self.holes.iter().map(scaled).collect(),
            round_holes: self.round_holes.iter().map(|disk| disk.scaled(factor)).collect(),
            straight: self.straight.iter().map(scaled).collect(),
        }
    }

    /// Returns the largest coordinate, and the extent.
    pub(crate) fn lengths(&self) -> [f64; 2] {
        lengths(&self.vertices)
    }

    /// Returns the vertices of the outline, counter-clockwise seen from the front. Holes do not
    /// change them.
    pub fn vertices(&self) -> &[Vector] {
        &self.vertices
    }

    /// Returns the unit normal, which points to the front.
    pub fn normal(&self) -> Vector {
        self.normal
    }

    /// Returns the polygon with front and back swapped.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let turned = |outline: &Vec<Vector>| outline.iter().rev().copied().collect();
        Self {
            vertices: turned(&self.vertices),
            normal: -self.normal,
            pieces: self.pieces.iter().map(turned).collect(),
            holes: self.holes.iter().map(turned).collect(),
            round_holes: self.round_holes.iter().map(|disk| disk.reversed()).collect(),
            straight: self.straight.iter().map(turned).collect(),
        }
    }

    /// Returns the area minus the holes.
    pub fn area(&self) -> f64 {
        if self.holes.is_empty() && self.round_holes.is_empty() {
            return area(&self.vertices, self.normal);
        }
        self.pieces.iter().map(|piece| area(piece, self.normal)).sum()
    }

    /// Returns the outlines of its polygonal holes, counter-clockwise seen from the front.
    pub(crate) fn holes(&self) -> &[Vec<Vector>] {
        &self.holes
    }

    /// Returns convex polygons that cover this one minus its holes without overlap: the polygon
    /// itself, triangles, or pieces around the holes. Each has the orientation of the polygon.
    pub fn convex_pieces(&self) -> &[Vec<Vector>] {
        &self.pieces
    }
}

/// Returns the edges of an outline, each from a vertex to the next.
pub(crate) fn edges<T: Copy>(outline: &[T]) -> impl Iterator<Item = [T; 2]> {
    let next = outline.iter().skip(1).chain(outline.first());
    outline.iter().zip(next).map(|(&a, &b)| [a, b])
}

/// Returns the area of an outline with this unit normal: ½ n·Σ (vᵢ − v₀) × (vᵢ₊₁ − v₀).
pub(crate) fn area(outline: &[Vector], normal: Vector) -> f64 {
    let [about, ..] = outline else { return 0.0 };
    let corner = |pair: &[Vector]| (pair[0] - *about).cross(pair[1] - *about);
    0.5 * outline.windows(2).map(corner).map(|twice| normal.dot(twice)).sum::<f64>()
}

/// Returns the vertices multiplied by a power of two, so that the largest coordinate is near 1:
/// products of such lengths neither overflow nor underflow.
pub(super) fn near_one(vertices: &[Vector]) -> Vec<Vector> {
    let unit = power_of_two(vertices.iter().fold(0.0, |m: f64, v| m.max(v.largest())));
    vertices.iter().map(|&v| unit.recip() * v).collect()
}

/// Computes Newell's normal N = ½ Σ vᵢ × vᵢ₊₁ about the first vertex, whose length is the area, and
/// checks that the vertices are planar.
fn checked_normal(vertices: &[Vector]) -> Result<Vector, PolygonError> {
    let [largest, extent] = lengths(vertices);
    if !(largest <= LARGEST_LENGTH && extent >= LEAST_LENGTH) {
        return Err(PolygonError::OutOfRange);
    }
    let origin = vertices[0];
    let scaled: Vec<Vector> = vertices.iter().map(|&v| (1.0 / extent) * (v - origin)).collect();
    let doubled = scaled.windows(2).fold(Vector::default(), |sum, pair| sum + pair[0].cross(pair[1]));
    let normal = doubled.unit().filter(|_| doubled.length() > PLANARITY * PLANARITY);
    let normal = normal.ok_or(PolygonError::NoArea)?;
    let count = vertices.len() as f64;
    let centre = (1.0 / count) * scaled.iter().fold(Vector::default(), |sum, &v| sum + v);
    let distance = |v: Vector| normal.dot(v - centre).abs();
    let (vertex, farthest) = scaled
        .iter()
        .map(|&v| distance(v))
        .enumerate()
        .max_by(|a, b| a.1.total_cmp(&b.1))
        .expect("a polygon has three vertices or more");
    if farthest > PLANARITY {
        return Err(PolygonError::NotPlanar {
            vertex: vertex + 1,
            distance: farthest * extent,
            accepted: PLANARITY * extent,
        });
    }
    Ok(normal)
}

fn is_convex(vertices: &[Vector], normal: Vector) -> bool {
    let count = vertices.len();
    (0..count).all(|i| turn(vertices[i], vertices[(i + 1) % count], vertices[(i + 2) % count], normal) >= 0.0)
}

/// Finds two edges that are not adjacent and have a point in common.
pub(super) fn crossing_edges(vertices: &[Vector], normal: Vector) -> Option<(usize, usize)> {
    let count = vertices.len();
    let edge = |i: usize| (vertices[i], vertices[(i + 1) % count]);
    for i in 0..count {
        for j in i + 2..count {
            if (j + 1) % count != i && cross(edge(i), edge(j), normal) {
                return Some((i, j));
            }
        }
    }
    None
}

/// Whether each of the two edges separates the end points of the other, or passes through one.
/// Coordinates are near 1. Of edges on one line, up to rounding, neither does if they are apart.
fn cross((a, b): (Vector, Vector), (c, d): (Vector, Vector), normal: Vector) -> bool {
    let (c_side, d_side) = (turn(a, b, c, normal), turn(a, b, d, normal));
    let (a_side, b_side) = (turn(c, d, a, normal), turn(c, d, b, normal));
    let (along, off) = (b - a, c_side.abs().max(d_side.abs()));
    if off <= ROUNDING * along.length() {
        let (low, high) = (along.dot(c - a).min(along.dot(d - a)), along.dot(c - a).max(along.dot(d - a)));
        let overlap = high >= 0.0 && low <= along.dot(along);
        if off == 0.0 || !overlap {
            return overlap;
        }
    }
    let separates = |s: f64, t: f64| (s <= 0.0 && t >= 0.0) || (s >= 0.0 && t <= 0.0);
    separates(c_side, d_side) && separates(a_side, b_side)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flat(points: &[(f64, f64)]) -> Vec<Vector> {
        points.iter().map(|&(x, y)| Vector::new(x, y, 0.0)).collect()
    }

    #[test]
    fn what_is_no_polygon_is_refused_with_its_reason() {
        use PolygonError::{Crossing, NoArea, RepeatedVertex, TooFewVertices};
        let cases = [
            ("two vertices", vec![(0.0, 0.0), (1.0, 0.0)], TooFewVertices(2)),
            ("a repeated vertex", vec![(0.0, 0.0), (1.0, 0.0), (1.0, 0.0), (0.0, 1.0)], RepeatedVertex(2)),
            ("a line", vec![(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)], NoArea),
            ("a bow tie", vec![(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 1.0)], Crossing(1, 3)),
        ];
        for (name, points, expected) in cases {
            assert_eq!(Polygon::new(flat(&points)).map(|_| ()), Err(expected), "{name}");
        }
    }

    #[test]
    fn a_vertex_off_the_plane_is_refused_beyond_a_millionth_of_the_extent() {
        let raised = |height: f64| {
            let mut square = flat(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
            square[2].z = height;
            Polygon::new(square)
        };
        assert!(raised(1e-7).is_ok());
        assert!(matches!(raised(1e-5), Err(PolygonError::NotPlanar { .. })));
    }

    #[test]
    fn convex_pieces_have_the_area_of_the_polygon() {
        let cases = [
            ("square", vec![(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)], 1, 1.0),
            ("square with a vertex in an edge", vec![(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (0.0, 2.0)], 1, 2.0),
            ("arrow", vec![(0.0, 0.0), (2.0, 0.0), (0.5, 0.5), (0.0, 2.0)], 2, 1.0),
            (
                "U",
                vec![
                    (0.0, 0.0),
                    (3.0, 0.0),
                    (3.0, 3.0),
                    (2.0, 3.0),
                    (2.0, 1.0),
                    (1.0, 1.0),
                    (1.0, 3.0),
                    (0.0, 3.0),
                ],
                6,
                7.0,
            ),
        ];
        for (name, points, count, expected) in cases {
            let polygon = Polygon::new(flat(&points)).unwrap_or_else(|error| panic!("{name}: {error}"));
            assert_eq!(polygon.convex_pieces().len(), count, "{name}");
            let areas: Vec<f64> =
                polygon.convex_pieces().iter().map(|piece| area(piece, polygon.normal())).collect();
            assert!(areas.iter().all(|&area| area > 0.0), "{name}");
            let sum: f64 = areas.iter().sum();
            assert!((sum - expected).abs() < 1e-14, "{name}: {sum}");
        }
    }

    /// Vertices and diagonals of such shapes lie on common lines, of which rounding takes them off.
    #[test]
    fn shapes_on_a_grid_keep_their_area_in_every_position() {
        let shapes: [(&str, &[[i32; 2]]); 4] = [
            ("L", &[[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]]),
            ("stairs", &[[0, 0], [3, 0], [3, 1], [2, 1], [2, 2], [1, 2], [1, 3], [0, 3]]),
            (
                "plus",
                &[
                    [1, 0],
                    [2, 0],
                    [2, 1],
                    [3, 1],
                    [3, 2],
                    [2, 2],
                    [2, 3],
                    [1, 3],
                    [1, 2],
                    [0, 2],
                    [0, 1],
                    [1, 1],
                ],
            ),
            (
                "comb",
                &[
                    [0, 0],
                    [5, 0],
                    [5, 2],
                    [4, 2],
                    [4, 1],
                    [3, 1],
                    [3, 2],
                    [2, 2],
                    [2, 1],
                    [1, 1],
                    [1, 2],
                    [0, 2],
                ],
            ),
        ];
        let mut random = forms_testing::SplitMix(1);
        for (number, (name, grid)) in shapes.iter().cycle().take(2000).enumerate() {
            let digits: f64 = if number % 8 < 4 { 10.0 } else { 1e17 };
            let mut vector = || {
                let [x, y, z] = [0; 3].map(|_| (digits * 8.0 * (random.unit() - 0.5)).round() / digits);
                Vector::new(x, y, z)
            };
            let [origin, u, v] = [vector(), vector(), vector()];
            let corner = |&[i, j]: &[i32; 2]| origin + f64::from(i) * u + f64::from(j) * v;
            if u.cross(v).length() < 0.1 * u.length() * v.length() {
                continue;
            }
            let vertices: Vec<Vector> = grid.iter().map(corner).collect();
            let polygon =
                Polygon::new(vertices.clone()).unwrap_or_else(|e| panic!("{name} {vertices:?}: {e}"));
            let sum: f64 = polygon.convex_pieces().iter().map(|piece| area(piece, polygon.normal())).sum();
            let expected = polygon.area();
            assert!((sum - expected).abs() < 1e-12 * expected, "{name} {vertices:?}: {sum}, not {expected}");
        }
    }
}
