//! Coverage: how often the truth lies within one and within two of the standard errors that are told.

use super::{Claim, Compared};
use rayon::prelude::*;
use std::ops::AddAssign;

/// Answers that were compared, and how many of them are within one and within two standard errors.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Coverage {
    pub(crate) count: usize,
    pub(crate) within: [usize; 2],
    /// Answers that are exact but for rounding, which are not counted above.
    pub(crate) exact: usize,
    /// The most standard errors that one is off.
    pub(crate) worst: f64,
}

impl Coverage {
    /// What runs of a claim with so many seeds find.
    pub(crate) fn of(claim: &Claim, seeds: u64, tolerance: f64) -> Self {
        let runs: Vec<Vec<Compared>> =
            (1..=seeds).into_par_iter().map(|seed| claim.compared(seed, tolerance)).collect();
        let mut coverage = Self::default();
        runs.iter().flatten().for_each(|compared| coverage.add(compared));
        coverage
    }

    fn add(&mut self, compared: &Compared) {
        // a flux is the irradiance times the area, and would count twice
        if compared.answer.quantity == super::Quantity::Flux {
            return;
        }
        let Some(deviations) = compared.deviations(1e-12) else {
            self.exact += 1;
            return;
        };
        self.count += 1;
        self.within[0] += usize::from(deviations <= 1.0);
        self.within[1] += usize::from(deviations <= 2.0);
        self.worst = self.worst.max(deviations);
    }

    /// The parts of the answers within one and within two standard errors.
    pub(crate) fn parts(&self) -> [f64; 2] {
        self.within.map(|within| within as f64 / self.count as f64)
    }
}

impl AddAssign for Coverage {
    fn add_assign(&mut self, other: Self) {
        self.count += other.count;
        self.exact += other.exact;
        self.worst = self.worst.max(other.worst);
        self.within.iter_mut().zip(other.within).for_each(|(within, other)| *within += other);
    }
}
