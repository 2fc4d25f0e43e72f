//! A hill in profile with its normals, and with the normals of an equation whose first two rows
//! vanish.

use crate::flat::at;
use forms_figures::{Colour, Drawing, Pen, View};

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
        "Normals of a hill, and the normals as printed",
        "A hill with normals at right angles to it, and with the normals as printed, which all point straight up",
        [620, 250],
        View::flat(85.0, [310.0, 225.0]),
    );
    drawing.curve(120, Pen::solid(Colour::Ink, 1.8), |share| {
        let x = 6.4 * share - 3.2;
        at(x, height(x))
    });
    for x in [-2.2, -1.4, -0.7, 0.0, 0.7, 1.4, 2.2] {
        let (foot, rise) = (at(x, height(x)), slope(x));
        drawing.arrow(foot, at(-0.55 * rise, 0.55), Pen::solid(Colour::Blue, 1.8));
        drawing.arrow(foot, at(0.0, 0.55), Pen::dashed(Colour::Vermilion, 1.4));
    }
    drawing.words(at(1.95, 1.65), [30.0, 0.0], "normals", Colour::Blue);
    drawing.words(at(-1.95, 1.65), [-30.0, 0.0], "as printed", Colour::Vermilion);
    drawing.finish()
}
