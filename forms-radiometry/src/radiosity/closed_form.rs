//! Closed forms: what a point gets straight from lights, to the last digit, and what of that is rounding.
//!
//! ```text
//! each face that light comes from ─┬─ nothing before it ─▶ precise: its measure in double-double
//!                                  └─ else ──────────────▶ visible: its measure in f64, as a sum over pieces
//! lights without extent ───────────── seen or not ───────▶ precise: cos θ/r²
//! ```
//! It takes some hundred times as long as a sum in `f64`, so that few receivers are worth it: answers, and not the cells of maps.

use super::direct::{Lights, hides};
use super::gather::{Group, Scratch, Transport};
use super::measure::Measure;
use crate::faces::emits;
use crate::geometry::precise::{
    Precise, Rounded, dot, form_factor, length, rounding, rounding_beyond, solid_angle, unit, way,
};
use crate::geometry::{Between, Face, Vector};
use crate::scene::{Light, LightKind};
use forms::math::{DoubleDouble, Real};
use std::f64::consts::PI;

/// What the corners of a piece of a luminaire and what its edges add are rounded by in `f64`.
const OF_PIECE: f64 = 16.0 * f64::EPSILON;
/// The measure of all directions is twice that of a hemisphere, and an edge more may lie in the horizon: it subtends half of what the others do at most.
const WITH_HORIZON: f64 = 3.0;

impl Measure {
    /// The measure, over π, of what a point sees of a convex outline that nothing hides.
    fn precisely(self, point: Vector, outline: &[Vector]) -> Rounded {
        match self {
            Self::Plane(normal) => form_factor(point, outline, normal, true),
            Self::Flow(axis) => form_factor(point, outline, axis, false).times(-1.0),
            Self::Sphere => solid_angle(point, outline).over_pi(),
        }
    }

    /// The measure of directions about one, over π, by their solid angle over π; and by how much the rounding of its axis changes it.
    fn precise_factor(self, direction: Precise) -> Rounded {
        let along = |axis: Vector| {
            let (axis, turned) = unit(axis);
            Rounded { value: dot(axis, direction), error: turned }
        };
        match self {
            Self::Plane(normal) => {
                let Rounded { value, error } = along(normal);
                if value.to_f64() > 0.0 { Rounded { value, error } } else { Rounded::exactly(0.0) }
            }
            Self::Flow(axis) => along(axis).times(-1.0),
            Self::Sphere => Rounded::exactly(1.0),
        }
    }
}

impl Lights<'_> {
    /// How many edges there are to see from a point.
    pub(crate) fn edges(&self, transport: &Transport) -> usize {
        self.faces().iter().map(|&index| transport.faces[index].vertices.len()).sum()
    }

    /// What a point gets straight from lights, for each band, and a bound on what rounding changes of it.
    pub(crate) fn precisely(
        &self,
        (point, measure): (Vector, Measure),
        transport: &Transport,
        scratch: &mut Scratch,
    ) -> Vec<[f64; 2]> {
        let scene = self.scene();
        let mut sums = vec![Rounded::exactly(0.0); scene.band_count()];
        let mut open = Rounded::exactly(measure.whole());
        for face in self.faces().iter().map(|&index| &transport.faces[index]) {
            let seen = measured(point, measure, face, transport, scratch);
            open = open + seen.times(-1.0);
            if emits(scene, face) {
                add(&mut sums, seen, &scene.surfaces[face.surface].radiance);
            }
        }
        add(&mut sums, open, &scene.ambient.radiance);
        sums.iter_mut().for_each(|sum| *sum = sum.times_pi());
        for light in &scene.lights {
            let (arriving, factor) = without_extent(light, point, measure, transport);
            add(&mut sums, factor, arriving);
        }
        sums.into_iter().map(Rounded::nearest).collect()
    }

    /// A bound on what rounding changes of what a point gets straight from lights, for each band, where it is summed in `f64`.
    pub(crate) fn rounding(&self, (point, measure): (Vector, Measure), transport: &Transport) -> Vec<f64> {
        let of_face = |face: &Face| {
            WITH_HORIZON * OF_PIECE * rounding(point, &face.vertices)
                + unseen(point, measure, face, transport)
        };
        let mut sums = self.of_faces(OF_PIECE * measure.whole(), of_face, transport);
        self.add_of_beams(&[point], &mut sums);
        sums
    }

    /// The same for all of some points, whatever is measured there; without end where one of them is near to a face.
    pub(crate) fn rounding_of_all(&self, points: &[Vector], transport: &Transport) -> Vec<f64> {
        let whole = Measure::Sphere.whole();
        let of_face = |face: &Face| {
            let squared = face.vertices.iter().map(|&corner| nearest(corner, points));
            let nearest = squared.fold(f64::INFINITY, f64::min).sqrt();
            if points.iter().any(|&point| unseen(point, Measure::Sphere, face, transport) > 0.0) {
                return f64::INFINITY;
            }
            WITH_HORIZON * OF_PIECE * rounding_beyond(nearest, &face.vertices)
        };
        let mut sums = self.of_faces(OF_PIECE * whole, of_face, transport);
        self.add_of_beams(points, &mut sums);
        sums
    }

    /// The same for the cells of a map in a ball. Edges of a convex polygon subtend 2π together at most; what cells beside one of them have more is not in it.
    pub(crate) fn rounding_within(&self, (center, radius): (Vector, f64), transport: &Transport) -> Vec<f64> {
        let of_face = |face: &Face| {
            let squared = face.vertices.iter().map(|&corner| nearest(corner, &[center]));
            let distance = (squared.fold(f64::INFINITY, f64::min).sqrt() - radius).max(0.0);
            WITH_HORIZON * OF_PIECE * rounding_beyond(distance, &face.vertices).min(2.0)
        };
        self.of_faces(OF_PIECE * Measure::Sphere.whole(), of_face, transport)
    }

    /// Adds what rounding changes of lights without extent at the nearest of some points.
    fn add_of_beams(&self, points: &[Vector], sums: &mut [f64]) {
        for light in &self.scene().lights {
            let (arriving, squared) = match &light.kind {
                LightKind::Point { position, intensity } => (intensity, nearest(*position, points)),
                LightKind::Distant { irradiance, .. } => (irradiance, 1.0),
            };
            sums.iter_mut().zip(arriving).for_each(|(sum, arriving)| *sum += OF_PIECE * arriving / squared);
        }
    }

    /// The sums over all faces of what the measure, over π, of each changes by, times its radiance; `open` is what the measure of all directions does.
    fn of_faces(&self, mut open: f64, of_face: impl Fn(&Face) -> f64, transport: &Transport) -> Vec<f64> {
        let scene = self.scene();
        let mut sums = vec![0.0; scene.band_count()];
        for face in self.faces().iter().map(|&index| &transport.faces[index]) {
            let of_face = of_face(face);
            open += of_face;
            if emits(scene, face) {
                let radiance = &scene.surfaces[face.surface].radiance;
                sums.iter_mut().zip(radiance).for_each(|(sum, radiance)| *sum += PI * of_face * radiance);
            }
        }
        let outside = scene.ambient.radiance.iter().zip(&mut sums).filter(|(radiance, _)| **radiance > 0.0);
        outside.for_each(|(radiance, sum)| *sum += PI * open * radiance);
        sums
    }
}

