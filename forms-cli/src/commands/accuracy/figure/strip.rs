//! The strip below the panels: each variant with its time, and the bits lost in each regime.

use super::marker;
use crate::commands::accuracy::report::{Report, Row};
use crate::drawing::{Anchor, Drawing, INK, QUIET, Style};
use forms::core::accuracy::{Regime, Score};

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

/// Position of the strip.
pub(super) struct Strip {
    pub(super) left: f64,
    pub(super) right: f64,
    pub(super) top: f64,
}

impl Strip {
    pub(super) fn draw(&self, drawing: &mut Drawing, report: &Report) {
        let regimes: Vec<Regime> = Regime::ALL
            .into_iter()
            .filter(|regime| report.rows.iter().any(|row| score(row, *regime).is_some()))
            .collect();
        let left = self.left + REGIMES;
        let cell = (self.right - left) / regimes.len().max(1) as f64;
        self.head(drawing, &regimes, cell);
        for (place, row) in report.rows.iter().enumerate() {
            let y = self.top + HEAD + ROW * place as f64;
            self.variant(drawing, row, y);
            let hardest = row.hardest().map(|score| score.regime);
            for (column, &regime) in regimes.iter().enumerate() {
                let Some(score) = score(row, regime) else { continue };
                let corner = [left + cell * column as f64, y];
                loss(drawing, corner, cell, row, score, hardest == Some(regime));
            }
        }
    }

    fn head(&self, drawing: &mut Drawing, regimes: &[Regime], cell: f64) {
        let (base, first) = (self.top + HEAD - 7.0, self.left + REGIMES);
        let quiet = Style::of(11.5, QUIET);
        drawing.text([self.left + NAME, base], quiet, "variant");
        drawing.text([self.left + TIME, base], quiet.anchored(Anchor::End), "ns");
        drawing.text([self.left + FRONT, base], quiet.anchored(Anchor::Middle), "front");
        let title = "bits lost, mean, by regime of arguments; outlined: the hardest";
        drawing.text([first + 2.0, base - 19.0], Style::of(13.0, INK).bold(), title);
        for (column, regime) in regimes.iter().enumerate() {
            let x = first + cell * (column as f64 + 0.5);
            drawing.text([x, base], Style::of(11.5, INK).anchored(Anchor::Middle), regime.name());
        }
    }

    fn variant(&self, drawing: &mut Drawing, row: &Row, y: f64) {
        let (middle, base) = (y + ROW / 2.0, y + ROW / 2.0 + 4.0);
        marker(drawing, [self.left + 8.0, middle], row.variant());
        drawing.text([self.left + NAME, base], Style::of(12.5, INK), &row.variant().name());
        let time = row.time();
        drawing.text([self.left + TIME, base], Style::of(12.5, INK).anchored(Anchor::End), &time);
        if row.pareto {
            drawing.circle([self.left + FRONT, middle], 3.5, INK, INK);
        }
    }
}

fn score(row: &Row, regime: Regime) -> Option<&Score> {
    row.line.scores.iter().find(|score| score.regime == regime)
}

/// Draws a cell with the bits lost; its colour is darker for a larger lost fraction of the digits.
fn loss(drawing: &mut Drawing, [x, y]: [f64; 2], width: f64, row: &Row, score: &Score, hardest: bool) {
    let lost = score.bits.mean;
    let share = ((lost - 0.5).max(0.0) / row.correct_bits(0.0)).min(1.0).sqrt();
    let mix = |from: f64, to: f64| (from + (to - from) * share).round() as u8;
    let fill = format!("#{:02x}{:02x}{:02x}", mix(234.0, 150.0), mix(243.0, 38.0), mix(236.0, 30.0));
    let ink = if share > 0.55 { "#ffffff" } else { INK };
    drawing.cell([x + 1.5, y + 1.5], [width - 3.0, ROW - 3.0], &fill, hardest.then_some(INK));
    let style = Style::of(12.0, ink).anchored(Anchor::Middle);
    drawing.text([x + width / 2.0, y + ROW / 2.0 + 4.0], style, &format!("{lost:.1}"));
}
