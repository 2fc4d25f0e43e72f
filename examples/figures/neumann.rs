//! The Neumann series in a furnace: the contribution of each bounce, and the sums, which rise to a
//! limit.

use crate::flat::{at, rectangle};
use forms_figures::{Colour, Drawing, Pen, View};

/// Fraction of the light that is left after a bounce.
const KEPT: f64 = 0.75;
const BOUNCES: i32 = 13;
/// Half the width of a bar.
const HALF: f64 = 0.36;

pub(crate) fn figure() -> String {
    let mut drawing = Drawing::new(
        "The Neumann series in a furnace",
        "Bars: light after each bounce, each three quarters of the one before; above them the sums, which rise to a limit",
        [620, 350],
        View::flat(40.0, [60.0, 280.0]),
    );
    let tall = 1.35;
    let limit = tall / (1.0 - KEPT);
    let end = f64::from(BOUNCES);
    let mut sum = 0.0;
    for bounce in 0..BOUNCES {
        let (x, adds) = (f64::from(bounce), tall * KEPT.powi(bounce));
        let (left, right) = (x - HALF, x + HALF);
        drawing.area(&rectangle([left, sum], [right, sum + adds]), 0.3, Pen::solid(Colour::Vermilion, 1.2));
        drawing.area(&rectangle([left, 0.0], [right, sum]), 0.06, Pen::solid(Colour::Faint, 0.7));
        sum += adds;
    }
    drawing.line(&[at(-0.7, 0.0), at(end, 0.0)], Pen::solid(Colour::Ink, 1.2));
    drawing.line(&[at(-0.7, limit), at(end, limit)], Pen::dashed(Colour::Blue, 1.4));
    for (bounce, name) in [(0, "Lₑ"), (1, "TLₑ"), (2, "T²Lₑ"), (3, "T³Lₑ")] {
        let below = tall * (1.0 - KEPT.powi(bounce)) / (1.0 - KEPT);
        let middle = below + tall * KEPT.powi(bounce) / 2.0;
        let place = at(f64::from(bounce), middle);
        if bounce == 0 {
            drawing.label_inside(place, name, Colour::Vermilion);
        } else {
            drawing.label(place, [-33.0, 0.0], name, Colour::Vermilion);
        }
    }
    for bounce in 0..BOUNCES {
        drawing.words(at(f64::from(bounce), 0.0), [0.0, 14.0], &bounce.to_string(), Colour::Quiet);
    }
    drawing.words(at(0.6, limit), [0.0, -14.0], "limit of the sum", Colour::Blue);
    drawing.words(at(end / 2.0 - 0.5, 0.0), [0.0, 40.0], "number of bounces", Colour::Ink);
    drawing.finish()
}
