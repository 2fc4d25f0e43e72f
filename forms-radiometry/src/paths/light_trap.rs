//! Light traps: places that light reaches and never leaves, and where nothing absorbs it.
//!
//! ```text
//! rays from light sources ─ traced as long as they lose no energy ─▶ some are left after very many
//!                           events: a trap of positive measure
//! two plane mirrors that face each other and reflect everything ─▶ light normal to both never ends
//! ```
//! A ray is traced from its light source, and dropped as soon as it loses energy. Where light can
//! leave, all rays are gone after a few events: a glass of water traps no light from outside. Where
//! some rays are left after thousands of events, the sum of all orders does not exist.

use super::boundary::{Passage, mirrored};
use super::luminaires::Front;
use super::mirror::reflected;
use super::optics::{MediumOptics, Optics};
use super::refraction::refracted;
use super::vertex::Law;
use super::warps::{free_flight_sample, fresnel_dielectric};
use super::world::{Side, World};
use crate::geometry::Vector;
use crate::sampling::{Samples, key};
use crate::scene::{Cone, Filling, Light, LightKind, MaterialKind, SceneError};
use crate::visibility::{Met, Start, Wall};
use rayon::prelude::*;

/// Number of rays from surfaces, least number of rays from each point light, and number of events for
/// which each ray is traced. Point lights together send at least as many rays as surfaces.
const RAYS: u32 = 512;
const RAYS_OF_POINT: u32 = 8;
const TURNS: u32 = 4096;
/// Number of rays that are allowed to survive all events by chance.
const CHANCE: usize = 1;
/// Planes are parallel if the cosine of the angle between their normals differs from ±1 by less
/// than this.
const PARALLEL: f64 = 1e-12;
/// Number of points of a mirror that are tested for a view of the other mirror.
const POINTS: u32 = 64;

/// Returns an error for a trap that light of a world reaches, if there is one.
pub(crate) fn trap(world: &World) -> Option<SceneError> {
    let scene = &*world.scene;
    let surface = (0..scene.band_count()).find_map(|band| {
        let search = Search::of(world, band);
        search.mirrors().or_else(|| search.closed())
    })?;
    let surface = &scene.surfaces[surface];
    let message = format!(
        "light that reaches the surface `{}` is trapped: it never leaves and nothing absorbs it",
        surface.name
    );
    let expected = "a reflectance below 1, an absorbing medium, or an opening";
    Some(SceneError::new(&surface.place, message, expected))
}

/// Search for light traps in one band.
pub(crate) struct Search<'w> {
    pub(crate) world: &'w World,
    pub(crate) optics: Optics<1>,
}

/// A ray that has lost no energy so far.
pub(crate) struct Ray {
    pub(crate) start: Start,
    pub(crate) direction: Vector,
    pub(crate) filling: Filling,
}

impl<'w> Search<'w> {
    pub(crate) fn of(world: &'w World, band: usize) -> Self {
        Self { world, optics: Optics::of(&world.scene, band, 1) }
    }
}

