//! Maps: the bounding rectangle of a polygon in its plane is divided into cells, and the irradiance
//! is evaluated at their centres.
//!
//! ```text
//! cells ┬ all, in blocks ─▶ direct light ──────────────────────────┐
//!       ├ polynomials of elements ─────────────────────────────────┼▶ irradiance
//!       └ some, the others interpolated ─▶ lack of the polynomials ┘
//! ```
//! Direct light costs little and has sharp shadows. Reflected light costs much and is smooth in
//! most cells.

use super::interpolation::interpolated;
use crate::geometry::{BoundingRectangle, Polygon, Vector};
use crate::parallelism::Parallelism;
use crate::radiosity::{Group, Measure, Radiosity, Scratch, Transport};
use crate::scene::Shape;
use crate::visibility::{Face, ReceivingArea};
use crate::watch::Watch;
use smallvec::{SmallVec, smallvec};

/// Number of cells along each side of a block. The cells of a block share the search for occluders.
const BLOCK: usize = 8;

/// Cells of a map.
pub(crate) struct Grid {
    area: ReceivingArea,
    normal: Vector,
    size: [usize; 2],
    /// Centres of the columns on the lowest edge, and offsets of the rows from that edge.
    middles: [Vec<Vector>; 2],
    /// Whether each cell lies on the surface.
    is_on: Vec<bool>,
    /// Centres of the cells that lie on the surface, block by block.
    points: Vec<Vector>,
    /// Cell of each of these points, counted row by row.
    cells: Vec<usize>,
    blocks: Vec<Block>,
}

/// One item for each corner of a rectangle.
type Corners<T> = SmallVec<[T; 4]>;

/// Cells that adjoin along both sides, without those that lie off the surface.
struct Block {
    /// End of its points; they begin at the end of the block before it.
    end: usize,
    /// The points at its corners, if all are on the surface.
    corners: Option<Corners<Vector>>,
}

impl Grid {
    /// Returns a ball that contains the centres of all cells: its centre and its radius.
    pub(crate) fn ball(&self) -> (Vector, f64) {
        let [columns, rows] = self.size;
        let corners = [[0, 0], [columns - 1, 0], [0, rows - 1], [columns - 1, rows - 1]];
        let corners = corners.map(|cell| self.middle(cell));
        let center = 0.25 * corners.iter().fold(Vector::default(), |sum, &corner| sum + corner);
        (center, corners.iter().map(|&corner| (corner - center).length()).fold(0.0, f64::max))
    }

    /// Returns the grid over a side of a planar surface of this shape. Its first axis is the first
    /// edge of the outline. The cells of the back lie behind those of the front.
    pub(crate) fn over(
        transport: &Transport,
        (area, shape): (ReceivingArea, &Shape),
        size: [usize; 2],
    ) -> Option<Self> {
        let faces = || transport.faces_in(area);
        let first = transport.faces_in(ReceivingArea::front(area.surface)).next()?;
        // the faces of a polygon do not cover its holes
        let outline = shape.as_polygon().map_or(&*first.vertices, Polygon::vertices);
        let middles = middles(outline, first.normal, size)?;
        let [columns, rows] = size;
        let mut grid = Self {
            area,
            normal: if area.is_back { -first.normal } else { first.normal },
            size,
            middles,
            is_on: vec![false; columns * rows],
            points: Vec::with_capacity(columns * rows),
            cells: Vec::with_capacity(columns * rows),
            blocks: Vec::new(),
        };
        for cut in cuts(size) {
            let corners: Corners<Vector> = cut.corners().into_iter().map(|cell| grid.middle(cell)).collect();
            let is_inside = faces().any(|face| corners.iter().all(|&point| lies_on(point, face)));
            for row in cut.first[1]..=cut.last[1] {
                let cells = row * columns + cut.first[0]..=row * columns + cut.last[0];
                if is_inside {
                    let [across_columns, up_rows] = &grid.middles;
                    let across_columns = &across_columns[cut.first[0]..=cut.last[0]];
                    grid.points.extend(across_columns.iter().map(|&along| along + up_rows[row]));
                    grid.is_on[cells.clone()].fill(true);
                    grid.cells.extend(cells);
                    continue;
                }
                for cell in cells {
                    let point = grid.middle([cell % columns, row]);
                    if faces().any(|face| lies_on(point, face)) {
                        grid.is_on[cell] = true;
                        grid.points.push(point);
                        grid.cells.push(cell);
                    }
                }
            }
            let corners = grid.outline(&cut);
            grid.blocks.push(Block { end: grid.points.len(), corners });
        }
        Some(grid)
    }

