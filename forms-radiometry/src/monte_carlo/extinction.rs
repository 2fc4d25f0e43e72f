//! Where extinction is all, or nearly all, that happens to light, so that it can be computed.

use super::optics::MediumOptics;
use super::path::Limits;
use crate::extinction::left;
use crate::scene::{MaterialKind, Medium, Scene, Surface};

impl<const N: usize> MediumOptics<N> {
    /// What is left after a distance, which may be without end.
    pub(super) fn transmittance(&self, distance: f64) -> [f64; N] {
        self.extinction.map(|extinction| left(extinction, distance))
    }
}

/// The extinction in each band where that is all that happens to light: it is scattered by nothing, and as [`unturned`] says. None where lights do
/// not count.
pub(crate) fn extinction_alone(scene: &Scene, limits: &Limits) -> Option<Vec<f64>> {
    let medium = &scene.media[scene.ambient.medium?];
    let is_scattered =
        limits.scatterings != Some(0) && medium.scattering.iter().any(|&scattering| scattering > 0.0);
    (limits.direct && !is_scattered).then(|| unturned(scene, limits)).flatten()
}

/// The medium and its extinction in each band where a single scattering is asked for, the only lights are points and far away, and all else is as
/// [`unturned`] says.
pub(crate) fn scattering_once<'s>(scene: &'s Scene, limits: &Limits) -> Option<(&'s Medium, Vec<f64>)> {
    let medium = &scene.media[scene.ambient.medium?];
    let is_scattered =
        limits.scatterings == Some(1) && medium.scattering.iter().any(|&scattering| scattering > 0.0);
    let is_alone = limits.direct && is_scattered && !scene.surfaces.iter().any(Surface::emits);
    // surfaces that are seen reflect to the eye, whatever is asked for
    let limits = Limits { reflections: None, ..*limits };
    is_alone.then(|| unturned(scene, &limits)).flatten().map(|extinction| (medium, extinction))
}

/// The extinction in each band where one medium is everywhere, and no surface reflects or bends light, or only some orders are asked for, and none
/// of these. None where nothing is taken away, or light comes from outside through a medium that lets it pass.
fn unturned(scene: &Scene, limits: &Limits) -> Option<Vec<f64>> {
    let medium = &scene.media[scene.ambient.medium?];
    let is_black = |surface: &Surface| match &scene.materials[surface.material].kind {
        MaterialKind::Diffuse { reflectance } => {
            limits.reflections == Some(0) || reflectance.iter().all(|&reflectance| reflectance == 0.0)
        }
        MaterialKind::Mirror { .. } | MaterialKind::Dielectric { .. } | MaterialKind::Conductor { .. } => {
            false
        }
    };
    let both = medium.absorption.iter().zip(&medium.scattering);
    let extinction: Vec<f64> = both.map(|(absorption, scattering)| absorption + scattering).collect();
    let comes_in = |(extinction, outside): (&f64, &f64)| *extinction == 0.0 && *outside > 0.0;
    let is_alone = extinction.iter().any(|&extinction| extinction > 0.0)
        && scene.surfaces.iter().all(is_black)
        && !extinction.iter().zip(&scene.ambient.radiance).any(comes_in);
    is_alone.then_some(extinction)
}
