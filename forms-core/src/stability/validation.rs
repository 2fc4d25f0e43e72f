//! Validation: a form is compared with the formula at points that the search has not seen.
//!
//! The points are new samples of every regime, a grid of simple numbers in random combinations, on
//! which strata lie, and the same grid with some arguments from the edges of the range of `f64`,
//! where a reciprocal or a product leaves the range. A form is rejected if it has no value, or an
//! infinite one, where the formula as written gives a number, or if it loses more bits in the mean
//! of a regime or of a grid.

use crate::accuracy::{Regime, Sample, Width, bits_lost, sample, sample_at};
use crate::expression::Pool;
use crate::kernel::{Interpreter, Program};
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

/// Samples that were not used to choose a form, with the values of the formula as written.
pub(super) struct Validation {
    /// Samples of each regime, then the grids.
    regimes: Vec<Unseen>,
    /// Number of regimes before the grids.
    sampled: usize,
}

/// Samples of a regime or of a grid.
struct Unseen {
    samples: Vec<Sample>,
    /// Values of the formula at each sample.
    written: Vec<Vec<f64>>,
    /// Sum of the bits that the formula loses at the samples.
    lost_by_formula: f64,
}

impl Unseen {
    fn new(samples: Vec<Sample>, formula: &Interpreter<'_, f64>) -> Self {
        let written: Vec<Vec<f64>> = samples.iter().map(|sample| formula.values(&sample.arguments)).collect();
        let lost_by_formula = samples.iter().zip(&written).map(|(sample, values)| lost(sample, values)).sum();
        Unseen { samples, written, lost_by_formula }
    }
}

impl Validation {
    /// Draws the samples for a kernel whose formula as written is computed by this program.
    pub(super) fn new(pool: &Pool, kernel: &Kernel, formula: &Program) -> Self {
        let mut regimes: Vec<Vec<Sample>> = sample(pool, kernel, Width::Double, &Regime::ALL, SAMPLES, SEED)
            .into_iter()
            .map(|regime| regime.samples)
            .collect();
        let sampled = regimes.len();
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
            regimes.push(sample_at(pool, kernel, Width::Double, &points));
        };
        grid(|round, random| of(&NUMBERS[..if round % 2 == 0 { SIMPLE } else { NUMBERS.len() }], random));
        grid(|round, random| {
            let is_edge = (random >> 32) % 2 == 0;
            let simple = if round % 2 == 0 { SIMPLE } else { NUMBERS.len() };
            of(if is_edge { EDGES } else { &NUMBERS[..simple] }, random)
        });
        let formula = formula.interpreter::<f64>();
        let regimes = regimes.into_iter().map(|samples| Unseen::new(samples, &formula)).collect();
        Validation { regimes, sampled }
    }

    /// Returns the largest number of bits that a form loses at a sample of a regime, of a value that is a
    /// normal number. The grids are not asked: at the edges of the range no form keeps all digits.
    pub(super) fn most_lost(&self, form: &Program) -> f64 {
        let form = form.interpreter::<f64>();
        let samples = self.regimes[..self.sampled].iter().flat_map(|regime| &regime.samples);
        let samples = samples.filter(|sample| has_normal_values(sample));
        samples.map(|sample| lost(sample, &form.values(&sample.arguments))).fold(0.0, f64::max)
    }

    /// Whether a form has a number wherever the formula computes one, and loses no more bits in any
    /// mean.
    pub(super) fn loses_no_more(&self, form: &Program) -> bool {
        let form = form.interpreter::<f64>();
        self.regimes.iter().all(|regime| {
            let mut lost_by_form = 0.0;
            for (sample, written) in regime.samples.iter().zip(&regime.written) {
                let values = form.values(&sample.arguments);
                if !has_numbers_where(sample, &values, written) {
                    return false;
                }
                lost_by_form += lost(sample, &values);
            }
            lost_by_form <= regime.lost_by_formula + ROUNDINGS * regime.samples.len() as f64
        })
    }
}

/// Returns the bits lost at a sample. Beyond a certain loss it does not matter how wrong a value is.
fn lost(sample: &Sample, values: &[f64]) -> f64 {
    bits_lost(Width::Double, sample, values).min(WRONG)
}

/// Whether no value at a sample is below the normal numbers, where digits are missing.
pub(super) fn has_normal_values(sample: &Sample) -> bool {
    sample.values.iter().flatten().all(|(exact, _)| *exact == 0.0 || exact.is_normal())
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
