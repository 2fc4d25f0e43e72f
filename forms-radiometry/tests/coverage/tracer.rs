//! Path tracer: a scene and a receiver become values with standard errors.
//!
//! ```text
//! receiver ─▶ direction of sight ─▶ hit ─┬─▶ emitted light, MIS with next-event estimation
//!                                        ├─▶ next-event estimation: a point of an emitter,
//!                                        │   point and distant lights
//!                                        └─▶ diffuse or mirror reflection ─▶ next hit …
//!                                            (Russian roulette)
//! ```
//! The tracer shares only vectors with the code that it judges: rays are intersected with every
//! surface in turn. The points of a low-discrepancy sequence, shifted at random sixteen times,
//! replace random numbers; the shifts provide the standard error.

use crate::pieces::{NEAR, Piece, around, cosine_direction, pieces};
use crate::sequence::Sampler;
use crate::world::{Kind, Light, World};
use forms_radiometry::geometry::Vector;
use std::f64::consts::{FRAC_1_PI, PI};

/// Number of reflections before Russian roulette starts.
const SURE: usize = 4;

struct Hit {
    piece: usize,
    distance: f64,
    place: Vector,
    /// Normal on the side of the ray's origin.
    normal: Vector,
    is_front: bool,
}

/// World for path tracing.
pub(crate) struct Tracer<'w> {
    world: &'w World,
    pieces: Vec<Piece>,
    /// Pieces that emit, with the cumulative probability of each.
    emitters: Vec<(usize, f64)>,
}

/// Directions of the light that counts at the receiver.
#[derive(Clone, Copy)]
enum Sight {
    /// Directions of the hemisphere around a normal, weighted by their cosines.
    Hemisphere(Vector),
    /// All directions.
    Sphere,
}

impl<'w> Tracer<'w> {
    pub(crate) fn new(world: &'w World) -> Self {
        let pieces: Vec<Piece> = world
            .surfaces
            .iter()
            .enumerate()
            .flat_map(|(surface, what)| pieces(surface, &what.shape))
            .collect();
        let power = |piece: &Piece| world.surfaces[piece.surface].radiance * piece.area;
        let all: f64 = pieces.iter().map(power).sum();
        let mut sum = 0.0;
        let mut emitters = Vec::new();
        for (index, piece) in pieces.iter().enumerate().filter(|(_, piece)| power(piece) > 0.0) {
            sum += power(piece) / all;
            emitters.push((index, sum));
        }
        Self { world, pieces, emitters }
    }

    /// Takes one sample of a receiver's light: each contribution with the direction that it comes
    /// from and the length of its path.
    pub(crate) fn sample(
        &self,
        kind: &Kind,
        cell: Option<[usize; 2]>,
        sampler: &mut Sampler,
        sink: &mut dyn FnMut(Vector, f64, f64),
    ) {
        match *kind {
            Kind::Point { position, normal } => {
                let normal = normal.unit().expect("a normal");
                self.arriving(position, Sight::Hemisphere(normal), sampler, sink);
            }
            Kind::Sphere { position } => self.arriving(position, Sight::Sphere, sampler, sink),
            Kind::Ray { origin, direction } => {
                self.along(origin, direction.unit().expect("a direction"), None, sampler, sink);
            }
            Kind::Surface { surface, grid } => {
                let (place, normal) = self.place_on(surface, grid.zip(cell), sampler);
                self.arriving(place, Sight::Hemisphere(normal), sampler, sink);
            }
            Kind::Camera { origin, target, fov, resolution: [width, height] } => {
                let [column, row] = cell.expect("a pixel");
                let forward = (target - origin).unit().expect("a direction");
                let right = forward.cross(Vector::new(0.0, 0.0, 1.0)).unit().expect("a direction");
                let up = right.cross(forward);
                let half = (0.5 * fov.to_radians()).tan();
                let x = 2.0 * (column as f64 + sampler.next()) / width as f64 - 1.0;
                let y = 1.0 - 2.0 * (row as f64 + sampler.next()) / height as f64;
                let half_width = half * width as f64 / height as f64;
                let way = forward + (x * half_width) * right + (y * half) * up;
                self.along(origin, way.unit().expect("a direction"), None, sampler, sink);
            }
        }
    }

    /// Returns a point on a surface, or the centre of a cell of its map, with the normal there.
    fn place_on(
        &self,
        surface: usize,
        cell: Option<([usize; 2], [usize; 2])>,
        sampler: &mut Sampler,
    ) -> (Vector, Vector) {
        let own = || self.pieces.iter().filter(move |piece| piece.surface == surface);
        let all: f64 = own().map(|piece| piece.area).sum();
        let mut left = sampler.next() * all;
        let mut chosen = own().next().expect("a piece");
        for piece in own() {
            chosen = piece;
            left -= piece.area;
            if left < 0.0 {
                break;
            }
        }
        match cell {
            None => chosen.place(sampler.next(), sampler.next()),
            Some(([columns, rows], [column, row])) => {
                chosen.place((column as f64 + 0.5) / columns as f64, (row as f64 + 0.5) / rows as f64)
            }
        }
    }

