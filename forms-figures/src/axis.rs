//! Axes of charts: a label with its unit, a scale, and the form of the numbers.

use crate::text::width;
use crate::ticks::{self, Ticks};

/// Font size of the numbers along an axis, and of its label.
pub(crate) const NUMBER: f64 = 12.5;
pub(crate) const LABEL: f64 = 13.5;
/// Share of the range that is left free at both ends, so that marks are inside.
const MARGIN: f64 = 0.04;
/// Smallest distances between numbers: along a horizontal and along a vertical axis.
const APART: [f64; 2] = [58.0, 27.0];

/// Scale of an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scale {
    /// Equal differences have equal lengths.
    #[default]
    Linear,
    /// Equal ratios have equal lengths.
    Logarithmic,
}

/// Form of the numbers along an axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Numbers {
    /// Short decimal numbers, and powers of ten where these are long.
    #[default]
    Plain,
    /// Whole numbers in groups of three digits.
    Thousands,
    /// Durations from nanoseconds to seconds; the values are seconds.
    Seconds,
    /// Sizes from bytes to gigabytes; the values are bytes.
    Bytes,
    /// Names at 0, 1, 2, …
    Names(Vec<String>),
}

/// Axis of a chart.
#[derive(Clone, Debug, Default)]
pub struct Axis {
    /// Quantity and unit.
    pub label: String,
    /// Scale.
    pub scale: Scale,
    /// Form of the numbers.
    pub numbers: Numbers,
    /// Least and greatest value; `None` for the range of the data.
    pub range: Option<[f64; 2]>,
}

impl Axis {
    /// Creates a linear axis.
    pub fn linear(label: impl Into<String>) -> Self {
        Self { label: label.into(), ..Self::default() }
    }

    /// Creates a logarithmic axis.
    pub fn logarithmic(label: impl Into<String>) -> Self {
        Self { label: label.into(), scale: Scale::Logarithmic, ..Self::default() }
    }

    /// Returns the axis with another form of numbers.
    pub fn with_numbers(self, numbers: Numbers) -> Self {
        Self { numbers, ..self }
    }

    /// Returns the axis with a fixed range.
    pub fn over(self, range: [f64; 2]) -> Self {
        Self { range: Some(range), ..self }
    }

    /// Returns the smallest range of whole decades that contains all values, at least one decade.
    pub fn decades(values: impl IntoIterator<Item = f64>) -> [f64; 2] {
        let logarithms = values.into_iter().map(f64::log10).filter(|power| power.is_finite());
        let ends = logarithms.fold(None, |ends: Option<[f64; 2]>, power| {
            Some(ends.map_or([power; 2], |[least, most]| [least.min(power), most.max(power)]))
        });
        let [least, most] = ends.unwrap_or([-1.0, 0.0]);
        let [from, to] = [least.floor(), most.ceil()];
        [from, to.max(from + 1.0)].map(|power| 10_f64.powf(power))
    }

    /// Returns the coordinate of a value along the axis: its decimal logarithm on a logarithmic axis.
    pub(crate) fn coordinate(&self, value: f64) -> f64 {
        if self.scale == Scale::Logarithmic { value.log10() } else { value }
    }

    /// Returns the range of coordinates: the given one, or that of the data with a margin.
    pub(crate) fn coordinates(&self, data: impl Iterator<Item = f64>) -> [f64; 2] {
        if let Some(range) = self.range {
            return range.map(|end| self.coordinate(end));
        }
        if let Numbers::Names(names) = &self.numbers {
            return [-0.6, names.len() as f64 - 0.4];
        }
        let finite = data.map(|value| self.coordinate(value)).filter(|value| value.is_finite());
        let ends = finite.fold(None, |ends: Option<[f64; 2]>, value| {
            Some(ends.map_or([value; 2], |[least, most]| [least.min(value), most.max(value)]))
        });
        let [least, most] = ends.unwrap_or([0.0, 1.0]);
        // A constant is drawn in the middle.
        let margin = if most > least {
            MARGIN * (most / 2.0 - least / 2.0) * 2.0
        } else if self.scale == Scale::Logarithmic {
            0.5
        } else {
            (least.abs() / 2.0).max(0.5)
        };
        [least - margin, most + margin].map(|end| end.clamp(-f64::MAX / 4.0, f64::MAX / 4.0))
    }

    /// Returns the numbers along a range of coordinates, which has this length on the paper.
    pub(crate) fn ticks(&self, range: [f64; 2], length: f64, is_horizontal: bool) -> Ticks {
        let apart = APART[usize::from(!is_horizontal)] / length.max(1.0);
        match (&self.numbers, self.scale) {
            (Numbers::Names(names), _) => {
                let named = names.iter().enumerate().map(|(place, name)| (place as f64, name.clone()));
                Ticks { labelled: named.collect(), fine: Vec::new() }
            }
            (_, Scale::Linear) => {
                let about = (0.7 / apart).clamp(2.0, 10.0) as usize;
                Ticks { labelled: ticks::linear(range, about), fine: Vec::new() }
            }
            (numbers, Scale::Logarithmic) => {
                ticks::logarithmic(range, apart, |digit, exponent| match numbers {
                    Numbers::Thousands => ticks::thousands(digit, exponent),
                    Numbers::Seconds => ticks::with_unit(digit, exponent, -9, &["ns", "µs", "ms", "s"]),
                    Numbers::Bytes => ticks::with_unit(digit, exponent, 0, &["B", "kB", "MB", "GB"]),
                    Numbers::Plain | Numbers::Names(_) => ticks::power(digit, exponent),
                })
            }
        }
    }

    /// Returns the room that numbers and label need to the left of a chart.
    pub(crate) fn room(&self, ticks: &Ticks) -> f64 {
        let widest = ticks.labelled.iter().map(|(_, text)| width(text, NUMBER)).fold(0.0, f64::max);
        let label = if self.label.is_empty() { 0.0 } else { 1.9 * LABEL };
        (widest + label + 14.0).ceil()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_contain_the_data_and_are_never_empty() {
        let linear = Axis::linear("x");
        let logarithmic = Axis::logarithmic("x");
        for values in [vec![], vec![3.0], vec![0.0, 1.0], vec![f64::NAN, 1.0], vec![-f64::MAX, f64::MAX]] {
            for axis in [&linear, &logarithmic] {
                let [from, to] = axis.coordinates(values.iter().copied());
                assert!(from < to && (to - from).is_finite(), "{values:?}: {from} to {to}");
            }
        }
    }

    #[test]
    fn decades_are_whole() {
        let near =
            |[a, b]: [f64; 2], [c, d]: [f64; 2]| (a / c - 1.0).abs() < 1e-12 && (b / d - 1.0).abs() < 1e-12;
        assert!(near(Axis::decades([0.02, 7.0]), [0.01, 10.0]));
        assert!(near(Axis::decades([1e-3, 1e-3]), [1e-3, 1e-2]));
        assert!(near(Axis::decades([]), [0.1, 1.0]));
    }
}
