//! Direct irradiance: a scene becomes a list of luminaires; from a position and a normal follows
//! the irradiance there.
//!
//! The only error is rounding: form factors are evaluated by Lambert's closed form, and occluders
//! are clipped out of each luminaire.

use crate::faces::{emits, faces};
use crate::geometry::{Between, Face, Screens, Vector, Workspace, form_factor_of_pieces};
use crate::kernels::irradiance;
use crate::scene::{DiffuseScene, ReceiverKind, Scene, SceneError, WorkingScene};

/// A scene preprocessed for direct light.
#[derive(Clone, Debug)]
pub struct DirectLight<'s> {
    scene: DiffuseScene<'s>,
    faces: Vec<Face>,
    screens: Screens,
    /// The indices of the faces that emit.
    luminaires: Vec<usize>,
    /// Scale factor from scene coordinates to the working units of the faces.
    factor: f64,
}

/// First intersection of a ray.
pub(crate) struct Met<'l> {
    pub(crate) face: &'l Face,
    /// The intersection point, in working units.
    pub(crate) position: Vector,
}

/// The direct irradiance of a point receiver.
#[derive(Clone, Debug, PartialEq)]
pub struct ReceiverResult {
    /// The receiver's name.
    pub receiver: String,
    /// Irradiance in W/m², per band.
    pub irradiance: Vec<f64>,
    /// Irradiance without occlusion of the luminaires, in W/m², per band.
    pub unoccluded: Vec<f64>,
}

/// Buffers that are reused from receiver to receiver.
#[derive(Clone, Debug, Default)]
pub(crate) struct Receiving {
    between: Vec<u32>,
    work: Workspace,
}

/// Computes the direct irradiance of every point receiver of a scene, in the order of the file.
/// Interreflected light is not included. Camera receivers are skipped: their result is a picture.
/// If the scene requests features that are not simulated, returns an error for each of them.
pub fn simulate_direct(scene: &Scene) -> Result<Vec<ReceiverResult>, Vec<SceneError>> {
    let light = DirectLight::new(scene)?;
    let mut lists = Receiving::default();
    let mut results = Vec::new();
    for receiver in &scene.receivers {
        let ReceiverKind::Point { position, normal } = receiver.kind else { continue };
        let mut unoccluded = vec![0.0; scene.band_count()];
        light.add_unoccluded(light.factor * position, normal, &mut lists, &mut unoccluded);
        let irradiance = light.irradiance(position, normal);
        results.push(ReceiverResult { receiver: receiver.name.clone(), irradiance, unoccluded });
    }
    Ok(results)
}

impl<'s> DirectLight<'s> {
    /// Prepares a scene: tessellates it, lists its luminaires, and builds the tree of occluders. If
    /// the scene requests features that are not simulated, returns an error for each of them.
    pub fn new(scene: &'s Scene) -> Result<Self, Vec<SceneError>> {
        DiffuseScene::of(scene).map(Self::of)
    }

    pub(crate) fn of(scene: DiffuseScene<'s>) -> Self {
        let WorkingScene { scene: working, factor, .. } = scene.scene.in_working_units();
        let faces = faces(&working, 0);
        let luminaires = (0..faces.len()).filter(|&index| emits(&working, &faces[index])).collect();
        Self { screens: Screens::of(&faces), luminaires, faces, factor, scene }
    }

    /// Returns the first intersection of a ray with the scene.
    pub(crate) fn first(&self, origin: Vector, direction: Vector) -> Option<Met<'_>> {
        let origin = self.factor * origin;
        let hit = self.screens.first(origin, direction)?;
        Some(Met { face: &self.faces[hit.face], position: origin + hit.distance * direction })
    }

    /// Returns the irradiance at a point in W/m², per band, on the side to which `normal` points.
    /// The normal need not be a unit vector; if it is zero, the irradiance is NaN.
    pub fn irradiance(&self, position: Vector, normal: Vector) -> Vec<f64> {
        let Some(normal) = normal.unit() else { return vec![f64::NAN; self.scene.scene.band_count()] };
        let mut sum = vec![0.0; self.scene.scene.band_count()];
        self.add_irradiance(self.factor * position, normal, &mut Receiving::default(), &mut sum);
        sum
    }

    /// Adds to `sum` the irradiance of a receiver with a unit normal, in working units: E = Σ π F L
    /// over the luminaires.
    pub(crate) fn add_irradiance(
        &self,
        position: Vector,
        normal: Vector,
        Receiving { between, work }: &mut Receiving,
        sum: &mut [f64],
    ) {
        for Face { surface, vertices, normal: facing, .. } in self.luminaires() {
            let hidden = self.screens.between(&[position], Some(normal), vertices, *facing, between);
            if hidden != Between::All {
                let seen = self.screens.visible(position, Some(normal), vertices, *facing, between, work);
                self.add(*surface, form_factor_of_pieces(seen, normal), sum);
            }
        }
    }

    fn add_unoccluded(&self, position: Vector, normal: Vector, lists: &mut Receiving, sum: &mut [f64]) {
        for Face { surface, vertices, normal: facing, .. } in self.luminaires() {
            let all = self.screens.visible(position, Some(normal), vertices, *facing, &[], &mut lists.work);
            self.add(*surface, form_factor_of_pieces(all, normal), sum);
        }
    }

    fn luminaires(&self) -> impl Iterator<Item = &Face> {
        self.luminaires.iter().map(|&index| &self.faces[index])
    }

    fn add(&self, surface: usize, form_factor: f64, sum: &mut [f64]) {
        if form_factor != 0.0 {
            for (sum, &radiance) in sum.iter_mut().zip(&self.scene.scene.surfaces[surface].radiance) {
                *sum += irradiance(form_factor, radiance);
            }
        }
    }
}
