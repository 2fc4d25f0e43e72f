//! The Neumann series in a furnace: the contribution of each bounce, and the sums, which rise to a
//! limit.

use crate::drawing::{Drawing, Pen, View, style};
use crate::flat::{at, rectangle};

/// Fraction of the light that is left after a bounce.
const KEPT: f64 = 0.75;
const BOUNCES: i32 = 13;
/// Half the width of a bar.
const HALF: f64 = 0.36;

pub(crate) fn figure() -> String {
    let mut drawing = Drawing::new(
        "Bars: light after each bounce, each three quarters of the one before; above them the sums, which rise to a limit",
        [620, 330],
        View::flat(40.0, [60.0, 280.0]),
    );
    let tall = 1.35;
    let limit = tall / (1.0 - KEPT);
    let end = f64::from(BOUNCES);
    let mut sum = 0.0;
    for bounce in 0..BOUNCES {
        let (x, adds) = (f64::from(bounce), tall * KEPT.powi(bounce));
        let (left, right) = (x - HALF, x + HALF);
        drawing.area(&rectangle([left, sum], [right, sum + adds]), 0.3, Pen::solid(style::FIRST, 1.2));
        drawing.area(&rectangle([left, 0.0], [right, sum]), 0.06, Pen::solid(style::FAINT, 0.7));
        sum += adds;
    }
    drawing.line(&[at(-0.7, 0.0), at(end, 0.0)], Pen::solid(style::INK, 1.2));
    drawing.line(&[at(-0.7, limit), at(end, limit)], Pen::dashed(style::SECOND, 1.4));
    for (bounce, name) in [(0, "L_e"), (1, "TL_e"), (2, "T²L_e"), (3, "T³L_e")] {
        let below = tall * (1.0 - KEPT.powi(bounce)) / (1.0 - KEPT);
        let middle = below + tall * KEPT.powi(bounce) / 2.0;
        let shift = if bounce == 0 { 0.0 } else { -33.0 };
        drawing.label(at(f64::from(bounce), middle), [shift, 0.0], name, style::FIRST);
    }
    drawing.label(at(-0.2, limit), [0.0, -14.0], "limit", style::SECOND);
    drawing.label(at(end / 2.0 - 0.5, 0.0), [0.0, 22.0], "bounces", style::INK);
    drawing.finish()
}
