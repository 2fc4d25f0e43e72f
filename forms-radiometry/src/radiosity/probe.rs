//! Probes: an estimand is evaluated as means over many rays and over some paths, in independent
//! batches, which give its value and error.
//!
//! ```text
//! value = exact part + mean of the rough light + mean of its correction
//! error = t √(s₁² + s₂²) + u (m₁/n₁ + m₂/n₂),  s² = Σ (batch − mean)²/(16 · 15)
//! ```
//! Each mean is a mean of the means of 16 batches. t is the two-sided 99.99 % quantile of Student's
//! distribution with 15 degrees of freedom. A feature that n points never hit is rarer than u/n
//! with that confidence, u = −ln 0.0001; where rays have to hit light sources, it can be the
//! brightest of them, m. Batches are independent scramblings of one point set (randomized
//! quasi-Monte Carlo); points within a batch are distributed more evenly than random ones, and the
//! spread of the batches shows this. A spread that is small by chance would end the sampling too
//! early, so a doubling is assumed to reduce the error by no more than half.

use super::costs::{BATCHES, FIRST, PATH, STUDENT};
use super::directions::towards;
use super::final_gathering::{FinalGathering, Numbers, Place, larger};
use super::importance::GoalKind;
use super::measure::Measure;
use super::transport::Scratch;
use super::walk::Begin;
use crate::geometry::Vector;
use crate::sampling::{Net, Random, key};
use rayon::prelude::*;

/// An event that never occurred in n trials is rarer than this over n, with the same confidence.
const UNSEEN: f64 = 9.210;
/// Maximum numbers of rays and of paths of a batch.
const MOST: [u32; 2] = [1 << 18, 1 << 16];

/// Number of points of a batch between two checks whether the work is stopped.
const ASKED: u32 = 32;

/// A mean over points, in batches.
#[derive(Clone, Debug)]
struct Mean {
    /// For each batch and band the sum over its points.
    sums: Vec<Vec<f64>>,
    /// Number of points of each batch so far.
    points: u32,
    /// For each band the error estimated from the spread of the batches.
    spread: Vec<f64>,
    /// For each band the largest value that a point can find.
    most: Vec<f64>,
}

/// An estimand.
#[derive(Clone, Debug)]
pub(crate) struct Probe {
    what: GoalKind,
    key: u64,
    /// For each band the part that needs no rays.
    exact: Vec<f64>,
    /// The rough light, and its correction.
    rough: Mean,
    lack: Mean,
    /// Upper bound on the light that truncated paths have missed, as a mean over all paths.
    cut: f64,
}

impl Mean {
    fn new(most: Vec<f64>) -> Self {
        let bands = most.len();
        Self { sums: vec![vec![0.0; bands]; BATCHES], points: 0, spread: vec![f64::INFINITY; bands], most }
    }

    /// Returns a mean of zero that needs no samples.
    fn nothing(bands: usize) -> Self {
        Self { spread: vec![0.0; bands], ..Self::new(vec![0.0; bands]) }
    }

    fn value(&self, band: usize) -> f64 {
        let sum: f64 = self.sums.iter().map(|sums| sums[band]).sum();
        if self.points == 0 { 0.0 } else { sum / (BATCHES as f64 * f64::from(self.points)) }
    }

    /// Adds the sums of more points to each batch, and updates the errors.
    fn add(&mut self, points: u32, sums: Vec<Vec<f64>>) {
        self.points += points;
        for (batch, sums) in self.sums.iter_mut().zip(sums) {
            batch.iter_mut().zip(sums).for_each(|(sum, more)| *sum += more);
        }
        for band in 0..self.spread.len() {
            let mean = self.value(band);
            let off = |sums: &Vec<f64>| (sums[band] / f64::from(self.points) - mean).powi(2);
            let squares: f64 = self.sums.iter().map(off).sum();
            let error = STUDENT * (squares / (BATCHES * (BATCHES - 1)) as f64).sqrt();
            let before = self.spread[band];
            self.spread[band] = if before.is_finite() { error.max(0.5 * before) } else { error };
        }
    }

    /// Returns the error due to features that the points can have missed because they are few.
    fn unseen(&self, band: usize) -> f64 {
        UNSEEN * self.most[band] / (BATCHES as f64 * f64::from(self.points.max(1)))
    }

    fn error(&self, band: usize) -> f64 {
        self.spread[band] + self.unseen(band)
    }
}

