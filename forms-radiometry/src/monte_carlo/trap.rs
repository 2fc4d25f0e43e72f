//! Light traps: places that light reaches and never leaves, and where nothing takes it.
//!
//! ```text
//! rays from luminaires ─ as long as nothing takes any of them ─▶ some still there after very many turns: a trap of positive measure
//! two plane mirrors that face each other and reflect everything, and light ─▶ what is normal to both never ends
//! ```
//! Light that is followed from where it is sent, and given up wherever a part of it is lost, is gone after few turns where it can
//! leave: a glass of water traps nothing that comes from outside. Where some of it is still there after thousands of turns, the sum of all
//! orders does not exist.

use super::boundary::Passage;
use super::luminaires::Front;
use super::mirror::reflected;
use super::optics::Optics;
use super::refraction::refracted;
use super::vertex::Law;
use super::warps::free_flight_sample;
use super::world::World;
use crate::geometry::{Met, Start, Vector, Wall};
use crate::sampling::{Samples, key};
use crate::scene::{Filling, LightKind, MaterialKind, SceneError};
use rayon::prelude::*;

/// How many rays are followed, and for how many turns.
const RAYS: u32 = 512;
const TURNS: u32 = 4096;
/// As many rays as may stay so long by chance.
const CHANCE: usize = 1;
/// Unit normals that are opposite but for this are those of parallel planes.
const PARALLEL: f64 = 1e-12;
/// Points of a mirror that are asked whether they see the other one.
const POINTS: u32 = 64;

/// The trap that light of a world reaches, if there is one.
pub(crate) fn trap(world: &World) -> Option<SceneError> {
    let scene = world.scene;
    let surface = (0..scene.band_count()).find_map(|band| {
        let search = Search::of(world, band);
        search.mirrors().or_else(|| search.closed())
    })?;
    let surface = &scene.surfaces[surface];
    let message = format!(
        "light that meets the surface `{}` is caught there: it never leaves and nothing absorbs it",
        surface.name
    );
    let expected = "a reflectance below 1, a medium that absorbs, or a way out";
    Some(SceneError::new(&surface.place, message, expected))
}

/// The search in one band.
pub(super) struct Search<'w> {
    pub(super) world: &'w World<'w>,
    pub(super) optics: Optics<1>,
}

/// A ray from which nothing was taken so far.
pub(super) struct Ray {
    pub(super) start: Start,
    pub(super) direction: Vector,
    pub(super) filling: Filling,
}

impl<'w> Search<'w> {
    pub(super) fn of(world: &'w World<'w>, band: usize) -> Self {
        Self { world, optics: Optics::of(world.scene, band, 1) }
    }
}

