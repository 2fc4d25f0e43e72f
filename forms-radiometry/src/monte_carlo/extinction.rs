//! Extinction: what is left of light along a ray, e^(−σ d).

use super::optics::MediumOptics;
use super::warps::transmittance;

impl<const N: usize> MediumOptics<N> {
    /// What is left after a distance, which may be without end.
    pub(super) fn transmittance(&self, distance: f64) -> [f64; N] {
        self.extinction.map(|extinction| if extinction > 0.0 { left(extinction, distance) } else { 1.0 })
    }
}

fn left(extinction: f64, distance: f64) -> f64 {
    if distance.is_finite() { transmittance(extinction, distance) } else { 0.0 }
}
