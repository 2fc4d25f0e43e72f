//! Closed forms: the direct light at a point to the last digit, and its rounding error.
//!
//! ```text
//! sphere or disk to be seen ─ nothing before it ─▶ precise: its measure; else its faces, in f64
//! each face to be seen ─┬─ nothing before it ─▶ precise: its measure in double-double
//!                       └─ else ──────────────▶ visible: its measure in f64, as a sum over pieces
//! point and distant lights ──── seen or not ──▶ precise: cos θ/r²
//! ```
//! This takes some hundred times as long as a sum in `f64`, so it is used only for few receivers:
//! for answers, and not for the cells of maps.

use super::direct::{Lights, kinds, sources};
use super::emission::emitted;
use super::measure::Measure;
use super::round::{bulges, sees};
use super::transport::{Group, Scratch, Transport};
use crate::faces::{emits, emits_from, has_round_holes, is_round, round_surfaces};
use crate::form_factor::double_double::{
    Precise, Rounded, dot, form_factor, length, rounding, rounding_beyond, solid_angle, unit, way,
};
use crate::geometry::Vector;
use crate::scene::{Light, LightKind, Scene, Surface};
use crate::visibility::{Between, Face};
use forms::math::{DoubleDouble, Real};
use std::collections::BTreeSet;
use std::f64::consts::PI;

/// Rounding of the corners of a piece of a luminous face, and of the terms of its edges, in `f64`.
const OF_PIECE: f64 = 16.0 * f64::EPSILON;
/// Factor of the rounding error. The measure of all directions is twice that of a hemisphere, and
/// one more edge can lie in the horizon: it subtends at most half of the angle that the others do.
const WITH_HORIZON: f64 = 3.0;
/// Cost of evaluating a disk or sphere as a whole, in edges.
const OF_ROUND: usize = 6;
/// Distance from the plane of a face, in units of the largest coordinate, within which the rounding
/// of coordinates decides on which side of it a point lies: the point counts as lying in the plane.
const OF_PLANE: f64 = 8.0 * f64::EPSILON;
/// Largest sine of the angle between the normal of a point and that of the face on which it lies:
/// normals are written with few digits.
const TILTED: f64 = 1e-3;
/// Maximum number of edges that all answers together evaluate in double-double, each in some 2 µs.
const PRECISE_EDGES: usize = 1024;

/// Whether the direct light of this many answers is computed to the last digit, by
/// [`Lights::precisely`], and not gathered in `f64`.
pub(crate) fn is_precise(scene: &Scene, faces: &[Face], answers: usize) -> bool {
    let seen = sources(scene, faces, kinds(scene, faces));
    let (round, flat): (Vec<&Face>, Vec<&Face>) = seen
        .into_iter()
        .map(|index| &faces[index])
        .partition(|face| scene.surfaces[face.surface].shape.is_round());
    let round: BTreeSet<usize> = round.into_iter().map(|face| face.surface).collect();
    let edges = flat.into_iter().map(|face| face.vertices.len()).sum::<usize>() + OF_ROUND * round.len();
    edges * answers <= PRECISE_EDGES
}

/// Direct light at a point.
pub(crate) struct Straight {
    /// The value in each band, and a bound on its rounding error.
    pub(crate) bands: Vec<[f64; 2]>,
    /// Whether flat pieces can represent a disk or sphere in it.
    pub(crate) has_pieces: bool,
}

/// Sums over everything that a point sees.
struct Sums {
    /// The light at the point in each band, over π.
    bands: Vec<Rounded>,
    /// The measure, over π, of the directions in which there is no face.
    open: Rounded,
}

/// The part of a face that a point sees.
struct Part {
    /// Its measure, over π.
    measure: Rounded,
    /// Whether its visibility is certain: it cannot be occluded, or all of the face is hidden.
    is_open: bool,
}

