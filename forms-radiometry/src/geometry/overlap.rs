//! Overlap of flat shapes: computes the area of the intersection of polygons and disks that lie in
//! one plane.
//!
//! ```text
//! two shapes ─ in one plane? ─▶ convex pieces clipped by each other, circles along edges ─▶ area
//! area ─ above rounding? ─▶ overlap
//! ```
//! Coordinates are decimals, so shapes that are meant to touch can overlap slightly: an overlap
//! that is narrower than [`resolution`] is ignored.

mod circle;

use super::plane::{closeness, flatness};
use super::polygon::{PLANARITY, area, intersection};
use super::scale::lengths;
use super::{Disk, Polygon, Vector};

/// A shape that lies in a plane.
#[derive(Clone, Debug)]
pub(crate) enum Flat {
    Polygon(Polygon),
    Disk(Disk),
}

impl Flat {
    /// Returns the unit normal, which points to the front.
    pub(crate) fn normal(&self) -> Vector {
        match self {
            Self::Polygon(polygon) => polygon.normal(),
            Self::Disk(disk) => disk.normal,
        }
    }

    /// Returns points whose bounding box contains the shape.
    pub(crate) fn corners(&self) -> Vec<Vector> {
        match self {
            Self::Polygon(polygon) => polygon.vertices().to_vec(),
            Self::Disk(disk) => disk.corners().to_vec(),
        }
    }

    pub(crate) fn area(&self) -> f64 {
        match self {
            Self::Polygon(polygon) => polygon.area(),
            Self::Disk(disk) => disk.area(),
        }
    }

    pub(crate) fn extent(&self) -> f64 {
        lengths(&self.corners())[1]
    }

    /// Returns a point of the shape's plane.
    fn point(&self) -> Vector {
        match self {
            Self::Polygon(polygon) => polygon.vertices()[0],
            Self::Disk(disk) => disk.center,
        }
    }

    /// Returns the largest distance of the shape's points from the plane of another shape.
    fn height_over(&self, other: &Self) -> f64 {
        let (point, normal) = (other.point(), other.normal());
        match self {
            Self::Polygon(polygon) => {
                polygon.vertices().iter().map(|&vertex| normal.dot(vertex - point).abs()).fold(0.0, f64::max)
            }
            Self::Disk(disk) => {
                normal.dot(disk.center - point).abs() + disk.radius * normal.cross(disk.normal).length()
            }
        }
    }

    /// Returns the largest distance of the vertices from the shape's own plane.
    fn flatness(&self) -> f64 {
        match self {
            Self::Polygon(polygon) => flatness(polygon.vertices(), polygon.normal()),
            Self::Disk(_) => 0.0,
        }
    }
}

/// Returns the length below which differences between two shapes count as rounding of their
/// coordinates: a millionth of the extent of the smaller one, or the distance within which vertices
/// count as coincident.
pub(crate) fn resolution(a: &Flat, b: &Flat) -> f64 {
    closeness_of(a, b).max(PLANARITY * a.extent().min(b.extent()))
}

fn closeness_of(a: &Flat, b: &Flat) -> f64 {
    closeness(a.corners().into_iter().chain(b.corners()))
}

/// Returns the distance of a shape from the plane of another one, if it exceeds rounding.
pub(crate) fn off_plane(shape: &Flat, other: &Flat) -> Option<f64> {
    let height = shape.height_over(other);
    (height > closeness_of(shape, other) + shape.flatness() + other.flatness()).then_some(height)
}

/// Returns the area of the intersection of two shapes, if they lie in one plane and the area
/// exceeds rounding.
pub(crate) fn overlap(a: &Flat, b: &Flat) -> Option<f64> {
    if a.normal().dot(b.normal()).abs() < 0.5 || (off_plane(a, b).is_some() && off_plane(b, a).is_some()) {
        return None;
    }
    let resolution = resolution(a, b);
    let Intersection { area, extent, is_straight } = Intersection::of(a, b);
    // shapes touch if their intersection is narrower than the resolution along its whole length
    let of_circles = if is_straight { 0.0 } else { cap(a.extent().min(b.extent()), resolution) };
    let rounding = of_circles.max(resolution * extent);
    (area > rounding).then_some(area)
}

