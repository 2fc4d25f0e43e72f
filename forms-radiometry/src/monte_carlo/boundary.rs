//! Boundaries: what becomes of a ray that meets a smooth surface.
//!
//! ```text
//! mirror, metal (mirror.rs) ──────┬─▶ passage: reflected or refracted, with its factor ─▶ direction, throughput
//! two media (refraction.rs) ──────┘
//! ```

use super::optics::times;
use crate::geometry::Vector;

/// What a ray does at a smooth boundary.
pub(super) enum Passage<const N: usize> {
    /// It goes on to this direction on the side it came from, with this factor.
    Reflected(Vector, [f64; N]),
    /// It goes on to this direction beyond the boundary, with this factor.
    Refracted(Vector, f64),
}

/// The direction of the mirror image, for a unit normal: d − 2 (d·n) n.
pub(super) fn mirrored(direction: Vector, normal: Vector) -> Vector {
    let reflected = direction.mirrored(normal);
    // so that rounding does not add up from mirror to mirror
    reflected.unit().unwrap_or(reflected)
}

impl<const N: usize> Passage<N> {
    /// The direction, the factor of what comes from there, and whether the ray stays on its side.
    pub(super) fn applied(self, throughput: &[f64; N]) -> (Vector, [f64; N], bool) {
        match self {
            Self::Reflected(direction, factor) => (direction, times(throughput, &factor), true),
            Self::Refracted(direction, factor) => (direction, throughput.map(|t| factor * t), false),
        }
    }
}
