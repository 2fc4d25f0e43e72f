//! The brightest source: the largest irradiance that a source of a scene causes by itself.
//!
//! ```text
//! π L of surfaces and from outside, E of distant lights, I/r² of point lights at points that are asked for
//! ```

use super::model::{Light, LightKind, Scene};
use crate::geometry::Vector;
use std::f64::consts::PI;

/// Returns the largest irradiance, of all bands, that a source of a scene causes by itself.
pub(crate) fn brightest_source(scene: &Scene) -> f64 {
    let of_surfaces = scene.surfaces.iter().flat_map(|surface| &surface.radiance);
    let radiances = of_surfaces.chain(&scene.ambient.radiance).map(|radiance| PI * radiance);
    let beams = scene.lights.iter().map(|light| beam(scene, light));
    radiances.chain(beams).filter(|irradiance| irradiance.is_finite()).fold(0.0, f64::max)
}

/// Returns the largest irradiance by a light, across its rays.
fn beam(scene: &Scene, light: &Light) -> f64 {
    let largest = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
    match &light.kind {
        LightKind::Distant { irradiance, .. } => largest(irradiance),
        LightKind::Point { position, intensity } => {
            let points = scene.receivers.iter().flat_map(|receiver| receiver.kind.points());
            let square = |(point, _): (Vector, Option<Vector>)| (point - *position).dot(point - *position);
            let nearest = points.map(square).fold(f64::INFINITY, f64::min);
            largest(intensity) / nearest
        }
    }
}
