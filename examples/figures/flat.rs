//! Points in one plane: x to the right and y upwards.

use forms_figures::vector::Vector;

/// Returns a point of the plane.
pub(crate) fn at(x: f64, y: f64) -> Vector {
    [x, y, 0.0]
}

/// Returns the rectangle between two opposite corners.
pub(crate) fn rectangle(low: [f64; 2], high: [f64; 2]) -> [Vector; 4] {
    [at(low[0], low[1]), at(high[0], low[1]), at(high[0], high[1]), at(low[0], high[1])]
}
