//! Scenes in which light undergoes only extinction, or almost only extinction, so that the answer
//! can be computed analytically.

use super::optics::MediumOptics;
use super::tracer::Limits;
use crate::extinction::left;
use crate::scene::{MaterialKind, Medium, Scene, Surface};

impl<const N: usize> MediumOptics<N> {
    /// Returns the transmittance over a distance, which can be infinite.
    pub(super) fn transmittance(&self, distance: f64) -> [f64; N] {
        self.extinction.map(|extinction| left(extinction, distance))
    }
}

/// Returns the extinction in each band if light undergoes nothing else: no medium scatters it, and
/// the conditions of [`unturned`] hold. `None` if direct light does not count.
pub(crate) fn extinction_alone(scene: &Scene, limits: &Limits) -> Option<Vec<f64>> {
    let medium = &scene.media[scene.ambient.medium?];
    let is_scattered =
        limits.scatterings != Some(0) && medium.scattering.iter().any(|&scattering| scattering > 0.0);
    (limits.direct && !is_scattered).then(|| unturned(scene, limits)).flatten()
}

/// Returns the medium and its extinction in each band if single scattering is requested, all light
/// sources are point or distant lights, and the conditions of [`unturned`] hold.
pub(crate) fn scattering_once<'s>(scene: &'s Scene, limits: &Limits) -> Option<(&'s Medium, Vec<f64>)> {
    let medium = &scene.media[scene.ambient.medium?];
    let is_scattered =
        limits.scatterings == Some(1) && medium.scattering.iter().any(|&scattering| scattering > 0.0);
    let is_alone = limits.direct && is_scattered && !scene.surfaces.iter().any(Surface::emits);
    // directly visible surfaces reflect towards the eye, whatever the limit on reflections
    let limits = Limits { reflections: None, ..*limits };
    is_alone.then(|| unturned(scene, &limits)).flatten().map(|extinction| (medium, extinction))
}

/// Returns the extinction in each band if one medium fills the scene and no surface reflects or
/// refracts light; diffuse reflection is allowed if the limits exclude it. `None` if there is no
/// extinction in any band, or if ambient radiance enters in a band without extinction.
fn unturned(scene: &Scene, limits: &Limits) -> Option<Vec<f64>> {
    let medium = &scene.media[scene.ambient.medium?];
    let is_black = |surface: &Surface| match &scene.materials[surface.material].kind {
        MaterialKind::Diffuse { reflectance } => {
            limits.reflections == Some(0) || reflectance.iter().all(|&reflectance| reflectance == 0.0)
        }
        MaterialKind::Mirror { .. }
        | MaterialKind::Dielectric { .. }
        | MaterialKind::Conductor { .. }
        | MaterialKind::Plastic { .. }
        | MaterialKind::Rough(_) => false,
    };
    let both = medium.absorption.iter().zip(&medium.scattering);
    let extinction: Vec<f64> = both.map(|(absorption, scattering)| absorption + scattering).collect();
    let comes_in = |(extinction, outside): (&f64, &f64)| *extinction == 0.0 && *outside > 0.0;
    let is_alone = extinction.iter().any(|&extinction| extinction > 0.0)
        && scene.lights.iter().all(|light| light.cone.is_none())
        && scene.surfaces.iter().all(is_black)
        && !extinction.iter().zip(&scene.ambient.radiance).any(comes_in);
    is_alone.then_some(extinction)
}
