//! A patch seen from the origin, its shadow on the unit sphere, and the angle between line of sight
//! and normal.

use forms_figures::vector::{Vector, add, cross, parallelogram, scaled, unit};
use forms_figures::{Colour, Drawing, Pen, View};
use std::f64::consts::TAU;

pub(crate) const EYE: Vector = [0.0; 3];
pub(crate) const CORNER: Vector = [0.215, 1.715, 0.5];
pub(crate) const A: Vector = [-0.75, 0.47, 0.0];
pub(crate) const B: Vector = [0.12, 0.1, 0.9];
/// Number of points on each side of an outline.
const SIDE: i32 = 12;

pub(crate) fn figure() -> String {
    let view = View::from_direction(15.0, 18.0, 128.0, [180.0, 232.0]);
    let mut drawing = Drawing::new(
        "The solid angle of a patch",
        "A patch seen from the centre of the unit sphere, and the region of the sphere it covers",
        [620, 370],
        view,
    );
    sphere(&mut drawing, view);
    let corners = parallelogram(CORNER, A, B);
    let outline = outline(corners);
    let shadow: Vec<Vector> = outline.iter().map(|&point| unit(point)).collect();
    for corner in corners {
        drawing.line(&[EYE, corner], Pen::dashed(Colour::Blue, 1.0));
    }
    drawing.area(&shadow, 0.35, Pen::solid(Colour::Vermilion, 1.4));
    drawing.area(&corners, 0.25, Pen::solid(Colour::Ochre, 1.4));
    sight(&mut drawing, corners);
    drawing.dot(EYE, Colour::Ink);
    drawing.label(EYE, [-14.0, 10.0], "o", Colour::Ink);
    drawing.label(unit(scaled(0.5, add(corners[0], corners[2]))), [-48.0, -32.0], "dω", Colour::Vermilion);
    drawing.finish()
}

/// Draws the outline of the unit sphere, its equator and one meridian.
pub(crate) fn sphere(drawing: &mut Drawing, view: View) {
    let [right, up] = view.plane();
    let circle = |a: Vector, b: Vector| -> Vec<Vector> {
        (0..=72)
            .map(|step| {
                let (sin, cos) = (f64::from(step) * TAU / 72.0).sin_cos();
                add(scaled(cos, a), scaled(sin, b))
            })
            .collect()
    };
    drawing.area(&circle(right, up), 0.04, Pen::solid(Colour::Faint, 1.2));
    drawing.line(&circle([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]), Pen::dashed(Colour::Faint, 0.7));
    drawing.line(&circle([0.0, 1.0, 0.0], [0.0, 0.0, 1.0]), Pen::dashed(Colour::Faint, 0.7));
}

/// Returns points along the sides of a polygon.
pub(crate) fn outline(corners: [Vector; 4]) -> Vec<Vector> {
    (0..4)
        .flat_map(|side| {
            (0..SIDE).map(move |step| {
                let share = f64::from(step) / f64::from(SIDE);
                add(scaled(1.0 - share, corners[side]), scaled(share, corners[(side + 1) % 4]))
            })
        })
        .collect()
}

/// Draws the line of sight to the middle of the patch, its normal and the angle between them.
fn sight(drawing: &mut Drawing, corners: [Vector; 4]) {
    let middle = scaled(0.5, add(corners[0], corners[2]));
    let normal = unit(cross(A, B));
    let direction = unit(middle);
    let normal =
        if forms_figures::vector::dot(normal, direction) < 0.0 { scaled(-1.0, normal) } else { normal };
    drawing.line(&[EYE, middle], Pen::solid(Colour::Blue, 1.6));
    drawing.label(scaled(0.6, middle), [10.0, 14.0], "r", Colour::Blue);
    drawing.arrow(middle, scaled(0.95, direction), Pen::solid(Colour::Blue, 2.0));
    drawing.label(add(middle, scaled(0.95, direction)), [12.0, -6.0], "p", Colour::Blue);
    drawing.arrow(middle, scaled(0.95, normal), Pen::solid(Colour::Ink, 2.0));
    drawing.label(add(middle, scaled(0.95, normal)), [12.0, 6.0], "n", Colour::Ink);
    drawing.angle(middle, direction, normal, 0.5, Pen::solid(Colour::Ink, 1.2));
    drawing.label(add(middle, scaled(0.64, unit(add(direction, normal)))), [4.0, 0.0], "θ", Colour::Ink);
    drawing.label(corners[3], [-16.0, -8.0], "dA", Colour::Ochre);
}
