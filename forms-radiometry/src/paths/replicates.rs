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

use super::follow::Follow;
use super::question::Question;
use crate::sampling::{Draws, key};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// Number of replicates of a single value, and of a pixel or a cell.
pub(crate) const REPLICATES: usize = 32;

/// Sum with its compensated rounding error: Neumaier (1974).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Sum {
    sum: f64,
    rest: f64,
}

impl Sum {
    pub(crate) fn add(&mut self, value: f64) {
        let sum = self.sum + value;
        self.rest +=
            if self.sum.abs() >= value.abs() { (self.sum - sum) + value } else { (value - sum) + self.sum };
        self.sum = sum;
    }

    pub(crate) fn value(self) -> f64 {
        self.sum + self.rest
    }
}

/// Time bins of light, by optical path length.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bins {
    pub(crate) start: f64,
    pub(crate) width: f64,
    pub(crate) count: usize,
}

/// The sums of one replicate: for each number, band and bin.
#[derive(Clone, Debug)]
pub(crate) struct Sums {
    pub(super) sums: Vec<Sum>,
    /// For each band the largest contribution that a sample lost because a light source was
    /// occluded.
    pub(super) missed: Vec<f64>,
    bands: usize,
    bins: Option<Bins>,
}

impl Sums {
    fn new(numbers: usize, bands: usize, bins: Option<Bins>) -> Self {
        let count = bins.map_or(1, |bins| bins.count);
        Self { sums: vec![Sum::default(); numbers * bands * count], missed: vec![0.0; bands], bands, bins }
    }

    /// Returns the bin of light with this optical path length; `None` if it is in no bin.
    pub(super) fn bin(&self, way: f64) -> Option<usize> {
        let Some(Bins { start, width, count }) = self.bins else { return Some(0) };
        let place = ((way - start) / width).floor();
        (place >= 0.0 && place < count as f64).then_some(place as usize)
    }

    /// Records a contribution that a sample lost to occlusion in a band.
    pub(super) fn miss(&mut self, band: usize, value: f64) {
        self.missed[band] = self.missed[band].max(value);
    }

    pub(super) fn add(&mut self, [number, band, bin]: [usize; 3], value: f64) {
        let bins = self.bins.map_or(1, |bins| bins.count);
        self.sums[(number * self.bands + band) * bins + bin].add(value);
    }
}

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
    pub(crate) fn new(key: u64, question: &Question, bands: usize, bins: Option<Bins>) -> Self {
        Self { key, of: vec![Sums::new(question.numbers(), bands, bins); REPLICATES], samples: 0 }
    }

    /// Adds samples to the selected replicates, up to the number `to`.
    pub(crate) fn extend(
        &mut self,
        to: u32,
        question: &Question,
        followers: &[Box<dyn Follow + '_>],
        is_meant: impl Fn(usize) -> bool + Sync,
    ) {
        let (from, own) = (self.samples, self.key);
        let extend = |(replicate, sums): (usize, &mut Sums)| {
            let key = key(own, replicate as u64);
            for index in from..to {
                for follower in followers {
                    let mut draws = Draws::new(key ^ follower.bands()[0] as u64, index);
                    follower.sample(question, &mut draws, sums);
                }
            }
        };
        let all = self.of.par_iter_mut().enumerate();
        all.filter(|(replicate, _)| is_meant(*replicate)).for_each(extend);
        self.samples = to;
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
