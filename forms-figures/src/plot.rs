//! Plots: series of values as lines, marks and bars of error over linear or logarithmic axes.

use crate::chart::BELOW;
use crate::text::width;
use crate::{Anchor, Area, Axis, Canvas, Chart, Colour, Mark, Numbers, Pen, Style};

const WIDTH: f64 = 720.0;
/// Height of the frame, and of a row if the vertical axis has names.
const HEIGHT: f64 = 320.0;
const NAMED: f64 = 28.0;
/// Left and right edge of titles, legends and notes.
const EDGES: [f64; 2] = [20.0, 700.0];
/// Height of a row of the legend, its font size, and the length of a line in it.
const ROW: f64 = 21.0;
const LEGEND: f64 = 13.0;
const SAMPLE: f64 = 28.0;
/// Font sizes of titles and notes.
pub(crate) const TITLE: f64 = 16.0;
pub(crate) const NOTE: f64 = 12.0;
const MARK: f64 = 4.2;
/// Half the width of the ends of a bar of error.
const CAP: f64 = 4.0;
const STROKE: f64 = 2.0;

/// Line through the points of a series.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Line {
    /// No line.
    None,
    /// Continuous line.
    Solid,
    /// Dashed line.
    Dashed,
}

/// Series of points.
#[derive(Clone, Debug)]
pub struct Series {
    /// Name in the legend; empty for none.
    pub name: String,
    /// Points. A point that is not finite interrupts the line.
    pub points: Vec<[f64; 2]>,
    /// Errors of the values: none, or one for each point.
    pub errors: Vec<f64>,
    /// Line through the points.
    pub line: Line,
    /// Mark of the points; `None` for no marks.
    pub mark: Option<Mark>,
    /// Colour; `None` for the next colour of the theme.
    pub colour: Option<Colour>,
}

impl Series {
    /// Creates a line with marks.
    pub fn line(name: impl Into<String>, points: Vec<[f64; 2]>) -> Self {
        let name = name.into();
        Self { name, points, errors: Vec::new(), line: Line::Solid, mark: Some(Mark::Dot), colour: None }
    }

    /// Creates a line without marks.
    pub fn curve(name: impl Into<String>, points: Vec<[f64; 2]>) -> Self {
        Self { mark: None, ..Self::line(name, points) }
    }

    /// Creates marks without a line.
    pub fn marks(name: impl Into<String>, points: Vec<[f64; 2]>, mark: Mark) -> Self {
        Self { line: Line::None, mark: Some(mark), ..Self::line(name, points) }
    }

    /// Returns the series in a colour.
    pub fn coloured(self, colour: Colour) -> Self {
        Self { colour: Some(colour), ..self }
    }

    /// Returns the series with bars of error.
    pub fn with_errors(self, errors: Vec<f64>) -> Self {
        Self { errors, ..self }
    }

    /// Returns the series with another mark.
    pub fn marked(self, mark: Mark) -> Self {
        Self { mark: Some(mark), ..self }
    }

    /// Returns the series with a dashed line.
    pub fn dashed(self) -> Self {
        Self { line: Line::Dashed, ..self }
    }
}

/// Value that is marked by a dashed line across the plot.
#[derive(Clone, Debug)]
pub struct Level {
    /// Value on the vertical axis.
    pub value: f64,
    /// Text above the line.
    pub name: String,
    /// Colour.
    pub colour: Colour,
}

/// Contents of a plot.
#[derive(Clone, Debug, Default)]
pub struct Plot {
    /// Title.
    pub title: String,
    /// Sentence that says what is seen, for readers who do not see it.
    pub description: String,
    /// Note below the plot, such as the conditions of a measurement.
    pub note: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Series, in the order of the legend.
    pub series: Vec<Series>,
    /// Marked values.
    pub levels: Vec<Level>,
    /// Text in the middle of a plot without points.
    pub missing: String,
}

impl Plot {
    /// Returns the plot as the text of an SVG file.
    pub fn svg(&self) -> String {
        let mut canvas = Canvas::new();
        let height = match &self.y.numbers {
            Numbers::Names(names) => NAMED * (names.len() as f64 + 0.2),
            _ => HEIGHT,
        };
        let bottom = self.draw(&mut canvas, height);
        canvas.finish([WIDTH, bottom], &self.title, &self.description)
    }

