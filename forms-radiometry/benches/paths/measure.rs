//! Measures the time until the error reaches the target: runs with successive tolerances, each half
//! of the one before. The script does the same with numbers of samples.
//!
//! ```text
//! tolerance ─▶ seeds: values, seconds ─▶ root-mean-square error, median time
//!    ▲                                     ├─ reached ──▶ log-log interpolation, last two
//!    │                                     ├─ too long ─▶ extrapolated by error ~ 1/√time
//!    └────────── half the tolerance ───────┘
//! ```

use crate::outliers;
use crate::work::Work;
use forms_radiometry::simulation::Simulation;
use forms_radiometry_testing::benches::simulated::{relative_error, simulated, values};
use forms_testing::wall_clock;
use std::time::Instant;

/// Runs shorter than this, in seconds, are timed as an average over many runs.
const SHORT: f64 = 5e-3;
/// After a run longer than this, in seconds, the time is extrapolated.
const LONGEST: f64 = 0.7;

/// Measurements of a work.
pub(crate) struct Measured<'w> {
    pub(crate) work: &'w Work,
    pub(crate) seconds: f64,
    /// Error that is reached in this time.
    pub(crate) error: f64,
    /// Tolerance with which it is reached, and remarks common to all answers.
    pub(crate) how: String,
}

/// Runs with one tolerance.
struct Runs {
    tolerance: f64,
    seconds: f64,
    error: f64,
    /// Mean of all values, relative to the mean of the reference.
    mean: f64,
    simulations: Vec<Simulation>,
}

impl Runs {
    fn of(work: &Work, reference: &[f64], tolerance: f64) -> Self {
        let mut times = Vec::new();
        let mut simulations = Vec::new();
        for seed in 1..=work.seeds {
            let scene = work.with(seed, tolerance);
            let start = Instant::now();
            simulations.push(simulated(&scene));
            times.push(start.elapsed().as_secs_f64());
        }
        times.sort_by(f64::total_cmp);
        let mut seconds = times[times.len() / 2];
        if seconds < SHORT {
            let scene = work.with(1, tolerance);
            seconds = wall_clock::seconds(|| simulated(&scene));
        }
        let found: Vec<Vec<f64>> = simulations.iter().map(values).collect();
        let squares: f64 = found.iter().map(|found| relative_error(found, reference).powi(2)).sum();
        let mean = found.iter().flatten().sum::<f64>() / reference.iter().sum::<f64>() / work.seeds as f64;
        Self { tolerance, seconds, error: (squares / work.seeds as f64).sqrt(), mean, simulations }
    }

    /// Returns the remarks on the values.
    fn told(&self, work: &Work) -> String {
        let means = format!("; means differ by {:+.1e}", self.mean - 1.0);
        match work.known() {
            Some(known) if work.count() > 1 => {
                format!("{means}; {}", outliers::told(&self.simulations, known))
            }
            _ => means,
        }
    }
}

impl<'w> Measured<'w> {
    /// Measures the time to the target error, compared with a reference.
    pub(crate) fn of(work: &'w Work, reference: &[f64]) -> Self {
        let mut before: Option<Runs> = None;
        loop {
            let tolerance = before.as_ref().map_or(work.tolerance, |runs| 0.5 * runs.tolerance);
            let runs = Runs::of(work, reference, tolerance);
            println!(
                "{:40} {:10.3} ms, tolerance {tolerance:.1e}, error {:.1e}",
                work.title,
                1e3 * runs.seconds,
                runs.error
            );
            if runs.error <= work.target {
                return Self::between(work, before.as_ref(), &runs);
            }
            if runs.seconds > LONGEST {
                return Self::beyond(work, &runs);
            }
            before = Some(runs);
        }
    }

    /// Interpolates between two tolerances, on a line through both in logarithms.
    fn between(work: &'w Work, before: Option<&Runs>, runs: &Runs) -> Self {
        let (seconds, error) = before.map_or((runs.seconds, runs.error), |before| {
            let share = (before.error / work.target).ln() / (before.error / runs.error).ln();
            (before.seconds * (runs.seconds / before.seconds).powf(share), work.target)
        });
        Self { work, seconds, error, how: format!("tolerance {:.1e}{}", runs.tolerance, runs.told(work)) }
    }

    /// Extrapolates to more samples: the error is proportional to the reciprocal of the square root
    /// of their number.
    fn beyond(work: &'w Work, runs: &Runs) -> Self {
        let seconds = runs.seconds * (runs.error / work.target).powi(2);
        let how = format!(
            "extrapolated from {:.1e} with tolerance {:.1e}{}",
            runs.error,
            runs.tolerance,
            runs.told(work)
        );
        Self { work, seconds, error: work.target, how }
    }
}
