//! Arrangements of planes: planes divide points into cells. All points of a cell lie on the same
//! sides of all planes.
//!
//! ```text
//! planes ─┬─ with all corners of an outline on one side: the same side for all points in it
//!         └─ others: tested point by point ─▶ keys ─▶ cells
//! ```

use crate::geometry::edges::Columns;
use crate::geometry::{Plane, Vector};

/// The largest number of planes that separate points: a key has one bit for each.
const MOST: u32 = u64::BITS;

/// The side of a plane on which a point lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    /// In front of the plane.
    Front,
    /// Behind the plane.
    Behind,
    /// So close to the plane that the point counts as neither.
    Neither,
}

/// Classification of a plane.
#[derive(Clone, Copy, Debug)]
enum Known {
    /// All points are on this side.
    All(Side),
    /// The plane separates points; its side is at this bit of the keys.
    Parted(u32),
}

/// Planes, and the cells of points between them.
#[derive(Clone, Debug, Default)]
pub(super) struct Arrangement {
    /// The planes, with normals of any length, each with the product below which a point is on
    /// neither side.
    planes: Vec<(Plane, f64)>,
    known: Vec<Known>,
    /// The indices of the points, cell by cell, and their positions.
    points: Vec<u32>,
    places: Columns,
    /// For each point, the set of planes that it is in front of and the set of planes that it is
    /// behind.
    keys: [Vec<u64>; 2],
    /// For each cell, the same two sets, and the end of its points.
    cells: Vec<([u64; 2], usize)>,
    /// For each point, its index and its cell.
    unsorted: Vec<(u32, usize)>,
    cuts: Vec<usize>,
}

/// A cell of the arrangement.
#[derive(Clone, Copy)]
pub(super) struct Cell<'a> {
    known: &'a [Known],
    key: [u64; 2],
    /// The indices of its points.
    pub(super) points: &'a [u32],
    /// The positions of its points.
    pub(super) places: [&'a [f64]; 3],
}

impl Side {
    fn of(plane: Plane, least: f64, point: Vector) -> Self {
        let distance = plane.distance(point);
        match (distance > least, distance < -least) {
            (true, _) => Self::Front,
            (_, true) => Self::Behind,
            _ => Self::Neither,
        }
    }
}

impl Arrangement {
    pub(super) fn clear(&mut self) {
        self.planes.clear();
    }

    pub(super) fn add(&mut self, plane: Plane, least: f64) {
        self.planes.push((plane, least));
    }

    /// Divides some of the points in an outline into cells; `None` if too many planes separate
    /// them.
    pub(super) fn part(
        &mut self,
        points: &[Vector],
        some: impl Iterator<Item = u32>,
        outline: &[Vector],
    ) -> Option<()> {
        self.points.clear();
        self.points.extend(some);
        self.known.clear();
        self.cuts.clear();
        let mut parting = 0;
        for (index, &(plane, least)) in self.planes.iter().enumerate() {
            let first = Side::of(plane, least, outline[0]);
            let has = |side| outline.iter().any(|&corner| Side::of(plane, least, corner) == side);
            // the set of points with each value of `Side` is convex
            let is_all = outline[1..].iter().all(|&corner| Side::of(plane, least, corner) == first);
            if !is_all && has(Side::Front) && has(Side::Behind) {
                self.cuts.push(index);
            }
            self.known.push(if is_all { Known::All(first) } else { Known::Parted(parting) });
            parting += u32::from(!is_all);
        }
        if parting > MOST {
            return None;
        }
        self.take_places(points);
        self.cells.clear();
        if parting == 0 {
            self.cells.push(([0; 2], self.points.len()));
        } else {
            self.take_keys();
            self.sort();
            self.take_places(points);
        }
        Some(())
    }

    /// Fills the position columns in the current order of the points.
    fn take_places(&mut self, points: &[Vector]) {
        for (axis, column) in self.places.iter_mut().enumerate() {
            column.clear();
            column.extend(self.points.iter().map(|&index| points[index as usize].coordinates()[axis]));
        }
    }