    /// Samples the light that arrives at a place from the directions of sight.
    fn arriving(
        &self,
        place: Vector,
        sight: Sight,
        sampler: &mut Sampler,
        sink: &mut dyn FnMut(Vector, f64, f64),
    ) {
        self.next_event(place, sight, sampler, sink);
        let [u, v] = [sampler.next(), sampler.next()];
        match sight {
            Sight::Hemisphere(normal) => {
                let (way, density) = cosine_direction(normal, u, v);
                self.along(place, way, Some(density), sampler, &mut |length_way, length, value| {
                    sink(length_way, length, PI * value);
                });
            }
            Sight::Sphere => {
                let z = 2.0 * u - 1.0;
                let way = around(Vector::new(0.0, 0.0, 1.0), z, v);
                self.along(place, way, Some(0.25 * FRAC_1_PI), sampler, &mut |way, length, value| {
                    sink(way, length, 4.0 * PI * value);
                });
            }
        }
    }

    /// Samples the radiance that arrives along a direction, which was sampled with a density, or is
    /// given.
    fn along(
        &self,
        from: Vector,
        first: Vector,
        density: Option<f64>,
        sampler: &mut Sampler,
        sink: &mut dyn FnMut(Vector, f64, f64),
    ) {
        let (mut origin, mut way, mut density) = (from, first, density);
        let (mut throughput, mut length) = (1.0, 0.0);
        // number of flat mirrors since the last next-event estimation, and the path length from
        // there
        let (mut mirrors, mut since) = (0, 0.0);
        for reflections in 0.. {
            let Some(hit) = self.hit(origin, way, f64::INFINITY, false) else {
                if self.world.absorption == 0.0 {
                    sink(first, f64::INFINITY, throughput * self.world.sky);
                }
                return;
            };
            let piece = &self.pieces[hit.piece];
            let surface = &self.world.surfaces[piece.surface];
            throughput *= (-self.world.absorption * hit.distance).exp();
            length += hit.distance;
            since += hit.distance;
            if !(hit.is_front || surface.is_two_sided) {
                return;
            }
            if surface.radiance > 0.0 {
                let by_area = || self.density(hit.piece) * since * since / hit.normal.dot(way).abs();
                let weight =
                    density.filter(|_| mirrors <= 1).map_or(1.0, |density| density / (density + by_area()));
                sink(first, length, throughput * surface.radiance * weight);
            }
            if surface.reflectance == 0.0 {
                return;
            }
            if reflections >= SURE && sampler.next() >= surface.reflectance {
                return;
            }
            throughput *= if reflections >= SURE { 1.0 } else { surface.reflectance };
            origin = hit.place;
            if surface.is_mirror {
                way = way - (2.0 * way.dot(hit.normal)) * hit.normal;
                mirrors += 1;
                density = density.filter(|_| piece.is_flat());
                continue;
            }
            self.next_event(origin, Sight::Hemisphere(hit.normal), sampler, &mut |_, more, value| {
                sink(first, length + more, throughput * FRAC_1_PI * value);
            });
            let (next, of_next) = cosine_direction(hit.normal, sampler.next(), sampler.next());
            (way, density) = (next, Some(of_next));
            (mirrors, since) = (0, 0.0);
        }
    }

    /// Next-event estimation: samples the light at a place from point and distant lights, and from
    /// a point of an emitter, with MIS weights against sampled directions.
    fn next_event(
        &self,
        place: Vector,
        sight: Sight,
        sampler: &mut Sampler,
        sink: &mut dyn FnMut(Vector, f64, f64),
    ) {
        let cosine = |way: Vector| match sight {
            Sight::Hemisphere(normal) => normal.dot(way).max(0.0),
            Sight::Sphere => 1.0,
        };
        for &light in &self.world.lights {
            let (way, distance, irradiance) = self.reaching(light, place);
            if self.hit(place, way, distance, true).is_none() {
                sink(way, distance, cosine(way) * irradiance);
            }
            for mirror in self.mirrors() {
                let Some((way, distance, irradiance)) = self.mirrored(light, mirror, place) else { continue };
                sink(way, distance, cosine(way) * irradiance);
            }
        }
        let [pick, u, v] = [sampler.next(), sampler.next(), sampler.next()];
        let Some(&(index, _)) = self.emitters.iter().find(|(_, sum)| pick < *sum).or(self.emitters.last())
        else {
            return;
        };
        let piece = &self.pieces[index];
        let surface = &self.world.surfaces[piece.surface];
        let (point, normal) = piece.place(u, v);
        let mut looked_for = |image: Vector, normal: Vector, mirror: Option<usize>| {
            let to = image - place;
            let distance = to.length();
            let way = (1.0 / distance) * to;
            let leaving = -way.dot(normal);
            let leaving = if surface.is_two_sided { leaving.abs() } else { leaving };
            let arriving = cosine(way);
            if !(leaving > 0.0 && arriving > 0.0) {
                return;
            }
            let near = distance * (1.0 - NEAR);
            let left = match mirror {
                None => f64::from(u8::from(self.hit(place, way, near, true).is_none())),
                Some(mirror) => self.left_by(mirror, place, way, near).unwrap_or(0.0),
            };
            let by_area = self.density(index) * distance * distance / leaving;
            let by_direction = match sight {
                Sight::Hemisphere(_) => arriving * FRAC_1_PI,
                Sight::Sphere => 0.25 * FRAC_1_PI,
            };
            let transmitted = left * (-self.world.absorption * distance).exp();
            sink(way, distance, transmitted * surface.radiance * arriving / (by_area + by_direction));
        };
        looked_for(point, normal, None);
        for mirror in self.mirrors() {
            let [at, across] = self.mirror(mirror);
            let turned = |way: Vector| way - (2.0 * way.dot(across)) * across;
            looked_for(at + turned(point - at), turned(normal), Some(mirror));
        }
    }

