//! Replicates that are kept: their sums are handed out to be written down, and taken back.

use super::replicates::{Replicates, Sum};

/// The sums of each replicate that was kept, and what its samples missed.
pub(crate) type KeptSums = Vec<Option<(Vec<Sum>, Vec<f64>)>>;

/// The same, to be written down.
pub(crate) type WrittenSums<'s> = Vec<Option<(&'s [Sum], &'s [f64])>>;

impl Replicates {
    /// The sums of the replicates that are meant; nothing without samples.
    pub(crate) fn kept(&self, is_meant: impl Fn(usize) -> bool) -> WrittenSums<'_> {
        if self.samples == 0 {
            return Vec::new();
        }
        let of_one = |(replicate, sums)| is_meant(replicate).then_some(sums);
        self.of.iter().map(|sums| (&sums.sums[..], &sums.missed[..])).enumerate().map(of_one).collect()
    }

    /// Takes the sums of so many samples of the replicates that are meant; whether they are there and are as many as this question
    /// has.
    #[must_use]
    pub(crate) fn restore(&mut self, samples: u32, sums: KeptSums, is_meant: impl Fn(usize) -> bool) -> bool {
        if samples == 0 {
            return sums.is_empty();
        }
        let is_whole = sums.len() == self.of.len();
        self.samples = samples;
        let mut meant =
            self.of.iter_mut().zip(sums).enumerate().filter(|(replicate, _)| is_meant(*replicate));
        is_whole
            && meant.all(|(_, (own, kept))| match kept {
                Some((sums, missed)) if sums.len() == own.sums.len() && missed.len() == own.missed.len() => {
                    (own.sums, own.missed) = (sums, missed);
                    true
                }
                _ => false,
            })
    }
}
