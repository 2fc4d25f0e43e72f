//! Error bounds of a form at the samples, as the arithmetic that bounds the errors of `f64` shows them.

use super::form::MOST_UNITS;
use crate::accuracy::Sample;
use crate::kernel::Program;
use forms_math::{Guarded, Real};

/// Error bounds of a form, in units of 2⁻⁵³.
pub(super) struct Bounds {
    /// Bound that nearly all typical samples keep.
    pub(super) typical: f64,
    /// Weight of the samples whose bound is above [`MOST_UNITS`].
    pub(super) unsettled: f64,
}

/// Share of the typical samples that keep the bound: the others take up to a hundred times as long.
const NEARLY_ALL: f64 = 0.95;
/// Factor of the bound of these samples, so that fewer arguments than samples exceed it.
const MARGIN: f64 = 1.25;

impl Bounds {
    /// Computes a form at the samples, the first of which are the typical ones.
    pub(super) fn of(program: &Program, samples: &[&Sample], weights: &[f64], typical: usize) -> Self {
        let guarded = program.interpreter::<Guarded<f64>>();
        let of_sample = |sample: &&Sample| {
            let in_lanes = program.bounds_in_lanes(&sample.arguments).into_iter().fold(0.0, f64::max);
            if in_lanes.is_finite() {
                return in_lanes;
            }
            // beyond the exponents of lanes, and for functions that they do not have
            let arguments: Vec<_> = sample.arguments.iter().map(|&value| Guarded::from_f64(value)).collect();
            guarded.values(&arguments).into_iter().map(units).fold(0.0, f64::max)
        };
        let units: Vec<f64> = samples.iter().map(of_sample).collect();
        let is_unsettled = |(units, _): &(&f64, &f64)| **units > MOST_UNITS;
        let unsettled = units.iter().zip(weights).filter(is_unsettled).map(|(_, weight)| weight).sum();
        let mut first = units[..typical].to_vec();
        first.sort_by(f64::total_cmp);
        let last = (typical as f64 * NEARLY_ALL) as usize;
        let nearly_all = first.get(last.min(typical.saturating_sub(1))).copied().unwrap_or(f64::INFINITY);
        Bounds { typical: MARGIN * nearly_all, unsettled }
    }
}

/// Returns the error bound of a value in units of 2⁻⁵³ of the exact one; infinite without a bound.
fn units(value: Guarded<f64>) -> f64 {
    let (size, error) = (value.value().abs(), value.error());
    let relative = error / (size - error);
    if value.is_undefined() || error == 0.0 {
        0.0
    } else if relative >= 0.0 {
        relative * 2f64.powi(53)
    } else {
        f64::INFINITY
    }
}
