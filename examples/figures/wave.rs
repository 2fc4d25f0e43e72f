//! A plane wave: the perpendicular electric and magnetic fields, and the parallelogram that
//! represents the energy flux.

use forms_figures::vector::{Vector, add, parallelogram, scaled};
use forms_figures::{Colour, Drawing, Pen, View};
use std::f64::consts::TAU;

const PERIODS: f64 = 1.5;
/// Length of a period along the axis, and the amplitudes of the two fields.
const PERIOD: f64 = 2.9;
const ELECTRIC: f64 = 1.15;
const MAGNETIC: f64 = 1.15;
const ARROWS: i32 = 24;

/// Returns a point on the axis of the wave. The axis is drawn to the right; the wave's x axis
/// points up and its y axis to the reader.
fn place(z: f64) -> Vector {
    [0.0, z, 0.0]
}

fn field(z: f64) -> [Vector; 2] {
    let wave = (TAU * z / PERIOD).cos();
    [[0.0, 0.0, ELECTRIC * wave], [MAGNETIC * wave, 0.0, 0.0]]
}

pub(crate) fn figure() -> String {
    let view = View::from_direction(32.0, 24.0, 112.0, [110.0, 175.0]);
    let mut drawing = Drawing::new(
        "A plane wave and its energy flux",
        "A plane wave: two fields at right angles, in step, and the parallelogram that they span",
        [620, 412],
        view,
    );
    let end = PERIODS * PERIOD;
    drawing.arrow(place(-0.3), [0.0, end + 0.9, 0.0], Pen::solid(Colour::Ink, 1.2));
    drawing.label(place(end + 0.6), [14.0, 2.0], "z", Colour::Ink);
    for (which, (name, colour)) in [("E", Colour::Vermilion), ("H", Colour::Blue)].into_iter().enumerate() {
        let tips: Vec<Vector> = (0..=120)
            .map(|step| f64::from(step) / 120.0 * end)
            .map(|z| add(place(z), field(z)[which]))
            .collect();
        drawing.line(&tips, Pen::solid(colour, 2.0));
        for step in 0..=ARROWS {
            let z = f64::from(step) / f64::from(ARROWS) * end;
            drawing.line(&[place(z), add(place(z), field(z)[which])], Pen::solid(colour, 0.8));
        }
        let crest = add(place(PERIOD), field(PERIOD)[which]);
        drawing.label(crest, if which == 0 { [0.0, -14.0] } else { [-4.0, 18.0] }, name, colour);
    }
    let [electric, magnetic] = field(PERIOD);
    drawing.area(&parallelogram(place(PERIOD), electric, magnetic), 0.3, Pen::solid(Colour::Ochre, 1.4));
    let middle = add(place(PERIOD), scaled(0.5, add(electric, magnetic)));
    drawing.arrow(middle, [0.0, 0.9, 0.0], Pen::solid(Colour::Ochre, 2.4));
    drawing.label(add(middle, [0.0, 0.9, 0.0]), [34.0, 0.0], "E∧H", Colour::Ochre);
    drawing.finish()
}
