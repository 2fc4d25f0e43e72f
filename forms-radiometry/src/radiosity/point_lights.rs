//! Point and distant lights: their spectrum, and its factors in the light at points and on outlines.

use super::measure::Measure;
use super::transport::Transport;
use crate::form_factor::double_double::{Rounded, area_across, solid_angle};
use crate::geometry::Vector;
use crate::scene::{Light, LightKind};

/// Returns the factor of the intensity, or of the irradiance, of a light in its unoccluded light at
/// a point.
pub(super) fn reaching_factor(light: &Light, point: Vector, measure: Measure) -> f64 {
    let (towards, squared) = match light.kind {
        LightKind::Point { position, .. } => {
            let way = position - point;
            (way, way.dot(way))
        }
        LightKind::Distant { direction, .. } => (-direction, 1.0),
    };
    towards.unit().map_or(0.0, |unit| measure.factor(unit) / squared)
}

/// Whether a point or distant light is hidden from a point.
pub(super) fn hides(light: &Light, point: Vector, transport: &Transport) -> bool {
    transport.occlusion
        && match light.kind {
            LightKind::Point { position, .. } => transport.screens.hides(point, position),
            LightKind::Distant { direction, .. } => transport.screens.hides_direction(point, -direction),
        }
}

/// Returns the factor of the intensity, or of the irradiance, of a light in its flux onto a convex
/// outline without occluders.
pub(super) fn measure(light: &Light, outline: &[Vector]) -> Rounded {
    match light.kind {
        LightKind::Point { position, .. } => solid_angle(position, outline),
        LightKind::Distant { direction, .. } => area_across(outline, direction),
    }
}

/// Returns the intensity, or the irradiance, of a light in each band.
pub(super) fn spectrum(light: &Light) -> &[f64] {
    match &light.kind {
        LightKind::Point { intensity, .. } => intensity,
        LightKind::Distant { irradiance, .. } => irradiance,
    }
}
