//! Validation: a form is compared with the formula at points that the search has not seen.
//!
//! Other samples of every regime, a grid of simple numbers in every mixture, on which strata lie, and the same grid
//! with some arguments from the edges of the range of `f64`, where a reciprocal or a product leaves it: a form goes that
//! has no value, or an infinite one, where the formula as it is written has a number, or that loses more bits on the
//! mean of a regime or of a grid.

use crate::accuracy::{Regime, Sample, Samples, Width, bits_lost, sample, sample_at};
use crate::expression::Pool;
use crate::kernel::Program;
use crate::random::SplitMix;
use crate::resolve::Kernel;

/// Samples of each regime, and their seed: others than those of the search.
const SAMPLES: usize = 32;
const SEED: u64 = 0x7a11;

/// Points of each grid.
const GRID: usize = 160;

/// A few roundings more on the mean are no loss, in bits.
const ROUNDINGS: f64 = 1.5;

/// The numbers of the grid; each is taken with both signs.
const NUMBERS: &[f64] =
    &[0.0, 1.0, 0.5, 2.0, 0.25, 0.1, 10.0, 1e-3, 1e3, 1e-8, 1e8, 1e-17, 1e17, 1e-100, 1e100, 1e-160, 1e160];

/// How many of them, from the first, are taken at every second point, and beside those at the edges.
const SIMPLE: usize = 5;

/// The edges of the range: numbers whose reciprocals, doubles or halves are outside of it or subnormal.
const EDGES: &[f64] =
    &[5e-324, 1e-320, 1e-310, f64::MIN_POSITIVE, 1e-307, 1e-300, 1e300, 1e307, 8e307, f64::MAX];

/// Values from here on round to infinity where one more rounding meets them.
const BESIDE_THE_LARGEST: f64 = f64::MAX / 16.0;

/// Samples that no form was chosen by.
pub(super) struct Validation {
    regimes: Vec<Samples>,
}

impl Validation {
    pub(super) fn new(pool: &Pool, kernel: &Kernel) -> Self {
        let mut regimes = sample(pool, kernel, Width::Double, &Regime::ALL, SAMPLES, SEED);
        let mut random = SplitMix(SEED);
        let mut grid = |draw: fn(usize, u64) -> f64| {
            let mut point = |round| {
                let number = |_| {
                    let random = random.next();
                    let sign = if random & 1 == 0 { 1.0 } else { -1.0 };
                    sign * draw(round, random >> 8)
                };
                kernel.arguments.iter().map(number).collect()
            };
            let points: Vec<Vec<f64>> = (0..GRID).map(&mut point).collect();
            let samples = sample_at(pool, kernel, Width::Double, &points);
            if !samples.is_empty() {
                regimes.push(Samples { regime: Regime::Singular, samples, undecided: 0 });
            }
        };
        grid(|round, random| of(&NUMBERS[..if round % 2 == 0 { SIMPLE } else { NUMBERS.len() }], random));
        grid(|round, random| {
            let is_edge = (random >> 32) % 2 == 0;
            let simple = if round % 2 == 0 { SIMPLE } else { NUMBERS.len() };
            of(if is_edge { EDGES } else { &NUMBERS[..simple] }, random)
        });
        Validation { regimes }
    }

    /// Whether a form has a number wherever the formula computes one, and on no mean loses more bits.
    pub(super) fn loses_no_more(&self, form: &Program, formula: &Program) -> bool {
        let (form, formula) = (form.interpreter::<f64>(), formula.interpreter::<f64>());
        self.regimes.iter().all(|regime| {
            let (mut lost, mut lost_by_formula) = (0.0, 0.0);
            for sample in &regime.samples {
                let [values, written] = [&form, &formula].map(|program| program.values(&sample.arguments));
                if !has_numbers_where(sample, &values, &written) {
                    return false;
                }
                lost += bits_lost(Width::Double, sample, &values);
                lost_by_formula += bits_lost(Width::Double, sample, &written);
            }
            lost <= lost_by_formula + ROUNDINGS * regime.samples.len() as f64
        })
    }
}

/// One of these numbers.
fn of(numbers: &[f64], random: u64) -> f64 {
    numbers[(random & 0xffff_ffff) as usize % numbers.len()]
}

/// Whether each value is a number where that of the formula is and should be.
fn has_numbers_where(sample: &Sample, values: &[f64], written: &[f64]) -> bool {
    let outputs = sample.values.iter().zip(values.iter().zip(written));
    outputs.into_iter().all(|(exact, (value, written))| match exact {
        Some((exact, _)) if written.is_finite() => value.is_finite() || exact.abs() > BESIDE_THE_LARGEST,
        _ => true,
    })
}