/// The square of the distance from a place to the nearest of some points.
fn nearest(place: Vector, points: &[Vector]) -> f64 {
    let squared = |&point: &Vector| (place - point).dot(place - point);
    points.iter().map(squared).fold(f64::INFINITY, f64::min)
}

/// The measure, over π, that a face may have that is taken to have none because the point is so near to its plane.
fn unseen(point: Vector, measure: Measure, face: &Face, transport: &Transport) -> f64 {
    let height = face.normal.dot(point - face.vertices[0]);
    let looks_away = measure.horizon().is_some_and(|normal| normal.dot(face.normal) >= 0.0);
    let is_near = height != 0.0 && height.abs() <= transport.screens.resolution();
    if is_near && !looks_away { measure.whole().max(1.0) } else { 0.0 }
}

/// Adds a measure times the radiance of each band.
fn add(sums: &mut [Rounded], measure: Rounded, radiance: &[f64]) {
    for (sum, &radiance) in sums.iter_mut().zip(radiance).filter(|(_, radiance)| **radiance != 0.0) {
        *sum = *sum + measure.times_datum(radiance);
    }
}

/// The measure, over π, of what a point sees of a face.
fn measured(
    point: Vector,
    measure: Measure,
    face: &Face,
    transport: &Transport,
    scratch: &mut Scratch,
) -> Rounded {
    if !transport.occlusion {
        return measure.precisely(point, &face.vertices);
    }
    let (points, luminaire) = ([point], (face.vertices.as_slice(), face.normal));
    let receivers = (points.as_slice(), measure.horizon());
    match transport.screens.between_among(None, receivers, luminaire, &mut scratch.between) {
        Between::All => Rounded::exactly(0.0),
        Between::Nothing => measure.precisely(point, &face.vertices),
        Between::Some => {
            let group = Group { points: &points, outline: &points, measure };
            let mut sum = Rounded { error: unseen(point, measure, face, transport), ..Rounded::exactly(0.0) };
            transport.see_parts(group, luminaire, &scratch.between, &mut scratch.view, |_, piece| {
                let value = DoubleDouble::from_f64(measure.of(piece));
                sum = sum + Rounded { value, error: OF_PIECE * rounding(Vector::default(), piece) };
            });
            sum
        }
    }
}

/// The intensity or irradiance of a light without extent in each band, and what of it a point gets.
fn without_extent<'l>(
    light: &'l Light,
    point: Vector,
    measure: Measure,
    transport: &Transport,
) -> (&'l [f64], Rounded) {
    let (arriving, towards, turned) = match &light.kind {
        LightKind::Point { position, intensity } => (intensity, way(point, *position), 0.0),
        LightKind::Distant { direction, irradiance } => {
            let (direction, turned) = unit(*direction);
            (irradiance, direction.map(|x| -x), turned)
        }
    };
    let distance = length(towards);
    if distance.to_f64() == 0.0 || hides(light, point, transport) {
        return (arriving, Rounded::exactly(0.0));
    }
    let Rounded { value, error } = measure.precise_factor(towards.map(|x| x / distance));
    let squared = if matches!(light.kind, LightKind::Point { .. }) {
        distance * distance
    } else {
        DoubleDouble::from_f64(1.0)
    };
    (arriving, Rounded { value: value / squared, error: (error + turned) / squared.to_f64() })
}
