//! Replicates: an estimand is evaluated by independent replicates of one point set; their means
//! give the value and its standard error.
//!
//! ```text
//! value = Σ mᵣ/R     σ² = Σ (mᵣ − value)²/(R (R − 1))     mᵣ the mean of n samples of replicate r
//! ```
//! This is randomized quasi-Monte Carlo: the samples within a replicate are of low discrepancy, so
//! that only the spread between replicates shows their error. The number of samples doubles from
//! round to round. All sums are accumulated in a fixed order, so that the result does not depend on
//! threads.

use super::estimand::Estimand;
use super::path_sampler::PathSampler;
use super::sums::{Bins, Sums};
use crate::job::REPLICATES;
use crate::sampling::{Draws, key};
use rayon::prelude::*;

/// The replicates of an estimand.
#[derive(Clone, Debug)]
pub(crate) struct Replicates {
    key: u64,
    pub(super) of: Vec<Sums>,
    /// Number of samples of each replicate.
    pub(crate) samples: u32,
}

impl Replicates {
    /// Creates replicates without samples, for an estimand that this key identifies.
    pub(crate) fn new(key: u64, estimand: &Estimand, bands: usize, bins: Option<Bins>) -> Self {
        Self { key, of: vec![Sums::new(estimand.numbers(), bands, bins); REPLICATES], samples: 0 }
    }

    /// Adds samples to the selected replicates, up to the number `to`. Returns the number of path
    /// segments that were traced for them. Long paths are cut where the work was stopped.
    pub(crate) fn extend(
        &mut self,
        to: u32,
        estimand: &Estimand,
        samplers: &[Box<dyn PathSampler + '_>],
        is_meant: impl Fn(usize) -> bool + Sync,
        is_stopped: &(dyn Fn() -> bool + Sync),
    ) -> u64 {
        let (from, own) = (self.samples, self.key);
        let extend = |(replicate, sums): (usize, &mut Sums)| {
            let key = key(own, replicate as u64);
            let mut segments = 0;
            for index in from..to {
                for path_samplers in samplers {
                    let mut draws = Draws::new(key ^ path_samplers.bands()[0] as u64, index, is_stopped);
                    path_samplers.sample(estimand, &mut draws, sums);
                    segments += draws.segments;
                }
            }
            segments
        };
        let all = self.of.par_iter_mut().enumerate();
        let segments = all.filter(|(replicate, _)| is_meant(*replicate)).map(extend).sum();
        self.samples = to;
        segments
    }

    /// Whether a path was cut.
    pub(crate) fn are_cut(&self) -> bool {
        self.of.iter().flat_map(|sums| &sums.missed).any(|missed| missed.is_infinite())
    }

    /// Returns the number of samples of all replicates together.
    pub(crate) fn count(&self) -> f64 {
        self.of.len() as f64 * f64::from(self.samples)
    }

    /// Returns the number of values: numbers, bands and bins.
    pub(crate) fn len(&self) -> usize {
        self.of[0].sums.len()
    }

    /// Returns the largest contribution that a sample lost to occlusion in the band of a value.
    pub(crate) fn missed(&self, place: usize) -> f64 {
        let band = self.band(place);
        self.of.iter().map(|sums| sums.missed[band]).fold(0.0, f64::max)
    }

    /// Returns the band of a value.
    pub(crate) fn band(&self, place: usize) -> usize {
        let Sums { bands, bins, .. } = &self.of[0];
        place / bins.map_or(1, |bins| bins.count) % bands
    }

    /// Returns a value, and its standard error from the spread of the replicates.
    pub(crate) fn found(&self, place: usize) -> [f64; 2] {
        let mean = |sums: &Sums| sums.sums[place].value() / f64::from(self.samples);
        let count = self.of.len() as f64;
        let value = self.of.iter().map(mean).sum::<f64>() / count;
        let squares: f64 = self.of.iter().map(|sums| (mean(sums) - value).powi(2)).sum();
        [value, (squares / (count * (count - 1.0))).sqrt()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::paths::sums::Sum;

    /// Number of samples of each replicate for 2³⁰ samples in total.
    const SAMPLES: u64 = 1 << 25;
    const DIGITS: u32 = 52;

    #[test]
    fn a_sum_of_all_samples_that_are_ever_taken_keeps_its_digits() {
        // integers whose sum fits in 128 bits
        let numbers = || (0..SAMPLES).map(|index| key(1, index) >> (64 - DIGITS));
        let small = |number: f64| number / (1_u64 << DIGITS) as f64;
        let exact = small(numbers().map(u128::from).sum::<u128>() as f64);
        let (mut sum, mut plain) = (Sum::default(), 0.0);
        for number in numbers() {
            sum.add(small(number as f64));
            plain += small(number as f64);
        }
        let error = |found: f64| (found / exact - 1.0).abs();
        assert!(error(sum.value()) <= f64::EPSILON, "{}", error(sum.value()));
        assert!(error(plain) > f64::EPSILON, "a plain sum would do");
    }
}
