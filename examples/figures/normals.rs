//! A hill in profile with its normals, and with the normals of an equation whose first two rows
//! vanish.

use crate::drawing::{Drawing, Pen, View, style};
use crate::flat::{at, curve};

/// Returns the height of the hill.
fn height(x: f64) -> f64 {
    1.5 * (-0.5 * x * x).exp()
}

/// Returns the slope of the hill.
fn slope(x: f64) -> f64 {
    -x * height(x)
}

pub(crate) fn figure() -> String {
    let mut drawing = Drawing::new(
        "A hill with normals at right angles to it, and with the normals as printed, which all point straight up",
        [620, 250],
        View::flat(85.0, [310.0, 225.0]),
    );
    curve(&mut drawing, 120, Pen::solid(style::INK, 1.8), |share| {
        let x = 6.4 * share - 3.2;
        at(x, height(x))
    });
    for x in [-2.2, -1.4, -0.7, 0.0, 0.7, 1.4, 2.2] {
        let (foot, rise) = (at(x, height(x)), slope(x));
        drawing.arrow(foot, at(-0.55 * rise, 0.55), Pen::solid(style::SECOND, 1.8));
        drawing.arrow(foot, at(0.0, 0.55), Pen::dashed(style::FIRST, 1.4));
    }
    drawing.label(at(1.95, 1.65), [30.0, 0.0], "normals", style::SECOND);
    drawing.label(at(-1.95, 1.65), [-30.0, 0.0], "as printed", style::FIRST);
    drawing.finish()
}
