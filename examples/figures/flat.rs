//! Figures in one plane: x to the right and y upwards.

use crate::drawing::{Drawing, Pen};
use crate::vector::Vector;

/// Returns a point of the plane.
pub(crate) fn at(x: f64, y: f64) -> Vector {
    [x, y, 0.0]
}

/// Returns the rectangle between two opposite corners.
pub(crate) fn rectangle(low: [f64; 2], high: [f64; 2]) -> [Vector; 4] {
    [at(low[0], low[1]), at(high[0], low[1]), at(high[0], high[1]), at(low[0], high[1])]
}

/// Draws a curve given by a parameter from 0 to 1.
pub(crate) fn curve(drawing: &mut Drawing, steps: u32, pen: Pen, point: impl Fn(f64) -> Vector) {
    let points: Vec<Vector> = (0..=steps).map(|step| point(f64::from(step) / f64::from(steps))).collect();
    drawing.line(&points, pen);
}