impl FinalGathering<'_> {
    /// Creates an estimand with its first rays and paths, if the work is not stopped before.
    /// Different keys are independent.
    pub(crate) fn probe(&self, what: GoalKind, number: u64) -> Probe {
        let bands = self.scene.band_count();
        let mut scratch = Scratch::default();
        let reflects = self.question.orders != Some(0);
        let (exact, gathers, lacks) = match what {
            GoalKind::At { position, measure } => {
                let straight = self.question.direct.then(|| self.straight(position, measure, &mut scratch));
                let gathers = reflects || (self.by_rays && self.question.direct);
                (straight.unwrap_or_else(|| vec![0.0; bands]), gathers, reflects)
            }
            GoalKind::Mean { surface } => (self.rough_mean(surface), false, true),
        };
        let weight = match what {
            GoalKind::At { measure: Measure::Plane(_), .. } | GoalKind::Mean { .. } => 1.0,
            GoalKind::At { .. } => Measure::Sphere.whole(),
        };
        let mut most: Vec<f64> = self.brightest.iter().map(|brightest| weight * brightest).collect();
        if let (GoalKind::Mean { surface }, true) = (what, self.question.direct) {
            most = larger(most, self.most_of_beams_on(surface));
        }
        let mean = |is_sampled| if is_sampled { Mean::new(most.clone()) } else { Mean::nothing(bands) };
        let (rough, lack) = (mean(gathers), mean(lacks));
        let key = self.key(Numbers::Probes, number);
        let mut probe = Probe { what, key, exact, rough, lack, cut: 0.0 };
        if gathers {
            self.add_rays(&mut probe, FIRST[0]);
        }
        if lacks {
            self.add_paths(&mut probe, FIRST[1]);
        }
        probe
    }

    /// Doubles the rays or the paths, whichever pays best; returns `false` if neither can be
    /// doubled. `scales` holds for each band the value that errors are relative to.
    pub(crate) fn improve(&self, probe: &mut Probe, scales: &[f64]) -> bool {
        let relative = |mean: &Mean| {
            let of_band = |(band, scale): (usize, &f64)| {
                let error = mean.error(band);
                if error > 0.0 { error / scale } else { 0.0 }
            };
            scales.iter().enumerate().map(of_band).fold(0.0, f64::max)
        };
        // a doubling takes as much time as all samples so far, and halves the square of the error
        let gain = |mean: &Mean, cost: f64, most: u32| {
            let is_open = mean.points > 0 && mean.points < most;
            if is_open { relative(mean).powi(2) / (cost * f64::from(mean.points)) } else { 0.0 }
        };
        let gains = [gain(&probe.rough, 1.0, MOST[0]), gain(&probe.lack, PATH, MOST[1])];
        if self.watch.is_stopped() || gains[0].max(gains[1]).is_nan() || gains[0].max(gains[1]) <= 0.0 {
            return false;
        }
        if gains[0] > gains[1] {
            self.add_rays(probe, probe.rough.points);
        } else {
            self.add_paths(probe, probe.lack.points);
        }
        true
    }

    fn add_rays(&self, probe: &mut Probe, count: u32) {
        let GoalKind::At { position, measure } = probe.what else { return };
        let first = probe.rough.points;
        let batch = |batch: usize| {
            let net = Net::new(key(probe.key, batch as u64));
            let mut sums = vec![0.0; self.scene.band_count()];
            for index in first..first + count {
                if self.is_stopped_at(index) {
                    break;
                }
                let (direction, weight) = towards(measure, net.point(index));
                self.gather(position, direction, weight, &mut sums);
            }
            sums
        };
        let sums = (0..BATCHES).into_par_iter().map(batch).collect();
        if !self.watch.is_stopped() {
            probe.rough.add(count, sums);
        }
    }

    fn add_paths(&self, probe: &mut Probe, count: u32) {
        let first = probe.lack.points;
        let bands = self.scene.band_count();
        let begins = self.begins(probe.what);
        let batch = |batch: usize| {
            let of_batch = key(probe.key, (BATCHES + batch) as u64);
            let net = Net::new(of_batch);
            let (mut scratch, mut cut) = (Scratch::default(), 0.0_f64);
            let (mut sums, mut unused, mut weights) = (vec![0.0; bands], vec![0.0; bands], vec![0.0; bands]);
            for index in first..first + count {
                if self.is_stopped_at(index) {
                    break;
                }
                let Some((place, begin, weight)) = begins.at(self, net.point(index), &mut unused) else {
                    continue;
                };
                if begin == Begin::Reflecting {
                    weights
                        .iter_mut()
                        .zip(self.reflectance(place.element))
                        .for_each(|(w, rho)| *w = weight * rho);
                } else {
                    weights.fill(weight);
                }
                let mut random = Random::new(key(of_batch, u64::from(index)));
                cut += self.correction(place, begin, &mut random, &mut scratch, [&mut weights, &mut sums]);
            }
            (sums, cut)
        };
        let (sums, cuts): (Vec<Vec<f64>>, Vec<f64>) = (0..BATCHES).into_par_iter().map(batch).unzip();
        if self.watch.is_stopped() {
            return;
        }
        let before = probe.cut * f64::from(first);
        probe.cut = (before + cuts.iter().sum::<f64>() / BATCHES as f64) / f64::from(first + count);
        probe.lack.add(count, sums);
    }

    /// Whether the work is stopped; checked only at some points.
    fn is_stopped_at(&self, index: u32) -> bool {
        index.is_multiple_of(ASKED) && self.watch.is_stopped()
    }

    fn begins(&self, what: GoalKind) -> Begins {
        let GoalKind::Mean { surface } = what else { return Begins::Seen(what) };
        let (mut whole, mut elements, mut ends) = (0.0, Vec::new(), Vec::new());
        for element in self.front(surface) {
            whole += self.subdivision.elements[element].area;
            elements.push(element);
            ends.push(whole);
        }
        Begins::On { elements, ends }
    }

    /// Returns the elements of the front of a surface.
    fn front(&self, surface: usize) -> impl Iterator<Item = usize> {
        let is_on = move |element: &usize| {
            self.transport.faces[self.subdivision.elements[*element].face].is_front_of(surface)
        };
        (0..self.subdivision.elements.len()).filter(is_on)
    }

    /// Returns the mean of the rough irradiance over the front of a surface.
    fn rough_mean(&self, surface: usize) -> Vec<f64> {
        let mut sums = vec![0.0; self.scene.band_count()];
        let mut whole = 0.0;
        for element in self.front(surface) {
            let area = self.subdivision.elements[element].area;
            whole += area;
            let node = self.subdivision.node_of[element] as usize;
            for (band, sum) in sums.iter_mut().enumerate() {
                let straight = if self.question.direct { 0.0 } else { self.direct[band][node] };
                *sum += area * (self.irradiance[band][node] - straight);
            }
        }
        sums.into_iter().map(|sum| sum / whole).collect()
    }
}

