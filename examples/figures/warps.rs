//! Uniform points of the unit square, and their images on the disk by two warps: with the root and
//! without it.

use crate::flat::{at, rectangle};
use forms_figures::vector::{Vector, add};
use forms_figures::{Colour, Drawing, Pen, View};
use std::f64::consts::PI;

const RINGS: u32 = 8;
const SPOKES: u32 = 16;

pub(crate) fn figure() -> String {
    let mut drawing = Drawing::new(
        "Two warps of the unit square to a disk",
        "Even points of a square; on a disk, spread evenly by the root of u, and crowded at the centre without it",
        [620, 250],
        View::flat(95.0, [105.0, 115.0]),
    );
    drawing.area(&rectangle([-0.85, -0.85], [0.85, 0.85]), 0.05, Pen::solid(Colour::Faint, 1.2));
    panel(&mut drawing, at(0.0, 0.0), "(u, v)", |u, v| at(1.7 * u - 0.85, 1.7 * v - 0.85));
    for (middle, name, power) in [(2.15, "r = √u", 0.5), (4.35, "r = u", 1.0)] {
        drawing.curve(90, Pen::solid(Colour::Faint, 1.2), |share| {
            let angle = 2.0 * PI * share;
            at(middle + 0.95 * angle.cos(), 0.95 * angle.sin())
        });
        panel(&mut drawing, at(middle, 0.0), name, |u, v| {
            let (radius, angle) = (0.95 * u.powf(power), 2.0 * PI * v);
            at(radius * angle.cos(), radius * angle.sin())
        });
    }
    drawing.finish()
}

/// Draws the points around a centre, and the name below.
fn panel(drawing: &mut Drawing, middle: Vector, name: &str, warp: impl Fn(f64, f64) -> Vector) {
    for ring in 0..RINGS {
        for spoke in 0..SPOKES {
            let u = (f64::from(ring) + 0.5) / f64::from(RINGS);
            let v = (f64::from(spoke) + 0.5 * f64::from(ring % 2)) / f64::from(SPOKES);
            drawing.dot(add(middle, warp(u, v + 0.25 / f64::from(SPOKES))), Colour::Blue);
        }
    }
    drawing.label(middle, [0.0, 112.0], name, Colour::Ink);
}
