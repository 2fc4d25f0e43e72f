//! Prediction of samples: the total number of samples of the work, compared with the present
//! number, shows its progress.
//!
//! ```text
//! question  open: doubled until its error is small enough, n at the end, ± n/2 ┐
//!           else: its present samples                                          ├▶ Σ n ± √Σ (n/2)²
//! ```
//! Samples are doubled, and errors are estimates: the last doubling of a question may be one too
//! many or too few. For many questions that averages out. Where it does not, no remaining time can
//! be reported.

use super::Work;
use super::request::Request;
use crate::progress::{Outlook, Progress};
use crate::watch::Watch;
use rayon::prelude::*;
use std::sync::atomic::{AtomicU64, Ordering};

/// Number of equal parts of the samples after which progress is reported.
const PARTS: f64 = 1000.0;
/// Uncertainty of the samples of a question, relative to them.
const DOUBT: f64 = 0.5;
/// Largest uncertainty of all samples with which a remaining time is reported, relative to the
/// remaining samples.
const CERTAIN: f64 = 1.0 / 3.0;

/// Samples of a replicate, for all questions together.
pub(super) struct Samples {
    spent: AtomicU64,
    /// Number of samples at the beginning of the round. Future samples are taken to cost as much
    /// as samples of this round, not as earlier ones.
    before: f64,
    foreseen: f64,
    /// Uncertainty of the predicted number, in both directions.
    doubt: f64,
    is_pilot: bool,
}

impl Work<'_> {
    /// Returns the present and the predicted number of samples: for the pilot those of its round,
    /// then by errors or by the budget.
    pub(super) fn foreseen(&self) -> Samples {
        let is_pilot = self.division.budget.is_none() && self.scales.is_none();
        let tolerance = self.scene.solve.tolerance;
        let foreseen = |(estimand, request): (usize, &Request)| match self.division.budget {
            _ if request.computed.is_some() => [0.0; 2],
            Some(budget) if self.division.has(estimand) => [f64::from(budget.of_replicate()), 0.0],
            _ if is_pilot || request.is_there() || !request.is_answered() => {
                [f64::from(request.target.max(request.replicates.samples)), 0.0]
            }
            _ => {
                let samples = request.foreseen(&self.scales_of(request, self.scales.as_ref()), tolerance);
                [samples, (DOUBT * samples).powi(2)]
            }
        };
        let sum = |[a, b]: [f64; 2], [c, d]: [f64; 2]| [a + c, b + d];
        let all = self.requests.par_iter().enumerate().map(foreseen);
        let [foreseen, square] = all.reduce(|| [0.0; 2], sum);
        let spent: u64 = self.requests.iter().map(|request| u64::from(request.replicates.samples)).sum();
        let (before, doubt) = (spent as f64, square.sqrt());
        let samples = Samples { spent: AtomicU64::new(spent), before, foreseen, doubt, is_pilot };
        self.progress.begin(samples.outlook(before));
        samples
    }
}

impl Samples {
    /// Adds samples. Reports progress if they complete a part of all samples.
    pub(super) fn add(&self, count: u32, progress: &Progress<'_>) {
        let before = self.spent.fetch_add(u64::from(count), Ordering::Relaxed) as f64;
        let now = before + f64::from(count);
        let part = |spent: f64| (PARTS * spent / self.foreseen).floor();
        if part(before) < part(now) {
            progress.look(self.outlook(now));
            progress.progress("paths", (now - self.before) / (self.foreseen - self.before));
        }
    }

    /// Returns the outlook after this many samples.
    fn outlook(&self, spent: f64) -> Outlook {
        if self.is_pilot {
            Outlook::Unknown
        } else if self.doubt <= CERTAIN * (self.foreseen - spent) {
            Outlook::Stages(1)
        } else {
            Outlook::Doubtful
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_questions_are_certain_and_a_single_one_is_not() {
        let of = |count: f64, spent| {
            let each = 1000.0;
            let doubt = DOUBT * each * count.sqrt();
            let samples = Samples {
                spent: AtomicU64::new(0),
                before: 0.0,
                foreseen: each * count,
                doubt,
                is_pilot: false,
            };
            matches!(samples.outlook(spent), Outlook::Stages(1))
        };
        assert!(!of(1.0, 0.0) && !of(1.0, 999.0));
        assert!(of(100.0, 0.0) && of(100.0, 80e3) && !of(100.0, 90e3));
    }
}
