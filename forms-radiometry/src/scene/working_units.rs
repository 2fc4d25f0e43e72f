//! Working units: scales a scene in any unit and of any size to lengths and lights near 1, and
//! converts the results back to the author's units.
//!
//! ```text
//! scene in m, cm or mm ─ lengths × 2ᵏ, lights × 2ⁿ ─▶ both about 1 ─ simulation ─▶ results
//! results ─▶ irradiance, radiance × 2⁻ⁿ
//!            flux = irradiance × area in m² × 2⁻ⁿ
//! ```
//! Form factors contain fourth powers of lengths, which leave the range of `f64` long before the
//! lengths do. Scaling by a power of two rounds nothing. View factors and irradiance do not depend
//! on the unit of lengths; E = I/r² of a point light takes r in metres, as does the area of a flux.
//! Every answer is proportional to the lights.

use super::model::{LengthUnit, Light, LightKind, ReceiverKind, Scene, Shape};
use super::place::Place;
use crate::geometry::scale;
use crate::geometry::{Round, Sphere, Vector};
use std::borrow::Cow;

/// Largest ratio of lengths in one scene: if they differ by more, they cannot all be scaled near
/// enough to 1.
const WIDEST: f64 = 1e140;

/// The least radius relative to the coordinates of its centre: rounding would destroy a smaller
/// circle.
const LEAST_RADIUS: f64 = 1e-12;

/// A scene in working units.
#[derive(Clone, Debug)]
pub(crate) struct WorkingScene<'s> {
    pub(crate) scene: Cow<'s, Scene>,
    pub(crate) units: WorkingUnits,
}

/// Working units of a scene.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WorkingUnits {
    /// Scale factor from lengths in the file to working units: a power of two.
    pub(crate) factor: f64,
    /// The area of a square whose side is the working unit of length, in m².
    pub(crate) square_metres: f64,
    /// Scale factor from irradiance and radiance of the working scene to the author's units: a
    /// power of two.
    pub(crate) light: f64,
}

/// The lengths that determine the scaling of a scene.
struct Lengths {
    /// The largest absolute coordinate of any object.
    largest: f64,
    /// The least extent of a flat or curved piece, and the index of its surface.
    least: f64,
    least_surface: usize,
}

impl Scene {
    /// Returns the scene with lengths and lights near 1, without the lights that emit nothing.
    pub(crate) fn in_working_units(&self) -> WorkingScene<'_> {
        let factor = Lengths::of(self).factor();
        let metres = self.unit.metres() / factor;
        let square_metres = metres * metres;
        let brightest = self.brightest(square_metres);
        let darker = scale::factor([brightest; 2]);
        let mut scene = Cow::Borrowed(self);
        if !self.lights.iter().all(Light::emits) {
            scene.to_mut().lights.retain(Light::emits);
        }
        let has_points = scene.lights.iter().any(|light| matches!(light.kind, LightKind::Point { .. }));
        if factor != 1.0 || (has_points && square_metres != 1.0) {
            scene.to_mut().scale(factor);
        }
        if darker != 1.0 || (has_points && square_metres != 1.0) {
            scene.to_mut().darken(darker, square_metres);
        }
        WorkingScene { scene, units: WorkingUnits { factor, square_metres, light: darker.recip() } }
    }

    /// Returns the same for a scene that is not needed otherwise.
    pub(crate) fn into_working_units(self) -> (Self, WorkingUnits) {
        let WorkingScene { scene, units } = self.in_working_units();
        let changed = match scene {
            Cow::Owned(scene) => Some(scene),
            Cow::Borrowed(_) => None,
        };
        (changed.unwrap_or(self), units)
    }

    /// Returns the largest irradiance or radiance that a light causes at distances of about 1 in
    /// working units.
    fn brightest(&self, square_metres: f64) -> f64 {
        let largest = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
        let of_light = |light: &Light| match &light.kind {
            // the quotient can overflow or underflow, but not so far that the largest or smallest
            // number cannot replace it
            LightKind::Point { intensity, .. } => {
                let quotient = largest(intensity) / square_metres;
                let floor = if largest(intensity) > 0.0 { f64::MIN_POSITIVE } else { 0.0 };
                quotient.clamp(floor, f64::MAX)
            }
            LightKind::Distant { irradiance, .. } => largest(irradiance),
        };
        let surfaces = self.surfaces.iter().map(|surface| largest(&surface.radiance));
        let lights = self.lights.iter().map(of_light);
        surfaces.chain(lights).fold(largest(&self.ambient.radiance), f64::max)
    }

    /// Multiplies all lights by a power of two, and divides the intensity of point lights by the
    /// area of the square of the working unit of length.
    fn darken(&mut self, darker: f64, square_metres: f64) {
        let darken = |values: &mut Vec<f64>| values.iter_mut().for_each(|value| *value *= darker);
        for surface in &mut self.surfaces {
            darken(&mut surface.radiance);
            surface.exitance.iter_mut().for_each(darken);
        }
        darken(&mut self.ambient.radiance);
        for light in &mut self.lights {
            match &mut light.kind {
                LightKind::Distant { irradiance, .. } => darken(irradiance),
                LightKind::Point { intensity, .. } => {
                    // half of the factor before the division and half after it, since the product
                    // of both can be out of range
                    let half = (0.5 * darker.log2()).floor().exp2();
                    let other = darker / half;
                    intensity.iter_mut().for_each(|value| *value = *value * half / square_metres * other);
                }
            }
        }
    }

    fn scale(&mut self, factor: f64) {
        let move_point = |point: &mut Vector| *point = factor * *point;
        for medium in &mut self.media {
            let coefficients = medium.absorption.iter_mut().chain(&mut medium.scattering);
            coefficients.for_each(|coefficient| *coefficient /= factor);
        }
        for surface in &mut self.surfaces {
            surface.shape = surface.shape.scaled(factor);
        }
        for light in &mut self.lights {
            if let LightKind::Point { position, .. } = &mut light.kind {
                move_point(position);
            }
        }
        for receiver in &mut self.receivers {
            match &mut receiver.kind {
                ReceiverKind::Point { position, .. } | ReceiverKind::Sphere { position } => {
                    move_point(position);
                }
                ReceiverKind::Ray { origin, .. } => move_point(origin),
                ReceiverKind::Camera(camera) => *camera = camera.scaled(factor),
                ReceiverKind::Points(points) => points.positions.iter_mut().for_each(move_point),
                ReceiverKind::Surface { .. } | ReceiverKind::Faces { .. } => {}
            }
        }
    }

    /// Returns the lengths that are lost next to others: a place, the error message, and the
    /// expected input.
    pub(super) fn lost_lengths(&self) -> Vec<(&Place, String, String)> {
        let Lengths { largest, least, least_surface } = Lengths::of(self);
        let widest = self.surfaces.get(least_surface).filter(|_| least < largest / WIDEST).map(|surface| {
            let name = &surface.name;
            let message = format!(
                "the smallest extent of `{name}`, {least:.0e}, is too small compared with coordinates \
                 of {largest:.0e}"
            );
            let expected = format!("lengths in one scene that differ by no more than a factor of {WIDEST:e}");
            (&surface.place, message, expected)
        });
        let lost = self.surfaces.iter().filter_map(|surface| {
            let center = surface.shape.as_round()?.center().largest();
            let radius = match surface.shape {
                Shape::Sphere(Sphere { radius, .. }) => radius,
                Shape::Disk(disk) => disk.width(),
                Shape::Quadric(quadric) => quadric.least_extent(),
                Shape::Polygon(_) | Shape::Mesh(_) => return None,
            };
            let message = format!(
                "the radius {radius:e} of `{}` is lost to rounding at coordinates of {center:.0e}",
                surface.name
            );
            let expected =
                format!("a radius of at least {LEAST_RADIUS:e} times the coordinates of the centre");
            (radius < LEAST_RADIUS * center).then_some((&surface.place, message, expected))
        });
        widest.into_iter().chain(lost).collect()
    }
}

