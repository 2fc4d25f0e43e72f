//! Direct irradiance: a scene becomes a list of luminaires; a point and a normal become the light that falls
//! there.
//!
//! The only error is rounding: form factors are Lambert's closed form, and what hides a lamp is cut out of
//! it.

use crate::geometry::{Luminaire, Vector, Workspace, resolution};
use crate::kernels::irradiance;
use crate::scene::{DiffuseScene, ReceiverKind, Scene, SceneError};

/// A scene prepared for direct light.
#[derive(Clone, Debug)]
pub struct DirectLight<'s> {
    scene: DiffuseScene<'s>,
    /// Luminaires, each with the index of the surface that it belongs to.
    luminaires: Vec<(usize, Luminaire)>,
}

/// The direct irradiance of a point receiver.
#[derive(Clone, Debug, PartialEq)]
pub struct ReceiverResult {
    /// The receiver's name.
    pub receiver: String,
    /// Irradiance in W/m², per band.
    pub irradiance: Vec<f64>,
    /// What the irradiance would be if no surface hid a lamp, in W/m², per band.
    pub unoccluded: Vec<f64>,
}

/// The direct irradiance of every point receiver of a scene, in the order of the file. Light that surfaces
/// pass on to each other is not part of it. A camera's answer is a picture. A scene that asks for what is not
/// simulated is refused with all of it.
pub fn simulate_direct(scene: &Scene) -> Result<Vec<ReceiverResult>, Vec<SceneError>> {
    let light = DirectLight::new(scene)?;
    let mut work = Workspace::default();
    let mut results = Vec::new();
    for receiver in &scene.receivers {
        let ReceiverKind::Point { position, normal } = receiver.kind else { continue };
        let mut unoccluded = vec![0.0; scene.band_count()];
        light.add_unoccluded(position, normal, &mut work, &mut unoccluded);
        let irradiance = light.irradiance(position, normal);
        results.push(ReceiverResult { receiver: receiver.name.clone(), irradiance, unoccluded });
    }
    Ok(results)
}

impl<'s> DirectLight<'s> {
    /// Prepares a scene: for each side of each lamp, the surfaces that can come before it are kept. A scene that
    /// asks for what is not simulated is refused with all of it.
    pub fn new(scene: &'s Scene) -> Result<Self, Vec<SceneError>> {
        DiffuseScene::of(scene).map(Self::of)
    }

    pub(crate) fn of(scene: DiffuseScene<'s>) -> Self {
        let polygons = scene.polygons.iter().copied();
        let resolution = resolution(polygons.clone());
        let mut luminaires = Vec::new();
        for (index, surface) in scene.scene.surfaces.iter().enumerate().filter(|(_, surface)| surface.emits())
        {
            for &front in if surface.two_sided { &[true, false][..] } else { &[true] } {
                let sides = Luminaire::of(scene.polygons[index], front, polygons.clone(), resolution);
                luminaires.extend(sides.into_iter().map(|luminaire| (index, luminaire)));
            }
        }
        Self { scene, luminaires }
    }

    /// The irradiance at a point in W/m², per band, on the side to which `normal` points. The normal need not
    /// be a unit vector; if it is zero, the irradiance is not a number.
    pub fn irradiance(&self, position: Vector, normal: Vector) -> Vec<f64> {
        let Some(normal) = normal.unit() else { return vec![f64::NAN; self.scene.scene.band_count()] };
        let mut sum = vec![0.0; self.scene.scene.band_count()];
        self.add_irradiance(position, normal, &mut Workspace::default(), &mut sum);
        sum
    }

    /// Adds to `sum` the irradiance of a receiver with a unit normal: E = Σ π F L over the luminaires.
    pub(crate) fn add_irradiance(
        &self,
        position: Vector,
        normal: Vector,
        work: &mut Workspace,
        sum: &mut [f64],
    ) {
        for (surface, luminaire) in &self.luminaires {
            self.add(*surface, luminaire.visible_form_factor(position, normal, work), sum);
        }
    }

    fn add_unoccluded(&self, position: Vector, normal: Vector, work: &mut Workspace, sum: &mut [f64]) {
        for (surface, luminaire) in &self.luminaires {
            self.add(*surface, luminaire.unoccluded_form_factor(position, normal, work), sum);
        }
    }

    fn add(&self, surface: usize, form_factor: f64, sum: &mut [f64]) {
        if form_factor != 0.0 {
            for (sum, &radiance) in sum.iter_mut().zip(&self.scene.scene.surfaces[surface].radiance) {
                *sum += irradiance(form_factor, radiance);
            }
        }
    }
}
