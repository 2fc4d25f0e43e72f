//! The brightest place: lights become an irradiance that no place of a face exceeds.
//!
//! ```text
//! a face of radiance L, of area A, at the distance r or more   π L min(1, A/(π r²))   if the two face each other
//! from outside, radiance L                                     π L
//! a point of intensity I, at the height h, at r or more        I h/r³                 if it reaches some of the face
//! from far away, irradiance E                                  E cos θ                the same
//! ```
//! Of round surfaces, which bulge beyond their pieces, nothing is said but that a cosine and a form factor are at most 1.

use super::gather::Transport;
use super::shadows::spectrum;
use super::system::{is_reflecting, reflectance};
use crate::faces::emits;
use crate::geometry::{Face, distance_of_boxes};
use crate::scene::{Light, LightKind, Scene};
use std::f64::consts::PI;

/// The most that comes straight from lights to a place of a face that reflects, in any band.
pub(crate) fn most_direct(scene: &Scene, transport: &Transport) -> f64 {
    let on_face = |face: &Face| {
        let mut most = most_of_beams(face, scene, transport);
        for (most, radiance) in most.iter_mut().zip(&scene.ambient.radiance) {
            *most += PI * radiance;
        }
        for other in transport.faces.iter().filter(|other| emits(scene, other)) {
            let factor = PI * most_of_face((face, other), scene, transport);
            let radiances = &scene.surfaces[other.surface].radiance;
            most.iter_mut().zip(radiances).for_each(|(most, radiance)| *most += factor * radiance);
        }
        most.into_iter().fold(0.0, f64::max)
    };
    let reflecting = transport.faces.iter().filter(|face| is_reflecting(scene, face));
    reflecting.map(on_face).fold(0.0, f64::max)
}

/// The largest radiance that a face reflects of what comes straight from lights without extent, for each band.
pub(crate) fn most_reflected_of_beams(scene: &Scene, transport: &Transport) -> Vec<f64> {
    let mut largest = vec![0.0_f64; scene.band_count()];
    for face in transport.faces.iter().filter(|face| is_reflecting(scene, face)) {
        let arriving = most_of_beams(face, scene, transport);
        for ((largest, arriving), rho) in
            largest.iter_mut().zip(arriving).zip(reflectance(scene, face.surface))
        {
            *largest = largest.max(rho * arriving / PI);
        }
    }
    largest
}

/// The most that comes straight from lights without extent to a place of a face, for each band.
pub(super) fn most_of_beams(face: &Face, scene: &Scene, transport: &Transport) -> Vec<f64> {
    let mut most = vec![0.0; scene.band_count()];
    for light in &scene.lights {
        let factor = most_of_light(face, light, scene, transport);
        let is_far = matches!(light.kind, LightKind::Distant { .. });
        for (band, (most, of_band)) in most.iter_mut().zip(spectrum(light)).enumerate() {
            if !is_far || scene.is_lit_from_afar(band) {
                *most += factor * of_band;
            }
        }
    }
    most
}

/// The largest form factor of a place of a face to another face.
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

/// What is multiplied by the intensity, or the irradiance, of a light.
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
