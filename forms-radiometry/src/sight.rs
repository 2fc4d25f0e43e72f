//! Sight: a ray of a camera becomes the surface that it meets and the colour that it brings.

use crate::camera::Camera;
use crate::geometry::{Cone, Vector, Workspace, resolution};
use crate::irradiance::DirectLight;
use crate::scene::{Scene, Surface};
use crate::spectrum::{Colour, add_scaled, band_colours};
use std::f64::consts::PI;

/// A scene as seen by a camera.
pub(crate) struct Sight<'s> {
    scene: &'s Scene,
    camera: &'s Camera,
    light: DirectLight<'s>,
    views: Vec<View>,
    paints: Vec<Paint>,
}

/// A convex piece of a surface seen from the camera.
struct View {
    surface: usize,
    cone: Cone,
    /// The camera's distance from the piece's plane; negative behind it.
    distance: f64,
}

/// The colours of a surface.
struct Paint {
    emitted: Colour,
    /// What the irradiance in each band adds to the colour: ρ/π of the band's colour.
    reflected: Vec<Colour>,
}

/// What a ray brings.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sample {
    /// The surface that the ray meets first, if any.
    pub(crate) surface: Option<usize>,
    /// Linear sRGB.
    pub(crate) colour: Colour,
}

/// Lists that are reused from ray to ray.
#[derive(Default)]
pub(crate) struct Tracing {
    work: Workspace,
    irradiance: Vec<f64>,
}

impl<'s> Sight<'s> {
    pub(crate) fn new(scene: &'s Scene, camera: &'s Camera) -> Self {
        let resolution = resolution(scene.surfaces.iter().map(|surface| &surface.polygon));
        let mut views = Vec::new();
        for (index, surface) in scene.surfaces.iter().enumerate() {
            for piece in surface.polygon.convex_pieces() {
                let relative: Vec<Vector> = piece.iter().map(|&v| v - camera.origin).collect();
                let distance = -surface.polygon.normal().dot(relative[0]);
                if distance.abs() > resolution {
                    let cone = Cone::over(&relative, distance > 0.0);
                    views.push(View { surface: index, cone, distance });
                }
            }
        }
        let bands = band_colours(scene);
        let paints = scene.surfaces.iter().map(|surface| Paint::new(scene, surface, &bands)).collect();
        Self { scene, camera, light: DirectLight::new(scene), views, paints }
    }

    /// What the film point (x, y) sees: L = Lₑ + ρ E/π on a diffuse surface, nothing outside the scene.
    pub(crate) fn sample(&self, x: f64, y: f64, tracing: &mut Tracing) -> Sample {
        let direction = self.camera.direction(x, y);
        let Some((view, along)) = self.first(direction) else {
            return Sample { surface: None, colour: [0.0; 3] };
        };
        let surface = &self.scene.surfaces[view.surface];
        let mut colour = [0.0; 3];
        if view.distance > 0.0 || surface.two_sided {
            let normal =
                if view.distance > 0.0 { surface.polygon.normal() } else { -surface.polygon.normal() };
            let position = self.camera.origin + along * direction;
            tracing.irradiance.clear();
            tracing.irradiance.resize(self.scene.band_count(), 0.0);
            self.light.add_irradiance(position, normal, &mut tracing.work, &mut tracing.irradiance);
            let paint = &self.paints[view.surface];
            colour = paint.emitted;
            for (&irradiance, &reflected) in tracing.irradiance.iter().zip(&paint.reflected) {
                add_scaled(&mut colour, irradiance, reflected);
            }
        }
        Sample { surface: Some(view.surface), colour }
    }

    /// Whether a surface emits light.
    pub(crate) fn emits(&self, surface: usize) -> bool {
        self.scene.surfaces[surface].emits()
    }

    /// The first piece in a direction d from the camera, and the t at which t d lies in it.
    fn first(&self, direction: Vector) -> Option<(&View, f64)> {
        let mut first: Option<(&View, f64)> = None;
        for view in self.views.iter().filter(|view| view.cone.contains(direction)) {
            let normal = self.scene.surfaces[view.surface].polygon.normal();
            let along = -view.distance / normal.dot(direction);
            if along > 0.0 && first.is_none_or(|(_, nearest)| along < nearest) {
                first = Some((view, along));
            }
        }
        first
    }
}

impl Paint {
    fn new(scene: &Scene, surface: &Surface, bands: &[Colour]) -> Self {
        let mut emitted = [0.0; 3];
        for (&radiance, &band) in surface.radiance.iter().zip(bands) {
            add_scaled(&mut emitted, radiance, band);
        }
        let reflectance = &scene.materials[surface.material].reflectance;
        let reflected = reflectance.iter().zip(bands).map(|(rho, band)| band.map(|weight| rho / PI * weight));
        Self { emitted, reflected: reflected.collect() }
    }
}
