//! A parallelogram in space and its three shadows, measured by dy∧dz, dz∧dx and dx∧dy.

use forms_figures::vector::{Vector, add, parallelogram, scaled};
use forms_figures::{Colour, Drawing, Pen, View};

const AXIS: f64 = 2.25;
const CORNER: Vector = [1.05, 0.95, 1.75];
const U: Vector = [0.9, -0.1, -0.5];
const V: Vector = [-0.25, 1.05, -0.5];

pub(crate) fn figure() -> String {
    let view = View::from_direction(38.0, 27.0, 118.0, [300.0, 285.0]);
    let mut drawing = Drawing::new(
        "A parallelogram and its three shadows",
        "A parallelogram in space and its shadows on the three coordinate planes",
        [620, 470],
        view,
    );
    room(&mut drawing);
    for (dropped, colour) in [(0, Colour::Vermilion), (1, Colour::Blue), (2, Colour::Green)] {
        shadow(&mut drawing, dropped, colour);
    }
    let corners = parallelogram(CORNER, U, V);
    drawing.area(&corners, 0.25, Pen::solid(Colour::Ink, 1.4));
    drawing.arrow(CORNER, U, Pen::solid(Colour::Ink, 2.0));
    drawing.arrow(CORNER, V, Pen::solid(Colour::Ink, 2.0));
    drawing.label(add(CORNER, scaled(0.55, U)), [-10.0, -12.0], "U", Colour::Ink);
    drawing.label(add(CORNER, scaled(0.55, V)), [8.0, -12.0], "V", Colour::Ink);
    drawing.finish()
}

/// Draws the three planes and the axes.
fn room(drawing: &mut Drawing) {
    let origin = [0.0; 3];
    let axes: [Vector; 3] = [[AXIS, 0.0, 0.0], [0.0, AXIS, 0.0], [0.0, 0.0, AXIS]];
    for (a, b) in [(0, 1), (1, 2), (2, 0)] {
        drawing.area(&parallelogram(origin, axes[a], axes[b]), 0.05, Pen::solid(Colour::Faint, 0.6));
    }
    let names = [("x", [-12.0, 4.0]), ("y", [12.0, 4.0]), ("z", [0.0, -14.0])];
    for (axis, (name, shift)) in axes.into_iter().zip(names) {
        let long = scaled(1.1, axis);
        drawing.arrow(origin, long, Pen::solid(Colour::Ink, 1.0));
        drawing.label(long, shift, name, Colour::Ink);
    }
}

/// Draws the parallelogram with one coordinate set to 0, and the rays that project it there.
fn shadow(drawing: &mut Drawing, dropped: usize, colour: Colour) {
    let flat = |mut point: Vector| {
        point[dropped] = 0.0;
        point
    };
    let corners = parallelogram(CORNER, U, V);
    for corner in corners {
        drawing.line(&[corner, flat(corner)], Pen::dashed(Colour::Faint, 0.8));
    }
    let fallen = corners.map(flat);
    drawing.area(&fallen, 0.3, Pen::solid(colour, 1.4));
    let middle = scaled(0.5, add(fallen[0], fallen[2]));
    match dropped {
        0 => drawing.label(middle, [30.0, -40.0], "dy∧dz", colour),
        1 => drawing.label(middle, [-24.0, -52.0], "dz∧dx", colour),
        _ => drawing.label_inside(middle, "dx∧dy", colour),
    }
}
