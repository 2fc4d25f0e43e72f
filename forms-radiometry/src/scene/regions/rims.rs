//! Rims: finds the round shapes that end in the same circle, such as a cylinder and the disk that
//! closes it.
//!
//! ```text
//! circles of disks and quadrics ─ the same centre, axis and radius ─▶ one edge for each circle
//! ```
//! What holds at one point of a circle holds at all of them, so its edge is the tangent at a point.

use super::edges::{Edge, Wing};
use super::interfaces::{Interface, Piece};
use crate::geometry::round::across;
use crate::geometry::{Disk, Rim, Vector, Welded, closeness};
use rustc_hash::FxHashMap;

/// Largest sine of the angle between the axes of circles that coincide.
const PARALLEL: f64 = 1e-9;

/// Returns the edges at which disks and quadrics end. The rims of disks that were cut out of a
/// polygon are left out.
pub(super) fn rims(interfaces: &[Interface]) -> Vec<Edge> {
    let holes: Vec<&Disk> = interfaces.iter().flat_map(Interface::round_holes).collect();
    let own = |(index, interface): (usize, &Interface)| {
        let rims = match &interface.shape {
            Piece::Disk(disk) if holes.contains(&disk) => Vec::new(),
            Piece::Disk(disk) => disk.rims(),
            Piece::Quadric(quadric) => quadric.rims(),
            Piece::Face(..) | Piece::Sphere(_) => Vec::new(),
        };
        rims.into_iter().map(move |rim| (index, rim))
    };
    let rims: Vec<(usize, Rim)> = interfaces.iter().enumerate().flat_map(own).collect();
    let corners = rims.iter().flat_map(|(_, rim)| [rim.center, rim.point()]);
    let resolution = closeness(corners);
    let mut welded = Welded::new(resolution);
    let mut circles: Vec<Vec<(usize, Rim)>> = Vec::new();
    let mut of_centers: FxHashMap<u32, Vec<usize>> = FxHashMap::default();
    for (index, rim) in rims {
        let known = of_centers.entry(welded.number(rim.center)).or_default();
        let is_same = |&circle: &usize| circles[circle][0].1.is_same(&rim, resolution);
        if let Some(&circle) = known.iter().find(|circle| is_same(circle)) {
            circles[circle].push((index, rim));
        } else {
            known.push(circles.len());
            circles.push(vec![(index, rim)]);
        }
    }
    circles.iter().map(|circle| edge(circle)).collect()
}

/// Returns the edge of the shapes that end in a circle.
fn edge(circle: &[(usize, Rim)]) -> Edge {
    let (_, first) = circle[0];
    let outward = across(first.axis)[0];
    let tangent = first.axis.cross(outward);
    let wing = |&(interface, rim): &(usize, Rim)| {
        let placed = |[away, along]: [f64; 2]| away * outward + along * rim.axis;
        let (into, normal) = (placed(rim.into), placed(rim.normal));
        Wing::new(interface, normal.cross(tangent).dot(into) > 0.0, into)
    };
    let point = first.point();
    let mut edge = Edge::new([point, point + first.radius * tangent], circle.iter().map(wing).collect());
    edge.center = Some(first.center);
    edge
}

impl Rim {
    fn point(&self) -> Vector {
        self.center + self.radius * across(self.axis)[0]
    }

    fn is_same(&self, other: &Self, resolution: f64) -> bool {
        (self.radius - other.radius).abs() <= resolution && self.axis.cross(other.axis).length() <= PARALLEL
    }
}
