//! Extinction: what a homogeneous medium leaves of light along a ray, e^(−σ d).

// what rounding may make of it is part of every error that is told, so that it needs no guard
pub(crate) use crate::kernels::transmittance::unguarded as transmittance;

/// What is left after a distance, which may be without end. Where nothing is taken away, all of it is.
pub(crate) fn left(extinction: f64, distance: f64) -> f64 {
    match (extinction > 0.0, distance.is_finite()) {
        (false, _) => 1.0,
        (true, false) => 0.0,
        (true, true) => transmittance(extinction, distance),
    }
}

/// What is taken away on the way: 1 − e^(−σ d), without cancellation.
pub(crate) fn lost(extinction: f64, distance: f64) -> f64 {
    if extinction > 0.0 { -(-extinction * distance).exp_m1() } else { 0.0 }
}
