//! Light from many directions at one point, and its vector sum: one arrow, with a meter
//! perpendicular to it.

use forms_figures::vector::{Vector, add, scaled};
use forms_figures::{Colour, Drawing, Pen, View};

/// Angle from the vertical in degrees, and the amount of light from this direction.
const LIGHT: [(f64, f64); 9] = [
    (-70.0, 0.5),
    (-58.0, 0.8),
    (-40.0, 1.25),
    (-20.0, 0.95),
    (0.0, 1.1),
    (20.0, 1.6),
    (40.0, 1.9),
    (60.0, 1.5),
    (80.0, 0.7),
];
/// Factor by which the sum is shortened to fit.
const SHORTER: f64 = 0.22;
const METER: f64 = 0.85;
/// Gap between the arrow tips and the point, so that the tips do not cover each other.
const GAP: f64 = 0.32;

pub(crate) fn figure() -> String {
    let view = View::flat(88.0, [310.0, 225.0]);
    let mut drawing = Drawing::new(
        "Vector irradiance",
        "Light that arrives at a point from many directions, its sum, and a meter across it",
        [620, 400],
        view,
    );
    let mut sum: Vector = [0.0; 3];
    for (angle, amount) in LIGHT {
        let (sin, cos) = f64::to_radians(angle).sin_cos();
        let flow = scaled(-amount, [sin, cos, 0.0]);
        let foot = scaled(amount + GAP, [sin, cos, 0.0]);
        drawing.arrow(foot, flow, Pen::solid(Colour::Blue, 1.6));
        sum = add(sum, flow);
    }
    let arrow = scaled(SHORTER, sum);
    let length = arrow[0].hypot(arrow[1]);
    let along = [-arrow[1] / length, arrow[0] / length, 0.0];
    drawing.line(&[scaled(-METER, along), scaled(METER, along)], Pen::solid(Colour::Ink, 4.0));
    drawing.arrow([0.0; 3], arrow, Pen::solid(Colour::Vermilion, 3.0));
    drawing.label(arrow, [-14.0, 8.0], "J", Colour::Vermilion);
    drawing.words(scaled(-METER, along), [-34.0, 8.0], "meter", Colour::Ink);
    drawing.label([1.43, 1.7, 0.0], [30.0, -8.0], "L p dω", Colour::Blue);
    drawing.finish()
}
