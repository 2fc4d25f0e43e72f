//! Radiances: upper bounds on the light of a scene that samples may have missed, band by band.

use super::Task;
use crate::effects::EffectSet;
use crate::extinction::is_lit_from_afar;
use crate::paths::{Estimand, World};
use crate::radiosity::{Transport, most_reflected, reflectance};
use crate::scene::{Effect, Scene};

/// Bounds of the radiances of a scene, each for every band.
pub(super) struct Radiances<'w> {
    world: &'w World,
    outside: Vec<f64>,
    /// The brightest light that a surface reflects.
    reflected: Vec<f64>,
    /// The largest part of light that a surface or a medium passes on.
    passed_on: f64,
    /// Whether receivers get light that surfaces reflect.
    is_reflected: bool,
    /// Whether any light reaches a point: direct light, or light that something turns.
    reaches_points: bool,
    /// The brightest light where luminaires are not sampled by next-event estimation, and where they
    /// are.
    brightest: [Vec<f64>; 2],
}

impl<'w> Radiances<'w> {
    /// Returns the bounds for the scene of a task, whose faces are given without any occlusion.
    pub(super) fn of(task: Task<'w>, unhidden: &Transport) -> Self {
        let (world, scene) = (task.world, &*task.world.scene);
        let (outside, reflected) = (outside(scene), most_reflected(scene, unhidden));
        let passed_on = passed_on(scene, EffectSet::of_scene(scene));
        let brightest = [1.0, passed_on].map(|part| brightest(scene, &reflected, &outside, part));
        let is_reflected = task.effects.orders != Some(0);
        let turning = [Effect::Direct, Effect::Scattering, Effect::Mirror, Effect::Refraction];
        let reaches_points = is_reflected || turning.iter().any(|&effect| task.effects.has(effect));
        Self { world, outside, reflected, passed_on, is_reflected, reaches_points, brightest }
    }

    /// Returns for each band the largest value of an estimand that any light causes, and that light
    /// causes that is found only by chance. Of a place that a near light source makes bright, the
    /// cells or pixels around a cell or a pixel tell.
    pub(super) fn largest(&self, estimand: &Estimand, is_cell: bool) -> [Vec<f64>; 2] {
        // luminaires are sampled by next-event estimation, but from nowhere along the first ray of
        // an eye, which sees the reflection of the bright place
        let is_looked_for = !matches!(estimand, Estimand::Sight { .. } | Estimand::Pixel { .. });
        if is_looked_for && !self.reaches_points {
            return [0, 1].map(|_| vec![0.0; self.reflected.len()]);
        }
        let part = match is_looked_for {
            _ if is_cell || !self.is_reflected => 0.0,
            true => 1.0,
            false => self.passed_on,
        };
        let by_chance = by_chance(self.world, &self.outside, (&self.reflected, part));
        [&self.brightest[usize::from(is_looked_for)], &by_chance]
            .map(|radiances| radiances.iter().map(|&radiance| estimand.largest(radiance)).collect())
    }
}

/// Returns the radiance that arrives from outside, for each band.
fn outside(scene: &Scene) -> Vec<f64> {
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
fn brightest(scene: &Scene, reflected: &[f64], outside: &[f64], part: f64) -> Vec<f64> {
    let mut brightest = reflected.to_vec();
    add_brighter(&mut brightest, outside, 1.0);
    scene.surfaces.iter().for_each(|surface| add_brighter(&mut brightest, &surface.radiance, part));
    brightest
}

/// Returns, for each band, the brightest radiance that is found only by chance: from outside, of
/// surfaces via curved mirrors and glass, or this part of the light that a surface reflects.
fn by_chance(world: &World, outside: &[f64], (reflected, part): (&[f64], f64)) -> Vec<f64> {
    let is_by_chance = world.finds_outside_by_chance();
    let mut brightest: Vec<f64> =
        outside.iter().map(|&radiance| if is_by_chance { radiance } else { 0.0 }).collect();
    add_brighter(&mut brightest, reflected, part);
    let turned = world.turned_by_chance();
    world.scene.surfaces.iter().for_each(|surface| add_brighter(&mut brightest, &surface.radiance, turned));
    brightest
}

/// Raises each band to this part of a radiance where that is more.
fn add_brighter(brightest: &mut [f64], radiance: &[f64], part: f64) {
    brightest.iter_mut().zip(radiance).for_each(|(most, &radiance)| *most = most.max(part * radiance));
}
