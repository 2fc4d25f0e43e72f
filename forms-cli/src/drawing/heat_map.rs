//! A heat map: the values of a grid become colours of the scale viridis, with axes and a legend.

use super::{Anchor, Drawing, INK, QUIET, Style, round_values};
use forms_radiometry::output::viridis;

const SIZE: [f64; 2] = [560.0, 430.0];
/// Frame of the map: left, top, right and bottom.
const FRAME: [f64; 4] = [66.0, 48.0, 446.0, 372.0];
/// Left and right of the legend, which is as high as the frame.
const LEGEND: [f64; 2] = [466.0, 484.0];
/// Number of colour steps.
const LEVELS: usize = 96;
/// Ratio of positive values above which the scale is logarithmic.
const LINEAR_RATIO: f64 = 1e3;
/// Name of the pattern for cells without a value.
const UNDEFINED: &str = "undefined";

/// Mapping of values to fractions of the colour scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Scale {
    /// Least and greatest finite value.
    pub(crate) ends: [f64; 2],
    /// Whether equal ratios appear equal, instead of equal differences.
    pub(crate) is_logarithmic: bool,
}

impl Scale {
    /// Returns the scale for these values, or `None` if no value is finite.
    pub(crate) fn of(values: &[f64]) -> Option<Self> {
        let finite = || values.iter().copied().filter(|value| value.is_finite());
        let least = finite().reduce(f64::min)?;
        let greatest = finite().reduce(f64::max)?;
        let is_logarithmic = least > 0.0 && greatest > least * LINEAR_RATIO;
        Some(Scale { ends: [least, greatest], is_logarithmic })
    }

    /// Returns the fraction of a value, from 0 at the least to 1 at the greatest value; infinite
    /// values are at the ends.
    fn share(self, value: f64) -> f64 {
        let [least, greatest] = self.ends;
        let [least, greatest, value] = if self.is_logarithmic {
            [least.ln(), greatest.ln(), value.ln()]
        } else {
            [least, greatest, value]
        };
        let width = greatest / 2.0 - least / 2.0;
        if width <= 0.0 { 0.5 } else { ((value / 2.0 - least / 2.0) / width).clamp(0.0, 1.0) }
    }

    /// Returns the values of the legend, with their texts.
    fn ticks(self) -> Vec<(f64, String)> {
        let [least, greatest] = self.ends;
        if !self.is_logarithmic {
            return round_values(least, greatest, 6);
        }
        let (first, last) = (least.log10().ceil() as i32, greatest.log10().floor() as i32);
        let every = ((last - first) / 8 + 1) as usize;
        (first..=last).step_by(every).map(|power| (10f64.powi(power), format!("1e{power}"))).collect()
    }
}

/// Argument along an axis, with its range.
pub(crate) struct Range<'a> {
    pub(crate) name: &'a str,
    pub(crate) from: f64,
    pub(crate) to: f64,
}

/// Heat map of a function of two arguments, with its values at the centres of the cells of a grid.
pub(crate) struct HeatMap<'a> {
    pub(crate) title: &'a str,
    /// Text below the title.
    pub(crate) note: &'a str,
    pub(crate) across: Range<'a>,
    pub(crate) up: Range<'a>,
    /// Values, row by row from the lower end.
    pub(crate) values: &'a [f64],
    pub(crate) columns: usize,
}

