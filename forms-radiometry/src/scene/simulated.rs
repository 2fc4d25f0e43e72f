//! Supported features: nearly everything that a scene file can describe is simulated. A scene that
//! requests more is rejected here, with the place of each unsupported request, so that an answer
//! never silently belongs to a different scene. Pictures support less: direct light between
//! polygons.
//!
//! The parser does not depend on this list. An entry is removed when a solver supports the feature.

use super::effect::{Effect, Force};
use super::error::SceneError;
use super::model::{LightKind, MaterialKind, Receiver, ReceiverKind, Scene, Shape, Surface};
use super::place::Place;
use crate::geometry::Polygon;

/// A scene of diffuse polygons, the input of the solver for direct light.
#[derive(Clone, Debug)]
pub(crate) struct DiffuseScene<'s> {
    pub(crate) scene: &'s Scene,
    /// The shape of each surface.
    pub(crate) polygons: Vec<&'s Polygon>,
    /// The reflectance of each surface, per band.
    pub(crate) reflectances: Vec<&'s [f64]>,
}

impl<'s> DiffuseScene<'s> {
    /// Returns the scene as diffuse polygons, or an error for each feature beyond them.
    pub(crate) fn of(scene: &'s Scene) -> Result<Self, Vec<SceneError>> {
        let refused = not_pictured(scene);
        let polygons: Option<Vec<&Polygon>> =
            scene.surfaces.iter().map(|surface| surface.shape.as_polygon()).collect();
        let reflectances = scene.surfaces.iter().map(|surface| reflectance(scene, surface)).collect();
        match (polygons, reflectances) {
            (Some(polygons), Some(reflectances)) if refused.is_empty() => {
                Ok(Self { scene, polygons, reflectances })
            }
            _ => Err(refused),
        }
    }
}

fn reflectance<'s>(scene: &'s Scene, surface: &Surface) -> Option<&'s [f64]> {
    match &scene.materials[surface.material].kind {
        MaterialKind::Diffuse { reflectance } => Some(reflectance),
        MaterialKind::Mirror { .. } | MaterialKind::Dielectric { .. } | MaterialKind::Conductor { .. } => {
            None
        }
    }
}

/// Returns an error for each requested feature that is not simulated, in the order of the file. A
/// scene for which this list is empty is simulated unchanged.
pub fn not_simulated(scene: &Scene) -> Vec<SceneError> {
    let mut refused = Refusals::default();
    scene.receivers.iter().for_each(|receiver| refused.receiver(scene, receiver));
    refused.beams(scene);
    refused.in_order()
}

/// Returns an error for each requested feature that pictures do not support.
fn not_pictured(scene: &Scene) -> Vec<SceneError> {
    let mut refused = Refusals::default();
    refused.materials(scene);
    refused.media(scene);
    refused.shapes(scene);
    refused.lights(scene);
    let pictured = [Effect::Direct, Effect::Occlusion, Effect::Bands];
    refused.effects(scene, &pictured);
    for forced in &scene.solve.forced {
        if pictured.contains(&forced.effect) && forced.force == Force::Off {
            let what = format!("a picture without the effect `{}`", forced.effect.name());
            refused.refuse(&forced.place, &what, "\"on\"");
        }
    }
    refused.in_order()
}

#[derive(Default)]
struct Refusals {
    errors: Vec<(usize, SceneError)>,
}

impl Refusals {
    fn refuse(&mut self, place: &Place, what: &str, simulated: &str) {
        let message = format!("{what} is not supported");
        self.errors.push((place.start(), SceneError::new(place, message, simulated)));
    }

    fn in_order(mut self) -> Vec<SceneError> {
        self.errors.sort_by_key(|(start, _)| *start);
        self.errors.into_iter().map(|(_, error)| error).collect()
    }

    fn materials(&mut self, scene: &Scene) {
        for material in &scene.materials {
            let kind = match material.kind {
                MaterialKind::Diffuse { .. } => continue,
                MaterialKind::Mirror { .. } => "mirror",
                MaterialKind::Dielectric { .. } => "dielectric",
                MaterialKind::Conductor { .. } => "conductor",
            };
            let what = format!("the material `{}` of kind `{kind}`", material.name);
            self.refuse(&material.place, &what, "a material of kind `diffuse`");
        }
    }

