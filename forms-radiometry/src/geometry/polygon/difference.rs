//! Difference of polygons: subtracts coplanar polygons from a polygon and splits the remainder into
//! convex pieces.
//!
//! ```text
//! convex piece ─ line of an edge of a convex hole ─┬─ beyond it: a piece of the remainder
//!                                                  └─ rest ─▶ next edge … ─▶ inside all: dropped
//! ```
//! The lines of a convex hole cut a convex piece into convex pieces, no more than the hole has
//! edges. The pieces do not overlap, and their areas plus the area of the hole add up to the area
//! of the piece. Round holes are cut last ([`round_holes`](super::round_holes)).

use super::{Polygon, edges};
use crate::geometry::Vector;
use crate::geometry::clip::split_along;

impl Polygon {
    /// Returns this polygon minus the coplanar polygons `holes`, which face the same way; `None` if
    /// they cover it. Parts that are narrower than the resolution count as rounding and are not cut
    /// off.
    pub(crate) fn without(&self, holes: &[Self], resolution: f64) -> Option<Self> {
        let mut pieces = self.pieces.clone();
        for hole in holes.iter().flat_map(Self::convex_pieces) {
            let left = |piece: Vec<Vector>| difference(piece, hole, self.normal, resolution);
            pieces = pieces.into_iter().flat_map(left).collect();
        }
        let outlines = holes.iter().map(|hole| hole.vertices.clone());
        let holes = self.holes.iter().cloned().chain(outlines).collect();
        (!pieces.is_empty()).then(|| Self { pieces, holes, ..self.clone() })
    }
}

/// Returns the intersection of a convex outline with another one that has this unit normal,
/// projected along the normal; no vertices if it has no area.
pub(crate) fn intersection(outline: &[Vector], other: &[Vector], normal: Vector) -> Vec<Vector> {
    split_along_edges(outline, edges(other), normal, 0.0).1
}

/// Returns the convex pieces of a convex piece minus a convex hole.
pub(super) fn difference(
    piece: Vec<Vector>,
    hole: &[Vector],
    normal: Vector,
    resolution: f64,
) -> Vec<Vec<Vector>> {
    if split_along_edges(&piece, edges(hole), normal, resolution).1.is_empty() {
        return vec![piece];
    }
    // a segment from a point outside the hole to a point inside crosses an edge within the piece
    let crossing = edges(hole).filter(|edge| length_inside(*edge, &piece, normal) > resolution);
    let (mut outside, _) = split_along_edges(&piece, crossing, normal, resolution);
    outside.iter_mut().for_each(|piece| snap(piece, hole, resolution));
    outside
}

/// Splits a convex outline along the lines of edges with this unit normal: see [`split_along`].
pub(super) fn split_along_edges(
    outline: &[Vector],
    edges: impl Iterator<Item = [Vector; 2]>,
    normal: Vector,
    resolution: f64,
) -> (Vec<Vec<Vector>>, Vec<Vector>) {
    split_along(outline, edges.map(|edge| (inward(edge, normal), resolution)))
}

/// Returns the length of the part of an edge that lies in a convex outline.
fn length_inside([a, b]: [Vector; 2], outline: &[Vector], normal: Vector) -> f64 {
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for side in edges(outline) {
        let [start, end] = [a, b].map(inward(side, normal));
        let crossing = start / (start - end);
        match [start > 0.0, end > 0.0] {
            [true, true] => {}
            [false, false] => return 0.0,
            [true, false] => to = to.min(crossing),
            [false, true] => from = from.max(crossing),
        }
    }
    (to - from).max(0.0) * (b - a).length()
}

/// Moves vertices of a cut that lie next to a vertex of the hole onto it, so that no gap is left
/// between the piece and the hole.
fn snap(piece: &mut Vec<Vector>, hole: &[Vector], resolution: f64) {
    for vertex in piece.iter_mut() {
        if let Some(&corner) = hole.iter().find(|&&corner| (corner - *vertex).length() <= resolution) {
            *vertex = corner;
        }
    }
    piece.dedup();
    if piece.len() > 1 && piece.first() == piece.last() {
        piece.pop();
    }
}

/// Returns the signed distance of points from the line of an edge, positive on the side of its
/// polygon.
fn inward([a, b]: [Vector; 2], normal: Vector) -> impl Fn(Vector) -> f64 {
    let across = normal.cross(b - a).unit().unwrap_or_default();
    move |point| across.dot(point - a)
}

#[cfg(test)]
mod tests {
    use super::super::area;
    use super::*;
    use forms_testing::SplitMix;

    /// Distances below this count as rounding.
    const RESOLUTION: f64 = 1e-9;

    fn polygon(corners: &[[f64; 2]]) -> Polygon {
        Polygon::new(corners.iter().map(|&[x, y]| Vector::new(x, y, 0.0)).collect()).expect("a polygon")
    }

    fn rectangle([left, low]: [f64; 2], [right, high]: [f64; 2]) -> Polygon {
        polygon(&[[left, low], [right, low], [right, high], [left, high]])
    }

    fn common_area(a: &Polygon, b: &Polygon) -> f64 {
        let pairs = a.pieces.iter().flat_map(|own| b.pieces.iter().map(move |other| (own, other)));
        pairs.map(|(own, other)| area(&intersection(own, other, b.normal), a.normal)).sum()
    }

