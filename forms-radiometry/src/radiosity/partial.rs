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

use super::element::Element;
use super::measure::Measure;
use super::point_lights::{hides, measure, reaching_factor, spectrum};
use super::shadows::Shadows;
use super::transport::Transport;
use crate::geometry::{Vector, area, intersection};
use crate::scene::{Light, Scene};
use crate::visibility::Lit;
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
pub(super) fn spread(weights: &[f64], element: &Element) -> f64 {
    let of_parts = weights.iter().zip(&element.reference().weights).map(|(weight, part)| weight.abs() / part);
    if weights.len() == 1 {
        return weights[0].abs();
    }
    let (low, high) = of_parts.fold((f64::INFINITY, 0.0_f64), |(low, high), x| (low.min(x), high.max(x)));
    high - low
}
