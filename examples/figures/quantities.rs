//! From energy to radiance: every arrow divides by time, by area or by solid angle.

use forms_figures::vector::{Vector, add, scaled};
use forms_figures::{Colour, Drawing, Pen, View};

const HALF_WIDTH: f64 = 0.78;
const HALF_HEIGHT: f64 = 0.3;

/// Divisor of an arrow: its name and colour.
type Divisor = (&'static str, Colour);

const TIME: Divisor = ("time", Colour::Green);
const AREA: Divisor = ("area", Colour::Vermilion);
const ANGLE: Divisor = ("solid angle", Colour::Blue);

/// Symbols with units, and their places.
const QUANTITIES: [(&str, Vector); 6] = [
    ("Q\u{a0}\u{a0}J", [0.0, 4.2, 0.0]),
    ("H\u{a0}\u{a0}J/m²", [-2.6, 2.8, 0.0]),
    ("Φ\u{a0}\u{a0}W", [0.0, 2.8, 0.0]),
    ("E\u{a0}\u{a0}W/m²", [-2.6, 1.4, 0.0]),
    ("I\u{a0}\u{a0}W/sr", [2.6, 1.4, 0.0]),
    ("L\u{a0}\u{a0}W/(m² sr)", [0.0, 0.0, 0.0]),
];

/// Arrows: start, end, divisor, and offset of the label from the middle.
const STEPS: [(usize, usize, Divisor, [f64; 2]); 7] = [
    (0, 1, AREA, [-30.0, -10.0]),
    (0, 2, TIME, [28.0, 0.0]),
    (1, 3, TIME, [-28.0, 0.0]),
    (2, 3, AREA, [-16.0, -12.0]),
    (2, 4, ANGLE, [46.0, -12.0]),
    (3, 5, ANGLE, [-46.0, 12.0]),
    (4, 5, AREA, [30.0, 12.0]),
];

pub(crate) fn figure() -> String {
    let view = View::flat(76.0, [310.0, 360.0]);
    let mut drawing = Drawing::new(
        "From energy to radiance",
        "Energy divided by time, area and solid angle, step by step",
        [620, 400],
        view,
    );
    for (from, to, (name, colour), shift) in STEPS {
        let (from, to) = (QUANTITIES[from].1, QUANTITIES[to].1);
        let way = add(to, scaled(-1.0, from));
        let (start, end) = (add(from, leaving(way)), add(to, leaving(scaled(-1.0, way))));
        drawing.arrow(start, add(end, scaled(-1.0, start)), Pen::solid(colour, 2.0));
        drawing.words(scaled(0.5, add(start, end)), shift, name, colour);
    }
    for (text, place) in QUANTITIES {
        let [x, y, _] = place;
        let (left, right, low, high) = (x - HALF_WIDTH, x + HALF_WIDTH, y - HALF_HEIGHT, y + HALF_HEIGHT);
        let frame = [[left, low, 0.0], [right, low, 0.0], [right, high, 0.0], [left, high, 0.0]];
        drawing.area(&frame, 0.1, Pen::solid(Colour::Ink, 1.2));
        drawing.label_inside(place, text, Colour::Ink);
    }
    drawing.finish()
}

/// Returns the vector from the middle of a frame to its edge in a given direction.
fn leaving(way: Vector) -> Vector {
    let share = (HALF_WIDTH / way[0].abs().max(1e-9)).min(HALF_HEIGHT / way[1].abs().max(1e-9));
    scaled(share, way)
}
