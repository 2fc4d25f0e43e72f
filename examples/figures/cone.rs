//! The piece of cone between the unit sphere and a patch. Its boundary consists of the patch, its
//! shadow on the sphere, and walls of rays.

use crate::solid_angle::{A, B, CORNER, EYE, outline, sphere};
use forms_figures::vector::{Vector, add, cross, dot, parallelogram, scaled, unit};
use forms_figures::{Colour, Drawing, Pen, View};

pub(crate) fn figure() -> String {
    let view = View::from_direction(15.0, 18.0, 128.0, [180.0, 232.0]);
    let mut drawing = Drawing::new(
        "The cone between a patch and the unit sphere",
        "The piece of cone between the unit sphere and a patch, with its outward directions",
        [620, 370],
        view,
    );
    sphere(&mut drawing, view);
    let corners = parallelogram(CORNER, A, B);
    let shadow = corners.map(unit);
    for corner in shadow {
        drawing.line(&[EYE, corner], Pen::dashed(Colour::Faint, 1.0));
    }
    for side in 0..4 {
        let next = (side + 1) % 4;
        let wall = [shadow[side], corners[side], corners[next], shadow[next]];
        drawing.area(&wall, 0.14, Pen::solid(Colour::Blue, 1.0));
    }
    let round: Vec<Vector> = outline(corners).iter().map(|&point| unit(point)).collect();
    drawing.area(&round, 0.4, Pen::solid(Colour::Vermilion, 1.6));
    drawing.area(&corners, 0.3, Pen::solid(Colour::Ochre, 1.6));
    outward(&mut drawing, corners, shadow);
    drawing.dot(EYE, Colour::Ink);
    drawing.label(EYE, [-14.0, 10.0], "o", Colour::Ink);
    drawing.finish()
}

/// Draws arrows that point out of the piece of cone, one for each part of its boundary.
fn outward(drawing: &mut Drawing, corners: [Vector; 4], shadow: [Vector; 4]) {
    let middle = |quad: [Vector; 4]| scaled(0.5, add(quad[0], quad[2]));
    let (patch, seen) = (middle(corners), unit(middle(shadow)));
    let normal = unit(cross(A, B));
    let normal = if dot(normal, patch) < 0.0 { scaled(-1.0, normal) } else { normal };
    drawing.arrow(patch, scaled(0.6, normal), Pen::solid(Colour::Ochre, 2.0));
    drawing.words(add(patch, scaled(0.6, normal)), [30.0, -10.0], "patch", Colour::Ochre);
    drawing.arrow(seen, scaled(-0.45, seen), Pen::solid(Colour::Vermilion, 2.0));
    drawing.words(seen, [-62.0, -44.0], "shadow", Colour::Vermilion);
    let upper = middle([shadow[2], corners[2], corners[3], shadow[3]]);
    drawing.arrow(upper, [0.0, -0.25, 0.55], Pen::solid(Colour::Blue, 2.0));
    drawing.words(add(upper, [0.0, -0.25, 0.55]), [0.0, -14.0], "wall", Colour::Blue);
}
