//! Maps: the bounding rectangle of a polygon in its plane is divided into cells, and the irradiance is taken at their middles.

use super::watch::Watch;
use crate::geometry::{Face, Vector};
use crate::radiosity::{Group, Measure, Radiosity, Scratch, Transport};
use crate::sharing::Sharing;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The cells along each side of a block that shares the search for what stands in between.
const BLOCK: usize = 8;

/// The cells of a map.
pub(super) struct Grid {
    normal: Vector,
    size: [usize; 2],
    /// The middles of the cells that lie on the surface, block by block.
    points: Vec<Vector>,
    /// The cell of each of them, counted row by row.
    cells: Vec<usize>,
    blocks: Vec<Block>,
}

/// Cells that follow each other along both sides, as far as they lie on the surface.
struct Block {
    /// Where its points end; they begin where those of the block before it end.
    end: usize,
    /// The points at its corners, if all are on the surface.
    corners: Option<Vec<Vector>>,
}

impl Grid {
    /// The grid over the front of a planar surface: its first axis is the first edge of its first face.
    pub(super) fn over(transport: &Transport, surface: usize, size: [usize; 2]) -> Option<Self> {
        let faces = || transport.fronts(surface);
        let normal = faces().next()?.normal;
        let [across_columns, up_rows] = middles(transport, surface, size)?;
        let middle = |[column, row]: [usize; 2]| across_columns[column] + up_rows[row];
        let [columns, rows] = size;
        let (mut points, mut cells) =
            (Vec::with_capacity(columns * rows), Vec::with_capacity(columns * rows));
        let mut blocks = Vec::new();
        for cut in cuts(size) {
            let corners: Vec<Vector> = cut.corners().into_iter().map(middle).collect();
            let is_inside = faces().any(|face| corners.iter().all(|&point| lies_on(point, face)));
            let is_on = |point: Vector| is_inside || faces().any(|face| lies_on(point, face));
            let [[left, low], [right, high]] = [cut.first, cut.last];
            for (row, &up) in (low..=high).zip(&up_rows[low..=high]) {
                let first = row * columns;
                let of_row = &across_columns[left..=right];
                if is_inside {
                    points.extend(of_row.iter().map(|&across| across + up));
                    cells.extend(first + left..=first + right);
                } else {
                    let on_surface = (first + left..).zip(of_row).filter(|(_, across)| is_on(**across + up));
                    cells.extend(on_surface.clone().map(|(cell, _)| cell));
                    points.extend(on_surface.map(|(_, &across)| across + up));
                }
            }
            let corners = corners.iter().all(|&corner| is_on(corner)).then_some(corners);
            blocks.push(Block { end: points.len(), corners });
        }
        Some(Self { normal, size, points, cells, blocks })
    }

    /// The unit normal of the surface.
    pub(super) fn normal(&self) -> Vector {
        self.normal
    }

    /// How many cells there are along each side.
    pub(super) fn size(&self) -> [usize; 2] {
        self.size
    }

    /// The middles of the cells, row by row, where they lie on the surface.
    pub(super) fn cells(&self) -> Vec<Option<Vector>> {
        let mut cells = vec![None; self.size[0] * self.size[1]];
        self.cells.iter().zip(&self.points).for_each(|(&cell, &point)| cells[cell] = Some(point));
        cells
    }

    /// How many cells lie on the surface.
    pub(super) fn count(&self) -> usize {
        self.points.len()
    }

    /// Cells spread over the surface: one in so many, but no fewer than at least, as far as there are.
    pub(super) fn some(&self, [one_in, at_least]: [usize; 2]) -> impl Iterator<Item = Vector> {
        let step = one_in.min(self.count() / at_least).max(1);
        self.cells().into_iter().flatten().skip(step / 2).step_by(step)
    }

