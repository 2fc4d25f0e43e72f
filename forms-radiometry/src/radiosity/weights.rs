//! Weights: the visible pieces of an element become what a receiver gets from each of the element's nodes.
//!
//! ```text
//! Wₖ = ∫ φₖ(y) dμ(y)     over the pieces, μ the measure of the receiver (a form factor, say), φₖ the polynomial of node k
//! ```
//! A piece is cut until Gauss rules hold what is asked for: on a patch of radius r at the distance d the integrand is
//! analytic in an ellipse of the size ϱ = d/r + √((d/r)² − 1), and q points leave an error like ϱ^(−2q) of the patch's own light.
//! All patches are held to the same, for errors of neighbours have one sign. Then the weights of the piece are corrected so that
//! their sum is its measure exactly, by its closed form: what a uniform element sends is right to rounding, however near it is.

use super::element::Element;
use super::gather::{Group, Scratch, Transport};
use super::measure::Measure;
use super::reference::MOST_NODES;
use crate::geometry::{Patch, Vector, gauss, patches};
use crate::kernels::exchange_density;

/// The most points of a rule along one side; patches that would need more are cut.
const MOST_POINTS: usize = 4;
/// How often a patch is halved at most. What is left then is a millionth of it in area.
const DEEPEST: u32 = 20;
/// Pieces whose radius is this fraction of their distance are measured by the rule alone: in the closed form, the sum over
/// the edges would cancel.
const SMALL: f64 = 1e-3;

/// What the weights of one piece are made in.
struct Piece<'e> {
    element: &'e Element,
    position: Vector,
    measure: Measure,
    /// The error that the rules may leave, relative to the light that arrives.
    accuracy: f64,
    weights: [f64; MOST_NODES],
    /// The same with the solid angle as the measure.
    solid: [f64; MOST_NODES],
}

impl Transport {
    /// Calls `each` with the index of a point and what it gets from each node of an element, where it gets any.
    pub(super) fn weigh(
        &self,
        group: Group,
        (element, outline): (&Element, &[Vector]),
        scratch: &mut Scratch,
        mut each: impl FnMut(usize, &[f64]),
    ) {
        let mut current = None;
        let mut weights = [0.0; MOST_NODES];
        let count = element.count();
        self.see(group, (outline, element.normal), scratch, |index, piece| {
            if let Some(last) = current.replace(index)
                && last != index
            {
                each(last, &weights[..count]);
                weights = [0.0; MOST_NODES];
            }
            add(piece, element, group.points[index], group.measure, self.accuracy, &mut weights);
        });
        if let Some(last) = current {
            each(last, &weights[..count]);
        }
    }
}

/// Adds to `weights` what a receiver gets from each node of an element through this convex piece of it, relative to the
/// receiver.
pub(super) fn add(
    piece: &[Vector],
    element: &Element,
    position: Vector,
    measure: Measure,
    accuracy: f64,
    weights: &mut [f64],
) {
    let zero = [0.0; MOST_NODES];
    let mut sums = Piece { element, position, measure, accuracy, weights: zero, solid: zero };
    patches(piece).for_each(|patch| sums.add(&patch, 0));
    let share = sums.correction(piece);
    for ((weight, own), solid) in weights.iter_mut().zip(sums.weights).zip(sums.solid) {
        *weight += own + share * solid;
    }
}

impl Piece<'_> {
    /// What has to be added, in parts of the solid angle, to make the sum of the weights exact.
    fn correction(&self, piece: &[Vector]) -> f64 {
        let solid: f64 = self.solid.iter().sum();
        let distance = piece.iter().map(|v| v.length()).fold(f64::INFINITY, f64::min);
        let extent = piece.iter().map(|&v| (v - piece[0]).length()).fold(0.0, f64::max);
        if solid <= 0.0 || extent < SMALL * distance {
            return 0.0;
        }
        (self.measure.of(piece) - self.weights.iter().sum::<f64>()) / solid
    }

    fn add(&mut self, patch: &Patch, depth: u32) {
        let (centre, _) = patch.at(0.5, 0.5);
        let (radius, squared) = (patch.radius(centre), centre.dot(centre));
        let ratio = squared.sqrt() / radius;
        let points = if ratio > 1.0 {
            let ellipse = ratio + (ratio * ratio - 1.0).sqrt();
            (-0.5 * self.accuracy.ln() / ellipse.ln()).ceil()
        } else {
            f64::INFINITY
        };
        if points <= MOST_POINTS as f64 || depth >= DEEPEST {
            self.add_points(patch, (points.min(MOST_POINTS as f64) as usize).max(1));
        } else if let Some(halves) = patch.halves() {
            halves.iter().for_each(|half| self.add(half, depth + 1));
        } else {
            patch.quarters().iter().for_each(|quarter| self.add(quarter, depth + 2));
        }
    }

    fn add_points(&mut self, patch: &Patch, points: usize) {
        let normal = self.element.normal;
        for &[s, of_s] in gauss(points) {
            for &[t, of_t] in gauss(points) {
                let (way, density) = patch.at(s, t);
                let towards = (1.0 / way.dot(way).sqrt()) * way;
                let solid = exchange_density::unguarded(
                    way.x, way.y, way.z, towards.x, towards.y, towards.z, normal.x, normal.y, normal.z,
                );
                let solid = (of_s * of_t * density * solid).max(0.0);
                let own = solid * self.measure.factor(towards);
                let basis = self.element.basis(self.position + way);
                for (k, value) in basis.iter().enumerate().take(self.element.count()) {
                    self.weights[k] += own * value;
                    self.solid[k] += solid * value;
                }
            }
        }
    }
}
