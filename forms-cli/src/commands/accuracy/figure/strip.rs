//! The strip below the panels: each variant with its time, and the bits lost in each regime.

use super::marker;
use crate::commands::accuracy::report::{Report, Row};
use forms::core::accuracy::{Regime, Score};
use forms_figures::{Anchor, Canvas, Colour, Pen, Style};

/// Height of a line.
pub(super) const ROW: f64 = 23.0;

/// Height of the header above the first line.
pub(super) const HEAD: f64 = 44.0;

/// Positions of a variant's name, of its time, of its mark on the Pareto front, and of the first
/// regime.
const NAME: f64 = 24.0;
const TIME: f64 = 196.0;
const FRONT: f64 = 228.0;
const REGIMES: f64 = 256.0;

/// Opacity of the tint of a cell in which all digits are lost.
const STRONGEST: f64 = 0.6;

/// Position of the strip.
pub(super) struct Strip {
    pub(super) left: f64,
    pub(super) right: f64,
    pub(super) top: f64,
}

impl Strip {
    pub(super) fn draw(&self, canvas: &mut Canvas, report: &Report) {
        let regimes: Vec<Regime> = Regime::ALL
            .into_iter()
            .filter(|regime| report.rows.iter().any(|row| score(row, *regime).is_some()))
            .collect();
        let left = self.left + REGIMES;
        let cell = (self.right - left) / regimes.len().max(1) as f64;
        self.head(canvas, &regimes, cell);
        for (place, row) in report.rows.iter().enumerate() {
            let y = self.top + HEAD + ROW * place as f64;
            self.variant(canvas, row, y);
            let hardest = row.hardest().map(|score| score.regime);
            for (column, &regime) in regimes.iter().enumerate() {
                let Some(score) = score(row, regime) else { continue };
                let corner = [left + cell * column as f64, y];
                loss(canvas, corner, cell, row, score, hardest == Some(regime));
            }
        }
    }

    fn head(&self, canvas: &mut Canvas, regimes: &[Regime], cell: f64) {
        let (base, first) = (self.top + HEAD - 7.0, self.left + REGIMES);
        let quiet = Style::of(11.5, Colour::Quiet);
        canvas.text([self.left + NAME, base], quiet, "variant");
        canvas.text([self.left + TIME, base], quiet.anchored(Anchor::End), "ns");
        canvas.text([self.left + FRONT, base], quiet.anchored(Anchor::Middle), "front");
        let title = "bits lost, mean, by regime of arguments; outlined: the hardest";
        canvas.text([first + 2.0, base - 19.0], Style::of(13.0, Colour::Ink).bold(), title);
        for (column, regime) in regimes.iter().enumerate() {
            let x = first + cell * (column as f64 + 0.5);
            canvas.text([x, base], Style::of(11.5, Colour::Ink).anchored(Anchor::Middle), regime.name());
        }
    }

    fn variant(&self, canvas: &mut Canvas, row: &Row, y: f64) {
        let (middle, base) = (y + ROW / 2.0, y + ROW / 2.0 + 4.0);
        marker(canvas, [self.left + 8.0, middle], row.variant());
        canvas.text([self.left + NAME, base], Style::of(12.5, Colour::Ink), &row.variant().name());
        let time = row.time();
        canvas.text([self.left + TIME, base], Style::of(12.5, Colour::Ink).anchored(Anchor::End), &time);
        if row.pareto {
            canvas.circle([self.left + FRONT, middle], 4.0, Some(Colour::Ink), None);
        }
    }
}

fn score(row: &Row, regime: Regime) -> Option<&Score> {
    row.line.scores.iter().find(|score| score.regime == regime)
}

/// Draws a cell with the bits lost; its tint is stronger for a larger lost fraction of the digits.
fn loss(canvas: &mut Canvas, [x, y]: [f64; 2], width: f64, row: &Row, score: &Score, hardest: bool) {
    let lost = score.bits.mean;
    let share = ((lost - 0.5).max(0.0) / row.correct_bits(0.0)).min(1.0).sqrt();
    let (corner, size) = ([x + 1.5, y + 1.5], [width - 3.0, ROW - 3.0]);
    canvas.tint(corner, size, Colour::FineGrid, 1.0);
    if share > 0.0 {
        canvas.tint(corner, size, Colour::Vermilion, STRONGEST * share);
    }
    if hardest {
        canvas.rectangle(corner, size, None, Some(Pen::solid(Colour::Ink, 1.6)));
    }
    let style = Style::of(12.0, Colour::Ink).anchored(Anchor::Middle);
    canvas.text([x + width / 2.0, y + ROW / 2.0 + 4.0], style, &format!("{lost:.1}"));
}
