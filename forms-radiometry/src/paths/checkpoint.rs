//! Checkpoints of replicates: their sums are handed out to be saved, and restored.

use super::replicates::Replicates;
use super::sums::Sum;

/// The sums of each replicate in a checkpoint, and the contributions that its samples lost to
/// occlusion.
pub(crate) type KeptSums = Vec<Option<(Vec<Sum>, Vec<f64>)>>;

/// The same, borrowed to be saved.
pub(crate) type WrittenSums<'s> = Vec<Option<(&'s [Sum], &'s [f64])>>;

impl Replicates {
    /// Returns the sums of the selected replicates; empty without samples.
    pub(crate) fn kept(&self, is_meant: impl Fn(usize) -> bool) -> WrittenSums<'_> {
        if self.samples == 0 {
            return Vec::new();
        }
        let of_one = |(replicate, sums)| is_meant(replicate).then_some(sums);
        self.of.iter().map(|sums| (&sums.sums[..], &sums.missed[..])).enumerate().map(of_one).collect()
    }

    /// Restores the sums of `samples` samples of the selected replicates. Returns whether they are
    /// all present and match this estimand in number.
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
