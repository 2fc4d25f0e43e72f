//! Image sources: the images of point and distant lights in flat mirrors and flat boundaries of
//! media, which no path from a receiver would find.
//!
//! ```text
//! light ─ reflected or refracted by flat walls in turn, while enough of it remains ─▶ images
//! vertex, image ─▶ the one ray between them, if it meets these walls and no others ─▶ light
//! ```
//! The image of a point light at p in a plane mirror lies at p − 2 ((p − a)·n) n. Parallel light
//! stays parallel when a flat boundary reflects or refracts it; beyond the boundary a beam is wider
//! or narrower by the ratio of the cosines: E₂ = (1 − R) E₁ cos θ₁/cos θ₂. Light from one wall
//! continues to another one only where that wall lies in its beam.

use super::boundary::Passage;
use super::chains::LEAST_LISTED;
use super::image_ray::Ray;
use super::mirror::reflected;
use super::optics::{MediumOptics, Optics, largest, scaled, times};
use super::refraction::passages;
use super::world::World;
use crate::geometry::clip::split_along;
use crate::geometry::{Plane, Vector, edges};
use crate::sampling::{chosen, shares};
use crate::scene::{Filling, LightKind, MaterialKind};
use crate::visibility::{Start, Wall};

/// Maximum number of images; a scene with more is rejected.
const MOST: usize = 4096;
/// Up to this number of images, all are evaluated; of more, one is selected.
const FEW: usize = 16;
/// Total light of the omitted images as a fraction of the tolerance: a few of them follow from each
/// of the last listed images.
pub(crate) const LEFT_OUT: f64 = 1e-2;

/// Image sources of all lights in a scene.
pub(crate) struct Images<const N: usize> {
    all: Vec<Image<N>>,
    chances: Vec<f64>,
    /// Whether there are more images than can be listed.
    pub(crate) is_cut: bool,
}

/// Image of a light.
#[derive(Clone, Debug)]
pub(crate) struct Image<const N: usize> {
    place: Place,
    /// The index of the light.
    source: usize,
    /// Remaining intensity or irradiance; for a point light in metals, where it depends on the
    /// angle, an upper bound.
    light: [f64; N],
    /// The walls, in the order in which a ray from a receiver meets them.
    steps: Vec<Step>,
    /// Selection probability.
    chance: f64,
}

/// Position of an image.
#[derive(Clone, Copy, Debug)]
enum Place {
    Point(Vector),
    /// The unit vector along which the light travels.
    Far(Vector),
}

/// Interaction of the light of an image with a wall.
#[derive(Clone, Copy, Debug)]
struct Step {
    wall: usize,
    /// The side at which a ray from a receiver arrives.
    is_front: bool,
    is_bent: bool,
}

/// Light on its way from wall to wall.
#[derive(Clone, Debug)]
struct Sent<const N: usize> {
    place: Place,
    source: usize,
    light: [f64; N],
    filling: Filling,
    steps: Vec<Step>,
    /// The lit part of the last wall; empty before the first wall.
    lit: Vec<Vector>,
}

/// Light of an image at a point.
pub(crate) struct Coming<const N: usize> {
    /// The direction that the light comes from.
    pub(crate) direction: Vector,
    /// Irradiance in each band at normal incidence.
    pub(crate) irradiance: [f64; N],
    /// Optical path length.
    pub(crate) optical_path_length: f64,
}

impl<const N: usize> Images<N> {
    pub(crate) fn of(world: &World, optics: &Optics<N>) -> Self {
        let mut images = Self { all: Vec::new(), chances: Vec::new(), is_cut: false };
        let smooth: Vec<usize> =
            (0..world.interfaces.len()).filter(|&wall| is_smooth(world, optics, wall)).collect();
        if smooth.is_empty() {
            return images;
        }
        for (index, light) in world.scene.lights.iter().enumerate() {
            let (place, filling) = match light.kind {
                LightKind::Point { position, .. } => {
                    let start = world.walls.start_at(position);
                    (Place::Point(position), world.medium_at(start, Vector::new(0.6, 0.0, 0.8)))
                }
                LightKind::Distant { direction, .. } => (Place::Far(direction), world.scene.ambient.medium),
            };
            let sent = Sent {
                place,
                source: index,
                light: optics.beams[index],
                filling,
                steps: Vec::new(),
                lit: Vec::new(),
            };
            let least = LEAST_LISTED * world.scene.solve.tolerance * largest(&optics.beams[index]);
            images.add_images(world, optics, &smooth, sent, least);
        }
        let weights: Vec<f64> = images.all.iter().map(|image| largest(&image.light)).collect();
        let [chances, running] = shares(&weights);
        images.all.iter_mut().zip(chances).for_each(|(image, chance)| image.chance = chance);
        images.chances = running;
        images
    }

