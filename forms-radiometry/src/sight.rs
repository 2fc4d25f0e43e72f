//! Camera view: traces a camera ray to the first surface that it hits and returns the colour seen
//! along it.

use crate::camera::Camera;
use crate::geometry::Face;
use crate::irradiance::{DirectLight, Met, Receiving};
use crate::scene::{DiffuseScene, Scene, SceneError};
use crate::spectrum::{Colour, add_scaled, band_colours};
use std::f64::consts::PI;

/// A scene as seen by a camera.
pub(crate) struct Sight<'s> {
    scene: DiffuseScene<'s>,
    camera: &'s Camera,
    light: DirectLight<'s>,
    paints: Vec<Paint>,
}

/// The colours of a surface.
struct Paint {
    emitted: Colour,
    /// Colour reflected per unit of irradiance in each band: ρ/π times the colour of the band.
    reflected: Vec<Colour>,
}

/// Result of a camera ray.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sample {
    /// The first surface that the ray hits, if any.
    pub(crate) surface: Option<usize>,
    /// Linear sRGB.
    pub(crate) colour: Colour,
}

/// Buffers that are reused from ray to ray.
#[derive(Default)]
pub(crate) struct Tracing {
    lists: Receiving,
    irradiance: Vec<f64>,
}

impl<'s> Sight<'s> {
    pub(crate) fn new(scene: &'s Scene, camera: &'s Camera) -> Result<Self, Vec<SceneError>> {
        let scene = DiffuseScene::of(scene)?;
        let bands = band_colours(scene.scene);
        let paints = (0..scene.polygons.len()).map(|surface| Paint::new(&scene, surface, &bands)).collect();
        Ok(Self { light: DirectLight::of(scene.clone()), scene, camera, paints })
    }

    /// Returns the surface and the colour seen at the film point (x, y): L = Lₑ + ρ E/π on a
    /// diffuse surface, black outside the scene.
    pub(crate) fn sample(&self, x: f64, y: f64, tracing: &mut Tracing) -> Sample {
        let direction = self.camera.direction(x, y);
        let Some(Met { face, position }) = self.light.first(self.camera.origin, direction) else {
            return Sample { surface: None, colour: [0.0; 3] };
        };
        let &Face { surface, is_back, normal, .. } = face;
        let mut colour = [0.0; 3];
        if !is_back || self.scene.scene.surfaces[surface].two_sided {
            tracing.irradiance.clear();
            tracing.irradiance.resize(self.scene.scene.band_count(), 0.0);
            self.light.add_irradiance(position, normal, &mut tracing.lists, &mut tracing.irradiance);
            let paint = &self.paints[surface];
            colour = paint.emitted;
            for (&irradiance, &reflected) in tracing.irradiance.iter().zip(&paint.reflected) {
                add_scaled(&mut colour, irradiance, reflected);
            }
        }
        Sample { surface: Some(surface), colour }
    }

    /// Whether a surface emits light.
    pub(crate) fn emits(&self, surface: usize) -> bool {
        self.scene.scene.surfaces[surface].emits()
    }
}

impl Paint {
    fn new(scene: &DiffuseScene, surface: usize, bands: &[Colour]) -> Self {
        let mut emitted = [0.0; 3];
        for (&radiance, &band) in scene.scene.surfaces[surface].radiance.iter().zip(bands) {
            add_scaled(&mut emitted, radiance, band);
        }
        let reflectance = scene.reflectances[surface].iter();
        let reflected = reflectance.zip(bands).map(|(rho, band)| band.map(|weight| rho / PI * weight));
        Self { emitted, reflected: reflected.collect() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Vector;
    use crate::scene::{ReceiverKind, read};

    /// A floor, a lamp above its left half, and to its right a two-sided screen that hangs lower;
    /// without bands.
    const SCENE: &str = r#"
        [[material]]
        name = "grey"
        kind = "diffuse"
        reflectance = 0.5
        [[surface]]
        name = "floor"
        material = "grey"
        polygon = [[-4, -4, 0], [4, -4, 0], [4, 4, 0], [-4, 4, 0]]
        [[surface]]
        name = "lamp"
        material = "grey"
        polygon = [[-3, -1, 2], [-3, 1, 2], [-1, 1, 2], [-1, -1, 2]]
        radiance = 3
        [[surface]]
        name = "screen"
        material = "grey"
        polygon = [[1, -1, 1], [3, -1, 1], [3, 1, 1], [1, 1, 1]]
        two_sided = true
        [[receiver]]
        name = "above"
        kind = "camera"
        origin = [0, 0, 8]
        target = [0, 0, 0]
        up = [0, 1, 0]
        fov = 90
        resolution = [16, 16]
        [[receiver]]
        name = "below"
        kind = "camera"
        origin = [0, 0, 0.25]
        target = [0, 0, 1]
        up = [0, 1, 0]
        fov = 150
        resolution = [100, 100]
    "#;

    /// Returns the surface index and the brightness that the camera with this name sees in the
    /// direction of a point.
    fn seen(camera: &str, x: f64, y: f64) -> (Option<usize>, f64) {
        let scene = read(SCENE, "sight.toml").unwrap();
        let receiver = scene.receivers.iter().find(|r| r.name == camera).unwrap();
        let ReceiverKind::Camera(camera) = &receiver.kind else { panic!("{camera} is a camera") };
        let sample = Sight::new(&scene, camera).unwrap().sample(x, y, &mut Tracing::default());
        (sample.surface, sample.colour[0])
    }

    fn irradiance(position: Vector, normal: Vector) -> f64 {
        let scene = read(SCENE, "sight.toml").unwrap();
        DirectLight::new(&scene).unwrap().irradiance(position, normal)[0]
    }

    #[test]
    fn a_diffuse_surface_brings_its_reflectance_times_irradiance_over_pi() {
        let expected = 0.5 / PI * irradiance(Vector::default(), Vector::new(0.0, 0.0, 1.0));
        let (surface, radiance) = seen("above", 8.0, 8.0);
        assert_eq!(surface, Some(0));
        assert!(expected > 0.05 && (radiance - expected).abs() < 1e-15, "{radiance} and {expected}");
    }

    #[test]
    fn a_lamp_brings_its_radiance_from_the_front_and_nothing_from_the_back() {
        assert_eq!(seen("above", 6.0, 8.0), (Some(1), 0.0));
        let right_of_the_middle = 50.0 + 50.0 * (2.0 / 1.75) / 75_f64.to_radians().tan();
        assert_eq!(seen("below", right_of_the_middle, 50.0).0, Some(1));
        assert_eq!(seen("below", right_of_the_middle, 50.0).1, 3.0);
    }

    #[test]
    fn a_two_sided_surface_reflects_on_the_side_that_is_seen() {
        let at = Vector::new(2.0, 0.0, 1.0);
        let expected = 0.5 / PI * irradiance(at, Vector::new(0.0, 0.0, 1.0));
        let (surface, radiance) = seen("above", 8.0 + 8.0 * (2.0 / 7.0), 8.0);
        assert_eq!(surface, Some(2));
        assert!(expected > 0.005 && (radiance - expected).abs() < 1e-14, "{radiance} and {expected}");
        let left_of_the_middle = 50.0 - 50.0 * (2.0 / 0.75) / 75_f64.to_radians().tan();
        assert_eq!(seen("below", left_of_the_middle, 50.0), (Some(2), 0.0));
    }

    #[test]
    fn outside_the_scene_there_is_nothing_to_see() {
        assert_eq!(seen("above", 0.5, 0.5), (None, 0.0));
    }
}
