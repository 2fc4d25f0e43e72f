//! Edges in columns: the end points of visible edges are stored in columns, a kernel returns the
//! form-factor term of each edge, and the terms are summed for each point.
//!
//! ```text
//! ends of an edge from every point │ ends of the next │ … ─▶ kernel, row by row ─▶ sums by point
//! ```
//! End points are relative to the point that sees the edge. The edges run along a contour as a
//! point in front of a luminaire sees it: clockwise.

use super::Vector;
use forms_kernels::edge_form_factor;

/// Fewer rows than this are computed one at a time: the smallest batch takes as long as 12 single
/// rows (0.5 µs).
const FEW: usize = 12;

/// Point coordinates in columns, one for each axis.
pub(crate) type Columns = [Vec<f64>; 3];

/// Edges and their form-factor terms, reused from luminaire to luminaire.
#[derive(Clone, Debug, Default)]
pub(crate) struct Edges {
    /// Start points and end points.
    ends: [Columns; 2],
    /// For each row, the index of the point that sees the edge.
    owners: Vec<u32>,
    /// The direction from which θ is measured, repeated at least once for each row.
    along: Columns,
    values: Vec<f64>,
}

impl Edges {
    /// Removes all edges.
    pub(crate) fn clear(&mut self) {
        self.ends.iter_mut().flatten().for_each(Vec::clear);
        self.owners.clear();
    }

    /// Appends the edges of a convex piece that a point sees.
    pub(crate) fn push(&mut self, owner: usize, piece: &[Vector]) {
        let [from, to] = &mut self.ends;
        let next = piece.iter().skip(1).chain(piece.first());
        for (&a, &b) in piece.iter().zip(next) {
            for (columns, end) in [(&mut *from, a), (&mut *to, b)] {
                columns.iter_mut().zip(end.coordinates()).for_each(|(column, place)| column.push(place));
            }
            self.owners.push(owner as u32);
        }
    }

    /// Appends `count` edges for each of these points and returns the columns of their start and
    /// end points to fill in, ordered edge by edge and, within an edge, point by point.
    pub(crate) fn grow(&mut self, points: &[u32], count: usize) -> [[&mut [f64]; 3]; 2] {
        let start = self.owners.len();
        (0..count).for_each(|_| self.owners.extend_from_slice(points));
        let end = self.owners.len();
        self.ends.each_mut().map(|columns| {
            columns.each_mut().map(|column| {
                column.resize(end, 0.0);
                &mut column[start..]
            })
        })
    }

    /// Adds to each point's sum the contribution of its edges to ∫ cos θ dω/π, times a factor; θ is
    /// measured from the direction `along`.
    pub(crate) fn add_form_factors(&mut self, along: Vector, factor: f64, sums: &mut [f64]) {
        let Self { ends: [from, to], owners, along: axes, values } = self;
        measure([from, to].map(|columns| columns.each_ref().map(|column| &column[..])), along, axes, values);
        for (&owner, value) in owners.iter().zip(values) {
            sums[owner as usize] += factor * *value;
        }
    }

    /// Adds the same integral over an outline that all points see completely. Removes all edges.
    pub(crate) fn add_form_factors_of_whole(
        &mut self,
        (points, outline): (&[Vector], &[Vector]),
        (along, factor): (Vector, f64),
        sums: &mut [f64],
    ) {
        self.clear();
        let Self { ends: [corners, _], along: axes, values, .. } = self;
        for (axis, column) in corners.iter_mut().enumerate() {
            for corner in outline.iter().chain(outline.first()) {
                let place = corner.coordinates()[axis];
                column.extend(points.iter().map(|point| place - point.coordinates()[axis]));
            }
        }
        // the end point of an edge is the corner one block further in the column
        let (step, rows) = (points.len(), points.len() * outline.len());
        let ends = [0, step].map(|start| corners.each_ref().map(|column| &column[start..][..rows]));
        measure(ends, along, axes, values);
        for of_edge in values.chunks_exact(step) {
            sums.iter_mut().zip(of_edge).for_each(|(sum, value)| *sum += factor * value);
        }
    }
}

/// Computes the form-factor term of each edge. The point sees the luminaire clockwise: its edges
/// are taken backwards.
fn measure(ends: [[&[f64]; 3]; 2], along: Vector, axes: &mut Columns, values: &mut Vec<f64>) {
    let [[ax, ay, az], [bx, by, bz]] = ends;
    let rows = ax.len();
    if rows < FEW {
        let [nx, ny, nz] = along.coordinates();
        let edge = |i: usize| edge_form_factor(bx[i], by[i], bz[i], ax[i], ay[i], az[i], nx, ny, nz);
        values.clear();
        values.extend((0..rows).map(edge));
        return;
    }
    fill(axes, along.coordinates(), rows);
    values.resize(rows, 0.0);
    let [nx, ny, nz] = axes.each_ref().map(|column| &column[..rows]);
    edge_form_factor::batch(bx, by, bz, ax, ay, az, nx, ny, nz, values).expect("columns grow together");
}

/// Fills each column with one value, for at least `rows` rows. Most values are the same from group
/// to group and from element to element.
pub(crate) fn fill<const N: usize>(columns: &mut [Vec<f64>; N], values: [f64; N], rows: usize) {
    for (column, value) in columns.iter_mut().zip(values) {
        if column.first() != Some(&value) {
            column.clear();
        }
        if column.len() < rows {
            column.resize(rows, value);
        }
    }
}
