//! Stokes' theorem: circulations around the cells of a surface cancel on inner sides, and only the
//! boundary remains.

use forms_figures::vector::{Vector, add, scaled};
use forms_figures::{Colour, Drawing, Pen, View};

const CELLS: [i32; 2] = [4, 3];
/// Distance of the loop inside a cell from its sides, as a fraction of the cell.
const INSET: f64 = 0.13;

/// Returns a point of the saddle over the cells.
fn surface(u: f64, v: f64) -> Vector {
    [u, v, 0.12 * (u - 2.0) * (v - 1.5) + 0.45]
}

pub(crate) fn figure() -> String {
    let view = View::from_direction(-70.0, 42.0, 98.0, [80.0, 270.0]);
    let mut drawing = Drawing::new(
        "Stokes' theorem on a surface in cells",
        "A surface in cells. Walks around neighbouring cells run against each other; the rim is left",
        [620, 400],
        view,
    );
    for u in 0..CELLS[0] {
        for v in 0..CELLS[1] {
            cell(&mut drawing, f64::from(u), f64::from(v));
        }
    }
    rim(&mut drawing);
    drawing.finish()
}

/// Returns the corners of a cell in order, at a distance from its sides.
fn corners(u: f64, v: f64, inset: f64) -> [Vector; 4] {
    let (low, high) = (inset, 1.0 - inset);
    [(low, low), (high, low), (high, high), (low, high)].map(|(a, b)| surface(u + a, v + b))
}

/// Draws a cell and the loop inside it.
fn cell(drawing: &mut Drawing, u: f64, v: f64) {
    drawing.area(&corners(u, v, 0.0), 0.06, Pen::solid(Colour::Faint, 0.8));
    let walk = corners(u, v, INSET);
    for side in 0..4 {
        let (from, to) = (walk[side], walk[(side + 1) % 4]);
        drawing.arrow(from, add(to, scaled(-1.0, from)), Pen::solid(Colour::Blue, 1.2));
    }
}

/// Draws the sides that belong to one cell only, in the direction of its loop.
fn rim(drawing: &mut Drawing) {
    let [wide, deep] = CELLS.map(f64::from);
    let bottom = (0..CELLS[0]).map(|u| [(f64::from(u), 0.0), (f64::from(u) + 1.0, 0.0)]);
    let right = (0..CELLS[1]).map(|v| [(wide, f64::from(v)), (wide, f64::from(v) + 1.0)]);
    let top = (0..CELLS[0]).map(|u| [(wide - f64::from(u), deep), (wide - f64::from(u) - 1.0, deep)]);
    let left = (0..CELLS[1]).map(|v| [(0.0, deep - f64::from(v)), (0.0, deep - f64::from(v) - 1.0)]);
    for [from, to] in bottom.chain(right).chain(top).chain(left) {
        let (from, to) = (surface(from.0, from.1), surface(to.0, to.1));
        drawing.arrow(from, add(to, scaled(-1.0, from)), Pen::solid(Colour::Vermilion, 2.4));
    }
    drawing.label(surface(wide, deep), [26.0, -8.0], "∂M", Colour::Vermilion);
    drawing.label(surface(2.5, 1.5), [0.0, 0.0], "M", Colour::Ink);
}
