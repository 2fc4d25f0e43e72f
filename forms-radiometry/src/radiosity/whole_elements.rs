//! Whole elements: points of a group that see all of an element share one quadrature rule and one
//! batch of the kernel.
//!
//! ```text
//! points, element ─▶ a rule that is fine enough for the nearest point
//!                 ─▶ rows: point × point of the rule ─ exchange_density ─▶ weights
//! ```
//! The points of the rule and the polynomials at them are computed once for all points of the
//! group. The weights of each point are scaled so that their sum is exactly its measure, as in
//! [`weights`](super::weights).

use super::element::Element;
use super::patch_rule::{SMALL, rule};
use super::reference::MOST_NODES;
use crate::form_factor::patches;
use crate::geometry::{Edges, Vector, fill};
use forms_kernels::exchange_density;

/// Minimum number of points for a batch. Fewer points evaluate an element one by one: with the
/// usual rules, of 4 to 16 points, they have fewer rows than it takes for a batch to be faster.
pub(crate) const FEWEST: usize = 4;

/// A rule that points share, and the rows of a batch.
#[derive(Default)]
pub(crate) struct Whole {
    /// The points that see the element.
    seeing: Vec<Vector>,
    /// The points of the rule relative to the element's first corner, with their areas, and the
    /// values of the nodes' polynomials there.
    points: Vec<(Vector, f64)>,
    basis: Vec<[f64; MOST_NODES]>,
    ways: [Vec<f64>; 3],
    /// The normal of the points that see the element, and the normal of the element, repeated at
    /// least once for each row.
    normals: [Vec<f64>; 6],
    densities: Vec<f64>,
    edges: Edges,
    measures: Vec<f64>,
}

impl Whole {
    /// Calls `each` with the index of each of these points and, for a receiver with this normal
    /// there, its weights for the nodes of the element.
    pub(super) fn weigh(
        &mut self,
        seeing: impl Iterator<Item = Vector>,
        normal: Vector,
        (element, outline): (&Element, &[Vector]),
        accuracy: f64,
        mut each: impl FnMut(usize, &[f64]),
    ) {
        self.seeing.clear();
        self.seeing.extend(seeing);
        self.take_rule((element, outline), accuracy);
        self.compute_densities(outline[0], [normal, element.normal]);
        self.measures.clear();
        self.measures.resize(self.seeing.len(), 0.0);
        let Self { seeing, edges, measures, .. } = &mut *self;
        edges.add_form_factors_of_whole((seeing, outline), (normal, 1.0), measures);
        let extent = outline.iter().map(|&v| (v - outline[0]).length()).fold(0.0, f64::max);
        let count = element.count();
        for (index, densities) in self.densities.chunks_exact(self.points.len()).enumerate() {
            let mut weights = [0.0; MOST_NODES];
            let mut sum = 0.0;
            for ((density, (_, area)), basis) in densities.iter().zip(&self.points).zip(&self.basis) {
                let own = density.max(0.0) * area;
                sum += own;
                weights.iter_mut().zip(basis).for_each(|(weight, value)| *weight += own * value);
            }
            let nearest =
                || outline.iter().map(|&v| (v - self.seeing[index]).length()).fold(f64::INFINITY, f64::min);
            if sum > 0.0 && extent >= SMALL * nearest() {
                let scale = self.measures[index] / sum;
                weights.iter_mut().for_each(|weight| *weight *= scale);
            }
            each(index, &weights[..count]);
        }
    }

    /// Computes the points of a rule that is fine enough for all points that see the element.
    fn take_rule(&mut self, (element, outline): (&Element, &[Vector]), accuracy: f64) {
        let Self { seeing, points, basis, .. } = self;
        let local: Vec<Vector> = outline.iter().map(|&v| v - outline[0]).collect();
        let nearest = |centre: Vector| {
            let centre = outline[0] + centre;
            seeing.iter().map(|&x| (centre - x).dot(centre - x)).fold(f64::INFINITY, f64::min).sqrt()
        };
        points.clear();
        basis.clear();
        for patch in patches(&local) {
            rule(&patch, &nearest, accuracy, 0, &mut |point, area| {
                points.push((point, area));
                basis.push(element.basis(outline[0] + point));
            });
        }
    }

    /// Computes the exchange densities of all points that see the element with all points of the
    /// rule.
    fn compute_densities(&mut self, origin: Vector, normals: [Vector; 2]) {
        let Self { seeing, points, ways, densities, .. } = self;
        for (axis, column) in ways.iter_mut().enumerate() {
            column.clear();
            for &x in seeing.iter() {
                let from = (x - origin).coordinates()[axis];
                column.extend(points.iter().map(|(y, _)| y.coordinates()[axis] - from));
            }
        }
        let rows = seeing.len() * points.len();
        let [n, m] = normals;
        fill(&mut self.normals, [n.x, n.y, n.z, m.x, m.y, m.z], rows);
        densities.resize(rows, 0.0);
        let [rx, ry, rz] = &*ways;
        let [nx, ny, nz, mx, my, mz] = self.normals.each_ref().map(|column| &column[..rows]);
        exchange_density::batch_unguarded(rx, ry, rz, nx, ny, nz, mx, my, mz, densities)
            .expect("columns grow together");
    }
}
