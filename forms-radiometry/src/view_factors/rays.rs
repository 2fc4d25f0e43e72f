//! Rows by rays: the fractions of a surface's rays that arrive at each surface.
//!
//! ```text
//! F = Σ Fᵣ/R    σ² = Σ (Fᵣ − F)²/(R (R − 1))    error = σ + e/N
//! ```
//! Fᵣ is the fraction of a replicate of n low-discrepancy rays, each with its own random scrambling,
//! and N = R n. Events that no ray has met are rarer than e/N, as a rule: a view factor of zero has
//! that error.

use super::emitters::Emitters;
use super::{Goal, Row, ViewFactor};
use crate::answer::ErrorKind;
use crate::job::REPLICATES;
use crate::sampling::{Samples, key};
use crate::watch::Watch;
use rayon::prelude::*;

/// Rule of three: an event that none of n rays has met is rarer than this over n, as a rule.
const UNMET: f64 = 3.0;
/// Rays of each replicate: of the pilot, of its first part, and at most.
const FIRST: u32 = 1 << 8;
const FEW: u32 = 1 << 5;
const MOST: u32 = 1 << 30;
/// Power of the number of rays with which errors fall, as a cautious guess: 1/2 is that of random
/// rays, and low-discrepancy rays reach 0.6 to 0.75.
const POWER: f64 = 0.6;
/// The largest factor by which a number of rays predicted from the first few is off.
const UNSURE: f64 = 8.0;
/// Largest factor by which the number of rays grows at once: a guess from few rays can be far off.
const STEP: f64 = 16.0;

/// The rays of one surface so far.
pub(super) struct Rays<'e> {
    emitters: &'e Emitters,
    surface: usize,
    key: u64,
    /// The view factors that are known without rays.
    known: Vec<Option<ViewFactor>>,
    /// For each replicate, the number of rays that arrived at each surface.
    arrived: Vec<Vec<u32>>,
    /// Number of rays of each replicate.
    count: u32,
}

impl<'e> Rays<'e> {
    /// Traces the first rays of a surface, some of whose view factors are known.
    pub(super) fn pilot(
        emitters: &'e Emitters,
        surface: usize,
        known: Vec<Option<ViewFactor>>,
        seed: u64,
    ) -> Self {
        let arrived = vec![vec![0; known.len()]; REPLICATES];
        let mut rays = Self { emitters, surface, key: key(seed, surface as u64), known, arrived, count: 0 };
        rays.extend(FEW);
        rays
    }

    /// Returns the number of rays below which no row but that of a surface that sees only one other
    /// is expected to meet a tolerance.
    pub(super) fn fewest(tolerance: f64) -> f64 {
        (0.5 / tolerance).powf(1.0 / POWER)
    }

    fn extend(&mut self, to: u32) {
        let Self { emitters, surface, key: own, count, .. } = *self;
        self.arrived.par_iter_mut().enumerate().for_each(|(replicate, arrived)| {
            let own = key(own, replicate as u64);
            for index in count..to {
                if let Some(surface) = emitters.sent(surface, Samples::joint(own, index)) {
                    arrived[surface] += 1;
                }
            }
        });
        self.count = to;
    }

    /// Returns the view factors so far.
    pub(super) fn row(&self) -> Row {
        let factors = (0..self.arrived[0].len()).map(|surface| self.factor(surface)).collect();
        Row { factors, kind: ErrorKind::Sigma }
    }

    fn factor(&self, surface: usize) -> ViewFactor {
        if let Some(known) = self.known[surface] {
            return known;
        }
        let replicates = self.arrived.len() as f64;
        let fraction = |arrived: &Vec<u32>| f64::from(arrived[surface]) / f64::from(self.count);
        let value = self.arrived.iter().map(fraction).sum::<f64>() / replicates;
        let squares: f64 = self.arrived.iter().map(|arrived| (fraction(arrived) - value).powi(2)).sum();
        let deviation = (squares / (replicates * (replicates - 1.0))).sqrt();
        let error = deviation + UNMET / (replicates * f64::from(self.count));
        ViewFactor { value, error }
    }

    /// Whether no more than this number of rays, of all replicates, are expected to meet the goal. The
    /// rest of the pilot is traced only where its first rays do not settle that.
    pub(super) fn need_at_most(&mut self, most: f64, goal: Goal) -> bool {
        if self.needed(goal) > UNSURE * most {
            return false;
        }
        self.extend(FIRST);
        self.needed(goal) <= most
    }

    fn needed(&self, goal: Goal) -> f64 {
        REPLICATES as f64 * f64::from(self.count) * self.growth(goal)
    }

    fn growth(&self, goal: Goal) -> f64 {
        goal.excess(&self.row().factors).powf(1.0 / POWER).max(1.0)
    }

    /// Traces rays until the goal is met, or the work is stopped.
    pub(super) fn reach(&mut self, goal: Goal, watch: &dyn Watch) {
        self.extend(self.count.max(FIRST));
        loop {
            let growth = self.growth(goal);
            if growth <= 1.0 || self.count >= MOST || watch.is_stopped() {
                return;
            }
            let to = (f64::from(self.count) * growth.clamp(1.25, STEP)).min(f64::from(MOST));
            self.extend(to as u32);
        }
    }
}
