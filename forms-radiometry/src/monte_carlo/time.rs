//! Time: how long a path is to light.

use super::lattice::Lattice;
use super::optics::MediumOptics;
use super::path::Tracer;

impl<L: Lattice, const N: usize> Tracer<'_, L, N> {
    /// The optical length of a way, ∫ n ds, after a distance more in this medium; where nobody asks for the time it stays what it was.
    pub(super) fn longer(&self, way: f64, medium: &MediumOptics<N>, distance: f64) -> f64 {
        if L::TIME { way + medium.index * distance } else { way }
    }
}
