//! Partially shadowed elements: the direct light of point and distant lights at their nodes, and
//! its possible error.
//!
//! ```text
//! all of it lit or dark       D at the nodes
//! the part f of it lit        D = Φ/A at all nodes,
//!                             jump = (1/A) ∫ |D(x) − Φ/A| dA
//!                                  ≤ 2 f (1 − f) D of the lit part + its spread
//! ```
//! The flux Φ of the element is therefore correct wherever the nodes are, and no shadow that falls
//! between them is missed. D does not say where on the element the shadow lies. The possible error
//! of an answer is therefore the jump times half of the variation of the irradiance weight over the
//! element, and the effect of this error over all reflections.

use super::direct::{hides, reaching_factor};
use super::element::Element;
use super::gather::{Group, Scratch, Transport};
use super::importance::GoalKind;
use super::measure::Measure;
use super::shadows::{Shadows, measure, spectrum};
use super::solution::of_bands;
use super::system::Radiosity;
use crate::geometry::{Lit, Vector, area, intersection};
use crate::scene::{Light, Scene};
use forms::math::Real;

/// Parts of an element below this are no more than rounding.
const NOTHING: f64 = 1e-9;

/// Direct light of point and distant lights on an element.
pub(super) struct OnElement {
    /// For each node, in each band.
    pub(super) nodes: Vec<Vec<f64>>,
    /// Excess of this light over the light that reaches the node.
    pub(super) more: Vec<Vec<f64>>,
    /// For each band the mean deviation of the irradiance from this light.
    pub(super) jump: Vec<f64>,
}

/// The same for one light, over its intensity or irradiance.
struct OfLight {
    /// The light that reaches each node.
    seen: Vec<f64>,
    /// The mean, and the deviation of the irradiance from it, if the mean replaces the light at the
    /// nodes.
    mean: Option<f64>,
    jump: f64,
}

impl Shadows {
    /// Returns the direct light of point and distant lights on an element with this outline.
    pub(super) fn on_element(
        &self,
        (element, outline): (&Element, &[Vector]),
        scene: &Scene,
        transport: &Transport,
    ) -> OnElement {
        let bands = scene.band_count();
        let nothing = vec![vec![0.0; bands]; element.count()];
        let mut sums = OnElement { nodes: nothing.clone(), more: nothing, jump: vec![0.0; bands] };
        for (number, light) in scene.lights.iter().enumerate() {
            let OfLight { seen, mean, jump } =
                of_light(light, self.lit(element.face, number), (element, outline), transport);
            let of_bands = spectrum(light);
            let add = |sums: &mut [f64], factor: f64| {
                sums.iter_mut().zip(of_bands).for_each(|(sum, of_band)| *sum += factor * of_band);
            };
            for ((nodes, more), seen) in sums.nodes.iter_mut().zip(&mut sums.more).zip(seen) {
                let taken = mean.unwrap_or(seen);
                add(nodes, taken);
                add(more, taken - seen);
            }
            add(&mut sums.jump, jump);
        }
        sums
    }
}

fn of_light(
    light: &Light,
    lit: Option<&Lit>,
    (element, outline): (&Element, &[Vector]),
    transport: &Transport,
) -> OfLight {
    let points: Vec<Vector> = element.nodes().collect();
    let plane = Measure::Plane(element.normal);
    let open: Vec<f64> = points.iter().map(|&point| reaching_factor(light, point, plane)).collect();
    let [least, largest] = [f64::min, f64::max].map(|f| open.iter().copied().reduce(f).unwrap_or(0.0));
    let seen = || {
        let at = |(&point, &open): (&Vector, &f64)| {
            if open == 0.0 || hides(light, point, transport) { 0.0 } else { open }
        };
        points.iter().zip(&open).map(at).collect()
    };
    let mut found = OfLight { seen: seen(), mean: None, jump: 0.0 };
    let Some(lit) = lit else { return OfLight { jump: largest, ..found } };
    if lit.is_whole {
        return found;
    }
    let pieces = lit.pieces.iter().map(|piece| intersection(piece, outline, element.normal));
    let pieces: Vec<Vec<Vector>> = pieces.filter(|piece| !piece.is_empty()).collect();
    let part = pieces.iter().map(|piece| area(piece, element.normal)).sum::<f64>() / element.area;
    if !(NOTHING..=1.0 - NOTHING).contains(&part) {
        return found;
    }
    let flux: f64 = pieces.iter().map(|piece| measure(light, piece).value.to_f64()).sum();
    found.jump = 2.0 * (1.0 - part) * flux / element.area + (largest - least);
    found.mean = Some(flux / element.area);
    found
}

