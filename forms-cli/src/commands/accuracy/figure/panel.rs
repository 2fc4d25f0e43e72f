//! A panel: correct digits of a result over the time of one value, with a named marker for each
//! variant and the Pareto front.

use super::names::{Area, Names};
use super::{FRONT, colour, marker};
use crate::commands::accuracy::report::{Report, Row};
use crate::drawing::{Anchor, Axis, Drawing, GRID, INK, QUIET, Style, width};
use forms::core::accuracy::{Arithmetic, Score};

/// Number of digits at the upper end of the axis.
const MOST_DIGITS: f64 = 34.0;

/// Smallest distance between numbers on the axis of times.
const APART: f64 = 31.0;

/// Font size of names.
const NAME: f64 = 11.0;

/// Number of bits of each arithmetic.
const LEVELS: [(Arithmetic, &str, f64); 3] = [
    (Arithmetic::Single, "all of f32: 24 bits", 24.0),
    (Arithmetic::Double, "all of f64: 53 bits", 53.0),
    (Arithmetic::DoubleDouble, "all of dd: 106 bits", 106.0),
];

/// Range of the axis of times: decimal logarithms of nanoseconds.
#[derive(Clone, Copy)]
pub(super) struct Times {
    from: f64,
    to: f64,
}

impl Times {
    /// Returns the range of the measured times, or `None` if there are none.
    pub(super) fn of(report: &Report) -> Option<Self> {
        let times = || report.rows.iter().filter_map(|row| row.nanoseconds);
        let (least, most) = (times().reduce(f64::min)?.log10(), times().reduce(f64::max)?.log10());
        let margin = 0.06 * (most - least).max(0.5);
        Some(Times { from: least - margin, to: most + margin })
    }
}

/// Position and content of a panel.
pub(super) struct Panel<'a> {
    pub(super) area: Area,
    pub(super) times: Times,
    pub(super) title: &'a str,
    /// Score of a variant that is drawn.
    pub(super) score: fn(&Row) -> Option<&Score>,
    /// Whether the axis of digits is numbered.
    pub(super) numbered: bool,
}

impl Panel<'_> {
    pub(super) fn draw(&self, drawing: &mut Drawing, report: &Report) {
        let taken = self.frame(drawing);
        let times = self.times();
        let rows: Vec<(&Row, [f64; 2])> = report
            .rows
            .iter()
            .filter_map(|row| {
                let lost = (self.score)(row)?.bits.mean;
                Some((row, [times.place(row.nanoseconds?), self.y(row.correct_bits(lost))]))
            })
            .collect();
        let marks: Vec<[f64; 2]> = rows.iter().map(|(_, mark)| *mark).collect();
        let stairs = self.front(&marks);
        drawing.path(&stairs, FRONT, 3.0);
        let levels = LEVELS
            .iter()
            .map(|level| [[self.area.left, self.y(level.2)], [self.area.right, self.y(level.2)]]);
        let lines = stairs.windows(2).map(|step| [step[0], step[1]]).chain(levels).collect();
        let mut names = Names::new(self.area, &marks, taken, lines);
        for (row, mark) in &rows {
            let name = row.variant().name();
            let place = names.place(*mark, width(&name, NAME));
            if let Some(end) = place.thread {
                drawing.line(*mark, end, colour(row.variant().arithmetic), 0.7);
            }
            let style = Style::of(NAME, colour(row.variant().arithmetic)).anchored(place.anchor);
            drawing.text_over_lines(place.text, style, &name);
        }
        rows.iter().for_each(|(row, mark)| marker(drawing, *mark, row.variant()));
    }

    fn times(&self) -> Axis {
        Axis { powers: [self.times.from, self.times.to], paper: [self.area.left, self.area.right] }
    }

    fn y(&self, bits: f64) -> f64 {
        let part = bits * std::f64::consts::LOG10_2 / MOST_DIGITS;
        self.area.bottom - part * (self.area.bottom - self.area.top)
    }

    /// Draws axes and levels; returns the boxes of their texts.
    fn frame(&self, drawing: &mut Drawing) -> Vec<Area> {
        let Area { left, top, right, bottom } = self.area;
        drawing.text([left, top - 10.0], Style::of(13.0, INK).bold(), self.title);
        for digits in (0..=32).step_by(4) {
            let y = self.y(f64::from(digits) / std::f64::consts::LOG10_2);
            drawing.line([left, y], [right, y], GRID, 1.0);
            if self.numbered {
                let style = Style::of(12.0, INK).anchored(Anchor::End);
                drawing.text([left - 8.0, y + 4.0], style, &digits.to_string());
            }
        }
        self.time_axis(drawing);
        let mut taken = Vec::new();
        for (arithmetic, name, bits) in LEVELS {
            let y = self.y(bits);
            drawing.line([left, y], [right, y], colour(arithmetic), 0.9);
            let style = Style::of(NAME, QUIET).anchored(Anchor::End);
            drawing.text_over_lines([right - 4.0, y - 4.0], style, name);
            let start = right - 4.0 - width(name, NAME);
            taken.push(Area { left: start, top: y - 14.0, right, bottom: y });
        }
        drawing.line([left, bottom], [right, bottom], INK, 1.0);
        drawing.line([left, top], [left, bottom], INK, 1.0);
        taken
    }

    fn time_axis(&self, drawing: &mut Drawing) {
        let Area { left, top, right, bottom } = self.area;
        for (x, number) in self.times().ticks(APART) {
            drawing.line([x, top], [x, bottom], GRID, 1.0);
            let style = Style::of(12.0, INK).anchored(Anchor::Middle);
            drawing.text([x, bottom + 17.0], style, &number);
        }
        let style = Style::of(12.0, INK).anchored(Anchor::Middle);
        drawing.text([(left + right) / 2.0, bottom + 35.0], style, "time of one value [ns], logarithmic");
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
