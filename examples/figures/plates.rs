//! Two plates far apart, and the same plates nearly touching, with the gap through which light
//! escapes.

use forms_figures::vector::{Vector, add, parallelogram};
use forms_figures::{Colour, Drawing, Pen, View};

const SIDE: f64 = 1.3;
const X: Vector = [SIDE, 0.0, 0.0];
const Y: Vector = [0.0, SIDE, 0.0];

pub(crate) fn figure() -> String {
    let view = View::from_direction(38.0, 22.0, 80.0, [150.0, 235.0]);
    let [right, _] = view.plane();
    let mut drawing = Drawing::new(
        "Two plates, far apart and nearly touching",
        "Two square plates far apart, and the same two with a narrow gap, at the rim of which light escapes",
        [620, 310],
        view,
    );
    far(&mut drawing, [0.0; 3]);
    let aside = right.map(|component| 3.9 * component);
    near(&mut drawing, add(aside, [0.0, 0.0, 1.0]));
    drawing.finish()
}

fn far(drawing: &mut Drawing, corner: Vector) {
    let upper = add(corner, [0.0, 0.0, 2.3]);
    for (plate, colour) in [(corner, Colour::Blue), (upper, Colour::Ochre)] {
        drawing.area(&parallelogram(plate, X, Y), 0.25, Pen::solid(colour, 1.4));
    }
    let (from, to) = (add(upper, [0.65, 0.65, 0.0]), add(corner, [0.65, 0.65, 0.0]));
    drawing.line(&[from, to], Pen::dashed(Colour::Ink, 1.2));
    drawing.label(add(corner, [0.65, 0.65, 1.3]), [16.0, 0.0], "c", Colour::Ink);
    drawing.label(add(corner, [SIDE / 2.0, SIDE, 0.0]), [26.0, 14.0], "a", Colour::Ink);
    drawing.label(add(corner, [SIDE, SIDE / 2.0, 0.0]), [-26.0, 14.0], "b", Colour::Ink);
}

fn near(drawing: &mut Drawing, corner: Vector) {
    let upper = add(corner, [0.0, 0.0, 0.12]);
    drawing.area(&parallelogram(corner, X, Y), 0.25, Pen::solid(Colour::Blue, 1.4));
    for share in [0.15, 0.4, 0.65, 0.9] {
        let along = SIDE * share;
        for (foot, way) in [([SIDE, along, 0.06], [0.55, 0.0, 0.0]), ([along, SIDE, 0.06], [0.0, 0.55, 0.0])]
        {
            drawing.arrow(add(corner, foot), way, Pen::solid(Colour::Vermilion, 1.4));
        }
    }
    drawing.area(&parallelogram(upper, X, Y), 0.4, Pen::solid(Colour::Ochre, 1.4));
}