    /// Draws the plot with a frame of this height at the top of a canvas; returns the lower end.
    pub fn draw(&self, canvas: &mut Canvas, height: f64) -> f64 {
        canvas.text([EDGES[0], 32.0], Style::of(TITLE, Colour::Ink).bold(), &self.title);
        let top = self.legend(canvas, 58.0);
        let frame = Area { left: EDGES[0], top, right: EDGES[1] - 8.0, bottom: top + height };
        let data = self.data();
        let room = Chart::new(frame, &self.x, &self.y, &data).room();
        let frame = Area { left: EDGES[0] - 6.0 + room, ..frame };
        let chart = Chart::new(frame, &self.x, &self.y, &data);
        self.contents(canvas, &chart);
        if data.is_empty() && !self.missing.is_empty() {
            let middle = [f64::midpoint(frame.left, frame.right), f64::midpoint(frame.top, frame.bottom)];
            let style = Style::of(LEGEND, Colour::Quiet).anchored(Anchor::Middle);
            canvas.text_over_lines(middle, style, &self.missing);
        }
        let below = frame.bottom + BELOW;
        if self.note.is_empty() {
            return below + 14.0;
        }
        let style = Style::of(NOTE, Colour::Quiet).anchored(Anchor::End);
        canvas.text([frame.right, below + 22.0], style, &self.note);
        below + 38.0
    }

    /// Returns all points that are drawn, with the ends of their errors and the marked values.
    fn data(&self) -> Vec<[f64; 2]> {
        let mut data: Vec<[f64; 2]> = Vec::new();
        for series in &self.series {
            for (place, &[x, y]) in series.points.iter().enumerate() {
                let error = series.errors.get(place).copied().unwrap_or(0.0);
                data.extend([[x, y - error], [x, y + error], [x, y]]);
            }
        }
        data.retain(|point| point.iter().all(|number| number.is_finite()));
        let first = data.first().map(|point| point[0]);
        data.extend(first.into_iter().flat_map(|x| self.levels.iter().map(move |level| [x, level.value])));
        data
    }

    fn colour(&self, number: usize) -> Colour {
        self.series[number].colour.unwrap_or(Colour::DATA[number % Colour::DATA.len()])
    }

    /// Draws the names of the series in one or two columns; returns the top of the frame.
    fn legend(&self, canvas: &mut Canvas, top: f64) -> f64 {
        let named: Vec<usize> =
            (0..self.series.len()).filter(|&number| !self.series[number].name.is_empty()).collect();
        let column = (EDGES[1] - EDGES[0]) / 2.0;
        let widest = named.iter().map(|&number| width(&self.series[number].name, LEGEND)).fold(0.0, f64::max);
        let columns = if widest + SAMPLE + 20.0 < column { 2 } else { 1 };
        for (place, &number) in named.iter().enumerate() {
            let x = EDGES[0] + column * (place % columns) as f64;
            let y = top + ROW * (place / columns) as f64;
            let ends = [[x, y], [x + SAMPLE, y]];
            self.stroke(canvas, number, &ends);
            if let Some(mark) = self.series[number].mark {
                canvas.mark([x + SAMPLE / 2.0, y], mark, MARK, self.colour(number));
            }
            let style = Style::of(LEGEND, Colour::Ink);
            canvas.text([x + SAMPLE + 9.0, y + 4.6], style, &self.series[number].name);
        }
        let rows = named.len().div_ceil(columns);
        if rows == 0 { top - 6.0 } else { top + ROW * (rows as f64 - 1.0) + 20.0 }
    }

    /// Draws a line in the style of a series.
    fn stroke(&self, canvas: &mut Canvas, number: usize, places: &[[f64; 2]]) {
        let colour = self.colour(number);
        match self.series[number].line {
            Line::None => {}
            Line::Solid => canvas.path(places, Pen::solid(colour, STROKE)),
            Line::Dashed => canvas.path(places, Pen::dashed(colour, STROKE)),
        }
    }

