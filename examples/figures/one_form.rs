//! A 1-form as a family of lines: its value for a step is the number of lines that the step
//! crosses.

use forms_figures::vector::{Vector, add, scaled};
use forms_figures::{Colour, Drawing, Pen, View};

/// The form dx + dy/2. Lines are drawn where x + y/2 is an integer.
const FORM: [f64; 2] = [1.0, 0.5];
const HEIGHT: f64 = 5.2;
const LAST_LINE: i32 = 11;
const LAST_OBLIQUE: f64 = 9.0;
/// Start points of the steps, each halfway between two lines.
const FOOT: Vector = [2.7, 3.6, 0.0];
const FOOT_OF_DOUBLE: Vector = [2.9, 1.2, 0.0];
const FOOT_ALONG: Vector = [7.35, 2.3, 0.0];
/// Two steps: one crosses two lines, the other crosses none.
const STEP: Vector = [2.0, 0.0, 0.0];
const ALONG: Vector = [-1.0, 2.0, 0.0];

pub(crate) fn figure() -> String {
    let view = View::flat(60.0, [30.0, 325.0]);
    let mut drawing = Drawing::new(
        "A 1-form counts the lines that a step crosses",
        "A family of parallel lines, and three steps across it",
        [620, 350],
        view,
    );
    for line in 0..=LAST_LINE {
        let value = f64::from(line);
        let at = |y: f64| (value - FORM[1] * y) / FORM[0];
        let ends = [[at(0.0), 0.0, 0.0], [at(HEIGHT), HEIGHT, 0.0]];
        if at(HEIGHT) >= 0.0 && at(0.0) <= LAST_OBLIQUE + 0.6 {
            drawing.line(&ends, Pen::solid(Colour::Faint, 1.0));
        }
    }
    let steps = [
        (FOOT, STEP, "w(U) = 2", Colour::Vermilion, [0.0, -18.0]),
        (FOOT_OF_DOUBLE, scaled(2.0, STEP), "w(2U) = 4", Colour::Blue, [0.0, 18.0]),
        (FOOT_ALONG, ALONG, "w(V) = 0", Colour::Green, [48.0, -20.0]),
    ];
    for (foot, step, name, colour, shift) in steps {
        drawing.arrow(foot, step, Pen::solid(colour, 2.4));
        drawing.dot(foot, colour);
        drawing.label(add(foot, scaled(0.5, step)), shift, name, colour);
    }
    drawing.finish()
}
