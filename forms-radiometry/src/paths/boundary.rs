//! Specular boundaries: the outcome for a ray that meets a smooth surface.
//!
//! ```text
//! mirror, metal (mirror.rs) ─┬─▶ passage: reflected, refracted; a factor ─▶ direction, throughput
//! two media (refraction.rs) ─┘
//! ```

use super::optics::times;
use crate::geometry::Vector;

/// Outcome of a ray at a smooth boundary.
pub(super) enum Passage<const N: usize> {
    /// The ray continues in this direction on the side that it came from, with this factor.
    Reflected(Vector, [f64; N]),
    /// The ray continues in this direction beyond the boundary, with this factor.
    Refracted(Vector, f64),
}

/// Returns the mirror image of a direction, for a unit normal: d − 2 (d·n) n.
pub(super) fn mirrored(direction: Vector, normal: Vector) -> Vector {
    let reflected = direction.mirrored(normal);
    // normalised, so that rounding errors do not accumulate from mirror to mirror
    reflected.unit().unwrap_or(reflected)
}

impl<const N: usize> Passage<N> {
    /// Returns the new direction, the new throughput, and whether the ray stays on its side.
    pub(super) fn applied(self, throughput: &[f64; N]) -> (Vector, [f64; N], bool) {
        match self {
            Self::Reflected(direction, factor) => (direction, times(throughput, &factor), true),
            Self::Refracted(direction, factor) => (direction, throughput.map(|t| factor * t), false),
        }
    }
}
