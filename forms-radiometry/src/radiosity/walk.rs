//! Walks: what one random path finds of E − Ẽ at a point, Ẽ being its control variate.
//!
//! ```text
//! E(y) − Ẽ(y) = D(y) + ⟨ρ(y') Ẽ(y') − Ẽ(y) + ρ(y') (E − Ẽ)(y')⟩        y' where a ray of density cos θ/π from y ends
//! ```
//! A path goes on with the probability ρ, so that no weight exceeds one. In a furnace every term is zero, and so is the spread.
//!
//! Sources: E. Lafortune, Y. Willems, The ambient term as a variance reducing technique for Monte Carlo ray tracing (1994), with
//! a solution instead of a constant; J. Arvo, D. Kirk, Particle transport and image synthesis (1990), for how paths end.

use super::directions::above;
use super::gather::Scratch;
use super::paths::{Paths, Place};
use crate::kernels::irradiance;
use crate::sampling::Random;

/// The most reflections that a path is followed; what is left then is part of the error.
const MOST_REFLECTIONS: u32 = 512;

/// Which light at the begin of a path is meant.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Begin {
    /// What is reflected there to the receiver.
    Reflecting,
    /// What arrives there, for it is the receiver.
    Receiving,
}

/// Where a path is.
#[derive(Clone, Copy)]
struct Step {
    at: Place,
    is_first: bool,
    begin: Begin,
    /// Whether light straight from lights counts here.
    has_direct: bool,
    /// How many reflections are asked for between the lights and this point, if a number is.
    left: Option<u32>,
}

impl Paths<'_> {
    /// What of E − Ẽ at a point one path finds, added to the sums times a weight for each band. Returns how much of it the end of the path
    /// may have cut off at most, for the band where that is most.
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

    /// What a path finds at a point, for each band, and where it meets what is reflected there.
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

    /// For each band D − Ẽ at a point of a path. Of a number of orders only the first point has an Ẽ.
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