    fn contents(&self, canvas: &mut Canvas, chart: &Chart<'_>) {
        let is_shown = |point: &[f64; 2]| chart.coordinates(*point).iter().all(|number| number.is_finite());
        let pieces = |series: &Series| -> Vec<Vec<[f64; 2]>> {
            let pieces = series.points.split(|point| !is_shown(point));
            pieces.filter(|piece| !piece.is_empty()).map(<[_]>::to_vec).collect()
        };
        let solid = self.series.iter().enumerate().filter(|(_, series)| series.line == Line::Solid);
        let curves: Vec<_> = solid
            .flat_map(|(number, series)| {
                let coordinates =
                    |piece: Vec<[f64; 2]>| piece.iter().map(|&at| chart.coordinates(at)).collect();
                pieces(series).into_iter().map(move |piece| (coordinates(piece), self.colour(number), STROKE))
            })
            .collect();
        chart.draw_with(canvas, &curves);
        for level in &self.levels {
            self.level(canvas, chart, level);
        }
        for (number, series) in self.series.iter().enumerate() {
            if series.line == Line::Dashed {
                for piece in pieces(series) {
                    let places: Vec<_> = piece.iter().map(|&point| chart.place(point)).collect();
                    self.stroke(canvas, number, &places);
                }
            }
            let colour = self.colour(number);
            for (&point, &error) in series.points.iter().zip(&series.errors) {
                error_bar(canvas, chart, point, error, colour);
            }
            if let Some(mark) = series.mark {
                for &point in series.points.iter().filter(|point| is_shown(point)) {
                    canvas.mark(chart.place(point), mark, MARK, colour);
                }
            }
        }
    }

    fn level(&self, canvas: &mut Canvas, chart: &Chart<'_>, level: &Level) {
        let Area { left, right, .. } = chart.area;
        let y = chart.place([1.0, level.value])[1];
        canvas.line([left, y], [right, y], Pen::dashed(level.colour, 1.6));
        let style = Style::of(NOTE, level.colour).anchored(Anchor::End);
        canvas.text_over_lines([right - 6.0, y - 6.0], style, &level.name);
    }
}

/// Draws a bar from the least to the greatest value of a point within its error.
fn error_bar(canvas: &mut Canvas, chart: &Chart<'_>, [x, y]: [f64; 2], error: f64, colour: Colour) {
    let ends = [y - error, y + error].map(|end| chart.place([x, end]));
    if error > 0.0 && ends.iter().flatten().all(|number| number.is_finite()) {
        let pen = Pen::solid(colour, 1.4);
        canvas.line(ends[0], ends[1], pen);
        for [x, y] in ends {
            canvas.line([x - CAP, y], [x + CAP, y], pen);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plot(points: Vec<[f64; 2]>) -> Plot {
        Plot {
            title: "a < b".to_owned(),
            x: Axis::linear("x [m]"),
            y: Axis::logarithmic("y [1]"),
            series: vec![Series::line("first", points)],
            missing: "no values".to_owned(),
            ..Plot::default()
        }
    }

    #[test]
    fn a_line_has_a_gap_where_it_has_no_value() {
        let file =
            plot(vec![[0.0, 1.0], [1.0, 2.0], [2.0, f64::NAN], [3.0, 2.0], [4.0, 0.0], [5.0, 9.0]]).svg();
        // four points and the legend have marks
        assert_eq!(file.matches("<circle").count(), 5, "{file}");
        assert!(!file.contains("NaN") && !file.contains("inf") && !file.contains("no values"), "{file}");
        assert!(file.contains("x [m]") && file.contains("y [1]") && file.contains("a &lt; b"), "{file}");
    }

    #[test]
    fn empty_and_constant_series_are_drawn_with_numbers_only() {
        for points in [vec![], vec![[f64::NAN, 1.0]], vec![[1.0, 1.0]], vec![[0.0, f64::INFINITY]]] {
            let is_empty = !points.contains(&[1.0, 1.0]);
            let file = plot(points).svg();
            assert!(!file.contains("NaN") && !file.contains("inf"), "{file}");
            assert_eq!(file.contains("no values"), is_empty, "{file}");
        }
    }

    #[test]
    fn errors_are_bars_and_levels_are_dashed_lines() {
        let mut plot = plot(vec![[0.0, 10.0], [1.0, 20.0]]);
        let bare = plot.svg();
        plot.series[0].errors = vec![1.0, 2.0];
        plot.levels = vec![Level { value: 5.0, name: "limit".to_owned(), colour: Colour::Vermilion }];
        let file = plot.svg();
        assert!(file.matches("<line").count() >= bare.matches("<line").count() + 7, "{file}");
        assert_eq!(file.matches("stroke-dasharray").count(), 1);
        assert!(file.contains(">limit</text>"));
    }
}
