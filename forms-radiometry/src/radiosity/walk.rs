//! Walks: the contribution of one random path to E − Ẽ at a point, with Ẽ as the control variate.
//!
//! ```text
//! E(y) − Ẽ(y) = D(y) + ⟨ρ(y') Ẽ(y') − Ẽ(y) + ρ(y') (E − Ẽ)(y')⟩
//!                                              y' the end of a ray from y with density cos θ/π
//! ```
//! Russian roulette continues a path with the probability ρ, so that no weight exceeds one. In a
//! furnace every term is zero, and so is the variance.
//!
//! Sources: E. Lafortune, Y. Willems, The ambient term as a variance reducing technique for Monte
//! Carlo ray tracing (1994), with a solution instead of a constant; J. Arvo, D. Kirk, Particle
//! transport and image synthesis (1990), for how paths end.

use super::directions::above;
use super::final_gathering::{FinalGathering, Place};
use super::transport::Scratch;
use crate::sampling::Random;
use forms_kernels::irradiance;

/// Maximum number of reflections of a path; the remaining light is part of the error.
const MOST_REFLECTIONS: u32 = 512;

/// Kind of light at the start of a path.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Begin {
    /// Light that is reflected there to the receiver.
    Reflecting,
    /// Light that arrives there, because the point is the receiver.
    Receiving,
}

/// State of a path.
#[derive(Clone, Copy)]
struct Step {
    at: Place,
    is_first: bool,
    begin: Begin,
    /// Whether direct light counts here.
    has_direct: bool,
    /// Maximum number of reflections between the light sources and this point, if it is limited.
    left: Option<u32>,
}

impl FinalGathering<'_> {
    /// Adds the contribution of one path to E − Ẽ at a point to the sums, times a weight for each
    /// band. Returns an upper bound on the contribution that the end of the path truncated, for the
    /// band where it is largest.
    pub(super) fn correction(
        &self,
        at: Place,
        begin: Begin,
        random: &mut Random,
        scratch: &mut Scratch,
        [weights, sums]: [&mut [f64]; 2],
    ) -> f64 {
        let reflected = u32::from(begin == Begin::Reflecting);
        let mut step = Step {
            at,
            is_first: true,
            begin,
            has_direct: begin == Begin::Reflecting || self.question.direct,
            left: self.question.orders.map(|orders| orders - reflected),
        };
        let mut largest = 0.0_f64;
        for _ in 0..MOST_REFLECTIONS {
            let (change, next) = self.step(step, random, scratch);
            for ((sum, weight), change) in sums.iter_mut().zip(&*weights).zip(&change) {
                *sum += weight * change;
                largest = largest.max((weight * change).abs());
            }
            let Some(next) = next else { return 0.0 };
            let rho = self.reflectance(next.element);
            let survival = rho.iter().copied().fold(0.0, f64::max);
            if random.next() >= survival {
                return 0.0;
            }
            weights.iter_mut().zip(rho).for_each(|(weight, rho)| *weight *= rho / survival);
            let left = step.left.map(|left| left - 1);
            step = Step { at: next, is_first: false, has_direct: true, left, ..step };
        }
        largest / (1.0 - self.contraction).max(f64::EPSILON)
    }

    /// Returns the contribution of a path at a point in each band, and the next point, from which
    /// light is reflected.
    fn step(&self, step: Step, random: &mut Random, scratch: &mut Scratch) -> (Vec<f64>, Option<Place>) {
        let mut change = self.local(step, scratch);
        let is_last = step.left == Some(0);
        let meets_lights = self.by_rays && step.has_direct;
        if is_last && !meets_lights {
            return (change, None);
        }
        let normal = self.subdivision.elements[step.at.element].normal;
        let end = self.trace(step.at.position, above(normal, [random.next(), random.next()]));
        if meets_lights {
            let emitted = self.emitted(end.face);
            change.iter_mut().zip(emitted).for_each(|(sum, &l)| *sum += irradiance(1.0, l));
        }
        let next = end.place.filter(|_| !is_last);
        if let (Some(next), None) = (next, step.left) {
            let node = self.node(next);
            let reflectances = self.reflectance(next.element);
            for ((change, rough), rho) in change.iter_mut().zip(&self.irradiance).zip(reflectances) {
                *change += rho * rough[node];
            }
        }
        (change, next)
    }

    /// Returns D − Ẽ at a point of a path for each band. If the number of orders is limited, only
    /// the first point has an Ẽ.
    fn local(&self, step: Step, scratch: &mut Scratch) -> Vec<f64> {
        let mut sum =
            if step.has_direct { self.direct(step.at, scratch) } else { vec![0.0; self.scene.band_count()] };
        if step.is_first || step.left.is_none() {
            let node = self.node(step.at);
            let rough = if step.begin == Begin::Reflecting { &self.reflected } else { &self.irradiance };
            for (band, sum) in sum.iter_mut().enumerate() {
                let straight = if step.has_direct { 0.0 } else { self.direct[band][node] };
                *sum -= rough[band][node] - straight;
            }
        }
        sum
    }
}