    /// Returns the centre of the cell in a column and a row.
    fn middle(&self, [column, row]: [usize; 2]) -> Vector {
        let [across_columns, up_rows] = &self.middles;
        across_columns[column] + up_rows[row]
    }

    /// Returns the centres of the cells at the corners of a rectangle, if all are on the surface.
    fn outline(&self, cut: &Cut) -> Option<Corners<Vector>> {
        let corners = cut.corners();
        let is_on = corners.iter().all(|[column, row]| self.is_on[row * self.size[0] + column]);
        is_on.then(|| corners.into_iter().map(|cell| self.middle(cell)).collect())
    }

    /// Returns the unit normal of the surface.
    pub(crate) fn normal(&self) -> Vector {
        self.normal
    }

    /// Returns the centres of the cells, row by row, where they lie on the surface.
    pub(crate) fn cells(&self) -> Vec<Option<Vector>> {
        let mut cells = vec![None; self.size[0] * self.size[1]];
        self.cells.iter().zip(&self.points).for_each(|(&cell, &point)| cells[cell] = Some(point));
        cells
    }

    /// Returns the number of cells on the surface.
    pub(crate) fn count(&self) -> usize {
        self.points.len()
    }

    /// Returns cells spread over the surface: one in `one_in`, but at least `at_least` of them if
    /// there are enough.
    pub(crate) fn some(&self, [one_in, at_least]: [usize; 2]) -> impl Iterator<Item = Vector> {
        let step = one_in.min(self.count() / at_least).max(1);
        self.cells().into_iter().flatten().skip(step / 2).step_by(step)
    }

    /// Returns the irradiance of all cells, given their direct light, for each band row by row; NaN
    /// off the surface, and where the work was stopped before. The error of the reflected light
    /// stays within the allowed error of each band. `note` receives the number of computed cells.
    pub(crate) fn irradiance(
        &self,
        radiosity: &Radiosity,
        (mut irradiance, allowed): (Vec<f64>, &[f64]),
        watch: &dyn Watch,
        note: &(dyn Fn(usize) + Sync),
    ) -> Vec<Vec<f64>> {
        let bands = allowed.len();
        if radiosity.is_reflected() {
            let polynomials = self.polynomials(bands, radiosity);
            let compute = |cells: &[usize], gap: usize| {
                let mut found = self.reflected((cells, gap), bands, radiosity, watch, note);
                for (&cell, found) in cells.iter().zip(found.chunks_exact_mut(bands)) {
                    let of_cell = &polynomials[cell * bands..][..bands];
                    found.iter_mut().zip(of_cell).for_each(|(found, polynomial)| *found -= polynomial);
                }
                found
            };
            let lacks = interpolated(self.size, &self.is_on, allowed, compute);
            let reflected = lacks.iter().zip(&polynomials).map(|(lacks, polynomial)| lacks + polynomial);
            // next to dark cells, polynomials fall below zero
            let lit = reflected.map(|value| if value < 0.0 { 0.0 } else { value });
            irradiance.iter_mut().zip(lit).for_each(|(sum, value)| *sum += value);
        }
        (0..bands).map(|band| irradiance.iter().skip(band).step_by(bands).copied().collect()).collect()
    }

    /// Moves numbers of the cells on the surface, block by block, to their places among all cells.
    pub(crate) fn all_cells(&self, bands: usize, gathered: &[f64]) -> Vec<f64> {
        let mut values = vec![f64::NAN; self.size[0] * self.size[1] * bands];
        for (&cell, of_bands) in self.cells.iter().zip(gathered.chunks_exact(bands)) {
            values[cell * bands..][..bands].copy_from_slice(of_bands);
        }
        values
    }

    /// Evaluates the polynomials of the surface's elements: the light reflected to all cells, cell
    /// by cell and band by band; zero where there are no polynomials.
    fn polynomials(&self, bands: usize, radiosity: &Radiosity) -> Vec<f64> {
        let mut values = vec![0.0; self.size[0] * self.size[1] * bands];
        let elements = radiosity.elements_on(self.area);
        for (&cell, &point) in self.cells.iter().zip(&self.points) {
            radiosity.add_polynomial(&elements, point, &mut values[cell * bands..][..bands]);
        }
        values
    }

