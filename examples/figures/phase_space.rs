//! A beam in phase space: free space shears it along the position, a lens along the direction; its
//! area is preserved.

use forms_figures::vector::{Vector, add};
use forms_figures::{Colour, Drawing, Pen, View};

const PANEL: f64 = 3.2;
const AXIS: f64 = 1.35;
/// Half the width of the beam, in position and in direction.
const BEAM: [f64; 2] = [0.5, 0.38];
/// Distance, and reciprocal of the focal length.
const DISTANCE: f64 = 1.5;
const BEND: f64 = 0.95;

/// Propagates (x, a) through free space; `bent` propagates it through the lens after it.
fn further([x, a]: [f64; 2]) -> [f64; 2] {
    [x + DISTANCE * a, a]
}

fn bent([x, a]: [f64; 2]) -> [f64; 2] {
    [x, a - BEND * x]
}

pub(crate) fn figure() -> String {
    let view = View::flat(60.0, [118.0, 120.0]);
    let mut drawing = Drawing::new(
        "A beam in phase space",
        "A beam in phase space, a rectangle: sheared by free space, then by a lens, with the same area",
        [620, 250],
        view,
    );
    let corners =
        [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[u, v]| [u * BEAM[0], v * BEAM[1]]);
    let after_space = corners.map(further);
    let panels = [
        (corners, "a beam", Colour::Vermilion),
        (after_space, "after free space", Colour::Blue),
        (after_space.map(bent), "after a lens", Colour::Green),
    ];
    for (panel, (beam, name, colour)) in (0_i32..).zip(panels) {
        let middle: Vector = [PANEL * f64::from(panel), 0.0, 0.0];
        drawing.arrow(add(middle, [-AXIS, 0.0, 0.0]), [2.0 * AXIS, 0.0, 0.0], Pen::solid(Colour::Ink, 1.0));
        drawing.arrow(add(middle, [0.0, -AXIS, 0.0]), [0.0, 2.0 * AXIS, 0.0], Pen::solid(Colour::Ink, 1.0));
        drawing.label(add(middle, [AXIS, 0.0, 0.0]), [2.0, 14.0], "x", Colour::Ink);
        drawing.label(add(middle, [0.0, AXIS, 0.0]), [14.0, 2.0], "a", Colour::Ink);
        let outline = beam.map(|[x, a]| add(middle, [x, a, 0.0]));
        drawing.area(&outline, 0.3, Pen::solid(colour, 1.8));
        drawing.words(add(middle, [0.0, -AXIS, 0.0]), [0.0, 24.0], name, colour);
    }
    drawing.finish()
}
