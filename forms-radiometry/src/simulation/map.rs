//! Maps: the bounding rectangle of a polygon in its plane is divided into cells, and the irradiance is taken at their middles.

use super::watch::Watch;
use crate::geometry::{Face, Vector};
use crate::radiosity::{Group, Measure, Radiosity, Scratch, Transport};
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The cells along each side of a block that shares the search for what stands in between.
const BLOCK: usize = 8;

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
        let middle = |(column, row)| {
            let (x, y) = (place(column, columns, left, right), place(row, rows, low, high));
            let point = corner + x * along + y * across;
            faces().any(|face| lies_on(point, face)).then_some(point)
        };
        let cells = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row))).map(middle);
        Some(Self { normal: first.normal, size, cells: cells.collect() })
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

    /// Cells spread over the surface, about as many as this.
    pub(super) fn some(&self, count: usize) -> impl Iterator<Item = Vector> {
        let on_surface: Vec<Vector> = self.cells.iter().copied().flatten().collect();
        let step = (on_surface.len() / count).max(1);
        on_surface.into_iter().skip(step / 2).step_by(step)
    }

    /// The irradiance of all cells, for each band row by row; not a number off the surface, and where the work was stopped before.
    pub(super) fn irradiance(&self, bands: usize, radiosity: &Radiosity, watch: &dyn Watch) -> Vec<Vec<f64>> {
        let [columns, rows] = self.size;
        let blocks: Vec<[usize; 2]> = (0..rows.div_ceil(BLOCK))
            .flat_map(|row| (0..columns.div_ceil(BLOCK)).map(move |column| [column * BLOCK, row * BLOCK]))
            .collect();
        let done = AtomicUsize::new(0);
        let found: Vec<_> = blocks
            .par_iter()
            .map_init(Scratch::default, |scratch, &block| {
                let found =
                    if watch.is_stopped() { Vec::new() } else { self.block(block, radiosity, scratch) };
                let part = done.fetch_add(1, Ordering::Relaxed) as f64 / blocks.len() as f64;
                watch.progress("maps", part);
                found
            })
            .collect();
        let mut values = vec![vec![f64::NAN; columns * rows]; bands];
        for (cell, of_bands) in found.into_iter().flatten() {
            values.iter_mut().zip(of_bands).for_each(|(band, value)| band[cell] = value);
        }
        values
    }

    /// The cells of a block, each with its irradiance in each band.
    fn block(
        &self,
        [left, low]: [usize; 2],
        radiosity: &Radiosity,
        scratch: &mut Scratch,
    ) -> Vec<(usize, Vec<f64>)> {
        let [columns, rows] = self.size;
        let cells = (low..(low + BLOCK).min(rows))
            .flat_map(|row| (left..(left + BLOCK).min(columns)).map(move |column| row * columns + column));
        let (cells, points): (Vec<usize>, Vec<Vector>) =
            cells.filter_map(|cell| self.cells[cell].map(|point| (cell, point))).unzip();
        if points.is_empty() {
            return Vec::new();
        }
        let group = Group { points: &points, outline: &points, measure: Measure::Plane(self.normal) };
        cells.into_iter().zip(radiosity.reaching(group, scratch)).collect()
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
