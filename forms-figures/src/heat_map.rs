//! A heat map: the values of a grid become colours of the scale viridis, with axes and a colour bar.

use crate::axis::NUMBER;
use crate::plot::{NOTE, TITLE};
use crate::{Area, Axis, Canvas, Chart, Colour, Pen, Style, ticks};
use colorous::VIRIDIS;

const SIZE: [f64; 2] = [580.0, 446.0];
const FRAME: Area = Area { left: 74.0, top: 66.0, right: 452.0, bottom: 384.0 };
/// Left and right of the colour bar, which is as high as the frame.
const BAR: [f64; 2] = [474.0, 492.0];
/// Number of colour steps.
const LEVELS: usize = 96;
/// Ratio of positive values above which the scale is logarithmic.
const LINEAR_RATIO: f64 = 1e3;

/// Mapping of values to fractions of the colour scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColourScale {
    /// Least and greatest finite value.
    pub ends: [f64; 2],
    /// Whether equal ratios appear equal, instead of equal differences.
    pub is_logarithmic: bool,
}

impl ColourScale {
    /// Returns the scale for these values, or `None` if no value is finite.
    pub fn of(values: &[f64]) -> Option<Self> {
        let finite = || values.iter().copied().filter(|value| value.is_finite());
        let least = finite().reduce(f64::min)?;
        let greatest = finite().reduce(f64::max)?;
        let is_logarithmic = least > 0.0 && greatest > least * LINEAR_RATIO;
        Some(Self { ends: [least, greatest], is_logarithmic })
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

    /// Returns the values along the colour bar, with their texts.
    fn ticks(self) -> Vec<(f64, String)> {
        if !self.is_logarithmic {
            return ticks::linear(self.ends, 6);
        }
        let powers = self.ends.map(f64::log10);
        let labelled = ticks::logarithmic(powers, 0.08, ticks::power).labelled;
        labelled.into_iter().map(|(power, text)| (10_f64.powf(power), text)).collect()
    }
}

/// Heat map of a function of two arguments, with its values at the centres of the cells of a grid.
#[derive(Clone, Debug)]
pub struct HeatMap<'a> {
    /// Title.
    pub title: &'a str,
    /// Text below the title.
    pub note: &'a str,
    /// Horizontal axis with its range.
    pub x: Axis,
    /// Vertical axis with its range.
    pub y: Axis,
    /// Values, row by row from the lower end.
    pub values: &'a [f64],
    /// Number of values in a row.
    pub columns: usize,
}

impl HeatMap<'_> {
    /// Returns the map as the text of an SVG file. Cells without a value are hatched.
    pub fn svg(&self) -> String {
        let mut canvas = Canvas::new();
        let area = self.area();
        let Area { left, top, right, bottom } = area;
        canvas.text([20.0, 28.0], Style::of(TITLE, Colour::Ink).bold(), self.title);
        canvas.text([20.0, 47.0], Style::of(NOTE, Colour::Quiet), self.note);
        let has_gaps = self.values.iter().any(|value| value.is_nan());
        let scale = ColourScale::of(self.values);
        if has_gaps || scale.is_none() {
            canvas.hatch([left, top], [right - left, bottom - top]);
        }
        if let Some(scale) = scale {
            self.cells(&mut canvas, area, scale);
            colour_bar(&mut canvas, scale);
        }
        Chart::new(area, &self.x, &self.y, &[]).without_grid().draw(&mut canvas);
        let outline = Pen::solid(Colour::Ink, 1.2);
        canvas.rectangle([left, top], [right - left, bottom - top], None, Some(outline));
        if has_gaps {
            canvas.hatch([BAR[0], bottom + 20.0], [18.0, 14.0]);
            canvas.text([BAR[1] + 7.0, bottom + 31.5], Style::of(NUMBER, Colour::Ink), "not defined");
        }
        canvas.finish(SIZE, self.title, &self.description(scale))
    }

    /// Returns the frame, with room for the numbers at its left.
    fn area(&self) -> Area {
        let room = Chart::new(FRAME, &self.x, &self.y, &[]).room();
        Area { left: FRAME.left.max(room + 14.0), ..FRAME }
    }

    fn description(&self, scale: Option<ColourScale>) -> String {
        let values = scale.map_or("no value is defined".to_owned(), |scale| {
            format!("from {:.3e}, dark, to {:.3e}, bright", scale.ends[0], scale.ends[1])
        });
        format!("Values over {} across and {} upwards: {values}.", self.x.label, self.y.label)
    }

    /// Draws the cells. Neighbours of one colour in a row form one box, and all boxes of one colour
    /// form one path.
    fn cells(&self, canvas: &mut Canvas, area: Area, scale: ColourScale) {
        let rows = self.values.len() / self.columns;
        let mut levels: Vec<_> = (0..=LEVELS).map(|level| (colour(level), Vec::new())).collect();
        for (row, values) in self.values.chunks_exact(self.columns).enumerate() {
            let level = |value: &f64| {
                (!value.is_nan()).then(|| (scale.share(*value) * LEVELS as f64).round() as usize)
            };
            let mut column = 0;
            for run in values.chunk_by(|one, other| level(one) == level(other)) {
                if let Some(level) = level(&run[0]) {
                    levels[level].1.push([column, rows - 1 - row, run.len()]);
                }
                column += run.len();
            }
        }
        let Area { left, top, right, bottom } = area;
        let cell = [(right - left) / self.columns as f64, (bottom - top) / rows as f64];
        canvas.cells([left, top], cell, &levels);
    }
}

