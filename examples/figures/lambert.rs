//! A Lambertian surface: its radiance is the same in all directions, its intensity is a cosine.

use crate::drawing::{Drawing, Pen, View, style};
use crate::vector::{Vector, add, scaled};
use std::f64::consts::PI;

const REACH: f64 = 2.0;
const ARROWS: i32 = 12;
const PANELS: [(Vector, &str, &str); 2] =
    [([-2.6, 0.0, 0.0], "radiance", style::SECOND), ([2.6, 0.0, 0.0], "intensity", style::FIRST)];

pub(crate) fn figure() -> String {
    let view = View::flat(58.0, [310.0, 190.0]);
    let mut drawing = Drawing::new(
        "Arrows in all directions from a surface: of equal length for radiance, with tips on a circle for intensity",
        [620, 250],
        view,
    );
    for (panel, (foot, name, colour)) in PANELS.into_iter().enumerate() {
        let length = |angle: f64| if panel == 0 { REACH } else { REACH * angle.cos() };
        let tip = |angle: f64| add(foot, scaled(length(angle), [angle.sin(), angle.cos(), 0.0]));
        let edge: Vec<Vector> = (0..=60).map(|step| tip((f64::from(step) / 60.0 - 0.5) * PI)).collect();
        drawing.area(&edge, 0.1, Pen::dashed(style::FAINT, 1.0));
        for step in 1..ARROWS {
            let end = tip((f64::from(step) / f64::from(ARROWS) - 0.5) * PI);
            drawing.arrow(foot, add(end, scaled(-1.0, foot)), Pen::solid(colour, 1.6));
        }
        let ends = [-1.0, 1.0].map(|side| add(foot, [1.15 * side * REACH, 0.0, 0.0]));
        drawing.line(&ends, Pen::solid(style::INK, 3.0));
        drawing.label(foot, [0.0, 26.0], name, colour);
    }
    drawing.finish()
}
