//! Transmitted light: what a medium leaves of what lights send straight to a point, and what it scatters once of it into a ray.
//!
//! ```text
//! luminous face ─ visible from the point ─▶ convex pieces ─▶ triangles ─▶ sums with their bounds ─┐
//! lights without extent ─ not hidden ─▶ e^(−σ r) of what arrives ─────────────────────────────────┴─▶ a point, in each band
//! points that shine ─ past the shadows of faces ─▶ segments of a ray ─▶ sums with their bounds ─────▶ the ray, in each band
//! ```
//! What hides a face is cut out of it as exactly as in a vacuum ([`gather`](super::gather)), so that what is left to be integrated is smooth
//! (`triangles`).
//!
//! Source: S. Chandrasekhar, Radiative transfer (1950), chapter 1: the formal solution of the equation of transfer without scattering.

mod halving;
mod segments;
mod shadows;
mod triangles;

use super::direct::lights_at;
use super::gather::{Group, Scratch, Transport};
use super::measure::Measure;
use crate::extinction::{left, transmittance};
use crate::faces::{emits, faces, is_round};
use crate::geometry::{Screens, Vector};
use crate::scene::{LightKind, Medium, Scene};
use segments::{Lit, Segment, scattered};
use triangles::{Integrand, Triangle, fan};

/// Among more faces the search for what stands in between would take longer than samples.
const MOST_FACES: usize = 1 << 12;
/// The part of the tolerance that is left to integrals: they are so smooth that much more takes little longer.
const PART: f64 = 1e-3;
/// The optical thickness beyond which light is nothing: e^−1500 is below the least number.
const OPAQUE: f64 = 1500.0;
/// Rounding of a number, in units of the last place: of its terms, and for each unit of an exponent.
const ROUNDING: [f64; 2] = [64.0, 4.0];
/// Rounding of a height over a plane or a ray, in units of the last place of the largest distance.
const OF_HEIGHT: f64 = 8.0;

/// The lights of a scene in a medium that is everywhere.
pub(crate) struct Transmitted<'s> {
    scene: &'s Scene,
    transport: Transport,
    /// The faces that emit.
    luminous: Vec<usize>,
    /// The extinction coefficient in each band.
    extinction: Vec<f64>,
}

/// A number in a band, and what it may be off by.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Reached {
    pub(crate) value: f64,
    pub(crate) quadrature: f64,
    pub(crate) rounding: f64,
}

/// Whether the faces of a scene are flat, and few enough that what a point sees of them can be cut out.
pub(crate) fn has_exact_pieces(scene: &Scene) -> bool {
    !is_round(scene) && faces(scene, 0).len() <= MOST_FACES
}

impl<'s> Transmitted<'s> {
    /// The lights of a scene of flat faces whose medium has this extinction in each band.
    pub(crate) fn of(scene: &'s Scene, extinction: Vec<f64>) -> Self {
        let faces = faces(scene, 0);
        let luminous = (0..faces.len()).filter(|&index| emits(scene, &faces[index])).collect();
        let screens = if faces.is_empty() { Screens::none(&faces) } else { Screens::of(&faces) };
        let accuracy = (PART * scene.solve.tolerance).clamp(1e-12, 1e-6);
        let transport = Transport { faces, screens, occlusion: true, accuracy };
        Self { scene, transport, luminous, extinction }
    }

    /// What a point gets by each measure, all of them with one horizon, and of each of them in each band.
    pub(crate) fn at(&self, position: Vector, measures: &[Measure]) -> Vec<Reached> {
        let integrand = Integrand { measures, extinction: &self.extinction, scene: self.scene };
        let triangles = self.triangles(position, measures[0]);
        let mut reached = integrand.integrated(triangles, self.transport.accuracy);
        for (measure, of_bands) in measures.iter().zip(reached.chunks_exact_mut(self.extinction.len())) {
            self.add_lights(position, *measure, of_bands);
        }
        reached
    }

    /// What a ray brings that the medium scatters once of the light of points, in each band.
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
            // what comes from far away was extinguished on its way
            let LightKind::Point { position, intensity } = &light.kind else { continue };
            let lit = Lit::of(ray, *position, intensity);
            let end = end.min(lit.abreast.max(0.0) + OPAQUE / thinnest);
            let ends = shadows::lit(ray, end, *position, faces, screens.resolution());
            segments.extend(ends.into_iter().map(|ends| Segment { lit, ends }));
        }
        scattered(segments, medium, &self.extinction, *accuracy)
    }

    /// The pieces that a point sees of what shines, in triangles.
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

    /// Adds what comes from lights without extent.
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

/// What rounding may make of light after a distance, relative to it: an exponent is rounded before it is raised.
fn rounding(extinction: f64, distance: f64) -> f64 {
    let [of_terms, of_exponent] = ROUNDING;
    let exponent = if distance.is_finite() { extinction * distance } else { 0.0 };
    f64::EPSILON * (of_terms + of_exponent * exponent)
}

/// The bound of the error of Gauss' rule of so many points on an interval of length 2, over what the integrand is not above in the ellipse with
/// the foci at its ends and this sum of half axes.
///
/// Source: L. N. Trefethen, Is Gauss quadrature better than Clenshaw–Curtis? (2008), theorem 4.5.
fn gauss_error(rho: f64, points: usize) -> f64 {
    64.0 / 15.0 * rho.powi(-2 * points as i32) / (1.0 - 1.0 / (rho * rho))
}

/// What underflow may take of light in a medium.
fn least(extinction: f64) -> f64 {
    if extinction > 0.0 { f64::MIN_POSITIVE } else { 0.0 }
}
