//! Maps: the bounding rectangle of a polygon in its plane is divided into cells, and the irradiance is taken at their middles.

use super::watch::Watch;
use crate::geometry::{Face, Vector};
use crate::radiosity::{Group, Measure, Radiosity, Scratch, Transport};
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The cells along each side of a block that shares the search for what stands in between.
const BLOCK: usize = 8;
/// Blocks that one thread takes at least: of what nothing hides a block takes less than handing it over.
const SHARED: usize = 4;

/// The cells of a map.
pub(super) struct Grid {
    normal: Vector,
    size: [usize; 2],
    /// The middles of the cells, row by row, where they lie on the surface.
    cells: Vec<Option<Vector>>,
}

impl Grid {
    /// The grid over the front of a planar surface: its first axis is the first edge of its first face.
    pub(super) fn over(transport: &Transport, surface: usize, size: [usize; 2]) -> Option<Self> {
        let faces = || transport.fronts(surface);
        let first = faces().next()?;
        let corner = first.vertices[0];
        let along = (first.vertices[1] - corner).unit()?;
        let across = first.normal.cross(along);
        let extent = |axis: Vector| {
            let places = faces().flat_map(|face| &face.vertices).map(|&v| axis.dot(v - corner));
            places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), place| {
                (low.min(place), high.max(place))
            })
        };
        let ((left, right), (low, high)) = (extent(along), extent(across));
        let [columns, rows] = size;
        let place = |index: usize, count: usize, low: f64, high: f64| {
            low + (high - low) * (index as f64 + 0.5) / count as f64
        };
        let across_columns: Vec<Vector> =
            (0..columns).map(|column| corner + place(column, columns, left, right) * along).collect();
        let up_rows: Vec<Vector> = (0..rows).map(|row| place(row, rows, low, high) * across).collect();
        let middle = |[column, row]: [usize; 2]| across_columns[column] + up_rows[row];
        let mut cells = vec![None; columns * rows];
        for block in blocks(size) {
            let corners: Vec<Vector> = block.corners().into_iter().map(middle).collect();
            let is_inside = faces().any(|face| corners.iter().all(|&point| lies_on(point, face)));
            for cell @ [column, row] in block.cells() {
                let point = middle(cell);
                let is_on = is_inside || faces().any(|face| lies_on(point, face));
                cells[row * columns + column] = is_on.then_some(point);
            }
        }
        Some(Self { normal: first.normal, size, cells })
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
    pub(super) fn cells(&self) -> &[Option<Vector>] {
        &self.cells
    }

    /// Cells spread over the surface: one in so many, but no fewer than at least, as far as there are.
    pub(super) fn some(&self, [one_in, at_least]: [usize; 2]) -> impl Iterator<Item = Vector> {
        let on_surface = || self.cells.iter().copied().flatten();
        let step = one_in.min(on_surface().count() / at_least).max(1);
        on_surface().skip(step / 2).step_by(step)
    }

    /// The irradiance of all cells, for each band row by row; not a number off the surface, and where the work was stopped before.
    pub(super) fn irradiance(&self, bands: usize, radiosity: &Radiosity, watch: &dyn Watch) -> Vec<Vec<f64>> {
        let blocks: Vec<Block> = blocks(self.size).collect();
        let done = AtomicUsize::new(0);
        let found: Vec<(Vec<usize>, Vec<f64>)> = blocks
            .par_iter()
            .with_min_len(SHARED)
            .map_init(Scratch::default, |scratch, block| {
                let found = if watch.is_stopped() {
                    (Vec::new(), Vec::new())
                } else {
                    self.block(block, bands, radiosity, scratch)
                };
                let part = done.fetch_add(1, Ordering::Relaxed) as f64 / blocks.len() as f64;
                watch.progress("maps", part);
                found
            })
            .collect();
        let mut values = vec![vec![f64::NAN; self.cells.len()]; bands];
        for (cells, of_cells) in found {
            for (cell, of_bands) in cells.into_iter().zip(of_cells.chunks_exact(bands)) {
                values.iter_mut().zip(of_bands).for_each(|(band, &value)| band[cell] = value);
            }
        }
        values
    }

    /// The cells of a block that lie on the surface, and their irradiance in each band, cell by cell.
    fn block(
        &self,
        block: &Block,
        bands: usize,
        radiosity: &Radiosity,
        scratch: &mut Scratch,
    ) -> (Vec<usize>, Vec<f64>) {
        let index = |[column, row]: [usize; 2]| row * self.size[0] + column;
        let on_surface = |cell: [usize; 2]| self.cells[index(cell)].map(|point| (index(cell), point));
        let (mut cells, mut points) = (Vec::with_capacity(BLOCK * BLOCK), Vec::with_capacity(BLOCK * BLOCK));
        for (cell, point) in block.cells().filter_map(on_surface) {
            cells.push(cell);
            points.push(point);
        }
        let mut values = vec![0.0; bands * points.len()];
        if !points.is_empty() {
            // where a corner is off the surface, the hull of the others is not that of the cells
            let corners: Option<Vec<Vector>> =
                block.corners().into_iter().map(|corner| self.cells[index(corner)]).collect();
            let outline = corners.as_deref().unwrap_or(&points);
            let group = Group { points: &points, outline, measure: Measure::Plane(self.normal) };
            radiosity.gather(group, scratch, &mut values);
        }
        (cells, values)
    }
}

/// Cells that follow each other along both sides: the first and the last of them.
struct Block {
    first: [usize; 2],
    last: [usize; 2],
}

/// The blocks of a grid of this size, row by row.
fn blocks([columns, rows]: [usize; 2]) -> impl Iterator<Item = Block> {
    let ends = |count: usize| {
        (0..count)
            .step_by(BLOCK)
            .map(move |first| [first, (first + BLOCK).min(count) - 1])
            .collect::<Vec<_>>()
    };
    let across = ends(columns);
    ends(rows).into_iter().flat_map(move |[low, high]| {
        let block = move |[left, right]: [usize; 2]| Block { first: [left, low], last: [right, high] };
        across.clone().into_iter().map(block)
    })
}

impl Block {
    /// Its cells, row by row.
    fn cells(&self) -> impl Iterator<Item = [usize; 2]> {
        let [[left, low], [right, high]] = [self.first, self.last];
        (low..=high).flat_map(move |row| (left..=right).map(move |column| [column, row]))
    }

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

/// Whether a point of the plane of a convex face lies on it.
fn lies_on(point: Vector, face: &Face) -> bool {
    let corners = &face.vertices;
    (0..corners.len()).all(|i| {
        let (a, b) = (corners[i], corners[(i + 1) % corners.len()]);
        face.normal.dot((b - a).cross(point - a)) >= 0.0
    })
}