impl Search<'_> {
    /// Returns a surface that is hit by light that survived very many events.
    fn closed(&self) -> Option<usize> {
        let points = self.points();
        let of_points = if points.is_empty() { 0 } else { RAYS.max(RAYS_OF_POINT * points.len() as u32) };
        let of_ray = |ray: u32| {
            let samples = &mut Samples::new(key(17, 0), ray);
            let sent = match ray.checked_sub(RAYS) {
                None => self.of_surface(samples),
                Some(ray) => self.of_point(points[ray as usize % points.len()], samples),
            };
            self.caught(sent?, samples)
        };
        let caught: Vec<usize> = (0..RAYS + of_points).into_par_iter().filter_map(of_ray).collect();
        (caught.len() > CHANCE).then(|| caught[0])
    }

    /// Returns the positions of the point lights, and the cones of spot lights.
    fn points(&self) -> Vec<(Vector, Option<Cone>)> {
        let position = |light: &Light| match light.kind {
            LightKind::Point { position, .. } => Some((position, light.cone)),
            _ => None,
        };
        self.world.scene.lights.iter().filter_map(position).collect()
    }

    /// Returns the surface that a ray hits in the end, if the ray loses no energy.
    fn caught(&self, mut ray: Ray, samples: &mut Samples) -> Option<usize> {
        let mut last = None;
        for _ in 0..TURNS {
            last = Some(self.turn(&mut ray, samples)?);
        }
        last
    }

    /// Samples a ray from an emitting surface; `None` if there is none.
    fn of_surface(&self, samples: &mut Samples) -> Option<Ray> {
        let world = self.world;
        let surface = world.luminaires.emitting(samples.one())?;
        let (wall, position, normal) = world.front(surface).point(samples)?;
        let direction = Law::<1>::Plane(normal).direction(1, samples);
        Some(self.ray(world.walls.start_before(wall, position), direction))
    }

    /// Samples a ray from a point light; `None` if it sends no light there.
    fn of_point(&self, (position, cone): (Vector, Option<Cone>), samples: &mut Samples) -> Option<Ray> {
        let direction = Law::<1>::Sphere.direction(1, samples);
        let is_lit = cone.is_none_or(|cone| cone.factor(direction) > 0.0);
        is_lit.then(|| self.ray(self.world.walls.start_at(position), direction))
    }

    fn ray(&self, start: Start, direction: Vector) -> Ray {
        Ray { start, direction, filling: self.world.medium_at(start, direction) }
    }

    /// Traces a ray to its next event and returns the surface; `None` if the ray loses energy or
    /// escapes.
    fn turn(&self, ray: &mut Ray, samples: &mut Samples) -> Option<usize> {
        let medium = self.optics.medium(ray.filling);
        let met = self.world.walls.first(ray.start, ray.direction, f64::INFINITY)?;
        if medium.extinction[0] > medium.scattering[0] {
            return None;
        }
        let surface = self.world.interfaces[met.wall].surface;
        if medium.scatters() {
            let distance = free_flight_sample(medium.scattering[0], samples.one());
            if distance < met.distance {
                self.scatter(ray, distance, samples);
                return Some(surface);
            }
        }
        (self.meets(ray, &met, samples) >= 1.0).then_some(surface)
    }

    /// Scatters a ray in its medium after this distance.
    pub(crate) fn scatter(&self, ray: &mut Ray, distance: f64, samples: &mut Samples) {
        let asymmetry = self.optics.medium(ray.filling).asymmetry;
        let position = ray.start.position + distance * ray.direction;
        ray.direction = Law::Phase { forward: ray.direction, asymmetry }.direction(1, samples);
        ray.start = self.world.walls.start_free(position);
    }

    /// Applies the interaction of a wall to a ray; returns the fraction of its energy that remains.
    pub(crate) fn meets(&self, ray: &mut Ray, met: &Met, samples: &mut Samples) -> f64 {
        let (world, interface) = (self.world, &self.world.interfaces[met.wall]);
        let Side { is_front, normal, .. } = world.side(met, ray.direction);
        let medium = self.optics.medium(ray.filling);
        let passage = match world.material(met.wall) {
            MaterialKind::Dielectric { .. } => {
                let beyond = interface.filling(!met.is_front);
                let passage =
                    refracted([&medium, &self.optics.medium(beyond)], ray.direction, normal, samples.one());
                if matches!(passage, Passage::Refracted(..)) {
                    ray.filling = beyond;
                }
                passage
            }
            _ if !world.is_bright(met.wall, is_front) => return 0.0,
            MaterialKind::Diffuse { .. } => {
                let direction = Law::<1>::Plane(normal).direction(1, samples);
                Passage::Reflected(direction, world.reflectance(&self.optics, met))
            }
            MaterialKind::Plastic { specular, index, .. } => {
                let coat = (specular[self.optics.bands[0]], *index);
                self.coated(coat, (ray.direction, normal), met, samples)
            }
            MaterialKind::Rough(_) => self.roughened((met, &medium), (ray.direction, normal), samples),
            material => reflected(material, &self.optics, &medium, ray.direction, normal),
        };
        let (direction, [left], stays) = match passage {
            Passage::Reflected(direction, factor) => (direction, factor, true),
            Passage::Refracted(direction, _) => (direction, [1.0], false),
        };
        ray.direction = direction;
        ray.start = world.walls.start_on(met, met.is_front == stays);
        left
    }

    /// Returns the reflection of a ray by a coat, or by the base below it.
    fn coated(
        &self,
        (specular, index): (f64, f64),
        (direction, normal): (Vector, Vector),
        met: &Met,
        samples: &mut Samples,
    ) -> Passage<1> {
        let cosine = (-normal.dot(direction)).clamp(0.0, 1.0);
        if samples.one() < fresnel_dielectric(index, cosine) {
            return Passage::Reflected(mirrored(direction, normal), [specular]);
        }
        let law: Law<1> = Law::Coated { normal, index };
        let direction = law.direction(1, samples);
        let (transmitted, _) = law.weights(direction, 1);
        let [reflectance] = self.world.reflectance(&self.optics, met);
        Passage::Reflected(direction, transmitted.map(|part| (part * reflectance).min(1.0)))
    }

    /// Returns the reflection of a ray by a rough wall.
    fn roughened(
        &self,
        (met, medium): (&Met, &MediumOptics<1>),
        (direction, normal): (Vector, Vector),
        samples: &mut Samples,
    ) -> Passage<1> {
        let Some(lobes) = self.world.lobes(&self.optics, medium, met, [normal, -direction]) else {
            return Passage::Reflected(direction, [0.0]);
        };
        let law = Law::Rough(lobes);
        let direction = law.direction(1, samples);
        Passage::Reflected(direction, law.weights(direction, 1).0)
    }

    /// Finds a plane mirror that reflects everything to another one that faces it, where there is
    /// light.
    fn mirrors(&self) -> Option<usize> {
        let world = self.world;
        let has_light = self.optics.radiances.iter().chain(&self.optics.beams).any(|[value]| *value > 0.0);
        let is_perfect = |wall: &usize| {
            let is_mirror = matches!(world.material(*wall), MaterialKind::Mirror { .. });
            let surface = world.interfaces[*wall].surface;
            let is_flat = !world.scene.surfaces[surface].shape.is_smooth();
            is_mirror && is_flat && self.optics.reflectances[surface][0] >= 1.0
        };
        let mirrors: Vec<usize> = (0..world.interfaces.len()).filter(is_perfect).collect();
        let faces_another = |&&wall: &&usize| {
            let front = Front::of(std::iter::once((wall, world.walls.get(wall))));
            let mut samples = (0..POINTS).map(|index| Samples::new(key(19, wall as u64), index));
            samples.any(|mut samples| {
                front
                    .point(&mut samples)
                    .is_some_and(|(_, position, normal)| self.comes_back(wall, position, normal))
            })
        };
        let found = mirrors.iter().filter(|_| has_light).find(faces_another)?;
        Some(world.interfaces[*found].surface)
    }

    /// Whether light that leaves a point of a mirror along its normal returns along the normal from
    /// another mirror.
    fn comes_back(&self, wall: usize, position: Vector, normal: Vector) -> bool {
        let world = self.world;
        if matches!(world.walls.get(wall), Wall::Sphere(_)) {
            return false;
        }
        let start = world.walls.start_before(wall, position);
        let Some(met) = world.walls.first(start, normal, f64::INFINITY) else { return false };
        let medium = self.optics.medium(world.interfaces[wall].filling(true));
        let is_mirror = matches!(world.material(met.wall), MaterialKind::Mirror { .. });
        let is_perfect = self.optics.reflectances[world.interfaces[met.wall].surface][0] >= 1.0;
        is_mirror
            && is_perfect
            && world.is_bright(met.wall, met.is_front)
            && medium.extinction[0] == 0.0
            && (met.normal.dot(normal).abs() - 1.0).abs() < PARALLEL
    }
}