    /// Computes the keys: for each point, its sides of the separating planes.
    fn take_keys(&mut self) {
        let Self { planes, known, places, keys, points, .. } = self;
        keys.iter_mut().for_each(|keys| {
            keys.clear();
            keys.resize(points.len(), 0);
        });
        let [front, behind] = keys;
        for (&(plane, least), known) in planes.iter().zip(&*known) {
            let Known::Parted(place) = *known else { continue };
            let bit = 1 << place;
            let [x, y, z] = places.each_ref().map(|column| &column[..front.len()]);
            for (i, (front, behind)) in front.iter_mut().zip(&mut *behind).enumerate() {
                let distance = plane.distance(Vector::new(x[i], y[i], z[i]));
                *front |= if distance > least { bit } else { 0 };
                *behind |= if distance < -least { bit } else { 0 };
            }
        }
    }

    /// Sorts the points by cell. Successive points are often in the same cell.
    fn sort(&mut self) {
        let Self { points, keys: [front, behind], cells, unsorted, .. } = self;
        unsorted.clear();
        let mut last = 0;
        for (&point, key) in
            points.iter().zip(front.iter().zip(&*behind).map(|(&front, &behind)| [front, behind]))
        {
            if cells.get(last).is_none_or(|(known, _)| *known != key) {
                last = cells.iter().position(|(known, _)| *known == key).unwrap_or(cells.len());
                if last == cells.len() {
                    cells.push((key, 0));
                }
            }
            cells[last].1 += 1;
            unsorted.push((point, last));
        }
        // counting sort: counts become the starts of the cells, and the starts advance point by
        // point to the ends
        let mut start = 0;
        for (_, count) in &mut *cells {
            start += std::mem::replace(count, start);
        }
        for &(point, cell) in &*unsorted {
            let place = &mut cells[cell].1;
            points[*place] = point;
            *place += 1;
        }
    }

    /// Returns the indices of the planes on both sides of which the last outline has points.
    pub(super) fn cuts(&self) -> &[usize] {
        &self.cuts
    }

    /// Returns the cells that contain points.
    pub(super) fn cells(&self) -> impl Iterator<Item = Cell<'_>> {
        let starts = std::iter::once(0).chain(self.cells.iter().map(|(_, end)| *end));
        starts.zip(&self.cells).map(|(start, &(key, end))| Cell {
            known: &self.known,
            key,
            points: &self.points[start..end],
            places: self.places.each_ref().map(|column| &column[start..end]),
        })
    }
}

impl Cell<'_> {
    /// Returns the side of a plane on which the cell lies.
    pub(super) fn side(&self, plane: usize) -> Side {
        match self.known[plane] {
            Known::All(side) => side,
            Known::Parted(place) => match self.key.map(|bits| bits >> place & 1) {
                [0, 0] => Side::Neither,
                [0, _] => Side::Behind,
                _ => Side::Front,
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_points_of_a_cell_are_on_the_sides_that_it_says() {
        let at = |i: u32| Vector::new(f64::from(i % 8), f64::from(i / 8), 0.0);
        let points: Vec<Vector> = (0..64).map(at).collect();
        let outline = [0, 7, 63, 56].map(at);
        let mut arrangement = Arrangement::default();
        for (normal, through) in [([1.0, 0.3, 0.0], 2.2), ([-1.0, 1.0, 0.5], 0.0), ([0.0, 1.0, 0.0], 9.0)] {
            let [x, y, z] = normal;
            arrangement
                .add(Plane { point: Vector::new(0.0, through, 0.0), normal: Vector::new(x, y, z) }, 1e-9);
        }
        arrangement.part(&points, 0..64, &outline).unwrap();
        let mut count = 0;
        for cell in arrangement.cells() {
            for (place, &(plane, least)) in arrangement.planes.iter().enumerate() {
                for &index in cell.points {
                    assert_eq!(cell.side(place), Side::of(plane, least, points[index as usize]), "{plane:?}");
                }
            }
            count += cell.points.len();
        }
        // the diagonal has points on neither side, and the last plane separates none
        assert_eq!([count, arrangement.cells().count()], [64, 5]);
        assert!(arrangement.cells().all(|cell| cell.side(2) == Side::Behind));
        assert_eq!(arrangement.cuts(), [0, 1]);
        arrangement.part(&points, 0..1, &outline[..1]).unwrap();
        assert!(arrangement.cuts().is_empty());
    }
}
