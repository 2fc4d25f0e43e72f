//! Time of flight: the optical path length of a path.

use super::optics::MediumOptics;

/// Returns an optical path length, ∫ n ds, after a further distance in this medium.
pub(super) fn longer<const N: usize>(
    optical_path_length: f64,
    medium: &MediumOptics<N>,
    distance: f64,
) -> f64 {
    optical_path_length + medium.index * distance
}
