//! Weights: computes from the visible pieces of an element the light that a receiver gets from each
//! of the element's nodes.
//!
//! ```text
//! Wₖ = ∫ φₖ(y) dμ(y)   over the pieces, φₖ the polynomial of node k, μ the measure of the receiver
//! ```
//! The measure is a form factor, for example.
//!
//! A piece is cut until Gauss rules reach the requested accuracy: on a patch of radius r at the
//! distance d the integrand is analytic in an ellipse of the size ϱ = d/r + √((d/r)² − 1), and q
//! points leave an error like ϱ^(−2q) of the patch's own light. All patches have the same accuracy,
//! because errors of neighbours have one sign. Then the weights of the piece are corrected so that
//! their sum is exactly its measure, by its closed form: the light of a uniform element is correct
//! to rounding, however close it is.

use super::element::Element;
use super::measure::Measure;
use super::patch_rule::{SMALL, rule};
use super::reference::MOST_NODES;
use super::system::Radiosity;
use super::transport::{Group, Scratch, Seen, Transport};
use super::whole_elements::FEWEST;
use crate::form_factor::{Patch, patches};
use crate::geometry::Vector;
use crate::visibility::Face;
use forms_kernels::exchange_density;

/// Visibility of a face from a group, where it determines the visibility of the elements of the
/// face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum OfFace {
    Nothing,
    /// Every point sees all of it.
    Whole,
    /// There are no occluders.
    Open,
    /// Visibility has to be computed for each element.
    Parts,
}

/// Accumulates the weights of one piece.
struct Piece<'e> {
    element: &'e Element,
    position: Vector,
    measure: Measure,
    /// Allowed quadrature error, relative to the arriving light.
    accuracy: f64,
    weights: [f64; MOST_NODES],
    /// The same with the solid angle as the measure.
    solid: [f64; MOST_NODES],
}

impl Transport {
    /// Calls `each` with the index of a point and its weights for the nodes of an element, for each
    /// point that sees any of it. `of_face` is the visibility of the whole face from the group.
    pub(super) fn weigh(
        &self,
        group: Group,
        source @ (element, outline): (&Element, &[Vector]),
        of_face: OfFace,
        scratch: &mut Scratch,
        mut each: impl FnMut(usize, &[f64]),
    ) {
        let luminaire = (outline, element.normal);
        let Scratch { between, before_face, view, whole, seeing, .. } = scratch;
        let seen = match of_face {
            OfFace::Nothing => Seen::Nothing,
            OfFace::Whole => Seen::Whole,
            OfFace::Open => {
                between.clear();
                self.seen_past(group, luminaire, between)
            }
            OfFace::Parts => self.seen(group, luminaire, Some(before_face), between),
        };
        seeing.clear();
        match seen {
            Seen::Nothing => return,
            Seen::Whole => seeing.extend(0..group.points.len()),
            Seen::Parts => {
                let seen = |each: &mut dyn FnMut(usize, &[Vector])| {
                    self.see_parts(group, luminaire, between, view, each);
                };
                self.weigh_parts(group, source, seen, seeing, &mut each);
            }
        }
        match group.measure {
            Measure::Plane(normal) if seeing.len() >= FEWEST => {
                let points = seeing.iter().map(|&index| group.points[index]);
                let of_point = |point: usize, weights: &[f64]| each(seeing[point], weights);
                whole.weigh(points, normal, source, self.accuracy, of_point);
            }
            _ => {
                let mut piece = Vec::with_capacity(outline.len());
                for &index in &*seeing {
                    let point = group.points[index];
                    piece.clear();
                    piece.extend(outline.iter().map(|&corner| corner - point));
                    let mut weights = [0.0; MOST_NODES];
                    add(&piece, element, point, group.measure, self.accuracy, &mut weights);
                    each(index, &weights[..element.count()]);
                }
            }
        }
    }

    /// Returns the visibility of a whole face from a group, and so of every element of the face.
    /// Keeps the possible occluders for the elements.
    pub(super) fn of_face(&self, group: Group, face: usize, scratch: &mut Scratch) -> OfFace {
        let Face { vertices, normal, .. } = &self.faces[face];
        match self.seen(group, (vertices, *normal), None, &mut scratch.before_face) {
            Seen::Nothing => OfFace::Nothing,
            Seen::Whole => OfFace::Whole,
            Seen::Parts if scratch.before_face.is_empty() => OfFace::Open,
            Seen::Parts => OfFace::Parts,
        }
    }