    /// The irradiance of all cells, for each band row by row; not a number off the surface, and where the work was stopped before.
    pub(super) fn irradiance(&self, bands: usize, radiosity: &Radiosity, watch: &dyn Watch) -> Vec<Vec<f64>> {
        let mut gathered = vec![f64::NAN; bands * self.count()];
        let done = AtomicUsize::new(0);
        let each = |scratch: &mut Scratch, (group, values): (Group, &mut [f64])| {
            if watch.is_stopped() {
                return;
            }
            if !group.points.is_empty() {
                radiosity.gather(group, scratch, values);
            }
            if watch.is_stopped() {
                values.fill(f64::NAN);
                return;
            }
            let part = done.fetch_add(1, Ordering::Relaxed) as f64 / self.blocks.len() as f64;
            watch.progress("maps", part);
        };
        let parts = self.parts(bands, &mut gathered);
        Sharing::of(radiosity.operations(self.count())).map(parts, each);
        let mut values = vec![vec![f64::NAN; self.size[0] * self.size[1]]; bands];
        for (&cell, of_bands) in self.cells.iter().zip(gathered.chunks_exact(bands)) {
            values.iter_mut().zip(of_bands).for_each(|(band, &value)| band[cell] = value);
        }
        values
    }

    /// Each block with the part of a list that its cells have, cell by cell and band by band.
    fn parts<'g>(&'g self, bands: usize, mut values: &'g mut [f64]) -> Vec<(Group<'g>, &'g mut [f64])> {
        let measure = Measure::Plane(self.normal);
        let mut start = 0;
        let part = |block: &'g Block| {
            let points = &self.points[start..block.end];
            start = block.end;
            // where a corner is off the surface, the hull of the others is not that of the cells
            let outline = block.corners.as_deref().unwrap_or(points);
            let (own, rest) = std::mem::take(&mut values).split_at_mut(bands * points.len());
            values = rest;
            (Group { points, outline, measure }, own)
        };
        self.blocks.iter().map(part).collect()
    }
}

/// A rectangle of cells: the first and the last of them.
struct Cut {
    first: [usize; 2],
    last: [usize; 2],
}

/// The rectangles of blocks of a grid of this size, row by row.
fn cuts([columns, rows]: [usize; 2]) -> impl Iterator<Item = Cut> {
    let ends = |count: usize| {
        (0..count)
            .step_by(BLOCK)
            .map(move |first| [first, (first + BLOCK).min(count) - 1])
            .collect::<Vec<_>>()
    };
    let across = ends(columns);
    ends(rows).into_iter().flat_map(move |[low, high]| {
        let cut = move |[left, right]: [usize; 2]| Cut { first: [left, low], last: [right, high] };
        across.clone().into_iter().map(cut)
    })
}

impl Cut {
    /// The cells at its corners, one after the other around it; of a block of one row or column two, of a single cell one.
    fn corners(&self) -> Vec<[usize; 2]> {
        let [[left, low], [right, high]] = [self.first, self.last];
        let mut corners = vec![[left, low], [right, low], [right, high], [left, high]];
        corners.dedup();
        if corners.len() > 1 && corners.first() == corners.last() {
            corners.pop();
        }
        corners
    }
}

/// The middles of the columns of a grid over the front of a surface, in its lowest edge, and of the rows as ways up from there.
fn middles(transport: &Transport, surface: usize, [columns, rows]: [usize; 2]) -> Option<[Vec<Vector>; 2]> {
    let faces = || transport.fronts(surface);
    let first = faces().next()?;
    let corner = first.vertices[0];
    let along = (first.vertices[1] - corner).unit()?;
    let across = first.normal.cross(along);
    let places = |axis: Vector, count: usize| {
        let places = faces().flat_map(|face| &face.vertices).map(|&v| axis.dot(v - corner));
        let (low, high) = places
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), place| (low.min(place), high.max(place)));
        (0..count).map(move |index| low + (high - low) * (index as f64 + 0.5) / count as f64)
    };
    let across_columns = places(along, columns).map(|place| corner + place * along).collect();
    let up_rows = places(across, rows).map(|place| place * across).collect();
    Some([across_columns, up_rows])
}

/// Whether a point of the plane of a convex face lies on it.
fn lies_on(point: Vector, face: &Face) -> bool {
    let corners = &face.vertices;
    (0..corners.len()).all(|i| {
        let (a, b) = (corners[i], corners[(i + 1) % corners.len()]);
        face.normal.dot((b - a).cross(point - a)) >= 0.0
    })
}
