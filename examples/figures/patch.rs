//! A surface with its tangent vectors, and the beam of light through the parallelogram that they span.

use forms_figures::vector::{Vector, add, cross, dot, parallelogram, scaled, unit};
use forms_figures::{Colour, Drawing, Pen, View};

/// Half the side of the parameter square.
const HALF: f64 = 1.25;
const LINES: i32 = 10;
/// Parameters of the point with the tangent vectors, and the parameter step that the vectors
/// represent.
const POINT: [f64; 2] = [-0.1, -0.05];
const STEP: f64 = 0.62;
/// Direction of the light.
const DIRECTION: Vector = [-0.02, 0.72, 0.72];

/// Returns the point (u, v, h(u, v)).
fn surface(u: f64, v: f64) -> Vector {
    [u, v, 0.35 - 0.22 * u * u - 0.12 * v * v + 0.06 * u * v]
}

/// Returns the derivatives of the surface by u and by v.
fn tangents(u: f64, v: f64) -> [Vector; 2] {
    [[1.0, 0.0, -0.44 * u + 0.06 * v], [0.0, 1.0, -0.24 * v + 0.06 * u]]
}

pub(crate) fn figure() -> String {
    let view = View::from_direction(28.0, 24.0, 125.0, [265.0, 256.0]);
    let mut drawing = Drawing::new(
        "A beam through a surface element",
        "A surface patch, its tangent vectors and normal, and a beam that crosses it at an angle",
        [620, 370],
        view,
    );
    grid(&mut drawing);
    let at = surface(POINT[0], POINT[1]);
    let [along_u, along_v] = tangents(POINT[0], POINT[1]).map(|tangent| scaled(STEP, tangent));
    let normal = unit(cross(along_u, along_v));
    let direction = unit(DIRECTION);
    beam(&mut drawing, parallelogram(at, along_u, along_v), direction);
    for (vector, name, shift) in
        [(along_u, "Sᵤ\u{a0}du", [-18.0, 14.0]), (along_v, "Sᵥ\u{a0}dv", [32.0, 12.0])]
    {
        drawing.arrow(at, vector, Pen::solid(Colour::Ink, 2.0));
        drawing.label(add(at, vector), shift, name, Colour::Ink);
    }
    drawing.arrow(at, scaled(1.3, normal), Pen::solid(Colour::Vermilion, 2.0));
    drawing.label(add(at, scaled(1.3, normal)), [-12.0, -8.0], "n", Colour::Vermilion);
    drawing.arrow(at, scaled(1.25, direction), Pen::solid(Colour::Blue, 2.0));
    drawing.label(add(at, scaled(1.25, direction)), [-2.0, -14.0], "p", Colour::Blue);
    drawing.angle(at, normal, direction, 0.55, Pen::solid(Colour::Ink, 1.2));
    let between = unit(add(normal, direction));
    drawing.label(add(at, scaled(0.68, between)), [0.0, -2.0], "θ", Colour::Ink);
    drawing.finish()
}

/// Draws lines of constant u and of constant v.
fn grid(drawing: &mut Drawing) {
    let place = |step: i32| -HALF + 2.0 * HALF * f64::from(step) / f64::from(LINES);
    for step in 0..=LINES {
        let fixed = place(step);
        let (of_u, of_v): (Vec<Vector>, Vec<Vector>) =
            (0..=LINES).map(|other| (surface(place(other), fixed), surface(fixed, place(other)))).unzip();
        drawing.line(&of_u, Pen::solid(Colour::Faint, 0.7));
        drawing.line(&of_v, Pen::solid(Colour::Faint, 0.7));
    }
    drawing.label(surface(HALF, -HALF), [16.0, 22.0], "S(u, v)", Colour::Faint);
}

/// Draws the parallelogram, the rays through its corners, and the cross section of the beam.
fn beam(drawing: &mut Drawing, corners: [Vector; 4], direction: Vector) {
    let far = add(corners[2], scaled(1.75, direction));
    let across = corners.map(|corner| {
        let missing = dot(add(far, scaled(-1.0, corner)), direction);
        add(corner, scaled(missing, direction))
    });
    drawing.area(&corners, 0.3, Pen::solid(Colour::Ochre, 1.2));
    for (corner, end) in corners.into_iter().zip(across) {
        drawing.line(&[corner, add(end, scaled(0.25, direction))], Pen::dashed(Colour::Blue, 1.0));
    }
    drawing.area(&across, 0.25, Pen::solid(Colour::Blue, 1.2));
    let middle = |quad: [Vector; 4]| scaled(0.5, add(quad[0], quad[2]));
    drawing.label_inside(middle(corners), "dA", Colour::Ink);
    drawing.label(middle(across), [90.0, 14.0], "cos θ dA", Colour::Blue);
}
