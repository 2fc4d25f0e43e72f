//! Supported features: nearly everything that a scene file can describe is simulated. A scene that
//! requests more is rejected here, with the place of each unsupported request, so that an answer
//! never silently belongs to a different scene.
//!
//! The parser does not depend on this list. An entry is removed when a solver supports the feature.

use super::effect::{Effect, Force};
use super::error::SceneError;
use super::model::{Light, LightKind, MaterialKind, Receiver, ReceiverKind, Scene, Shape, Surface};
use super::place::Place;

/// Returns an error for each requested feature that is not simulated, in the order of the file. A
/// scene for which this list is empty is simulated unchanged.
pub fn not_simulated(scene: &Scene) -> Vec<SceneError> {
    let mut refused = Refusals::default();
    scene.receivers.iter().for_each(|receiver| refused.receiver(scene, receiver));
    scene.receivers.iter().for_each(|receiver| refused.lights_at(scene, receiver));
    refused.beams(scene);
    refused.in_order()
}

#[derive(Default)]
struct Refusals {
    errors: Vec<(usize, SceneError)>,
}

impl Refusals {
    fn refuse(&mut self, place: &Place, what: &str, simulated: &str) {
        let message = format!("{what} is not supported");
        self.errors.push((place.order(), SceneError::new(place, message, simulated)));
    }

    fn in_order(mut self) -> Vec<SceneError> {
        self.errors.sort_by_key(|(start, _)| *start);
        self.errors.into_iter().map(|(_, error)| error).collect()
    }

    fn receiver(&mut self, scene: &Scene, receiver: &Receiver) {
        if let ReceiverKind::Surface { surface, grid: Some(_), .. } = receiver.kind {
            let shape = match scene.surfaces[surface].shape {
                Shape::Polygon(_) => return,
                Shape::Disk(disk) if !disk.is_annulus() => return,
                Shape::Disk(_) => "annulus",
                Shape::Mesh(_) => "mesh",
                Shape::Sphere(_) => "sphere",
                Shape::Quadric(quadric) => quadric.name(),
            };
            let what = format!("the map of a {shape}");
            self.refuse(&receiver.place, &what, "a receiver without `grid`");
        }
        if let Some(time) = receiver.time.as_ref().filter(|_| receiver.kind.has_cells()) {
            let (what, simulated) = match receiver.kind {
                ReceiverKind::Points(_) => {
                    ("many points", "a receiver without `time`, or with one `position`")
                }
                ReceiverKind::Faces { .. } => ("faces", "a receiver without `time`, or kind = \"surface\""),
                _ => ("pixels and map cells", "a receiver without `time`, or one without pixels or `grid`"),
            };
            self.refuse(&time.place, &format!("the time resolution of {what}"), simulated);
        }
    }

    /// Rejects a receiver with a point at a point light, where its light is infinite.
    fn lights_at(&mut self, scene: &Scene, receiver: &Receiver) {
        let is_at = |light: &&Light| match light.kind {
            LightKind::Point { position, .. } => receiver.kind.points().any(|(point, _)| point == position),
            LightKind::Distant { .. } => false,
        };
        if let Some(light) = scene.lights.iter().find(is_at) {
            let name = if light.name.is_empty() { String::new() } else { format!(" `{}`", light.name) };
            let message = format!(
                "the receiver `{}` is at the point light{name}, whose irradiance is infinite there",
                receiver.name
            );
            let error = SceneError::new(&receiver.place, message, "a receiver beside the light");
            self.errors.push((receiver.place.order(), error));
        }
    }

    fn coat(&mut self, surface: &Surface) {
        let what = format!("light from point or distant lights that the coat of `{}` reflects", surface.name);
        let expected = "diffuse surfaces, or area lights: surfaces with a radiance";
        self.refuse(&surface.place, &what, expected);
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
                MaterialKind::Diffuse { .. } | MaterialKind::Rough(_) => [false; 2],
                MaterialKind::Plastic { .. } if is_off(Effect::Mirror) => [false; 2],
                MaterialKind::Plastic { .. } => {
                    self.coat(surface);
                    continue;
                }
                MaterialKind::Mirror { .. } | MaterialKind::Conductor { .. } => {
                    [false, !is_off(Effect::Mirror)]
                }
                MaterialKind::Dielectric { inside } => {
                    let index = &scene.media[*inside].index;
                    let differs = (0..index.len()).any(|band| index[band] != around(band));
                    [differs && !is_off(Effect::Refraction); 2]
                }
            };
            let is_curved = surface.shape.is_curved() || surface.shape.is_smooth();
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
}
