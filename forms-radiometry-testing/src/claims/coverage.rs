//! Coverage: how often the truth lies within one and within two of the reported standard errors.

use super::{Claim, Compared};
use rayon::prelude::*;
use std::ops::AddAssign;

/// Number of compared answers, and how many lie within one and within two standard errors.
#[derive(Clone, Copy, Debug, Default)]
pub struct Coverage {
    /// Number of compared answers.
    pub count: usize,
    /// Number of answers within one and within two standard errors.
    pub within: [usize; 2],
    /// Number of answers that are exact except for rounding; these are not counted above.
    pub exact: usize,
    /// Largest deviation of an answer in standard errors.
    pub worst: f64,
}

impl Coverage {
    /// Runs a claim with this number of seeds.
    pub fn of(claim: &Claim, seeds: u64, tolerance: f64) -> Self {
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

    /// Returns the parts of the answers within one and within two standard errors.
    pub fn parts(&self) -> [f64; 2] {
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