    /// Weighs an element for the points of a group that see only parts of it; records the points
    /// that see all of it.
    fn weigh_parts(
        &self,
        group: Group,
        (element, outline): (&Element, &[Vector]),
        seen: impl FnOnce(&mut dyn FnMut(usize, &[Vector])),
        seeing: &mut Vec<usize>,
        each: &mut impl FnMut(usize, &[f64]),
    ) {
        let mut current = None;
        let mut weights = [0.0; MOST_NODES];
        let count = element.count();
        seen(&mut |index: usize, piece: &[Vector]| {
            let point = group.points[index];
            if piece.len() == outline.len()
                && piece.iter().zip(outline).all(|(&v, &corner)| v == corner - point)
            {
                seeing.push(index);
                return;
            }
            if let Some(last) = current.replace(index)
                && last != index
            {
                each(last, &weights[..count]);
                weights = [0.0; MOST_NODES];
            }
            add(piece, element, point, group.measure, self.accuracy, &mut weights);
        });
        if let Some(last) = current {
            each(last, &weights[..count]);
        }
    }
}

impl Radiosity<'_> {
    /// Calls `each` with an element that reflects, the index of a point and its weights for the
    /// nodes of the element, for all such elements in their order; only for some if the work is
    /// stopped. The visibility of a face is computed before that of its elements, which follow each
    /// other.
    pub(super) fn weigh(&self, group: Group, scratch: &mut Scratch, each: impl FnMut(usize, usize, &[f64])) {
        self.weigh_some(|_| true, group, scratch, each);
    }

    /// Calls `each` in the same way for some of these elements.
    pub(super) fn weigh_some(
        &self,
        is_asked: impl Fn(usize) -> bool,
        group: Group,
        scratch: &mut Scratch,
        mut each: impl FnMut(usize, usize, &[f64]),
    ) {
        let mut last = None;
        for (source, element) in self.sources().filter(|&(source, _)| is_asked(source)) {
            if self.watch.is_stopped() {
                return;
            }
            let of_face = match last {
                Some((face, seen)) if face == element.face => seen,
                _ => self.transport.of_face(group, element.face, scratch),
            };
            last = Some((element.face, of_face));
            let of_point = |point: usize, weights: &[f64]| each(source, point, weights);
            self.transport.weigh(group, (element, &self.outlines[source]), of_face, scratch, of_point);
        }
    }
}

/// Adds to `weights` the light that a receiver gets from each node of an element through this
/// convex piece of it, relative to the receiver.
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
    patches(piece).for_each(|patch| sums.add(&patch));
    let share = sums.correction(piece);
    for ((weight, own), solid) in weights.iter_mut().zip(sums.weights).zip(sums.solid) {
        *weight += own + share * solid;
    }
}

impl Piece<'_> {
    /// Returns the fraction of the solid angles to add to the weights so that their sum is exact.
    fn correction(&self, piece: &[Vector]) -> f64 {
        let solid: f64 = self.solid.iter().sum();
        let distance = piece.iter().map(|v| v.length()).fold(f64::INFINITY, f64::min);
        let extent = piece.iter().map(|&v| (v - piece[0]).length()).fold(0.0, f64::max);
        if solid <= 0.0 || extent < SMALL * distance {
            return 0.0;
        }
        (self.measure.of(piece) - self.weights.iter().sum::<f64>()) / solid
    }

    fn add(&mut self, patch: &Patch) {
        let (accuracy, normal) = (self.accuracy, self.element.normal);
        rule(patch, &Vector::length, accuracy, 0, &mut |way, area| {
            let towards = (1.0 / way.dot(way).sqrt()) * way;
            let solid = exchange_density::unguarded(
                way.x, way.y, way.z, towards.x, towards.y, towards.z, normal.x, normal.y, normal.z,
            );
            let solid = (area * solid).max(0.0);
            let own = solid * self.measure.factor(towards);
            let basis = self.element.basis(self.position + way);
            for (k, value) in basis.iter().enumerate().take(self.element.count()) {
                self.weights[k] += own * value;
                self.solid[k] += solid * value;
            }
        });
    }
}