impl Measure {
    /// Returns the measure, over π, of a convex outline without occluders, as a point sees it.
    pub(super) fn precisely(self, point: Vector, outline: &[Vector]) -> Rounded {
        match self {
            Self::Plane(normal) => form_factor(point, outline, normal, true),
            Self::Flow(axis) => form_factor(point, outline, axis, false).times(-1.0),
            Self::Sphere => solid_angle(point, outline).over_pi(),
        }
    }

    /// Returns the measure of a small solid angle about a direction, over that solid angle, with
    /// the error from the rounding of its axis.
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
    /// Returns the number of edges that a point has to see.
    pub(crate) fn edges(&self, transport: &Transport) -> usize {
        self.faces().iter().map(|&index| transport.faces[index].vertices.len()).sum()
    }

    /// Returns the direct light at a point. Disks and spheres can be `seen_whole` only if the
    /// result is not compared with a sum over their pieces.
    pub(crate) fn precisely(
        &self,
        at: (Vector, Measure),
        seen_whole: bool,
        transport: &Transport,
        scratch: &mut Scratch,
    ) -> Straight {
        let scene = self.scene();
        let mut sums = Sums::of_nothing(at.1, scene.band_count());
        let mut whole = Vec::new();
        for &surface in self.round().iter().filter(|_| seen_whole) {
            if let Some((seen, is_back)) = self.whole(at, surface, transport, scratch) {
                sums.take(seen, &scene.surfaces[surface], emits_from(scene, surface, is_back), transport);
                whole.push(surface);
            }
        }
        let (mut is_open, mut has_holes) = (true, false);
        let faces = self.faces().iter().map(|&index| &transport.faces[index]);
        for face in faces.filter(|face| !whole.contains(&face.surface)) {
            let seen = self.measured(at, face, transport, scratch);
            sums.take(seen.measure, &scene.surfaces[face.surface], emits(scene, face), transport);
            is_open &= seen.is_open;
            has_holes |= has_round_holes(scene, face.surface);
        }
        let mut bands = sums.with_outside(&scene.ambient.radiance);
        for light in &scene.lights {
            let (arriving, factor) = without_extent(light, at, scene, transport);
            add(&mut bands, factor, arriving);
        }
        is_open &= scene.lights.is_empty() || !transport.occlusion;
        let has_pieces = whole.len() < self.round().len() || has_holes || (is_round(scene) && !is_open);
        Straight { bands: bands.into_iter().map(Rounded::nearest).collect(), has_pieces }
    }

    /// Measures the visible part of a face from a point. Faces that tessellate a disk or sphere are
    /// evaluated in `f64`: their error is larger than rounding.
    fn measured(
        &self,
        (point, measure): (Vector, Measure),
        face: &Face,
        transport: &Transport,
        scratch: &mut Scratch,
    ) -> Part {
        if let Some(error) = on_face(face, point, measure) {
            return Part { measure: Rounded { error, ..Rounded::exactly(0.0) }, is_open: true };
        }
        let own = self.round().contains(&face.surface).then_some(face.surface);
        let (points, luminaire) = ([point], (face.vertices.as_slice(), face.normal));
        scratch.between.clear();
        let between = if transport.occlusion {
            let receivers = (points.as_slice(), measure.horizon());
            transport.screens.between_among(None, receivers, luminaire, &mut scratch.between)
        } else {
            Between::Nothing
        };
        let mut summed = |between: &[u32]| {
            let group = Group { points: &points, outline: &points, measure };
            let mut sum = Rounded { error: unseen(point, measure, face, transport), ..Rounded::exactly(0.0) };
            transport.see_parts(group, luminaire, between, &mut scratch.view, |_, piece| {
                let value = DoubleDouble::from_f64(measure.of(piece));
                sum = sum + Rounded { value, error: OF_PIECE * rounding(Vector::default(), piece) };
            });
            sum
        };
        match between {
            Between::Some => Part { measure: summed(&scratch.between), is_open: false },
            Between::All => {
                let is_sure = self.is_surely_hidden(point, face, transport, &scratch.between);
                let error = if is_sure { 0.0 } else { measure.at_most(point, &face.vertices) };
                Part { measure: Rounded { error, ..Rounded::exactly(0.0) }, is_open: error == 0.0 }
            }
            Between::Nothing => {
                let Rounded { value, error } =
                    if own.is_some() { summed(&[]) } else { measure.precisely(point, &face.vertices) };
                let bulges = if transport.occlusion {
                    let round = round_surfaces(self.scene());
                    bulges(round, (point, measure.horizon()), luminaire, own)
                        .min(measure.at_most(point, &face.vertices))
                } else {
                    0.0
                };
                Part { measure: Rounded { value, error: error + bulges }, is_open: bulges == 0.0 }
            }
        }
    }

