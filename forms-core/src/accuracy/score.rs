//! Scores: errors of computed values against the true ones, over the samples of each regime.

use super::ordinal::Width;
use super::regime::Regime;
use super::sample::{Sample, Samples};

/// Mean, 99th percentile and maximum of an error.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Statistics {
    /// The mean.
    pub mean: f64,
    /// The 99th percentile: 99 of 100 errors do not exceed it.
    pub percentile: f64,
    /// The maximum.
    pub maximum: f64,
}

impl Statistics {
    /// Returns the statistics of these errors.
    pub fn of(mut errors: Vec<f64>) -> Self {
        if errors.is_empty() {
            return Self::default();
        }
        errors.sort_by(f64::total_cmp);
        let count = errors.len();
        let mean = errors.iter().sum::<f64>() / count as f64;
        let percentile = errors[(count * 99).div_ceil(100) - 1];
        Statistics { mean, percentile, maximum: errors[count - 1] }
    }
}

/// The errors of one program on the samples of one regime.
#[derive(Clone, Debug, PartialEq)]
pub struct Score {
    /// The regime.
    pub regime: Regime,
    /// Number of scored points.
    pub points: usize,
    /// Bits lost: log₂(1 + the number of floating-point steps between the computed and the
    /// correctly rounded value).
    pub bits: Statistics,
    /// Errors in ulps of the true value.
    pub ulps: Statistics,
    /// Arguments at which most bits are lost.
    pub worst: Vec<f64>,
}

impl Score {
    /// Returns the errors of the results of `computed` at the arguments of each sample; for several
    /// outputs, the worst error counts.
    pub fn of(samples: &Samples, width: Width, mut computed: impl FnMut(&[f64]) -> Vec<f64>) -> Self {
        Self::by(samples, |sample| {
            let results = computed(&sample.arguments);
            let pairs = sample.values.iter().zip(results).filter_map(|(exact, got)| Some(((*exact)?, got)));
            let errors = pairs.map(|(exact, got)| (bits(width, got, exact), ulps(width, got, exact)));
            worst_of(errors)
        })
    }

    /// Returns the errors of results in double-double arithmetic, given as sums of two numbers.
    /// Each bit lost is a doubling of the error beyond 2⁻¹⁰⁶ of the value, and an ulp is 2⁻¹⁰⁵ of
    /// the value.
    pub fn of_double_double(samples: &Samples, mut computed: impl FnMut(&[f64]) -> Vec<(f64, f64)>) -> Self {
        Self::by(samples, |sample| {
            let results = computed(&sample.arguments);
            let pairs = sample.values.iter().zip(results).filter_map(|(exact, got)| Some(((*exact)?, got)));
            worst_of(pairs.map(|(exact, got)| double_double_error(got, exact)))
        })
    }

    fn by(samples: &Samples, mut errors: impl FnMut(&Sample) -> (f64, f64)) -> Self {
        let found: Vec<(f64, f64)> = samples.samples.iter().map(&mut errors).collect();
        let worst = (0..found.len()).max_by(|&a, &b| found[a].0.total_cmp(&found[b].0));
        Score {
            regime: samples.regime,
            points: found.len(),
            bits: Statistics::of(found.iter().map(|error| error.0).collect()),
            ulps: Statistics::of(found.iter().map(|error| error.1).collect()),
            worst: worst.map_or_else(Vec::new, |place| samples.samples[place].arguments.clone()),
        }
    }
}

fn worst_of(errors: impl Iterator<Item = (f64, f64)>) -> (f64, f64) {
    errors.fold((0.0, 0.0), |worst, error| (worst.0.max(error.0), worst.1.max(error.1)))
}

/// Returns the bits lost at one sample; for several outputs, the worst loss counts.
pub(crate) fn bits_lost(width: Width, sample: &Sample, computed: &[f64]) -> f64 {
    let pairs = sample.values.iter().zip(computed);
    pairs.filter_map(|(exact, got)| Some(bits(width, *got, (*exact)?))).fold(0.0, f64::max)
}

/// Returns the bits lost against the correctly rounded value.
fn bits(width: Width, computed: f64, exact: (f64, f64)) -> f64 {
    width.bits_between(computed, rounded(width, exact))
}

/// Returns the number nearest to high + low, where high is the `f64` nearest to this sum; if high
/// is a tie, the sign of low breaks it.
fn rounded(width: Width, (high, low): (f64, f64)) -> f64 {
    let nearest = width.round(high);
    if width == Width::Double || low == 0.0 || nearest == high {
        return nearest;
    }
    let other = width.at(width.ordinal(nearest) + if high > nearest { 1 } else { -1 });
    let is_tie = (high - nearest).abs() == (other - high).abs();
    let other_is_nearer = (other > nearest) == (low > 0.0);
    if is_tie && other_is_nearer { other } else { nearest }
}

/// Returns |computed − exact| in ulps of the exact value.
fn ulps(width: Width, computed: f64, (high, low): (f64, f64)) -> f64 {
    let difference = (computed - high) - low;
    if difference.is_nan() { f64::INFINITY } else { difference.abs() / width.unit(high) }
}

fn double_double_error(computed: (f64, f64), exact: (f64, f64)) -> (f64, f64) {
    let difference = (computed.0 - exact.0) + (computed.1 - exact.1);
    if difference == 0.0 {
        return (0.0, 0.0);
    }
    let relative = difference.abs() / exact.0.abs();
    if relative.is_nan() {
        return (106.0, f64::INFINITY);
    }
    let bits = (1.0 + relative * 2f64.powi(106)).log2().min(106.0);
    (bits, relative * 2f64.powi(105))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn statistics_are_of_the_sorted_errors() {
        let errors: Vec<f64> = (1..=200).rev().map(f64::from).collect();
        let found = Statistics::of(errors);
        assert_eq!((found.mean, found.percentile, found.maximum), (100.5, 198.0, 200.0));
        assert_eq!(Statistics::of(vec![]), Statistics::default());
    }

    #[test]
    fn a_tie_in_single_precision_is_broken_by_what_is_left() {
        let tie = 1.0 + f64::from(f32::EPSILON) / 2.0;
        let above = 1.0 + f64::from(f32::EPSILON);
        assert_eq!(rounded(Width::Single, (tie, 0.0)), 1.0);
        assert_eq!(rounded(Width::Single, (tie, 1e-20)), above);
        assert_eq!(rounded(Width::Single, (tie, -1e-20)), 1.0);
        assert_eq!(rounded(Width::Single, (-tie, -1e-20)), -above);
    }

    #[test]
    fn errors_are_counted_in_units_of_the_last_place() {
        assert_eq!(ulps(Width::Double, 1.0 + f64::EPSILON, (1.0, 0.0)), 1.0);
        assert_eq!(ulps(Width::Double, 1.0, (1.0, f64::EPSILON / 4.0)), 0.25);
        assert_eq!(ulps(Width::Double, f64::NAN, (1.0, 0.0)), f64::INFINITY);
        assert_eq!(double_double_error((1.0, 2f64.powi(-105)), (1.0, 0.0)).1, 1.0);
    }
}
