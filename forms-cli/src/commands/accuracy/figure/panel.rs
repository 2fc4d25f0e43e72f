//! A panel: correct digits of a result over the time of one value, with a named marker for each
//! variant and the Pareto front.

use super::{colour, front, marker};
use crate::commands::accuracy::report::{Report, Row};
use forms::core::accuracy::{Arithmetic, Score};
use forms_figures::{Anchor, Area, Axis, Canvas, Chart, Colour, Names, Pen, Style, width};
use std::f64::consts::LOG10_2;

/// Number of digits at the upper end of the axis.
const MOST_DIGITS: f64 = 34.0;

/// Font size of names.
const NAME: f64 = 11.0;

/// Number of bits of each arithmetic.
const LEVELS: [(Arithmetic, &str, f64); 3] = [
    (Arithmetic::Single, "all of f32: 24 bits", 24.0),
    (Arithmetic::Double, "all of f64: 53 bits", 53.0),
    (Arithmetic::DoubleDouble, "all of dd: 106 bits", 106.0),
];

/// Range of the axis of times, in nanoseconds.
#[derive(Clone, Copy)]
pub(super) struct Times([f64; 2]);

impl Times {
    /// Returns the range of the measured times, or `None` if there are none.
    pub(super) fn of(report: &Report) -> Option<Self> {
        let times = || report.rows.iter().filter_map(|row| row.nanoseconds);
        let (least, most) = (times().reduce(f64::min)?.log10(), times().reduce(f64::max)?.log10());
        let margin = 0.06 * (most - least).max(0.5);
        Some(Times([least - margin, most + margin].map(|power| 10_f64.powf(power))))
    }
}

/// Position and content of a panel.
pub(super) struct Panel<'a> {
    pub(super) area: Area,
    pub(super) times: Times,
    pub(super) title: &'a str,
    /// Label of the vertical axis; empty for the label of the panel at the left.
    pub(super) digits: &'a str,
    /// Score of a variant that is drawn.
    pub(super) score: fn(&Row) -> Option<&Score>,
}

impl Panel<'_> {
    pub(super) fn draw(&self, canvas: &mut Canvas, report: &Report) {
        let x = Axis::logarithmic("time of one value [ns]").over(self.times.0);
        let y = Axis::linear(self.digits).over([0.0, MOST_DIGITS]);
        let chart = Chart::new(self.area, &x, &y, &[]);
        chart.draw(canvas);
        canvas.text([self.area.left, self.area.top - 10.0], Style::of(13.0, Colour::Ink).bold(), self.title);
        let taken = self.levels(canvas, &chart);
        let place =
            |row: &Row, lost: f64| Some(chart.place([row.nanoseconds?, row.correct_bits(lost) * LOG10_2]));
        let marked = report.rows.iter().filter_map(|row| {
            let lost = (self.score)(row)?.bits.mean;
            Some((row, place(row, lost)?))
        });
        let rows: Vec<(&Row, [f64; 2])> = marked.collect();
        let marks: Vec<[f64; 2]> = rows.iter().map(|(_, mark)| *mark).collect();
        let stairs = self.front(&marks);
        canvas.path(&stairs, front());
        let Area { left, right, .. } = self.area;
        let levels = LEVELS.map(|level| chart.place([1.0, level.2 * LOG10_2])[1]);
        let levels = levels.into_iter().map(|y| [[left, y], [right, y]]);
        let lines = stairs.windows(2).map(|step| [step[0], step[1]]).chain(levels).collect();
        let mut names = Names::new(self.area, &marks, taken, lines);
        for (row, mark) in &rows {
            let colour = colour(row.variant().arithmetic);
            let name = row.variant().name();
            let place = names.place(*mark, width(&name, NAME));
            if let Some(end) = place.thread {
                canvas.line(*mark, end, Pen::solid(colour, 0.7));
            }
            canvas.text_over_lines(place.text, Style::of(NAME, colour).anchored(place.anchor), &name);
        }
        rows.iter().for_each(|(row, mark)| marker(canvas, *mark, row.variant()));
    }

    /// Draws the precision of each arithmetic; returns the boxes of the texts.
    fn levels(&self, canvas: &mut Canvas, chart: &Chart<'_>) -> Vec<Area> {
        let Area { left, right, .. } = self.area;
        let level = |(arithmetic, name, bits): (Arithmetic, &str, f64)| {
            let y = chart.place([1.0, bits * LOG10_2])[1];
            canvas.line([left, y], [right, y], Pen::solid(colour(arithmetic), 0.9));
            let style = Style::of(NAME, Colour::Quiet).anchored(Anchor::End);
            canvas.text_over_lines([right - 4.0, y - 4.0], style, name);
            Area { left: right - 4.0 - width(name, NAME), top: y - 14.0, right, bottom: y }
        };
        LEVELS.map(level).to_vec()
    }

    /// Returns the staircase of the Pareto front: the variants that no other beats in both time and
    /// digits.
    fn front(&self, marks: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let mut sorted = marks.to_vec();
        sorted.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
        let mut stairs: Vec<[f64; 2]> = Vec::new();
        for mark in sorted {
            match stairs.last().copied() {
                None => stairs.push(mark),
                Some(last) if mark[1] < last[1] - 0.5 => stairs.extend([[mark[0], last[1]], mark]),
                Some(_) => {}
            }
        }
        let end = stairs.last().map(|last| [self.area.right, last[1]]);
        stairs.extend(end);
        stairs
    }
}
