//! Names and numbers that the elements of a scene file refer to.

use super::element::Indices;
use super::subsurfaces::OnKey;
use std::collections::HashSet;

/// Names and numbers to which the elements of a scene refer.
#[derive(Default)]
pub(super) struct Known {
    /// The number of bands; unknown if the bands themselves are invalid.
    pub(super) bands: Option<usize>,
    pub(super) media: Indices,
    pub(super) materials: Indices,
    /// The materials that are dielectrics.
    pub(super) dielectrics: HashSet<usize>,
    pub(super) surfaces: Indices,
    /// The keys `on` of surfaces.
    pub(super) on: Vec<OnKey>,
}