    /// Returns for each band a bound on the rounding error of the direct light at a point, where it
    /// is summed in `f64`. A point that lies `on` a face sees nothing in the plane of that face, on
    /// whichever side its coordinates are rounded to.
    pub(crate) fn rounding(
        &self,
        (point, measure): (Vector, Measure),
        on: Option<&Face>,
        transport: &Transport,
    ) -> Vec<f64> {
        let is_beside = |face: &Face| {
            let is_in_plane = |on: &Face| lies_in_plane(face, on, transport.screens.resolution());
            on.is_some_and(is_in_plane)
        };
        let of_face = |face: &Face| {
            let unseen = if is_beside(face) { 0.0 } else { unseen(point, measure, face, transport) };
            WITH_HORIZON * OF_PIECE * rounding(point, &face.vertices) + unseen
        };
        let mut sums = self.of_faces(OF_PIECE * measure.whole(), of_face, transport);
        self.add_of_beams(&[point], &mut sums);
        sums
    }

    /// Returns the same bound for all of several points and for any measure; infinite if one of
    /// them is close to the plane of a face.
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

    /// Returns the same bound for the cells of a map within a ball. The edges of a convex polygon
    /// subtend at most 2π together; the additional error of cells next to an edge is not included.
    pub(crate) fn rounding_within(&self, (center, radius): (Vector, f64), transport: &Transport) -> Vec<f64> {
        let of_face = |face: &Face| {
            let squared = face.vertices.iter().map(|&corner| nearest(corner, &[center]));
            let distance = (squared.fold(f64::INFINITY, f64::min).sqrt() - radius).max(0.0);
            WITH_HORIZON * OF_PIECE * rounding_beyond(distance, &face.vertices).min(2.0)
        };
        self.of_faces(OF_PIECE * Measure::Sphere.whole(), of_face, transport)
    }

    /// Adds the rounding error of point and distant lights at the nearest of several points.
    fn add_of_beams(&self, points: &[Vector], sums: &mut [f64]) {
        for light in &self.scene().lights {
            let (arriving, squared) = match &light.kind {
                LightKind::Point { position, intensity } => (intensity, nearest(*position, points)),
                LightKind::Distant { irradiance, .. } => (irradiance, 1.0),
            };
            sums.iter_mut().zip(arriving).for_each(|(sum, arriving)| *sum += OF_PIECE * arriving / squared);
        }
    }

