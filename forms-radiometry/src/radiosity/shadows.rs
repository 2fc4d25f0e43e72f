//! Shadows of lights without extent: faces and lights become the lit part of each face under each light, its flux in closed form and the
//! border along which elements are cut.
//!
//! ```text
//! far away, irradiance E     Φ = E A⊥,  A⊥ the lit area across the direction
//! a point of intensity I     Φ = I Ω,   Ω the solid angle of the lit part from the point
//! ```

use super::contact::Contact;
use super::gather::Transport;
use crate::geometry::precise::{Rounded, area_across, solid_angle};
use crate::geometry::{Beam, Face, Lit, Vector, edges};
use crate::scene::{Light, LightKind, Scene};
use crate::sharing::Sharing;
use crate::simulation::Watch;

/// A border of more segments cuts no face.
const MOST_SEGMENTS: usize = 256;

/// The lit parts of faces.
pub(super) struct Shadows {
    /// Of each face, under each light, where they are wanted and not too many pieces.
    lit: Vec<Vec<Option<Lit>>>,
}

impl Shadows {
    /// Those on the faces of which they are wanted; none if the work is stopped.
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
        let sharing =
            if transport.occlusion && !scene.lights.is_empty() { Sharing::Shared } else { Sharing::Alone };
        Self { lit: sharing.map(&transport.faces, of_face) }
    }

    /// For each band the flux that comes straight from lights without extent to a face; nothing where a lit part is not known.
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

    /// The part of a face that is lit under a light, where that is known.
    pub(super) fn lit(&self, face: usize, light: usize) -> Option<&Lit> {
        self.lit[face].get(light)?.as_ref()
    }

    /// Where shadows end on a face: nowhere if they end in too many places.
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
    /// Whether a light without extent may reach some of a face.
    pub(super) fn may_reach(&self, face: &Face, light: &Light) -> bool {
        self.lit(face, light).is_none_or(|lit| !lit.pieces.is_empty())
    }

    /// The part of a face that a light without extent reaches.
    fn lit(&self, face: &Face, light: &Light) -> Option<Lit> {
        let beam = beam(light);
        if self.occlusion {
            self.screens.lit((&face.vertices, face.normal), beam)
        } else {
            Some(Lit::unhidden((&face.vertices, face.normal), beam, self.screens.resolution()))
        }
    }

    /// The measure of the lit part of a face in the light's own.
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

/// What is multiplied by the intensity, or the irradiance, of a light for its flux to a convex outline that nothing hides.
pub(super) fn measure(light: &Light, outline: &[Vector]) -> Rounded {
    match light.kind {
        LightKind::Point { position, .. } => solid_angle(position, outline),
        LightKind::Distant { direction, .. } => area_across(outline, direction),
    }
}

/// The intensity, or the irradiance, of a light in each band.
pub(super) fn spectrum(light: &Light) -> &[f64] {
    match &light.kind {
        LightKind::Point { intensity, .. } => intensity,
        LightKind::Distant { irradiance, .. } => irradiance,
    }
}

/// The rays of a light without extent.
fn beam(light: &Light) -> Beam {
    match light.kind {
        LightKind::Point { position, .. } => Beam::From(position),
        LightKind::Distant { direction, .. } => Beam::Along(direction),
    }
}

fn perimeter(piece: &[Vector]) -> f64 {
    edges(piece).map(|[a, b]| (b - a).length()).sum()
}