    /// Adds the images of a light, and of its images, in smooth walls, depth first.
    fn add_images(&mut self, world: &World, optics: &Optics<N>, smooth: &[usize], sent: Sent<N>, least: f64) {
        let mut waiting = vec![sent];
        while let Some(sent) = waiting.pop() {
            for &wall in smooth {
                for is_front in [true, false] {
                    for next in sent.after(world, optics, wall, is_front) {
                        if largest(&next.light) <= least {
                            continue;
                        }
                        if self.all.len() == MOST {
                            self.is_cut = true;
                            return;
                        }
                        let steps = next.steps.iter().rev().copied().collect();
                        let (place, source, light) = (next.place, next.source, next.light);
                        self.all.push(Image { place, source, light, steps, chance: 0.0 });
                        waiting.push(next);
                    }
                }
            }
        }
    }

    /// Returns all images if they are few or all are requested, otherwise one of them selected by a
    /// number from 0 to 1; each with its probability.
    pub(crate) fn choose(&self, number: f64, asks_for_all: bool) -> impl Iterator<Item = (&Image<N>, f64)> {
        let are_few = asks_for_all || self.all.len() <= FEW;
        let one = chosen(&self.chances, number).filter(|_| !are_few);
        let taken = one.map_or(&self.all[..], |place| &self.all[place..=place]);
        taken.iter().map(move |image| (image, if are_few { 1.0 } else { image.chance }))
    }
}

/// Whether a wall reflects or refracts light into single directions only.
fn is_smooth<const N: usize>(world: &World, optics: &Optics<N>, wall: usize) -> bool {
    match world.material(wall) {
        MaterialKind::Diffuse { .. } | MaterialKind::Plastic { .. } | MaterialKind::Rough(_) => false,
        MaterialKind::Mirror { .. } | MaterialKind::Conductor { .. } => true,
        MaterialKind::Dielectric { .. } => {
            let [front, back] = world.interfaces[wall].fillings;
            !optics.is_clear(front, back)
        }
    }
}

impl<const N: usize> Sent<N> {
    /// Returns the light that a wall reflects and refracts from one of its sides.
    fn after(&self, world: &World, optics: &Optics<N>, wall: usize, is_front: bool) -> Vec<Self> {
        let Some(plane) = world.walls.get(wall).plane() else { return Vec::new() };
        let Plane { point, normal } = plane.facing(is_front);
        let interface = &world.interfaces[wall];
        let arrives = match self.place {
            Place::Point(position) => normal.dot(position - point) > 0.0,
            Place::Far(direction) => normal.dot(direction) < 0.0,
        };
        let is_same = self.steps.last().is_some_and(|last| last.wall == wall && !last.is_bent);
        if !arrives || is_same || interface.filling(is_front) != self.filling {
            return Vec::new();
        }
        let lit = self.lit_on(world.walls.get(wall), point, normal);
        if lit.is_empty() {
            return Vec::new();
        }
        let material = world.material(wall);
        let medium = optics.medium(self.filling);
        let next = |place: Place, light: [f64; N], is_bent: bool| {
            let mut steps = self.steps.clone();
            // refracted light continues on the other side, where a ray from a receiver arrives
            steps.push(Step { wall, is_front: is_front != is_bent, is_bent });
            let filling = if is_bent { interface.filling(!is_front) } else { self.filling };
            Self { place, source: self.source, light, filling, steps, lit: lit.clone() }
        };
        let is_boundary = matches!(material, MaterialKind::Dielectric { .. });
        match self.place {
            Place::Point(position) if !is_boundary && world.is_bright(wall, is_front) => {
                let image = plane.mirrored(position);
                // the reflectance of a metal is largest at grazing incidence: 1
                let factor = if let MaterialKind::Mirror { .. } = material {
                    optics.reflectances[interface.surface]
                } else {
                    [1.0; N]
                };
                vec![next(Place::Point(image), times(&self.light, &factor), false)]
            }
            Place::Far(direction) if is_boundary => {
                let other = optics.medium(interface.filling(!is_front));
                self.at_boundary([&medium, &other], direction, normal)
                    .map(|(direction, light, is_bent)| next(Place::Far(direction), light, is_bent))
                    .collect()
            }
            Place::Far(direction) if world.is_bright(wall, is_front) => {
                match reflected(material, optics, &medium, direction, normal) {
                    Passage::Reflected(direction, factor) => {
                        vec![next(Place::Far(direction), times(&self.light, &factor), false)]
                    }
                    Passage::Refracted(..) => Vec::new(),
                }
            }
            _ => Vec::new(),
        }
    }