impl LengthUnit {
    /// Returns the length of the unit in metres.
    pub fn metres(self) -> f64 {
        match self {
            Self::Metre => 1.0,
            Self::Centimetre => 1e-2,
            Self::Millimetre => 1e-3,
        }
    }
}

impl Shape {
    pub(super) fn scaled(&self, factor: f64) -> Self {
        match self {
            Self::Polygon(polygon) => Self::Polygon(polygon.scaled(factor)),
            Self::Mesh(mesh) => Self::Mesh(mesh.scaled(factor).into()),
            Self::Sphere(sphere) => Self::Sphere(sphere.scaled(factor)),
            Self::Disk(disk) => Self::Disk(disk.scaled(factor)),
            Self::Quadric(quadric) => Self::Quadric(quadric.scaled(factor)),
        }
    }

    /// Returns the largest absolute coordinate of the shape, and the least extent of its pieces.
    fn lengths(&self) -> [f64; 2] {
        match self {
            Self::Polygon(polygon) => polygon.lengths(),
            Self::Mesh(mesh) => mesh.lengths(),
            Self::Sphere(sphere) => [sphere.center.largest() + sphere.radius, sphere.radius],
            Self::Disk(disk) => [disk.center.largest() + disk.radius, disk.width()],
            Self::Quadric(quadric) => {
                let center = quadric.center().largest();
                [center + quadric.radius(), quadric.least_extent()]
            }
        }
    }
}

impl Lengths {
    fn of(scene: &Scene) -> Self {
        let mut lengths = Self { largest: 0.0, least: f64::INFINITY, least_surface: 0 };
        for (index, surface) in scene.surfaces.iter().enumerate() {
            let [largest, least] = surface.shape.lengths();
            lengths.largest = lengths.largest.max(largest);
            if least < lengths.least {
                (lengths.least, lengths.least_surface) = (least, index);
            }
        }
        let lights = scene.lights.iter().filter_map(|light| match light.kind {
            LightKind::Point { position, .. } => Some(position),
            LightKind::Distant { .. } => None,
        });
        let eyes = scene.receivers.iter().filter_map(|receiver| match &receiver.kind {
            ReceiverKind::Ray { origin, .. } => Some(*origin),
            ReceiverKind::Camera(camera) => Some(camera.origin),
            _ => None,
        });
        let points = scene.receivers.iter().flat_map(|receiver| receiver.kind.points());
        let farthest = lights
            .chain(eyes)
            .chain(points.map(|(position, _)| position))
            .map(Vector::largest)
            .fold(lengths.largest, f64::max);
        lengths.largest = farthest;
        lengths.least = lengths.least.min(farthest);
        lengths
    }

    /// Returns the scale factor that brings the lengths near 1.
    fn factor(&self) -> f64 {
        scale::factor([self.largest, self.least])
    }
}
