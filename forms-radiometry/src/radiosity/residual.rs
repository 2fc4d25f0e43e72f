//! Checks of direct light at points, and what its interpolation from nodes leaves there.

use crate::geometry::Vector;

/// Direct light at a point.
pub(super) struct Check {
    pub(super) face: usize,
    pub(super) position: Vector,
    /// The area that the point represents.
    pub(super) area: f64,
    /// Direct light of faces and surroundings in each band.
    pub(super) straight: Vec<f64>,
}

/// Excess of the direct light at a point over its interpolation from the nodes.
#[derive(Clone, Debug)]
pub(super) struct Residual {
    pub(super) element: usize,
    /// In each band, as a flux.
    pub(super) flux: Vec<f64>,
}