    fn area_of(polygon: Option<Polygon>) -> f64 {
        polygon.map_or(0.0, |polygon| polygon.area())
    }

    #[test]
    fn a_wall_without_holes_has_its_area_less_theirs() {
        let wall = || rectangle([0.0, 0.0], [4.0, 3.0]);
        let l = || polygon(&[[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]]);
        let cases: [(&str, Polygon, Vec<Polygon>, f64, usize); 9] = [
            ("none", wall(), vec![], 12.0, 1),
            ("inside", wall(), vec![rectangle([1.0, 1.0], [3.0, 2.5])], 9.0, 4),
            ("at an edge", wall(), vec![rectangle([1.0, 0.0], [2.0, 2.0])], 10.0, 3),
            ("in a corner", wall(), vec![rectangle([0.0, 0.0], [2.0, 2.0])], 8.0, 2),
            ("from edge to edge", wall(), vec![rectangle([1.0, 0.0], [2.0, 3.0])], 9.0, 2),
            (
                "two with an edge in common",
                wall(),
                vec![rectangle([1.0, 1.0], [2.0, 2.0]), rectangle([2.0, 1.0], [3.0, 2.0])],
                10.0,
                5,
            ),
            ("all of it", wall(), vec![wall()], 0.0, 0),
            ("elsewhere", wall(), vec![rectangle([5.0, 1.0], [6.0, 2.0])], 12.0, 1),
            ("of a wall that is not convex", l(), vec![rectangle([0.25, 0.25], [0.75, 2.0])], 5.125, 8),
        ];
        for (name, wall, holes, expected, count) in cases {
            let left = wall.without(&holes, RESOLUTION);
            let pieces = left.as_ref().map_or(0, |left| left.convex_pieces().len());
            let area = area_of(left);
            assert!((area - expected).abs() < 1e-14, "{name}: {area}");
            assert_eq!(pieces, count, "{name}");
        }
    }

    #[test]
    fn holes_that_are_not_convex_and_turned_walls_lose_the_same_area() {
        let star =
            [[2.0, 0.5], [2.2, 1.2], [3.0, 1.5], [2.2, 1.7], [2.0, 2.5], [1.8, 1.7], [1.0, 1.5], [1.8, 1.2]];
        let mut numbers = SplitMix(7);
        let mut number = || numbers.unit();
        for _ in 0..100 {
            let axis = |x: f64, y: f64, z: f64| Vector::new(x, y, z).unit().expect("a direction");
            let u = axis(number() - 0.5, number() - 0.5, number() - 0.5);
            let v = u.cross(axis(number(), number(), number() - 2.0)).unit().expect("a direction");
            let at = 10.0 * Vector::new(number(), number(), number());
            let place = |&[x, y]: &[f64; 2]| at + x * u + y * v;
            let [wall, hole] = [&[[0.0, 0.0], [4.0, 0.0], [5.0, 3.0], [0.0, 3.0]][..], &star]
                .map(|corners| Polygon::new(corners.iter().map(place).collect()).expect("a polygon"));
            let left = wall.without(std::slice::from_ref(&hole), RESOLUTION).expect("most of the wall");
            assert!((left.area() + hole.area() - wall.area()).abs() < 1e-13 * wall.area());
            let [of_wall, of_left] = [&wall, &left].map(|polygon| common_area(polygon, &hole));
            assert!((of_wall - hole.area()).abs() < 1e-13 * wall.area() && of_left < 1e-13, "{of_left}");
            assert_eq!(left.vertices(), wall.vertices());
        }
    }

    #[test]
    fn a_strip_narrower_than_the_resolution_is_not_cut_off() {
        let wall = rectangle([0.0, 0.0], [4.0, 3.0]);
        let hole = |margin: f64| rectangle([margin, margin], [2.0, 3.0 - margin]);
        assert_eq!(
            wall.without(&[hole(1e-10)], RESOLUTION).expect("the other half").convex_pieces().len(),
            1
        );
        assert_eq!(
            wall.without(&[hole(1e-3)], RESOLUTION).expect("all but the hole").convex_pieces().len(),
            4
        );
        let whole = rectangle([-1e-10, 1e-10], [4.0, 3.0]);
        assert!(wall.without(&[whole], RESOLUTION).is_none());
    }

    #[test]
    fn corners_of_pieces_at_a_hole_are_those_of_the_hole_to_the_last_bit() {
        let wall = rectangle([0.0, 0.0], [3.0, 3.1]);
        let hole = polygon(&[[0.7, 0.9], [2.1, 1.1], [1.9, 2.3], [0.3, 1.7]]);
        let left = wall.without(std::slice::from_ref(&hole), RESOLUTION).expect("most of the wall");
        for corner in hole.vertices() {
            let near = |vertex: &&Vector| (**vertex - *corner).length() < 1e-6;
            let vertices: Vec<&Vector> = left.convex_pieces().iter().flatten().filter(near).collect();
            assert!(!vertices.is_empty() && vertices.iter().all(|vertex| *vertex == corner), "{corner:?}");
        }
    }
}