    /// Gathers the light that surfaces reflect to some cells with about this spacing, cell by cell
    /// and band by band.
    fn reflected(
        &self,
        (cells, gap): (&[usize], usize),
        bands: usize,
        radiosity: &Radiosity,
        watch: &dyn Watch,
        note: &(dyn Fn(usize) + Sync),
    ) -> Vec<f64> {
        let [columns, _] = self.size;
        let side = BLOCK.max(2 * gap);
        let mut order: Vec<usize> = (0..cells.len()).collect();
        let block = |index: usize| [cells[index] / columns, cells[index] % columns].map(|place| place / side);
        order.sort_by_key(|&index| block(index));
        let groups: Vec<&[usize]> = order.chunk_by(|&one, &other| block(one) == block(other)).collect();
        let each = |scratch: &mut Scratch, group: &[usize]| {
            let mut found = vec![f64::NAN; bands * group.len()];
            let places = || group.iter().map(|&index| [cells[index] % columns, cells[index] / columns]);
            let points: Vec<Vector> = places().map(|place| self.middle(place)).collect();
            let corners = self.outline(&Cut::around(places()));
            let outline = corners.as_deref().unwrap_or(&points);
            let measure = Measure::Plane(self.normal);
            if !watch.is_stopped() {
                radiosity.gather_reflected(Group { points: &points, outline, measure }, scratch, &mut found);
            }
            if watch.is_stopped() {
                found.fill(f64::NAN);
            } else {
                note(group.len());
            }
            found
        };
        let found = Parallelism::of(radiosity.operations(cells.len()))
            .map(&groups, |scratch, group| each(scratch, group));
        let mut values = vec![f64::NAN; bands * cells.len()];
        for (&index, of_cell) in order.iter().zip(found.iter().flat_map(|found| found.chunks_exact(bands))) {
            values[index * bands..][..bands].copy_from_slice(of_cell);
        }
        values
    }

    /// Returns each block with its part of a list that is ordered cell by cell and band by band.
    pub(crate) fn parts<'g>(
        &'g self,
        bands: usize,
        mut values: &'g mut [f64],
    ) -> Vec<(Group<'g>, &'g mut [f64])> {
        let measure = Measure::Plane(self.normal);
        let mut start = 0;
        let part = |block: &'g Block| {
            let points = &self.points[start..block.end];
            start = block.end;
            // where a corner is off the surface, the hull of the others is not the hull of the
            // cells
            let outline = block.corners.as_deref().unwrap_or(points);
            let (own, rest) = std::mem::take(&mut values).split_at_mut(bands * points.len());
            values = rest;
            (Group { points, outline, measure }, own)
        };
        self.blocks.iter().map(part).collect()
    }
}

/// Rectangle of cells, given by its first and its last cell.
struct Cut {
    first: [usize; 2],
    last: [usize; 2],
}

/// Returns the rectangles of the blocks of a grid of this size, row by row.
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
    /// Returns the smallest rectangle around some cells.
    fn around(mut cells: impl Iterator<Item = [usize; 2]>) -> Self {
        let one = cells.next().expect("no group is empty");
        let grow = |Self { first, last }: Self, cell: [usize; 2]| Self {
            first: [0, 1].map(|axis| first[axis].min(cell[axis])),
            last: [0, 1].map(|axis| last[axis].max(cell[axis])),
        };
        cells.fold(Self { first: one, last: one }, grow)
    }

    /// Returns the cells at its corners, in order around it: two for a block of one row or column,
    /// one for a single cell.
    fn corners(&self) -> Corners<[usize; 2]> {
        let [[left, low], [right, high]] = [self.first, self.last];
        let mut corners = smallvec![[left, low], [right, low], [right, high], [left, high]];
        corners.dedup();
        if corners.len() > 1 && corners.first() == corners.last() {
            corners.pop();
        }
        corners
    }
}

/// Returns the centres of the columns of a grid over an outline with this unit normal, on its
/// lowest edge, and the offsets of the rows from that edge.
fn middles(outline: &[Vector], normal: Vector, [columns, rows]: [usize; 2]) -> Option<[Vec<Vector>; 2]> {
    let rectangle = BoundingRectangle::of(outline, normal)?;
    let middles = |count: usize| (0..count).map(|index| index as f64 + 0.5);
    Some([rectangle.on_lowest_edge(middles(columns), columns), rectangle.offsets(middles(rows), rows)])
}

/// Whether a point of the plane of a convex face lies on it.
fn lies_on(point: Vector, face: &Face) -> bool {
    let corners = &face.vertices;
    (0..corners.len()).all(|i| {
        let (a, b) = (corners[i], corners[(i + 1) % corners.len()]);
        face.normal.dot((b - a).cross(point - a)) >= 0.0
    })
}
