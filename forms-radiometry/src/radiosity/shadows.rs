//! Shadows of point and distant lights: computes the lit part of each face under each light, its
//! flux in closed form, and the shadow border along which elements are cut.
//!
//! ```text
//! a distant light of irradiance E    Φ = E A⊥,  A⊥ the lit area across the direction
//! a point light of intensity I       Φ = I Ω,   Ω the solid angle of the lit part from the light
//! ```

use super::contact::Contact;
use super::point_lights::{measure, spectrum};
use super::question::Question;
use super::reflectance::is_reflecting;
use super::transport::Transport;
use crate::form_factor::double_double::Rounded;
use crate::geometry::{Vector, edges};
use crate::parallelism::Parallelism;
use crate::scene::{Light, LightKind, Scene};
use crate::visibility::{Beam, Face, Lit};
use crate::watch::Watch;

/// Maximum number of segments of a shadow border; a border with more does not cut the face.
const MOST_SEGMENTS: usize = 256;

/// The lit parts of faces.
pub(super) struct Shadows {
    /// For each face, under each light, if it was requested and does not have too many pieces.
    lit: Vec<Vec<Option<Lit>>>,
}

impl Shadows {
    /// Computes the lit parts of the faces that receive light for a question, or reflect it; none if
    /// the work is stopped.
    pub(super) fn on(scene: &Scene, transport: &Transport, question: &Question, watch: &dyn Watch) -> Self {
        let is_wanted = |face: &Face| {
            let is_source = question.orders != Some(0) && is_reflecting(scene, face);
            is_source || question.receives.have(face)
        };
        Self::of(scene, transport, is_wanted, watch)
    }

    /// Computes the lit parts of the selected faces; none if the work is stopped.
    pub(super) fn of(
        scene: &Scene,
        transport: &Transport,
        is_wanted: impl Fn(&Face) -> bool + Sync,
        watch: &dyn Watch,
    ) -> Self {
        let of_face = |_: &mut (), face: &Face| {
            let lights = scene.lights.iter().filter(|_| is_wanted(face) && !watch.is_stopped());
            lights.map(|light| transport.lit(face, light)).collect()
        };
        let parallelism = if transport.occlusion && !scene.lights.is_empty() {
            Parallelism::Shared
        } else {
            Parallelism::Alone
        };
        Self { lit: parallelism.map(transport.faces.as_slice(), of_face) }
    }

    /// Returns for each band the direct flux of point and distant lights onto a face; `None` if a
    /// lit part is not known.
    pub(super) fn flux(&self, index: usize, scene: &Scene, transport: &Transport) -> Option<Vec<Rounded>> {
        let mut flux = vec![Rounded::exactly(0.0); scene.band_count()];
        if self.lit[index].len() < scene.lights.len() {
            return None;
        }
        for (light, lit) in scene.lights.iter().zip(&self.lit[index]) {
            let measure = transport.measured_by(light, lit.as_ref()?, &transport.faces[index]);
            let sums = flux.iter_mut().zip(spectrum(light));
            sums.for_each(|(sum, &of_band)| *sum = *sum + measure.times_datum(of_band));
        }
        Some(flux)
    }

    /// Returns the lit part of a face under a light, if it is known.
    pub(super) fn lit(&self, face: usize, light: usize) -> Option<&Lit> {
        self.lit[face].get(light)?.as_ref()
    }

    /// Returns the shadow borders on a face; empty if they have too many segments.
    pub(super) fn borders(&self, index: usize, face: &Face, closeness: f64) -> Vec<Contact> {
        let lit = self.lit[index].iter().flatten();
        let segments: Vec<[Vector; 2]> = lit.flat_map(|lit| lit.border(&face.vertices, closeness)).collect();
        if segments.len() > MOST_SEGMENTS {
            return Vec::new();
        }
        segments.into_iter().filter_map(|ends| Contact::of_shadow(ends, face.normal)).collect()
    }
}

impl Transport {
    /// Whether a point or distant light can reach some of a face.
    pub(super) fn may_reach(&self, face: &Face, light: &Light) -> bool {
        self.lit(face, light).is_none_or(|lit| !lit.pieces.is_empty())
    }

    /// Returns the part of a face that a point or distant light reaches.
    fn lit(&self, face: &Face, light: &Light) -> Option<Lit> {
        let beam = beam(light);
        if self.occlusion {
            self.screens.lit((&face.vertices, face.normal), beam)
        } else {
            Some(Lit::unhidden((&face.vertices, face.normal), beam, self.screens.resolution()))
        }
    }

    /// Returns the measure of the lit part of a face: a solid angle or a projected area, depending
    /// on the light.
    fn measured_by(&self, light: &Light, lit: &Lit, face: &Face) -> Rounded {
        let pieces = lit.pieces.iter().map(|piece| measure(light, piece));
        let mut sum = pieces.fold(Rounded::exactly(0.0), |sum, piece| sum + piece);
        if !lit.is_whole {
            let perimeter: f64 = lit.pieces.iter().map(|piece| perimeter(piece)).sum();
            let squared = match light.kind {
                LightKind::Point { position, .. } => face.normal.dot(position - face.vertices[0]).powi(2),
                LightKind::Distant { .. } => 1.0,
            };
            sum.error += perimeter * self.screens.rounding() / squared;
        }
        sum
    }
}

/// Returns the rays of a point or distant light.
fn beam(light: &Light) -> Beam {
    match light.kind {
        LightKind::Point { position, .. } => Beam::From(position),
        LightKind::Distant { direction, .. } => Beam::Along(direction),
    }
}

fn perimeter(piece: &[Vector]) -> f64 {
    edges(piece).map(|[a, b]| (b - a).length()).sum()
}