fn colour_bar(canvas: &mut Canvas, scale: ColourScale) {
    let Area { top, bottom, .. } = FRAME;
    let [left, right] = BAR;
    let levels: Vec<_> = (0..=LEVELS).map(|level| (colour(level), vec![[0, LEVELS - level, 1]])).collect();
    let height = bottom - top;
    canvas.cells([left, top], [right - left, height / (LEVELS + 1) as f64], &levels);
    canvas.rectangle([left, top], [right - left, height], None, Some(Pen::solid(Colour::Ink, 1.2)));
    for (value, text) in scale.ticks() {
        let y = bottom - scale.share(value) * height;
        canvas.line([right, y], [right + 4.0, y], Pen::solid(Colour::Ink, 1.2));
        canvas.text([right + 8.0, y + 4.4], Style::of(NUMBER, Colour::Quiet), &text);
    }
    if scale.is_logarithmic {
        canvas.text([left, top - 9.0], Style::of(NOTE, Colour::Quiet), "logarithmic");
    }
}

/// Returns the colour of a level, as red, green and blue.
fn colour(level: usize) -> [u8; 3] {
    VIRIDIS.eval_rational(level, LEVELS + 1).into_array()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(values: &[f64]) -> String {
        let x = Axis::linear("x").over([0.0, 1.0]);
        let y = Axis::linear("a < b").over([-1.0, 1.0]);
        HeatMap { title: "f(x, y)", note: "", x, y, values, columns: 2 }.svg()
    }

    #[test]
    fn the_least_value_is_dark_the_greatest_bright_and_a_nan_has_no_colour() {
        let map = drawn(&[0.0, f64::NAN, 1.0, 1.0]);
        let cell = |run: &str, level| {
            let [red, green, blue] = colour(level);
            format!("<path d=\"{run}\" fill=\"#{red:02x}{green:02x}{blue:02x}\"/>")
        };
        assert!(
            map.contains(&cell("M0 1h1v1h-1z", 0)) && map.contains(&cell("M0 0h2v1h-2z", LEVELS)),
            "{map}"
        );
        assert!(map.contains("not defined") && map.contains("a &lt; b"), "{map}");
        assert!(!drawn(&[0.0, 1.0]).contains("not defined"));
    }

    #[test]
    fn values_of_any_size_are_drawn_with_numbers_only() {
        let cases =
            [[f64::NAN; 2], [3.0; 2], [-f64::MAX, f64::MAX], [f64::INFINITY, 1.0], [5e-324, 1e300], [0.0; 2]];
        for values in cases {
            let map = drawn(&values);
            assert!(!map.contains("NaN") && !map.contains("inf"), "{values:?}: {map}");
        }
    }

    #[test]
    fn positive_values_over_many_sizes_are_shown_by_their_logarithms() {
        assert!(ColourScale::of(&[1e-3, 1e3]).is_some_and(|scale| scale.is_logarithmic));
        assert!(ColourScale::of(&[0.0, 1e3]).is_some_and(|scale| !scale.is_logarithmic));
        let middle = ColourScale { ends: [1e-2, 1e2], is_logarithmic: true }.share(1.0);
        assert!((middle - 0.5).abs() < 1e-12);
    }
}
