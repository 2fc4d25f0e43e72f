//! Brightest place: bounds the direct irradiance on a face from above.
//!
//! ```text
//! face: radiance L, area A, at r or more           π L min(1, A/(π r²))  if both face each other
//! surroundings: radiance L                         π L
//! point light: intensity I, height h, at r or more I h/r³                if it reaches the face
//! distant light: irradiance E                      E cos θ               if it reaches the face
//! ```
//! Here r is a distance; a light reaches the face if it reaches any part of it. Disks and spheres
//! extend beyond their tessellation. For them the only bounds used are that a cosine and a form
//! factor are at most 1.

use super::point_lights::spectrum;
use super::reflectance::{is_reflecting, reflectance};
use super::transport::Transport;
use crate::extinction::is_lit_from_afar;
use crate::faces::emits;
use crate::scene::{Light, LightKind, Scene};
use crate::visibility::{Face, distance_of_boxes};
use std::f64::consts::PI;

/// Maximum number of pairs of reflecting and emitting faces whose distances are found.
const MOST_PAIRS: usize = 1 << 20;

/// Returns an upper bound on the direct irradiance on any face that reflects, in any band.
pub(crate) fn most_direct(scene: &Scene, transport: &Transport) -> f64 {
    let emitting: Vec<&Face> = transport.faces.iter().filter(|other| emits(scene, other)).collect();
    let on_face = |face: &Face| {
        let both = most_of_beams(face, scene, transport).into_iter();
        let both = both.zip(most_of_faces(face, &emitting, scene, transport));
        let outside = scene.ambient.radiance.iter().chain(std::iter::repeat(&0.0));
        both.zip(outside).map(|((beams, faces), outside)| beams + faces + PI * outside).fold(0.0, f64::max)
    };
    let reflecting = transport.faces.iter().filter(|face| is_reflecting(scene, face));
    reflecting.map(on_face).fold(0.0, f64::max)
}

/// Returns for each band the largest radiance that a face reflects of the direct light of surfaces,
/// and of point and distant lights. If surfaces are many, only their radiance is looked at.
pub(crate) fn most_reflected(scene: &Scene, transport: &Transport) -> Vec<f64> {
    let mut largest = vec![0.0_f64; scene.band_count()];
    let emitting: Vec<&Face> = transport.faces.iter().filter(|other| emits(scene, other)).collect();
    let reflecting: Vec<&Face> = transport.faces.iter().filter(|face| is_reflecting(scene, face)).collect();
    let are_many = emitting.len() * reflecting.len() > MOST_PAIRS;
    let brightest = |band: usize| {
        let radiances = scene.surfaces.iter().filter_map(|surface| surface.radiance.get(band));
        radiances.copied().fold(0.0, f64::max)
    };
    let of_all: Vec<f64> = (0..largest.len()).map(|band| PI * brightest(band)).collect();
    for face in reflecting {
        let of_beams = most_of_beams(face, scene, transport);
        let of_faces =
            if are_many { of_all.clone() } else { most_of_faces(face, &emitting, scene, transport) };
        for (band, rho) in reflectance(scene, face.surface).iter().enumerate() {
            // form factors add up to no more than 1
            let arriving = of_beams[band] + of_faces[band].min(of_all[band]);
            largest[band] = largest[band].max(rho * arriving / PI);
        }
    }
    largest
}

/// Returns for each band an upper bound on the irradiance of emitting faces on a face.
fn most_of_faces(face: &Face, emitting: &[&Face], scene: &Scene, transport: &Transport) -> Vec<f64> {
    let mut most = vec![0.0; scene.band_count()];
    for other in emitting {
        let factor = PI * most_of_face((face, other), scene, transport);
        let radiances = &scene.surfaces[other.surface].radiance;
        most.iter_mut().zip(radiances).for_each(|(most, radiance)| *most += factor * radiance);
    }
    most
}

/// Returns for each band an upper bound on the irradiance of point and distant lights on a face.
fn most_of_beams(face: &Face, scene: &Scene, transport: &Transport) -> Vec<f64> {
    let mut most = vec![0.0; scene.band_count()];
    for light in &scene.lights {
        let factor = most_of_light(face, light, scene, transport);
        let is_far = matches!(light.kind, LightKind::Distant { .. });
        for (band, (most, of_band)) in most.iter_mut().zip(spectrum(light)).enumerate() {
            if !is_far || is_lit_from_afar(scene, band) {
                *most += factor * of_band;
            }
        }
    }
    most
}

/// Returns how far the irradiance of a point light on a face may exceed its mean there, as the
/// largest ratio for any face that reflects; at least 1. A light that is near a face has a high and
/// narrow peak below it, and sends the face no more than half of its power.
pub(super) fn highest_peak(scene: &Scene, transport: &Transport) -> f64 {
    let is_near = |light: &&Light| matches!(light.kind, LightKind::Point { .. });
    let of_face = |face: &Face| {
        let of_light = |light| face.area * most_of_light(face, light, scene, transport) / (2.0 * PI);
        scene.lights.iter().filter(is_near).map(of_light).fold(1.0, f64::max)
    };
    let reflecting = transport.faces.iter().filter(|face| is_reflecting(scene, face));
    reflecting.map(of_face).fold(1.0, f64::max)
}

/// Returns an upper bound on the form factor from a point of a face to another face.
fn most_of_face((face, other): (&Face, &Face), scene: &Scene, transport: &Transport) -> f64 {
    if is_round(face, scene) || is_round(other, scene) {
        return 1.0;
    }
    let Face { vertices, normal, .. } = face;
    if !transport.screens.face_each_other(vertices, Some(*normal), &other.vertices, other.normal) {
        return 0.0;
    }
    let distance = distance_of_boxes(vertices, &other.vertices);
    (other.area / (PI * distance * distance)).min(1.0)
}

/// Returns the factor of the intensity, or of the irradiance, of a light in this bound.
fn most_of_light(face: &Face, light: &Light, scene: &Scene, transport: &Transport) -> f64 {
    let is_round = is_round(face, scene);
    if !is_round && !transport.may_reach(face, light) {
        return 0.0;
    }
    match light.kind {
        LightKind::Point { position, .. } => {
            let height = face.normal.dot(position - face.vertices[0]).max(0.0);
            let distance = distance_of_boxes(&face.vertices, &[position]).max(height);
            match (is_round, height > 0.0) {
                (true, _) => 1.0 / (distance * distance),
                (false, true) => height / (distance * distance * distance),
                (false, false) => 0.0,
            }
        }
        LightKind::Distant { .. } if is_round => 1.0,
        LightKind::Distant { direction, .. } => (-face.normal.dot(direction)).max(0.0),
    }
}

fn is_round(face: &Face, scene: &Scene) -> bool {
    scene.surfaces[face.surface].shape.is_round()
}
