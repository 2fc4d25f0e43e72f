//! Extinction: transmittance e^(−σ d) of a homogeneous medium along a ray.

use crate::scene::{Medium, Scene};

// the kernel's rounding error is part of every reported error, so it needs no guard
pub(crate) use forms_kernels::transmittance::unguarded as transmittance;

/// Whether light from far away arrives in this band: an ambient medium that absorbs or scatters
/// extinguishes it completely.
pub(crate) fn is_lit_from_afar(scene: &Scene, band: usize) -> bool {
    let is_clear = |medium: &Medium| medium.absorption[band] == 0.0 && medium.scattering[band] == 0.0;
    scene.ambient.medium.is_none_or(|medium| is_clear(&scene.media[medium]))
}

/// Returns the transmittance over a distance, which can be infinite. It is 1 where the extinction
/// is zero.
pub(crate) fn left(extinction: f64, distance: f64) -> f64 {
    match (extinction > 0.0, distance.is_finite()) {
        (false, _) => 1.0,
        (true, false) => 0.0,
        (true, true) => transmittance(extinction, distance),
    }
}

/// Returns the fraction that extinction removes along the way: 1 − e^(−σ d), without cancellation.
pub(crate) fn lost(extinction: f64, distance: f64) -> f64 {
    if extinction > 0.0 { -(-extinction * distance).exp_m1() } else { 0.0 }
}
