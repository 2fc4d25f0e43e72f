//! Outlines in columns: what points see of a luminaire becomes columns of corners, a kernel over the pairs of neighbours gives
//! what each edge adds, and sums over edges what each point gets.
//!
//! ```text
//! all points see the whole     corner 1 from every point │ corner 2 from every point │ … │ corner 1 again
//! each sees its own pieces     the corners of a piece, the first one again │ those of the next piece, or of a line of a border │ …
//! ```
//! Rows are pairs of a corner and what stands one block, or one place, further on. Corners are relative to the points.

use super::measure::Measure;
use crate::geometry::Vector;
use crate::kernels::edge_form_factor;

/// Fewer rows than this are computed one by one: the fewest rows of a batch take as long as 12 rows one by one (0.5 µs).
const FEW: usize = 12;

/// Corners in columns, reused from luminaire to luminaire.
#[derive(Default)]
pub(super) struct Outlines {
    /// The points that see.
    points: [Vec<f64>; 3],
    corners: [Vec<f64>; 3],
    /// Of each piece the point that sees it and where its corners end, the first one again among them.
    pieces: Vec<(usize, usize)>,
    /// The direction that edges are measured along, at least as many times as there are rows.
    along: [Vec<f64>; 3],
    values: Vec<f64>,
}

impl Outlines {
    /// Adds to the sum of each point its measure, over π, of a luminaire of which all points see the whole.
    pub(super) fn add_whole(
        &mut self,
        points: &[Vector],
        luminaire: &[Vector],
        measure: Measure,
        sums: &mut [f64],
    ) {
        let Some((along, sign)) = along(measure) else {
            let mut piece = Vec::with_capacity(luminaire.len());
            for (&point, sum) in points.iter().zip(sums) {
                piece.clear();
                piece.extend(luminaire.iter().map(|&corner| corner - point));
                *sum += measure.of(&piece);
            }
            return;
        };
        for (axis, (column, of_points)) in self.corners.iter_mut().zip(&mut self.points).enumerate() {
            of_points.clear();
            of_points.extend(points.iter().map(|point| point.coordinates()[axis]));
            column.clear();
            for corner in luminaire.iter().chain(luminaire.first()) {
                let place = corner.coordinates()[axis];
                column.extend(of_points.iter().map(|point| place - point));
            }
        }
        self.measure_rows(along, points.len());
        for of_edge in self.values.chunks_exact(points.len()) {
            sums.iter_mut().zip(of_edge).for_each(|(sum, value)| *sum += sign * value);
        }
    }

    /// Forgets all pieces.
    pub(super) fn clear(&mut self) {
        self.corners.iter_mut().for_each(Vec::clear);
        self.pieces.clear();
    }

    /// Takes a convex piece that a point sees.
    pub(super) fn push(&mut self, point: usize, piece: &[Vector]) {
        self.extend(point, piece.iter().chain(piece.first()));
    }

    /// Takes a line along the border of what a point sees, which other lines close; not for measures that are no sums over edges.
    pub(super) fn push_line(&mut self, point: usize, line: &[Vector]) {
        self.extend(point, line.iter());
    }

    fn extend<'v>(&mut self, point: usize, corners: impl Iterator<Item = &'v Vector>) {
        let [x, y, z] = &mut self.corners;
        for corner in corners {
            x.push(corner.x);
            y.push(corner.y);
            z.push(corner.z);
        }
        self.pieces.push((point, x.len()));
    }

    /// Adds to the sum of each point its measure, over π, of the pieces that it sees.
    pub(super) fn add_pieces(&mut self, measure: Measure, sums: &mut [f64]) {
        if self.pieces.is_empty() {
            return;
        }
        let Some((along, sign)) = along(measure) else {
            let [x, y, z] = &self.corners;
            let mut start = 0;
            for &(point, end) in &self.pieces {
                let piece: Vec<Vector> = (start..end - 1).map(|i| Vector::new(x[i], y[i], z[i])).collect();
                sums[point] += measure.of(&piece);
                start = end;
            }
            return;
        };
        self.measure_rows(along, 1);
        let mut start = 0;
        for &(point, end) in &self.pieces {
            // the row from the end of a piece to the next one is no edge
            sums[point] += sign * self.values[start..end - 1].iter().sum::<f64>();
            start = end;
        }
    }

    /// What the edges from each corner to the one so many places further on add.
    fn measure_rows(&mut self, along: Vector, step: usize) {
        let [x, y, z] = &self.corners;
        let rows = x.len() - step;
        if rows < FEW {
            let [nx, ny, nz] = along.coordinates();
            let edge = |(from, to): (usize, usize)| {
                edge_form_factor(x[to], y[to], z[to], x[from], y[from], z[from], nx, ny, nz)
            };
            self.values.clear();
            self.values.extend((0..rows).zip(step..).map(edge));
            return;
        }
        fill(&mut self.along, along.coordinates(), rows);
        self.values.resize(rows, 0.0);
        let [nx, ny, nz] = self.along.each_ref().map(|column| &column[..rows]);
        let (from, to) = (..rows, step..);
        // a luminaire is clockwise as the point sees it: its edges are taken backwards
        edge_form_factor::batch(
            &x[to.clone()],
            &y[to.clone()],
            &z[to],
            &x[from],
            &y[from],
            &z[from],
            nx,
            ny,
            nz,
            &mut self.values,
        )
        .expect("columns grow together");
    }
}

/// Makes columns of one value each at least so long. From group to group and from element to element most values are the same.
pub(super) fn fill<const N: usize>(columns: &mut [Vec<f64>; N], values: [f64; N], rows: usize) {
    for (column, value) in columns.iter_mut().zip(values) {
        if column.first() != Some(&value) {
            column.clear();
        }
        if column.len() < rows {
            column.resize(rows, value);
        }
    }
}

/// The direction along which edges are measured, and the sign of their sum; nothing for a measure that is no sum over edges.
fn along(measure: Measure) -> Option<(Vector, f64)> {
    match measure {
        Measure::Plane(normal) => Some((normal, 1.0)),
        Measure::Flow(axis) => Some((axis, -1.0)),
        Measure::Sphere => None,
    }
}