    /// Returns the directions and the light that the boundary of two media reflects and refracts
    /// from parallel light, and whether it is refracted.
    fn at_boundary(
        &self,
        media: [&MediumOptics<N>; 2],
        direction: Vector,
        normal: Vector,
    ) -> impl Iterator<Item = (Vector, [f64; N], bool)> {
        let both = passages(media, direction, normal).into_iter().flatten();
        both.map(move |(part, passage)| match passage {
            Passage::Reflected(direction, _) => (direction, scaled(part, &self.light), false),
            Passage::Refracted(beyond, _) => {
                let widened = normal.dot(direction) / normal.dot(beyond);
                (beyond, scaled(part * widened, &self.light), true)
            }
        })
    }
}

impl<const N: usize> Sent<N> {
    /// Returns the part of a wall that the light reaches from the last wall, without regard to
    /// occluders. The lit part of the last wall is clipped to the half-space in front of this wall
    /// and to the cone of rays over it, and then projected along these rays. `point` and `normal`
    /// belong to the side at which the light arrives.
    fn lit_on(&self, wall: &Wall, point: Vector, normal: Vector) -> Vec<Vector> {
        let outline = wall.corners();
        if self.steps.is_empty() {
            return outline;
        }
        let middle = Vector::mean(&outline);
        let of_cone = edges(&outline).map(|[a, b]| {
            let side = (b - a).cross(self.ray_through(a));
            Plane { point: a, normal: if side.dot(middle - a) < 0.0 { -side } else { side } }
        });
        let planes = std::iter::once(Plane { point, normal }).chain(of_cone);
        let (_, lit) = split_along(&self.lit, planes.map(|plane| (move |v| plane.distance(v), 0.0)));
        let moved = |v: Vector| {
            let ray = self.ray_through(v);
            v + (normal.dot(point - v) / normal.dot(ray)) * ray
        };
        lit.into_iter().map(moved).collect()
    }

    /// Returns the direction of the light's ray through a point.
    fn ray_through(&self, through: Vector) -> Vector {
        match self.place {
            Place::Point(position) => through - position,
            Place::Far(direction) => direction,
        }
    }
}

impl<const N: usize> Image<N> {
    /// Returns the number of walls that reflect or refract the light.
    pub(crate) fn events(&self) -> u32 {
        self.steps.len() as u32
    }

    /// Returns the position of the image; `None` if it is distant.
    pub(crate) fn point(&self) -> Option<Vector> {
        match self.place {
            Place::Point(position) => Some(position),
            Place::Far(_) => None,
        }
    }

    /// Returns the part of the intensity that the light sends in a direction.
    fn aimed(&self, world: &World, direction: Vector) -> f64 {
        world.scene.lights[self.source].cone.map_or(1.0, |cone| cone.factor(direction))
    }

    /// Returns the light of the image at a point in a medium; `None` if an occluder is in the way.
    pub(crate) fn coming(
        &self,
        world: &World,
        optics: &Optics<N>,
        start: Start,
        filling: Filling,
    ) -> Option<Coming<N>> {
        let (direction, distance) = match self.place {
            Place::Point(position) => {
                let offset = position - start.position;
                (offset.unit()?, offset.length())
            }
            Place::Far(direction) => (-direction, f64::INFINITY),
        };
        let mut ray =
            Ray { start, direction, filling, left: distance, factor: self.light, optical_path_length: 0.0 };
        let mut steps = self.steps.iter();
        loop {
            let reach = if ray.left.is_finite() { (1.0 - 1e-12) * ray.left } else { ray.left };
            let met = world.walls.first(ray.start, ray.direction, reach);
            let medium = optics.medium(ray.filling);
            ray.passes(&medium, met.as_ref());
            let Some(met) = met else {
                let squared = if distance.is_finite() { distance * distance } else { 1.0 };
                let is_done = steps.next().is_none();
                let aimed = self.aimed(world, -ray.direction);
                let irradiance = ray.factor.map(|factor| aimed * factor / squared);
                return is_done.then_some(Coming {
                    direction,
                    irradiance,
                    optical_path_length: ray.optical_path_length,
                });
            };
            let beyond = world.interfaces[met.wall].filling(!met.is_front);
            if is_smooth(world, optics, met.wall) {
                let step =
                    steps.next().filter(|step| step.wall == met.wall && step.is_front == met.is_front)?;
                ray.turn(world, optics, &met, step.is_bent, beyond)?;
            } else if matches!(world.material(met.wall), MaterialKind::Dielectric { .. }) {
                ray.start = world.walls.start_on(&met, !met.is_front);
                ray.filling = beyond;
            } else {
                return None;
            }
        }
    }
}