    fn shapes(&mut self, scene: &Scene) {
        for surface in &scene.surfaces {
            let shape = match surface.shape {
                Shape::Polygon(_) => continue,
                Shape::Mesh(_) => "a mesh",
                Shape::Sphere(_) => "a sphere",
                Shape::Disk(_) => "a disk",
            };
            self.refuse(&surface.place, &format!("the surface `{}`, {shape},", surface.name), "a polygon");
        }
    }

    fn lights(&mut self, scene: &Scene) {
        for light in &scene.lights {
            let kind = match light.kind {
                LightKind::Point { .. } => "a point light",
                LightKind::Distant { .. } => "a distant light",
            };
            self.refuse(&light.place, kind, "a surface with a radiance");
        }
        if scene.ambient.radiance.iter().any(|&radiance| radiance > 0.0) {
            self.refuse(&scene.ambient.place, "ambient radiance", "radiance = 0");
        }
    }

    fn media(&mut self, scene: &Scene) {
        let ambient = &scene.ambient;
        if let Some(medium) = ambient.medium.map(|medium| &scene.media[medium]).filter(|m| !m.is_vacuum()) {
            self.refuse(&ambient.place, &format!("a scene filled with `{}`", medium.name), "vacuum");
        }
    }

    fn receiver(&mut self, scene: &Scene, receiver: &Receiver) {
        if let ReceiverKind::Surface { surface, grid: Some(_) } = receiver.kind {
            let shape = match scene.surfaces[surface].shape {
                Shape::Polygon(_) | Shape::Disk(_) => return,
                Shape::Mesh(_) => "mesh",
                Shape::Sphere(_) => "sphere",
            };
            let what = format!("the map of a {shape}");
            self.refuse(&receiver.place, &what, "a receiver without `grid`");
        }
        let is_raster =
            matches!(receiver.kind, ReceiverKind::Camera(_) | ReceiverKind::Surface { grid: Some(_), .. });
        if let Some(time) = receiver.time.as_ref().filter(|_| is_raster) {
            self.refuse(
                &time.place,
                "the time resolution of pixels and map cells",
                "a receiver without `time`, or one without pixels or `grid`",
            );
        }
    }

    /// Rejects light from a point or from a single direction that a curved surface reflects or
    /// refracts: no path from a receiver finds it. The same holds for light of a point behind a
    /// refracting boundary. Flat surfaces are handled by image sources.
    fn beams(&mut self, scene: &Scene) {
        let is_off = |effect| scene.solve.forced.iter().any(|f| f.effect == effect && f.force == Force::Off);
        let has_point = scene.lights.iter().any(|light| matches!(light.kind, LightKind::Point { .. }));
        let around = |band: usize| scene.ambient.medium.map_or(1.0, |medium| scene.media[medium].index[band]);
        for surface in scene.surfaces.iter().filter(|_| !scene.lights.is_empty()) {
            let [bends, mirrors] = match &scene.materials[surface.material].kind {
                MaterialKind::Diffuse { .. } => [false; 2],
                MaterialKind::Mirror { .. } | MaterialKind::Conductor { .. } => {
                    [false, !is_off(Effect::Mirror)]
                }
                MaterialKind::Dielectric { inside } => {
                    let index = &scene.media[*inside].index;
                    let differs = (0..index.len()).any(|band| index[band] != around(band));
                    [differs && !is_off(Effect::Refraction); 2]
                }
            };
            let is_curved = matches!(surface.shape, Shape::Sphere(_));
            if is_curved && mirrors {
                let what = format!(
                    "light from point or distant lights that the curved surface `{}` reflects or refracts",
                    surface.name
                );
                self.refuse(&surface.place, &what, "flat surfaces, or area lights: surfaces with a radiance");
            } else if bends && has_point {
                let what = format!("light from point lights that is refracted at `{}`", surface.name);
                self.refuse(
                    &surface.place,
                    &what,
                    "a distant light, or an area light: a surface with a radiance",
                );
            }
        }
    }

    /// Rejects effects that are not simulated, unless they are forced off.
    fn effects(&mut self, scene: &Scene, simulated: &[Effect]) {
        for forced in &scene.solve.forced {
            if !simulated.contains(&forced.effect) && forced.force != Force::Off {
                let name = forced.effect.name();
                self.refuse(&forced.place, &format!("the effect `{name}`"), "\"off\"");
            }
        }
    }
}