/// Starting points of the paths of a probe.
enum Begins {
    /// On the surfaces seen from a point.
    Seen(GoalKind),
    /// On elements, each with the cumulative area up to its end.
    On { elements: Vec<usize>, ends: Vec<f64> },
}

impl Begins {
    /// Returns the start of a path for a point of the square, and its weight.
    fn at(
        &self,
        paths: &FinalGathering,
        [u, v]: [f64; 2],
        unused: &mut [f64],
    ) -> Option<(Place, Begin, f64)> {
        match self {
            Self::Seen(GoalKind::At { position, measure }) => {
                let (direction, weight) = towards(*measure, [u, v]);
                let place = paths.gather(*position, direction, weight, unused)?;
                Some((place, Begin::Reflecting, weight))
            }
            Self::Seen(GoalKind::Mean { .. }) => None,
            Self::On { elements, ends } => {
                let at = u * ends.last()?;
                let index = ends.partition_point(|&end| end <= at).min(ends.len() - 1);
                let begin = if index == 0 { 0.0 } else { ends[index - 1] };
                let within = ((at - begin) / (ends[index] - begin)).clamp(f64::EPSILON, 1.0 - f64::EPSILON);
                let element = elements[index];
                let position: Vector = paths.subdivision.elements[element].image([within, v]);
                Some((Place { element, position }, Begin::Receiving, 1.0))
            }
        }
    }
}

impl Probe {
    /// Returns the cost so far, in rays.
    pub(crate) fn spent(&self) -> f64 {
        BATCHES as f64 * (f64::from(self.rough.points) + PATH * f64::from(self.lack.points))
    }

    /// Returns the value in a band.
    pub(crate) fn value(&self, band: usize) -> f64 {
        self.exact[band] + self.rough.value(band) + self.lack.value(band)
    }

    /// Returns the sampling error of rays and paths in a band, and the bound on the light of
    /// reflections beyond the end of truncated paths.
    pub(crate) fn errors(&self, band: usize) -> [f64; 2] {
        let (rough, lack) = (&self.rough, &self.lack);
        let sampling = rough.spread[band].hypot(lack.spread[band]) + rough.unseen(band) + lack.unseen(band);
        [sampling, self.cut]
    }

    /// Returns the value in a band, and its error.
    pub(crate) fn found(&self, band: usize) -> [f64; 2] {
        let [sampling, orders] = self.errors(band);
        [self.value(band), sampling + orders]
    }
}