/// Returns the area of the intersection of two shapes in one plane.
pub(crate) fn common_area(a: &Flat, b: &Flat) -> f64 {
    Intersection::of(a, b).area
}

/// The intersection of two shapes in one plane.
#[derive(Default)]
struct Intersection {
    area: f64,
    /// The extent of its polygonal pieces.
    extent: f64,
    /// Whether no circle contributes to it.
    is_straight: bool,
}

/// A part of a shape with a sign: its area is added or subtracted.
#[derive(Clone, Copy)]
enum Part<'s> {
    Pieces(&'s [Vec<Vector>], Vector),
    Disk(Disk, f64),
}

impl Flat {
    /// Returns the parts whose indicator functions add up to the indicator function of the shape: a
    /// polygon is its polygonal pieces minus its round holes.
    fn parts(&self) -> Vec<Part<'_>> {
        match self {
            Self::Disk(disk) if disk.is_annulus() => {
                let [whole, hole] = disk.whole_and_hole();
                vec![Part::Disk(whole, 1.0), Part::Disk(hole, -1.0)]
            }
            Self::Disk(disk) => vec![Part::Disk(*disk, 1.0)],
            Self::Polygon(polygon) => {
                let holes = polygon.round_holes().iter().map(|disk| Part::Disk(*disk, -1.0));
                [Part::Pieces(polygon.straight_pieces(), polygon.normal())].into_iter().chain(holes).collect()
            }
        }
    }
}

impl Intersection {
    /// Computes the intersection of two shapes: the product of two indicator functions is the sum
    /// of the products of their parts.
    fn of(a: &Flat, b: &Flat) -> Self {
        let mut sum = Self { is_straight: true, ..Self::default() };
        for own in a.parts() {
            for other in b.parts() {
                sum.add(own, other);
            }
        }
        sum
    }

    fn add(&mut self, a: Part, b: Part) {
        match (a, b) {
            (Part::Pieces(a, normal), Part::Pieces(b, other)) => self.add_pieces((a, normal), (b, other)),
            (Part::Pieces(pieces, _), Part::Disk(disk, sign))
            | (Part::Disk(disk, sign), Part::Pieces(pieces, _)) => {
                self.add_round(sign * circle::area_in_pieces(&disk, pieces));
            }
            (Part::Disk(a, sign), Part::Disk(b, other)) => {
                self.add_round(sign * other * circle::area_in_disk(&a, &b));
            }
        }
    }

    fn add_round(&mut self, area: f64) {
        self.area += area;
        self.is_straight &= area == 0.0;
    }

    fn add_pieces(
        &mut self,
        (a, normal): (&[Vec<Vector>], Vector),
        (b, other_normal): (&[Vec<Vector>], Vector),
    ) {
        let mut corners = Vec::new();
        for own in a {
            for other in b {
                let common = intersection(own, other, other_normal);
                self.area += area(&common, normal);
                corners.extend(common);
            }
        }
        if !corners.is_empty() {
            self.extent = lengths(&corners)[1];
        }
    }
}