/// Returns half of the variation of the irradiance weight over an element, times its area,
/// estimated from the weights of its nodes; for a single node, the whole weight. The half variation
/// is doubled, as the nodes do not reach the ends.
fn spread(weights: &[f64], element: &Element) -> f64 {
    let of_parts = weights.iter().zip(&element.reference().weights).map(|(weight, part)| weight.abs() / part);
    if weights.len() == 1 {
        return weights[0].abs();
    }
    let (low, high) = of_parts.fold((f64::INFINITY, 0.0_f64), |(low, high), x| (low.min(x), high.max(x)));
    high - low
}

/// Returns the value of an element in a band; 0 if there are no values.
fn of_element(all: &[Vec<f64>], element: usize, band: usize) -> f64 {
    all.get(band).and_then(|band| band.get(element)).copied().unwrap_or(0.0)
}

impl Radiosity<'_> {
    /// Recomputes the direct light that nodes miss. From it, and from the shadow borders on
    /// elements, computes for each band the possible error of the irradiance of each node over all
    /// reflections; empty if there is neither.
    pub(super) fn doubt_anew(&mut self) {
        self.residuals = self.residuals();
        self.missed = self.missed();
        self.doubts = Vec::new();
        if let Some(operator) = self.operator.as_ref().filter(|_| self.is_doubtful()) {
            let reflectances = self.reflectances();
            let once = |(band, reflectances): (usize, &Vec<f64>)| {
                operator.sums(|element, weights| reflectances[element] * self.astray(element, band, weights))
            };
            let once: Vec<Vec<f64>> = reflectances.iter().enumerate().map(once).collect();
            self.doubts =
                of_bands(operator, &reflectances, &once, self.question.orders, self.watch).irradiance;
        }
    }

    /// Whether the irradiance of an element differs from that of its nodes.
    pub(crate) fn is_doubtful(&self) -> bool {
        self.missed.iter().chain(&self.jumps).flatten().any(|&irradiance| irradiance > 0.0)
    }

    /// Returns the light of an element that its nodes, with these weights, do not represent, for a
    /// reflectance of 1.
    fn astray(&self, element: usize, band: usize, weights: &[f64]) -> f64 {
        let [jump, missed] = [&self.jumps, &self.missed].map(|all| of_element(all, element, band));
        if jump == 0.0 && missed == 0.0 {
            return 0.0;
        }
        let whole: f64 = weights.iter().map(|weight| weight.abs()).sum();
        (jump + missed) * spread(weights, &self.elements[element]) + missed * whole
    }

    /// Returns for each band the possible error of an answer due to shadow borders on elements and
    /// to light that the nodes miss.
    pub(crate) fn doubt(&self, what: GoalKind, scratch: &mut Scratch) -> Vec<f64> {
        let mut sums = vec![0.0; self.scene.band_count()];
        match what {
            GoalKind::At { position, measure } => {
                let points = [position];
                let group = Group { points: &points, outline: &points, measure };
                self.weigh(group, None, scratch, |source, _, weights| {
                    let element = &self.elements[source];
                    for (band, sum) in sums.iter_mut().enumerate() {
                        let doubts = self.doubts[band][self.first[source]..].iter();
                        let arriving: f64 =
                            weights.iter().zip(doubts).map(|(w, doubt)| w.abs() * doubt).sum();
                        *sum +=
                            self.reflectance(element, band) * (arriving + self.astray(source, band, weights));
                    }
                });
            }
            GoalKind::Mean { surface } => {
                let is_integral =
                    self.straight[surface].as_ref().is_some_and(|integral| integral.kinds.luminaires);
                if self.question.direct && !is_integral {
                    sums = self.missed_of(surface);
                }
                for index in self.elements_on(surface) {
                    for (area, node) in self.elements[index].areas().zip(self.first[index]..) {
                        sums.iter_mut()
                            .zip(&self.doubts)
                            .for_each(|(sum, doubts)| *sum += area * doubts[node]);
                    }
                }
            }
        }
        sums
    }

    /// Returns the uncertain part of an element's irradiance, relative to the largest irradiance,
    /// in the band where this ratio is largest.
    pub(super) fn jump(&self, element: usize) -> f64 {
        let of_band = |(band, &brightest): (usize, &f64)| {
            let jump: f64 =
                [&self.jumps, &self.missed].map(|all| of_element(all, element, band)).iter().sum();
            if jump > 0.0 { jump / brightest.max(jump) } else { 0.0 }
        };
        self.brightest.iter().enumerate().map(of_band).fold(0.0, f64::max)
    }
}
