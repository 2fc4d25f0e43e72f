//! Replicates: a question is answered by independent replicates of one point set; their means tell the answer and its standard error.
//!
//! ```text
//! value = Σ mᵣ/R          σ² = Σ (mᵣ − value)²/(R (R − 1))          mᵣ the mean of n samples of replicate r
//! ```
//! Within a replicate samples lie more evenly than random ones, which their spread shows only between replicates. The number of samples
//! doubles from round to round; all sums are taken in one order, so that the answer does not depend on threads.

use super::follow::Follow;
use super::question::Question;
use crate::sampling::{Draws, key};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// Replicates of a number, and of a pixel or a cell.
pub(crate) const REPLICATES: usize = 32;

/// A sum with what its rounding left out: Neumaier's (1974).
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

/// The bins of time that light falls into, by its optical length.
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
    /// For each band the largest value that a sample missed, since something hid a luminaire.
    pub(super) missed: Vec<f64>,
    bands: usize,
    bins: Option<Bins>,
}

impl Sums {
    fn new(numbers: usize, bands: usize, bins: Option<Bins>) -> Self {
        let count = bins.map_or(1, |bins| bins.count);
        Self { sums: vec![Sum::default(); numbers * bands * count], missed: vec![0.0; bands], bands, bins }
    }

    /// The bin of light that took this optical length; none if it is in no bin.
    pub(super) fn bin(&self, way: f64) -> Option<usize> {
        let Some(Bins { start, width, count }) = self.bins else { return Some(0) };
        let place = ((way - start) / width).floor();
        (place >= 0.0 && place < count as f64).then_some(place as usize)
    }

    /// Notes what a sample missed in a band.
    pub(super) fn miss(&mut self, band: usize, value: f64) {
        self.missed[band] = self.missed[band].max(value);
    }

    pub(super) fn add(&mut self, [number, band, bin]: [usize; 3], value: f64) {
        let bins = self.bins.map_or(1, |bins| bins.count);
        self.sums[(number * self.bands + band) * bins + bin].add(value);
    }
}

/// The replicates of a question.
#[derive(Clone, Debug)]
pub(crate) struct Replicates {
    key: u64,
    pub(super) of: Vec<Sums>,
    /// How many samples each replicate has.
    pub(crate) samples: u32,
}

impl Replicates {
    /// Replicates without samples, of a question that this key names.
    pub(crate) fn new(key: u64, question: &Question, bands: usize, bins: Option<Bins>) -> Self {
        Self { key, of: vec![Sums::new(question.numbers(), bands, bins); REPLICATES], samples: 0 }
    }

    /// Adds samples up to so many, to the replicates that are meant.
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

    /// How many samples all replicates have.
    pub(crate) fn count(&self) -> f64 {
        self.of.len() as f64 * f64::from(self.samples)
    }

    /// How many values there are: numbers, bands and bins.
    pub(crate) fn len(&self) -> usize {
        self.of[0].sums.len()
    }

    /// The largest value that a sample missed in the band of a value.
    pub(crate) fn missed(&self, place: usize) -> f64 {
        let band = self.band(place);
        self.of.iter().map(|sums| sums.missed[band]).fold(0.0, f64::max)
    }

    /// The band of a value.
    pub(crate) fn band(&self, place: usize) -> usize {
        let Sums { bands, bins, .. } = &self.of[0];
        place / bins.map_or(1, |bins| bins.count) % bands
    }

    /// A value, and its standard error by the spread of the replicates.
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

    /// Samples of each replicate where there are 2³⁰ in all.
    const SAMPLES: u64 = 1 << 25;
    const DIGITS: u32 = 52;

    #[test]
    fn a_sum_of_all_samples_that_are_ever_taken_keeps_its_digits() {
        // whole numbers, of which 128 bits hold the sum
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