/// Returns the area 4/3 d √(2rd) of the segment that a line at the depth d cuts off a circle of
/// this diameter 2r.
fn cap(diameter: f64, depth: f64) -> f64 {
    4.0 / 3.0 * depth * (diameter * depth).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(corners: &[[f64; 3]]) -> Flat {
        let vertices = corners.iter().map(|&[x, y, z]| Vector::new(x, y, z)).collect();
        Flat::Polygon(Polygon::new(vertices).expect("a polygon"))
    }

    fn square(x: f64, y: f64, z: f64, side: f64) -> Flat {
        polygon(&[[x, y, z], [x + side, y, z], [x + side, y + side, z], [x, y + side, z]])
    }

    fn disk(center: [f64; 3], radius: f64) -> Flat {
        let [x, y, z] = center;
        Flat::Disk(Disk {
            center: Vector::new(x, y, z),
            normal: Vector::new(0.0, 0.0, -1.0),
            radius,
            hole: 0.0,
        })
    }

    #[test]
    fn shapes_in_one_plane_overlap_by_the_area_in_common_and_touch_by_none() {
        use std::f64::consts::PI;
        let unit = || square(0.0, 0.0, 0.0, 1.0);
        let l =
            polygon(&[[0., 0., 0.], [3., 0., 0.], [3., 1., 0.], [1., 1., 0.], [1., 3., 0.], [0., 3., 0.]]);
        let upright = polygon(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 0.0, 1.0], [0.0, 0.0, 1.0]]);
        let down = polygon(&[[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 0.0]]);
        let cases = [
            ("the same twice", unit(), unit(), Some(1.0)),
            ("one inside of the other", unit(), square(0.25, 0.25, 0.0, 0.5), Some(0.25)),
            ("in part", unit(), square(0.5, 0.5, 0.0, 1.0), Some(0.25)),
            ("back to back", unit(), down, Some(1.0)),
            ("in a corner", unit(), square(0.999, 0.999, 0.0, 1.0), Some(1e-6)),
            ("along an edge, by a thousandth", unit(), square(0.999, 0.0, 0.0, 1.0), Some(1e-3)),
            ("along an edge, by rounding", unit(), square(1.0 - 1e-9, 0.0, 0.0, 1.0), None),
            ("an edge in common", unit(), square(1.0, 0.0, 0.0, 1.0), None),
            ("part of an edge in common", unit(), square(1.0, 0.3, 0.0, 2.0), None),
            ("a corner in common", unit(), square(1.0, 1.0, 0.0, 1.0), None),
            ("in the notch of another", l, square(1.0, 1.0, 0.0, 1.0), None),
            ("apart by rounding", unit(), square(0.0, 0.0, 1e-10, 1.0), Some(1.0)),
            ("apart by more", unit(), square(0.0, 0.0, 1e-8, 1.0), None),
            ("at a right angle", unit(), upright, None),
            ("a disk inside", unit(), disk([0.5, 0.5, 0.0], 0.5), Some(0.25 * PI)),
            ("a disk around", unit(), disk([0.5, 0.5, 0.0], 2.0), Some(1.0)),
            ("a disk in a corner", unit(), disk([1.0, 1.0, 0.0], 0.5), Some(PI / 16.0)),
            ("a disk that touches", unit(), disk([1.5, 0.5, 0.0], 0.5), None),
            ("a disk that touches up to rounding", unit(), disk([1.5, 0.5, 0.0], 0.5 + 1e-8), None),
            ("a disk above", unit(), disk([0.5, 0.5, 0.1], 0.5), None),
            ("disks", disk([0.0; 3], 1.0), disk([0.5, 0.0, 0.0], 0.5), Some(0.25 * PI)),
            ("disks that touch", disk([0.0; 3], 1.0), disk([1.5, 0.0, 0.0], 0.5), None),
        ];
        for (name, a, b, expected) in cases {
            for (a, b) in [(&a, &b), (&b, &a)] {
                let found = overlap(a, b);
                let is_right = match (found, expected) {
                    (Some(found), Some(expected)) => (found - expected).abs() < 1e-14,
                    (found, expected) => found.is_none() && expected.is_none(),
                };
                assert!(is_right, "{name}: {found:?}");
            }
        }
    }

    #[test]
    fn small_shapes_far_from_the_origin_are_judged_by_their_own_size() {
        // neighbours on a ground plane that is a million times as wide
        let at = 1e3;
        assert!(overlap(&square(at, 0.0, 0.0, 1.0), &square(at + 1.0, 0.0, 0.0, 1e6)).is_none());
        assert!(overlap(&square(at, 0.0, 0.0, 1.0), &square(0.0, -10.0, 0.0, 1e6)).is_some());
        assert!(overlap(&square(at, 0.0, 0.0, 1.0), &square(0.0, -10.0, 0.01, 1e6)).is_none());
    }
}
