//! Transmitted light: the direct light of light sources at a point after extinction in a medium,
//! and the light that the medium scatters once into a ray.
//!
//! ```text
//! emitting face ─ visible part ─▶ convex pieces ─▶ triangles ─▶ sums and bounds ─┐
//! point and distant lights ─ visible ─▶ e^(−σ r) of the arriving light ──────────┴─▶ a point
//! point lights ─ outside shadows of faces ─▶ segments of a ray ─▶ sums and bounds ─▶ the ray
//! ```
//! The results are per band. Occluders are clipped from a face as exactly as in a vacuum
//! ([`gather`](super::transport)), so that the remaining integrand is smooth (`triangles`).
//!
//! Source: S. Chandrasekhar, Radiative transfer (1950), chapter 1: the formal solution of the
//! equation of transfer without scattering.

mod halving;
mod segments;
mod shadows;
mod triangles;

use super::direct::lights_at;
use super::measure::Measure;
use super::transport::{Group, Scratch, Transport};
use crate::extinction::{left, transmittance};
use crate::faces::{emits, faces, is_round};
use crate::geometry::Vector;
use crate::scene::{LightKind, Medium, Scene};
use crate::visibility::Screens;
use segments::{Lit, Segment, scattered};
use std::sync::Arc;
use triangles::{Integrand, Triangle, fan};

/// Maximum number of faces: among more, the search for occluders would take longer than samples.
const MOST_FACES: usize = 1 << 12;
/// Fraction of the tolerance that is left to integrals: they are so smooth that a much smaller
/// fraction takes little longer.
const PART: f64 = 1e-3;
/// Optical thickness beyond which no light remains: e^−1500 is below the smallest positive number.
const OPAQUE: f64 = 1500.0;
/// Rounding of a number, in units of the last place: of its terms, and for each unit of an
/// exponent.
const ROUNDING: [f64; 2] = [64.0, 4.0];
/// Rounding of a height above a plane or a ray, in units of the last place of the largest distance.
const OF_HEIGHT: f64 = 8.0;

/// The light sources of a scene in a medium that fills it.
pub(crate) struct Transmitted<'s> {
    scene: &'s Scene,
    transport: Transport,
    /// The faces that emit.
    luminous: Vec<usize>,
    /// The extinction coefficient in each band.
    extinction: Vec<f64>,
}

/// A value in a band, and its errors.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Reached {
    pub(crate) value: f64,
    pub(crate) quadrature: f64,
    pub(crate) rounding: f64,
}

/// Whether the faces of a scene are flat, and few enough that their visible parts can be clipped
/// exactly.
pub(crate) fn has_exact_pieces(scene: &Scene) -> bool {
    !is_round(scene) && faces(scene, 0).len() <= MOST_FACES
}

impl<'s> Transmitted<'s> {
    /// Returns the light sources of a scene of flat faces whose medium has this extinction in each
    /// band.
    pub(crate) fn of(scene: &'s Scene, extinction: Vec<f64>) -> Self {
        let faces = faces(scene, 0);
        let luminous = (0..faces.len()).filter(|&index| emits(scene, &faces[index])).collect();
        let screens = if faces.is_empty() { Screens::none(&faces) } else { Screens::of(&faces) };
        let accuracy = (PART * scene.solve.tolerance).clamp(1e-12, 1e-6);
        let (faces, screens) = (Arc::new(faces), Arc::new(screens));
        let transport = Transport { faces, screens, occlusion: true, hides_outside: true, accuracy };
        Self { scene, transport, luminous, extinction }
    }

    /// Returns the light at a point by each measure, all of them with one horizon, and for each
    /// measure in each band.
    pub(crate) fn at(&self, position: Vector, measures: &[Measure]) -> Vec<Reached> {
        let integrand = Integrand { measures, extinction: &self.extinction, scene: self.scene };
        let triangles = self.triangles(position, measures[0]);
        let mut reached = integrand.integrated(triangles, self.transport.accuracy);
        for (measure, of_bands) in measures.iter().zip(reached.chunks_exact_mut(self.extinction.len())) {
            self.add_lights(position, *measure, of_bands);
        }
        reached
    }

    /// Returns the light of point lights that the medium scatters once into a ray, in each band.
    pub(crate) fn scattered_once(&self, ray: [Vector; 2], medium: &Medium) -> Vec<Reached> {
        let [origin, direction] = ray;
        let Transport { faces, screens, accuracy, .. } = &self.transport;
        let end = screens.first(origin, direction).map_or(f64::INFINITY, |met| met.distance);
        let thinnest = self
            .extinction
            .iter()
            .copied()
            .filter(|&extinction| extinction > 0.0)
            .fold(f64::INFINITY, f64::min);
        let mut segments = Vec::new();
        for light in &self.scene.lights {
            // light of distant lights was extinguished on its way
            let LightKind::Point { position, intensity } = &light.kind else { continue };
            let lit = Lit::of(ray, *position, intensity);
            let end = end.min(lit.abreast.max(0.0) + OPAQUE / thinnest);
            let ends = shadows::lit(ray, end, *position, faces, screens.resolution());
            segments.extend(ends.into_iter().map(|ends| Segment { lit, ends }));
        }
        scattered(segments, medium, &self.extinction, *accuracy)
    }

    /// Returns the pieces that a point sees of the emitting faces, as triangles.
    fn triangles(&self, position: Vector, measure: Measure) -> Vec<Triangle> {
        let (points, mut scratch) = ([position], Scratch::default());
        let group = Group { points: &points, outline: &points, measure };
        let mut triangles = Vec::new();
        for &index in &self.luminous {
            let face = &self.transport.faces[index];
            let height = face.normal.dot(position - face.vertices[0]);
            self.transport.see(group, (&face.vertices, face.normal), &mut scratch, |_, piece| {
                triangles.extend(fan(piece, face, height));
            });
        }
        triangles
    }

    /// Adds the light of point and distant lights.
    fn add_lights(&self, position: Vector, measure: Measure, of_bands: &mut [Reached]) {
        lights_at(self.scene, position, measure, &self.transport, |arriving, factor, distance| {
            for ((reached, &extinction), arriving) in of_bands.iter_mut().zip(&self.extinction).zip(arriving)
            {
                let value = factor * arriving * left(extinction, distance);
                reached.value += value;
                reached.rounding += rounding(extinction, distance) * value.abs() + least(extinction);
            }
        });
    }
}

/// Returns the rounding error of light after a distance, relative to the light: an exponent is
/// rounded before the exponential is taken.
fn rounding(extinction: f64, distance: f64) -> f64 {
    let [of_terms, of_exponent] = ROUNDING;
    let exponent = if distance.is_finite() { extinction * distance } else { 0.0 };
    f64::EPSILON * (of_terms + of_exponent * exponent)
}

/// Returns the error bound of the Gauss rule with this number of points on an interval of length 2,
/// over an upper bound of the integrand in the Bernstein ellipse: its foci are the ends of the
/// interval, and this is the sum of its half axes.
///
/// Source: L. N. Trefethen, Is Gauss quadrature better than Clenshaw–Curtis? (2008), theorem 4.5.
fn gauss_error(rho: f64, points: usize) -> f64 {
    64.0 / 15.0 * rho.powi(-2 * points as i32) / (1.0 - 1.0 / (rho * rho))
}

/// Returns the light in a medium that underflow can lose.
fn least(extinction: f64) -> f64 {
    if extinction > 0.0 { f64::MIN_POSITIVE } else { 0.0 }
}
