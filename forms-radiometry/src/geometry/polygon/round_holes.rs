//! Round holes: subtracts the regular polygons that approximate disks from a polygon.
//!
//! ```text
//! pieces ─ square around disk ─┬─ outside: pieces of the remainder
//!                              └─ inside ─ lines of the regular polygon ─▶ narrow pieces around it
//! ```
//! A regular polygon has the area of its disk and also replaces the disk in the faces of the scene:
//! hole and disk match at each tessellation level.

use super::difference::{difference, intersection, split_along_edges};
use super::{PLANARITY, Polygon, edges};
use crate::geometry::round::across;
use crate::geometry::{Disk, Vector};
use std::borrow::Cow;

/// Tessellation level of the holes in pieces that are requested without a level: 384 edges.
const FINENESS: usize = 4;
/// Half the side of the square around a disk, in radii: the square encloses the vertices of the
/// coarsest polygon.
const SQUARE: f64 = 1.1;

impl Polygon {
    /// Returns this polygon minus disks that lie in its plane, inside it, and face the same way.
    /// All other holes must have been cut before.
    pub(crate) fn without_disks(self, disks: Vec<Disk>) -> Self {
        if disks.is_empty() {
            return self;
        }
        let straight = self.pieces.clone();
        let whole = Self { round_holes: disks, straight, ..self };
        Self { pieces: whole.pieces_at(FINENESS).into_owned(), ..whole }
    }

    /// Returns the disks that were cut out.
    pub(crate) fn round_holes(&self) -> &[Disk] {
        &self.round_holes
    }

    /// Returns convex pieces of the polygon minus its polygonal holes; round holes are not cut out.
    pub(crate) fn straight_pieces(&self) -> &[Vec<Vector>] {
        if self.round_holes.is_empty() { &self.pieces } else { &self.straight }
    }

    /// Returns the convex pieces, with the disks that were cut out approximated by regular polygons
    /// of this tessellation level.
    pub(crate) fn pieces_at(&self, fineness: usize) -> Cow<'_, [Vec<Vector>]> {
        if self.round_holes.is_empty() {
            return Cow::Borrowed(&self.pieces);
        }
        let mut pieces = self.straight.clone();
        for disk in &self.round_holes {
            let hole = disk.polygon(fineness);
            pieces = pieces.into_iter().flat_map(|piece| without_disk(piece, disk, &hole)).collect();
        }
        Cow::Owned(pieces)
    }
}

/// Returns the convex pieces of a convex piece around the regular polygon that approximates a disk.
fn without_disk(piece: Vec<Vector>, disk: &Disk, hole: &[Vector]) -> Vec<Vec<Vector>> {
    if intersection(&piece, hole, disk.normal).is_empty() {
        return vec![piece];
    }
    let [u, v] = across(disk.normal).map(|axis| SQUARE * disk.radius * axis);
    let square = [disk.center - u - v, disk.center + u - v, disk.center + u + v, disk.center - u + v];
    let resolution = PLANARITY * disk.radius;
    let (mut pieces, inside) = split_along_edges(&piece, edges(&square), disk.normal, resolution);
    pieces.extend(difference(inside, hole, disk.normal, resolution));
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn a_wall_with_disks_cut_out_has_its_area_less_theirs_at_each_fineness() {
        let corners = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]];
        let wall = Polygon::new(corners.map(|[x, y]| Vector::new(x, y, 1.0)).to_vec()).expect("a rectangle");
        let disk = |x: f64, radius: f64| Disk {
            center: Vector::new(x, 1.5, 1.0),
            normal: Vector::new(0.0, 0.0, 1.0),
            radius,
            hole: 0.0,
        };
        let left = wall.without_disks(vec![disk(1.0, 0.5), disk(2.75, 1.0)]);
        let expected = 12.0 - 1.25 * PI;
        assert!((left.area() - expected).abs() < 1e-13);
        for fineness in 0..4 {
            let pieces = left.pieces_at(fineness);
            let sum: f64 = pieces.iter().map(|piece| super::super::area(piece, left.normal())).sum();
            assert!((sum - expected).abs() < 1e-13, "{fineness}: {sum}");
            assert!(pieces.len() <= 2 * (24 << fineness) + 16, "{}", pieces.len());
        }
    }
}
