//! Radiances: upper bounds on the light of a scene that samples may have missed, band by band.

use crate::effects::EffectSet;
use crate::extinction::is_lit_from_afar;
use crate::paths::World;
use crate::radiosity::reflectance;
use crate::scene::{Effect, Scene};

/// Returns the radiance that arrives from outside, for each band.
pub(super) fn outside(scene: &Scene) -> Vec<f64> {
    let radiance = |band: usize| scene.ambient.radiance.get(band).copied().unwrap_or(0.0);
    (0..scene.band_count())
        .map(|band| if is_lit_from_afar(scene, band) { radiance(band) } else { 0.0 })
        .collect()
}

/// Returns the largest part of light that a surface reflects to all sides, or a medium scatters.
pub(super) fn passed_on(scene: &Scene, effects: EffectSet) -> f64 {
    if effects.has(Effect::Scattering) {
        return 1.0;
    }
    (0..scene.surfaces.len()).flat_map(|surface| reflectance(scene, surface)).copied().fold(0.0, f64::max)
}

/// Returns, for each band, the brightest radiance: this part of the radiance of surfaces, light
/// from outside, or their light that a surface reflects.
pub(super) fn brightest(scene: &Scene, reflected: &[f64], outside: &[f64], part: f64) -> Vec<f64> {
    let mut brightest = reflected.to_vec();
    add_brighter(&mut brightest, outside, 1.0);
    scene.surfaces.iter().for_each(|surface| add_brighter(&mut brightest, &surface.radiance, part));
    brightest
}

/// Returns, for each band, the brightest radiance that is found only by chance: from outside, of
/// surfaces via curved mirrors and glass, or this part of the light that a surface reflects.
pub(super) fn by_chance(world: &World, outside: &[f64], (reflected, part): (&[f64], f64)) -> Vec<f64> {
    let mut brightest = outside.to_vec();
    add_brighter(&mut brightest, reflected, part);
    let turned = world.turned_by_chance();
    world.scene.surfaces.iter().for_each(|surface| add_brighter(&mut brightest, &surface.radiance, turned));
    brightest
}

/// Raises each band to this part of a radiance where that is more.
fn add_brighter(brightest: &mut [f64], radiance: &[f64], part: f64) {
    brightest.iter_mut().zip(radiance).for_each(|(most, &radiance)| *most = most.max(part * radiance));
}