impl HeatMap<'_> {
    /// Returns the map as an SVG file. Cells without a value are hatched.
    pub(crate) fn svg(&self) -> String {
        let mut drawing = Drawing::new();
        let [left, top, right, bottom] = FRAME;
        drawing.hatch(UNDEFINED);
        drawing.text([left, 22.0], Style::of(15.0, INK).bold(), self.title);
        drawing.text([left, 39.0], Style::of(12.5, QUIET), self.note);
        drawing.cell([left, top], [right - left, bottom - top], &format!("url(#{UNDEFINED})"), None);
        let scale = Scale::of(self.values);
        if let Some(scale) = scale {
            self.cells(&mut drawing, scale);
            legend(&mut drawing, scale);
        }
        self.axes(&mut drawing);
        if self.values.iter().any(|value| value.is_nan()) {
            drawing.cell([LEGEND[0], bottom + 24.0], [20.0, 14.0], &format!("url(#{UNDEFINED})"), None);
            drawing.text([LEGEND[1] + 6.0, bottom + 35.0], Style::of(12.5, INK), "not defined");
        }
        drawing.finish(SIZE[0], SIZE[1], self.title)
    }

    /// Draws the cells. Neighbours of one colour in a row form one box, and all boxes of one colour
    /// form one path.
    fn cells(&self, drawing: &mut Drawing, scale: Scale) {
        let rows = self.values.len() / self.columns;
        let mut levels: Vec<Vec<[usize; 3]>> = vec![Vec::new(); LEVELS + 1];
        for (row, values) in self.values.chunks_exact(self.columns).enumerate() {
            let level = |value: &f64| {
                (!value.is_nan()).then(|| (scale.share(*value) * LEVELS as f64).round() as usize)
            };
            let mut column = 0;
            for run in values.chunk_by(|one, other| level(one) == level(other)) {
                if let Some(level) = level(&run[0]) {
                    levels[level].push([column, rows - 1 - row, run.len()]);
                }
                column += run.len();
            }
        }
        let [left, top, right, bottom] = FRAME;
        let cell = [(right - left) / self.columns as f64, (bottom - top) / rows as f64];
        drawing.grid([left, top], cell, |drawing| {
            for (level, runs) in levels.iter().enumerate().filter(|(_, runs)| !runs.is_empty()) {
                drawing.runs(runs, &colour(level));
            }
        });
    }

    fn axes(&self, drawing: &mut Drawing) {
        let [left, top, right, bottom] = FRAME;
        let Range { name, from, to } = self.across;
        for (value, text) in round_values(from, to, 6) {
            let x = left + (value - from) / (to - from) * (right - left);
            drawing.line([x, bottom], [x, bottom + 5.0], INK, 1.0);
            drawing.text([x, bottom + 18.0], Style::of(13.0, INK).anchored(Anchor::Middle), &text);
        }
        drawing.text(
            [(left + right) / 2.0, bottom + 40.0],
            Style::of(14.0, INK).anchored(Anchor::Middle),
            name,
        );
        let Range { name, from, to } = self.up;
        for (value, text) in round_values(from, to, 6) {
            let y = bottom - (value - from) / (to - from) * (bottom - top);
            drawing.line([left - 5.0, y], [left, y], INK, 1.0);
            drawing.text([left - 9.0, y + 4.0], Style::of(13.0, INK).anchored(Anchor::End), &text);
        }
        drawing.upright([18.0, (top + bottom) / 2.0], 14.0, name);
        drawing.path(&[[left, top], [right, top], [right, bottom], [left, bottom], [left, top]], INK, 1.0);
    }
}

fn legend(drawing: &mut Drawing, scale: Scale) {
    let [_, top, _, bottom] = FRAME;
    let [left, right] = LEGEND;
    let count = LEVELS + 1;
    drawing.grid([left, top], [right - left, (bottom - top) / count as f64], |drawing| {
        (0..count).for_each(|level| drawing.runs(&[[0, LEVELS - level, 1]], &colour(level)));
    });
    drawing.path(&[[left, top], [right, top], [right, bottom], [left, bottom], [left, top]], INK, 1.0);
    for (value, text) in scale.ticks() {
        let y = bottom - scale.share(value) * (bottom - top);
        drawing.line([right, y], [right + 4.0, y], INK, 1.0);
        drawing.text([right + 7.0, y + 4.0], Style::of(12.5, INK), &text);
    }
    if scale.is_logarithmic {
        drawing.text([left, top - 8.0], Style::of(11.0, QUIET), "logarithmic");
    }
}

/// Returns the colour of a level in the notation of SVG.
fn colour(level: usize) -> String {
    let [red, green, blue] = viridis(level as f64 / LEVELS as f64);
    format!("#{red:02x}{green:02x}{blue:02x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(values: &[f64]) -> String {
        let across = Range { name: "x", from: 0.0, to: 1.0 };
        let up = Range { name: "a < b", from: -1.0, to: 1.0 };
        HeatMap { title: "f(x, y)", note: "", across, up, values, columns: 2 }.svg()
    }

    #[test]
    fn the_least_value_is_dark_the_greatest_bright_and_what_is_no_number_has_no_colour() {
        let map = drawn(&[0.0, f64::NAN, 1.0, 1.0]);
        let cell = |run: &str, level| format!("<path d=\"{run}\" fill=\"{}\"/>", colour(level));
        assert!(
            map.contains(&cell("M0 1h1v1h-1z", 0)) && map.contains(&cell("M0 0h2v1h-2z", LEVELS)),
            "{map}"
        );
        assert!(map.contains("not defined") && map.contains("a &lt; b"), "{map}");
        assert!(!drawn(&[0.0, 1.0]).contains("not defined"));
    }

    #[test]
    fn values_of_nothing_of_one_size_and_of_all_sizes_are_drawn_with_numbers_only() {
        let cases =
            [[f64::NAN; 2], [3.0; 2], [-f64::MAX, f64::MAX], [f64::INFINITY, 1.0], [5e-324, 1e300], [0.0; 2]];
        for values in cases {
            let map = drawn(&values);
            assert!(!map.contains("NaN") && !map.contains("inf"), "{values:?}: {map}");
        }
    }

    #[test]
    fn positive_values_over_many_sizes_are_shown_by_their_logarithms() {
        assert!(Scale::of(&[1e-3, 1e3]).is_some_and(|scale| scale.is_logarithmic));
        assert!(Scale::of(&[0.0, 1e3]).is_some_and(|scale| !scale.is_logarithmic));
        let middle = Scale { ends: [1e-2, 1e2], is_logarithmic: true }.share(1.0);
        assert!((middle - 0.5).abs() < 1e-12);
    }
}
