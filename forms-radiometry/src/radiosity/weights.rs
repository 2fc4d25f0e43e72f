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
use super::gather::{Group, Scratch, Seen, Transport};
use super::measure::Measure;
use super::reference::MOST_NODES;
use super::system::Radiosity;
use super::whole::FEWEST;
use crate::geometry::{Face, Patch, Vector, gauss, patches};
use crate::kernels::exchange_density;

/// The most points of a rule along one side; patches that would need more are cut.
const MOST_POINTS: usize = 4;
/// How often a patch is halved at most. What is left then is a millionth of it in area.
const DEEPEST: u32 = 20;
/// Pieces whose radius is this fraction of their distance are measured by the rule alone: in the closed form, the sum over
/// the edges would cancel.
pub(super) const SMALL: f64 = 1e-3;

/// What a group sees of a face, as far as that tells what it sees of its elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum OfFace {
    Nothing,
    /// Every point sees all of it.
    Whole,
    /// Nothing comes in between.
    Open,
    /// Each element has to be asked.
    Parts,
}

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
    /// Calls `each` with the index of a point and what it gets from each node of an element, where it gets any. `of_face` is what the
    /// group sees of the whole face.
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

    /// What a group sees of a whole face, and so of every element of it; what may come in between is kept for those.
    pub(super) fn of_face(&self, group: Group, face: usize, scratch: &mut Scratch) -> OfFace {
        let Face { vertices, normal, .. } = &self.faces[face];
        match self.seen(group, (vertices, *normal), None, &mut scratch.before_face) {
            Seen::Nothing => OfFace::Nothing,
            Seen::Whole => OfFace::Whole,
            Seen::Parts if scratch.before_face.is_empty() => OfFace::Open,
            Seen::Parts => OfFace::Parts,
        }
    }

    /// The same of the points of a group that see no more than parts of an element; those that see all of it are noted.
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
    /// Calls `each` with an element that reflects, the index of a point and what it gets from each node of the element, for all of them but
    /// those of one face; only some if the work is stopped. What a group sees of a face is asked before its elements, which follow each
    /// other.
    pub(super) fn weigh(
        &self,
        group: Group,
        but: Option<usize>,
        scratch: &mut Scratch,
        mut each: impl FnMut(usize, usize, &[f64]),
    ) {
        let mut last = None;
        for (source, element) in self.sources().filter(|(_, element)| Some(element.face) != but) {
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
    patches(piece).for_each(|patch| sums.add(&patch));
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

/// Calls `each` with the points of a rule on a patch, and the area of each; `nearest` is how near the nearest receiver is to a point.
pub(super) fn rule(
    patch: &Patch,
    nearest: &impl Fn(Vector) -> f64,
    accuracy: f64,
    depth: u32,
    each: &mut impl FnMut(Vector, f64),
) {
    let (centre, _) = patch.at(0.5, 0.5);
    let ratio = nearest(centre) / patch.radius(centre);
    let points = if ratio > 1.0 {
        let ellipse = ratio + (ratio * ratio - 1.0).sqrt();
        (-0.5 * accuracy.ln() / ellipse.ln()).ceil()
    } else {
        f64::INFINITY
    };
    if points <= MOST_POINTS as f64 || depth >= DEEPEST {
        let points = gauss((points.min(MOST_POINTS as f64) as usize).max(1));
        patch.by_rule(points, each);
    } else if let Some(halves) = patch.halves() {
        halves.iter().for_each(|half| rule(half, nearest, accuracy, depth + 1, each));
    } else {
        patch.quarters().iter().for_each(|quarter| rule(quarter, nearest, accuracy, depth + 2, each));
    }
}
