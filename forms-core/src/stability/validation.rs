//! Validation: a form is compared with the formula at points that the search has not seen.
//!
//! The points are new samples of every regime, a grid of simple numbers in random combinations, on
//! which strata lie, and the same grid with some arguments from the edges of the range of `f64`,
//! where a reciprocal or a product leaves the range. A form is rejected if it has no value, or an
//! infinite one, where the formula as written gives a number, or if it loses more bits in the mean
//! of a regime or of a grid.

use crate::accuracy::{Regime, Sample, Samples, Width, bits_lost, sample, sample_at};
use crate::expression::Pool;
use crate::kernel::Program;
use crate::random::SplitMix;
use crate::theory::Kernel;

/// Number of samples in each regime, and their seed; the samples differ from those of the search.
const SAMPLES: usize = 32;
const SEED: u64 = 0x7a11;

/// Number of points of each grid.
const GRID: usize = 160;

/// Tolerance of the mean loss in bits: a few more roundings do not count as a loss.
const ROUNDINGS: f64 = 1.5;

/// Numbers of the grid; each is used with both signs.
const NUMBERS: &[f64] =
    &[0.0, 1.0, 0.5, 2.0, 0.25, 0.1, 10.0, 1e-3, 1e3, 1e-8, 1e8, 1e-17, 1e17, 1e-100, 1e100, 1e-160, 1e160];

/// Number of leading entries to which every second point is restricted, alone or together with the
/// edges.
const SIMPLE: usize = 5;

/// Edges of the range: numbers whose reciprocals, doubles or halves are out of range or subnormal.
const EDGES: &[f64] =
    &[5e-324, 1e-320, 1e-310, f64::MIN_POSITIVE, 1e-307, 1e-300, 1e300, 1e307, 8e307, f64::MAX];

/// Magnitude from which one more rounding can overflow to infinity.
const BESIDE_THE_LARGEST: f64 = f64::MAX / 16.0;

/// Samples that were not used to choose a form.
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

    /// Whether a form has a number wherever the formula computes one, and loses no more bits in any
    /// mean.
    pub(super) fn loses_no_more(&self, form: &Program, formula: &Program) -> bool {
        let (form, formula) = (form.interpreter::<f64>(), formula.interpreter::<f64>());
        self.regimes.iter().all(|regime| {
            let (mut lost, mut lost_by_formula) = (0.0, 0.0);
            for sample in &regime.samples {
                let [values, written] = [&form, &formula].map(|program| program.values(&sample.arguments));
                if !has_numbers_where(sample, &values, &written) {
                    return false;
                }
                // beyond a certain loss it does not matter how wrong a value is
                lost += bits_lost(Width::Double, sample, &values).min(WRONG);
                lost_by_formula += bits_lost(Width::Double, sample, &written).min(WRONG);
            }
            lost <= lost_by_formula + ROUNDINGS * regime.samples.len() as f64
        })
    }
}

/// Selects one of these numbers.
fn of(numbers: &[f64], random: u64) -> f64 {
    numbers[(random & 0xffff_ffff) as usize % numbers.len()]
}

/// Loss in bits beyond which a value is not one of the formula.
const WRONG: f64 = 26.0;

/// Whether each value is finite where the formula's value is finite, close to the exact one, and
/// should be.
fn has_numbers_where(sample: &Sample, values: &[f64], written: &[f64]) -> bool {
    let outputs = sample.values.iter().zip(values.iter().zip(written));
    outputs.into_iter().all(|(exact, (value, written))| match exact {
        Some((exact, _)) if Width::Double.bits_between(*written, *exact) < WRONG => {
            value.is_finite() || exact.abs() > BESIDE_THE_LARGEST
        }
        _ => true,
    })
}