    /// Returns the sums over all faces of the error of the measure of each, over π, times its
    /// radiance; `open` is the error of the measure of all directions.
    fn of_faces(&self, mut open: f64, of_face: impl Fn(&Face) -> f64, transport: &Transport) -> Vec<f64> {
        let scene = self.scene();
        let mut sums = vec![0.0; scene.band_count()];
        for face in self.faces().iter().map(|&index| &transport.faces[index]) {
            let of_face = of_face(face);
            if transport.hides_outside {
                open += of_face;
            }
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

impl Sums {
    fn of_nothing(measure: Measure, bands: usize) -> Self {
        Self { bands: vec![Rounded::exactly(0.0); bands], open: Rounded::exactly(measure.whole()) }
    }

    /// Adds the visible measure of a surface.
    fn take(&mut self, seen: Rounded, surface: &Surface, emits: bool, transport: &Transport) {
        if transport.hides_outside {
            self.open = self.open + seen.times(-1.0);
        }
        if emits {
            self.bands
                .iter_mut()
                .zip(emitted(seen, surface))
                .for_each(|(sum, emitted)| *sum = *sum + emitted);
        }
    }

    /// Returns the light in each band where the remaining directions have these radiances.
    fn with_outside(mut self, radiance: &[f64]) -> Vec<Rounded> {
        add(&mut self.bands, self.open, radiance);
        self.bands.into_iter().map(Rounded::times_pi).collect()
    }
}

/// Returns the square of the distance from a place to the nearest of several points.
fn nearest(place: Vector, points: &[Vector]) -> f64 {
    let squared = |&point: &Vector| (place - point).dot(place - point);
    points.iter().map(squared).fold(f64::INFINITY, f64::min)
}

/// Returns the largest measure, over π, of a face that is treated as invisible because the point is
/// so close to its plane.
fn unseen(point: Vector, measure: Measure, face: &Face, transport: &Transport) -> f64 {
    let height = face.normal.dot(point - face.vertices[0]);
    let looks_away = measure.horizon().is_some_and(|normal| normal.dot(face.normal) >= 0.0);
    let is_near = height.abs() <= transport.screens.resolution() && on_face(face, point, measure).is_none();
    if is_near && !looks_away { measure.whole().max(1.0) } else { 0.0 }
}

/// Returns a bound on the visible part of a face in whose plane a point with a horizon lies, up to
/// the rounding of coordinates, with its normal along that of the face: zero, on whichever side it is
/// rounded to, but for the tilt θ of the normal, whose lune measures (1 − cos θ)/2. `None` for all
/// other points.
fn on_face(face: &Face, point: Vector, measure: Measure) -> Option<f64> {
    let first = face.vertices[0];
    let is_in_plane = face.normal.dot(point - first).abs() <= OF_PLANE * point.largest().max(first.largest());
    let tilt = measure.horizon()?.unit()?.cross(face.normal).length();
    (is_in_plane && tilt <= TILTED).then_some(0.25 * tilt * tilt)
}

/// Whether all of a face is as close to the plane of another as points that count as lying in it.
fn lies_in_plane(face: &Face, other: &Face, resolution: f64) -> bool {
    face.vertices.iter().all(|&corner| other.normal.dot(corner - other.vertices[0]).abs() <= resolution)
}

/// Adds a measure times the radiance of each band.
fn add(sums: &mut [Rounded], measure: Rounded, radiance: &[f64]) {
    for (sum, &radiance) in sums.iter_mut().zip(radiance).filter(|(_, radiance)| **radiance != 0.0) {
        *sum = *sum + measure.times_datum(radiance);
    }
}

/// Returns the intensity or irradiance of a point or distant light in each band, and its factor in
/// the light at a point.
fn without_extent<'l>(
    light: &'l Light,
    (point, measure): (Vector, Measure),
    scene: &Scene,
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
    let is_seen = sees(point, light, scene, transport);
    if distance.to_f64() == 0.0 || is_seen == Some(false) {
        return (arriving, Rounded::exactly(0.0));
    }
    let Rounded { value, error } = measure.precise_factor(towards.map(|x| x / distance));
    let squared = if matches!(light.kind, LightKind::Point { .. }) {
        distance * distance
    } else {
        DoubleDouble::from_f64(1.0)
    };
    let (value, error) = (value / squared, (error + turned) / squared.to_f64());
    let seen = match is_seen {
        None => Rounded { error: value.to_f64().abs() + error, ..Rounded::exactly(0.0) },
        Some(_) => Rounded { value, error },
    };
    (arriving, seen)
}
