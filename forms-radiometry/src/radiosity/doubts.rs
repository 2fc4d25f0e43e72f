//! Doubts: errors of answers due to shadow borders on elements, and to direct light that nodes miss.

use super::importance::GoalKind;
use super::partial::spread;
use super::solution::{Reflection, Solved};
use super::system::Radiosity;
use super::transport::{Group, Scratch};

/// Residual at which the possible errors over all reflections end, relative to those of one; what is
/// left is added to them.
const RESIDUAL: f64 = 1e-6;

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
        if let Some(reflection) = self.reflection.as_ref().filter(|_| self.is_doubtful()) {
            let Reflection { operator, reflectances, .. } = reflection;
            let bands = reflectances.len();
            let once = operator.sums(bands, |element, weights, sums| {
                let astray = self.astray(element, weights);
                for (band, sum) in sums.iter_mut().enumerate() {
                    *sum += reflectances[band][element] * astray(band);
                }
            });
            let Solved { mut irradiance, tail, .. } =
                reflection.solve(&once, self.question.orders, RESIDUAL, self.watch);
            for (doubts, tail) in irradiance.iter_mut().zip(tail) {
                doubts.iter_mut().for_each(|doubt| *doubt += tail);
            }
            self.doubts = irradiance;
        }
    }

    /// Whether the irradiance of an element differs from that of its nodes.
    pub(crate) fn is_doubtful(&self) -> bool {
        self.missed.iter().chain(&self.jumps).flatten().any(|&irradiance| irradiance > 0.0)
    }

    /// Returns the function that gives for each band the light of an element that its nodes, with
    /// these weights, do not represent, for a reflectance of 1.
    fn astray(&self, element: usize, weights: &[f64]) -> impl Fn(usize) -> f64 {
        let of = move |all: &[Vec<f64>], band: usize| of_element(all, element, band);
        let is_exact = |band: usize| of(&self.jumps, band) == 0.0 && of(&self.missed, band) == 0.0;
        let (spread, whole) = match (0..self.scene.band_count()).all(is_exact) {
            true => (0.0, 0.0),
            false => (
                spread(weights, &self.elements[element]),
                weights.iter().map(|weight| weight.abs()).sum::<f64>(),
            ),
        };
        move |band| {
            let [jump, missed] = [of(&self.jumps, band), of(&self.missed, band)];
            (jump + missed) * spread + missed * whole
        }
    }

    /// Returns for each band the possible error of an answer due to shadow borders on elements and
    /// to light that the nodes miss.
    pub(crate) fn doubt(&self, what: GoalKind, scratch: &mut Scratch) -> Vec<f64> {
        let mut sums = vec![0.0; self.scene.band_count()];
        match what {
            // the light that arrives at a point from elements is reflected
            GoalKind::At { .. } if self.question.orders == Some(0) => {}
            GoalKind::At { position, measure } => {
                let points = [position];
                let group = Group { points: &points, outline: &points, measure };
                self.weigh(group, scratch, |source, _, weights| {
                    let element = &self.elements[source];
                    let astray = self.astray(source, weights);
                    for (band, sum) in sums.iter_mut().enumerate() {
                        let doubts = self.doubts[band][self.first[source]..].iter();
                        let arriving: f64 =
                            weights.iter().zip(doubts).map(|(w, doubt)| w.abs() * doubt).sum();
                        *sum += self.reflectance(element, band) * (arriving + astray(band));
                    }
                });
            }
            GoalKind::Mean { area } => {
                let is_integral = self.straight.get(&area).is_some_and(|integral| integral.kinds.luminaires);
                if self.question.direct && !is_integral {
                    sums = self.missed_of(area);
                }
                for index in self.elements_on(area) {
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
