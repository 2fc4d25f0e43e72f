//! Time: how long a path is to light.

use super::optics::MediumOptics;

/// The optical length of a way, ∫ n ds, after a distance more in this medium.
pub(super) fn longer<const N: usize>(way: f64, medium: &MediumOptics<N>, distance: f64) -> f64 {
    way + medium.index * distance
}
