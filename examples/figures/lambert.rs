//! A Lambertian surface: its radiance is the same in all directions, its intensity is a cosine.

use forms_figures::vector::{Vector, add, scaled};
use forms_figures::{Colour, Drawing, Pen, View};
use std::f64::consts::PI;

const REACH: f64 = 2.0;
const ARROWS: i32 = 12;
const PANELS: [(Vector, &str, Colour); 2] =
    [([-2.6, 0.0, 0.0], "radiance", Colour::Blue), ([2.6, 0.0, 0.0], "intensity", Colour::Vermilion)];

pub(crate) fn figure() -> String {
    let view = View::flat(58.0, [310.0, 190.0]);
    let mut drawing = Drawing::new(
        "Radiance and intensity of a Lambertian surface",
        "Arrows in all directions from a surface: of equal length for radiance, with tips on a circle for intensity",
        [620, 250],
        view,
    );
    for (panel, (foot, name, colour)) in PANELS.into_iter().enumerate() {
        let length = |angle: f64| if panel == 0 { REACH } else { REACH * angle.cos() };
        let tip = |angle: f64| add(foot, scaled(length(angle), [angle.sin(), angle.cos(), 0.0]));
        let edge: Vec<Vector> = (0..=60).map(|step| tip((f64::from(step) / 60.0 - 0.5) * PI)).collect();
        drawing.area(&edge, 0.1, Pen::dashed(Colour::Faint, 1.0));
        for step in 1..ARROWS {
            let end = tip((f64::from(step) / f64::from(ARROWS) - 0.5) * PI);
            drawing.arrow(foot, add(end, scaled(-1.0, foot)), Pen::solid(colour, 1.6));
        }
        let ends = [-1.0, 1.0].map(|side| add(foot, [1.15 * side * REACH, 0.0, 0.0]));
        drawing.line(&ends, Pen::solid(Colour::Ink, 3.0));
        drawing.words(foot, [0.0, 26.0], name, colour);
    }
    drawing.finish()
}