    /// Returns the part of light that a flat mirror leaves along a direction, unless another
    /// surface is hit before a distance.
    fn left_by(&self, mirror: usize, place: Vector, way: Vector, distance: f64) -> Option<f64> {
        let met = self.hit(place, way, distance, false).filter(|met| met.piece == mirror && met.is_front)?;
        let turned = way - (2.0 * way.dot(met.normal)) * met.normal;
        let is_free = self.hit(met.place, turned, distance - met.distance, true).is_none();
        is_free.then(|| self.world.surfaces[self.pieces[mirror].surface].reflectance)
    }

    /// Returns a point of a flat mirror, and its normal.
    fn mirror(&self, mirror: usize) -> [Vector; 2] {
        let middle = self.pieces[mirror].middle;
        [middle, self.pieces[mirror].normal(middle)]
    }

    /// Returns the direction of a point or distant light, its distance, and its irradiance at
    /// normal incidence.
    fn reaching(&self, light: Light, place: Vector) -> (Vector, f64, f64) {
        match light {
            Light::Sun { direction, irradiance } => {
                (-1.0 * direction.unit().expect("a direction"), f64::INFINITY, irradiance)
            }
            Light::Lamp { position, intensity } => {
                let to = position - place;
                let distance = to.length();
                let transmitted = (-self.world.absorption * distance).exp();
                ((1.0 / distance) * to, distance, transmitted * intensity / (distance * distance))
            }
        }
    }

    /// Returns the flat mirrors.
    fn mirrors(&self) -> impl Iterator<Item = usize> {
        let is_mirror = |&index: &usize| {
            let piece = &self.pieces[index];
            piece.is_flat() && self.world.surfaces[piece.surface].is_mirror
        };
        (0..self.pieces.len()).filter(is_mirror)
    }

    /// Returns the same for the image of a light in a flat mirror, if the image is visible: no
    /// sampled direction finds it. Images of images are omitted, as no world has a second flat
    /// mirror.
    fn mirrored(&self, light: Light, mirror: usize, place: Vector) -> Option<(Vector, f64, f64)> {
        let [at, normal] = self.mirror(mirror);
        let across = |way: Vector| way - (2.0 * way.dot(normal)) * normal;
        let image = match light {
            Light::Sun { direction, irradiance } => Light::Sun { direction: across(direction), irradiance },
            Light::Lamp { position, intensity } => {
                Light::Lamp { position: at + across(position - at), intensity }
            }
        };
        let (way, distance, irradiance) = self.reaching(image, place);
        let left = self.left_by(mirror, place, way, distance)?;
        Some((way, distance, left * irradiance))
    }

    /// Returns the density, by area, with which next-event estimation samples points of a piece.
    fn density(&self, piece: usize) -> f64 {
        let radiance = |piece: &Piece| self.world.surfaces[piece.surface].radiance;
        let all: f64 = self
            .emitters
            .iter()
            .map(|&(index, _)| radiance(&self.pieces[index]) * self.pieces[index].area)
            .sum();
        radiance(&self.pieces[piece]) / all
    }

    /// Returns the first piece along a direction before a distance, with holes as pieces or open.
    fn hit(&self, origin: Vector, way: Vector, before: f64, is_through: bool) -> Option<Hit> {
        let mut nearest = None;
        let mut limit = before;
        for (index, piece) in self.pieces.iter().enumerate() {
            if is_through && self.world.surfaces[piece.surface].is_hole {
                continue;
            }
            let to = piece.middle - origin;
            let along = to.dot(way);
            if along + piece.reach < 0.0 || to.dot(to) - along * along > piece.reach * piece.reach {
                continue;
            }
            if let Some(distance) = piece.distance(origin, way).filter(|&distance| distance < limit) {
                limit = distance;
                nearest = Some((index, distance));
            }
        }
        nearest.map(|(piece, distance)| {
            let place = origin + distance * way;
            let normal = self.pieces[piece].normal(place);
            let is_front = normal.dot(way) < 0.0;
            Hit { piece, distance, place, normal: if is_front { normal } else { -1.0 * normal }, is_front }
        })
    }
}