impl Search<'_> {
    /// A surface that is met by light which was still there after very many turns.
    fn closed(&self) -> Option<usize> {
        let of_ray = |ray: u32| self.caught(&mut Samples::new(key(17, 0), ray));
        let caught: Vec<usize> = (0..RAYS).into_par_iter().filter_map(of_ray).collect();
        (caught.len() > CHANCE).then(|| caught[0])
    }

    /// The surface that one ray meets in the end, if nothing takes it.
    fn caught(&self, samples: &mut Samples) -> Option<usize> {
        let mut ray = self.sent(samples)?;
        let mut last = None;
        for _ in 0..TURNS {
            last = Some(self.turn(&mut ray, samples)?);
        }
        last
    }

    /// A ray as luminaires send it, or as it comes from outside.
    fn sent(&self, samples: &mut Samples) -> Option<Ray> {
        let world = self.world;
        let scene = world.scene;
        let number = samples.one();
        let (start, direction) = match world.luminaires.emitting(number) {
            Some(surface) => {
                let (wall, position, normal) = world.fronts[surface].point(samples)?;
                let direction = Law::<1>::Plane(normal).direction(1, samples);
                (world.walls.start_before(wall, position), direction)
            }
            None => match scene.lights.first().map(|light| &light.kind) {
                Some(LightKind::Point { position, .. }) => {
                    (world.walls.start_at(*position), Law::<1>::Sphere.direction(1, samples))
                }
                _ => return None,
            },
        };
        Some(Ray { start, direction, filling: world.medium_at(start, direction) })
    }

    /// Follows a ray to the next thing that turns it, and returns the surface; none where any of it is lost.
    fn turn(&self, ray: &mut Ray, samples: &mut Samples) -> Option<usize> {
        let medium = self.optics.medium(ray.filling);
        let met = self.world.walls.first(ray.start, ray.direction, f64::INFINITY)?;
        if medium.extinction[0] > medium.scattering[0] {
            return None;
        }
        let surface = self.world.sheets[met.wall].surface;
        if medium.scatters() {
            let distance = free_flight_sample(medium.scattering[0], samples.one());
            if distance < met.distance {
                self.scatter(ray, distance, samples);
                return Some(surface);
            }
        }
        (self.meets(ray, &met, samples) >= 1.0).then_some(surface)
    }

    /// Turns a ray where the medium scatters it, after this distance.
    pub(super) fn scatter(&self, ray: &mut Ray, distance: f64, samples: &mut Samples) {
        let asymmetry = self.optics.medium(ray.filling).asymmetry;
        let position = ray.start.position + distance * ray.direction;
        ray.direction = Law::Phase { forward: ray.direction, asymmetry }.direction(1, samples);
        ray.start = self.world.walls.start_free(position);
    }

    /// What a wall does with a ray; the part of it that goes on.
    pub(super) fn meets(&self, ray: &mut Ray, met: &Met, samples: &mut Samples) -> f64 {
        let (world, sheet) = (self.world, &self.world.sheets[met.wall]);
        let normal = if met.is_front { met.normal } else { -met.normal };
        let medium = self.optics.medium(ray.filling);
        let passage = match world.material(met.wall) {
            MaterialKind::Dielectric { .. } => {
                let beyond = sheet.filling(!met.is_front);
                let passage =
                    refracted([&medium, &self.optics.medium(beyond)], ray.direction, normal, samples.one());
                if matches!(passage, Passage::Refracted(..)) {
                    ray.filling = beyond;
                }
                passage
            }
            _ if !world.is_bright(met.wall, met.is_front) => return 0.0,
            MaterialKind::Diffuse { .. } => {
                let direction = Law::<1>::Plane(normal).direction(1, samples);
                Passage::Reflected(direction, self.optics.reflectances[sheet.surface])
            }
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

    /// A plane mirror that reflects everything to another one that faces it, where there is light.
    fn mirrors(&self) -> Option<usize> {
        let world = self.world;
        let has_light = self.optics.radiances.iter().chain(&self.optics.beams).any(|[value]| *value > 0.0);
        let is_perfect = |wall: &usize| {
            let is_mirror = matches!(world.material(*wall), MaterialKind::Mirror { .. });
            is_mirror && self.optics.reflectances[world.sheets[*wall].surface][0] >= 1.0
        };
        let mirrors: Vec<usize> = (0..world.sheets.len()).filter(is_perfect).collect();
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
        Some(world.sheets[*found].surface)
    }

    /// Whether light that leaves a point of a mirror along its normal comes back along it from another one.
    fn comes_back(&self, wall: usize, position: Vector, normal: Vector) -> bool {
        let world = self.world;
        if matches!(world.walls.get(wall), Wall::Sphere(_)) {
            return false;
        }
        let start = world.walls.start_before(wall, position);
        let Some(met) = world.walls.first(start, normal, f64::INFINITY) else { return false };
        let medium = self.optics.medium(world.sheets[wall].filling(true));
        let is_mirror = matches!(world.material(met.wall), MaterialKind::Mirror { .. });
        let is_perfect = self.optics.reflectances[world.sheets[met.wall].surface][0] >= 1.0;
        is_mirror
            && is_perfect
            && world.is_bright(met.wall, met.is_front)
            && medium.extinction[0] == 0.0
            && (met.normal.dot(normal).abs() - 1.0).abs() < PARALLEL
    }
}
