//! Paths: a ray and what it would bring become contributions, from vertex to vertex.
//!
//! ```text
//! ray ─▶ next wall ─┬─ light that the medium scatters into the segment, from luminaires      (scattering)
//!                   ├─ scattered before it ─▶ a vertex in the medium                          (scattering)
//!                   └─ wall ─▶ what it emits, weighed against what was found at the last vertex
//!                          ├─ diffuse ─▶ light from luminaires, and a vertex on the wall
//!                          └─ mirror, metal, boundary ─▶ a ray
//! ```
//! Weights of paths never grow: where one has become small, the path ends at random, and goes on with the weight of the limit. So
//! no path counts more than the first ones of its kind, and the variance is finite wherever the sum of all orders is.

use super::boundary::Passage;
use super::choice::Sought;
use super::images::Images;
use super::lattice::Lattice;
use super::mirror::reflected;
use super::next_event::part;
use super::optics::{MediumOptics, Optics, largest, scaled, times};
use super::refraction::refracted;
use super::scattering::Flight;
use super::time::longer;
use super::vertex::{Law, Vertex};
use super::world::World;
use crate::geometry::{Met, Start, Vector};
use crate::sampling::{Draws, Random, Samples};
use crate::scene::{Filling, MaterialKind};
use std::marker::PhantomData;

/// Paths of less weight than this end at random. The smaller it is, the longer paths are, and the less their lengths spread what they find.
const FAINT: f64 = 0.1;
/// A path that has been reflected or bent so often without being spread is caught where light from luminaires cannot get either: else the
/// scene would have been refused.
const CAUGHT: u32 = 4096;

/// How often light is reflected by diffuse surfaces and scattered by media at most, and what counts. A surface that is seen along a ray reflects
/// to the eye besides.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    pub(crate) reflections: Option<u32>,
    pub(crate) scatterings: Option<u32>,
    /// Whether light that comes straight from luminaires to a receiver counts.
    pub(crate) direct: bool,
}

/// Follows paths with the effects of a lattice's member.
pub(super) struct Tracer<'w, L, const N: usize> {
    pub(super) world: &'w World<'w>,
    pub(super) optics: Optics<N>,
    pub(super) images: Images<N>,
    pub(super) limits: Limits,
    pub(super) effects: PhantomData<L>,
}

/// A path on its way.
#[derive(Clone, Copy, Debug)]
pub(super) struct Path<const N: usize> {
    pub(super) start: Start,
    pub(super) direction: Vector,
    pub(super) filling: Filling,
    pub(super) throughput: [f64; N],
    /// The optical length so far, the integral of the index.
    pub(super) way: f64,
    /// The last vertex, as the mirrors since then show it, and the density that the direction had there; without end where a luminaire could not
    /// have been found from there.
    pub(super) vertex: Vector,
    pub(super) density: f64,
    /// Where luminaires were looked for from the last vertex: there, or along the segment on which it is; as mirrors show it.
    pub(super) sought: Sought,
    /// The chain of these mirrors.
    pub(super) chain: usize,
    pub(super) reflections: u32,
    /// How often diffuse surfaces may reflect it at most.
    pub(super) most: Option<u32>,
    pub(super) scatterings: u32,
    /// How often it was reflected or bent since it was spread last.
    pub(super) turns: u32,
    /// Whether nothing has happened to the light yet.
    pub(super) is_straight: bool,
    /// Whether all samples of the question went the same way so far.
    pub(super) is_same: bool,
}

pub(super) fn may_go_on(count: u32, most: Option<u32>) -> bool {
    most.is_none_or(|most| count < most)
}

impl<L: Lattice, const N: usize> Tracer<'_, L, N> {
    /// How many bands there are.
    pub(super) fn count(&self) -> usize {
        if N == 1 { 1 } else { self.optics.bands[1] }
    }

    pub(super) fn medium(&self, filling: Filling) -> MediumOptics<N> {
        self.optics.medium(filling)
    }

    /// The optical length of a way after a distance more; where nobody asks for the time it stays what it was.
    pub(super) fn longer(&self, way: f64, medium: &MediumOptics<N>, distance: f64) -> f64 {
        if L::TIME { longer(way, medium, distance) } else { way }
    }

    /// Follows a path to its end, and adds what it finds: a value for each band, and the optical length.
    pub(super) fn follow(&self, mut path: Path<N>, draws: &mut Draws, add: &mut impl FnMut(&[f64; N], f64)) {
        loop {
            let met = self.world.walls.first(path.start, path.direction, f64::INFINITY);
            let length = met.as_ref().map_or(f64::INFINITY, |met| met.distance);
            let medium = self.medium(path.filling);
            let scatters = L::SCATTERING && medium.scatters();
            if scatters && may_go_on(path.scatterings, self.limits.scatterings) {
                self.lit_segment(&path, &medium, length, draws, add);
                match self.flight(&path, &medium, met.as_ref(), &mut draws.path, add) {
                    Flight::Scattered(distance, factor) => {
                        path.throughput = times(&path.throughput, &factor);
                        self.scatter(&mut path, &medium, [distance, length], &mut draws.path);
                        if self.is_endless(&path, &medium) || !self.goes_on(&mut path, &mut draws.chance) {
                            return;
                        }
                        continue;
                    }
                    Flight::Passed(factor) => path.throughput = times(&path.throughput, &factor),
                    Flight::Nothing => return,
                }
            } else if scatters || L::ABSORPTION {
                path.throughput = times(&path.throughput, &medium.transmittance(length));
            }
            self.arrives(&mut path, met.as_ref(), &medium, add);
            let Some(met) = met else { return };
            if !self.interacts(&mut path, &met, &medium, draws, add)
                || !self.goes_on(&mut path, &mut draws.chance)
            {
                return;
            }
        }
    }

    /// Adds what comes from where a segment ends to a path that got there.
    pub(super) fn arrives(
        &self,
        path: &mut Path<N>,
        met: Option<&Met>,
        medium: &MediumOptics<N>,
        add: &mut impl FnMut(&[f64; N], f64),
    ) {
        if let Some(met) = met {
            path.way = self.longer(path.way, medium, met.distance);
            self.emitted(path, met, add);
        } else if self.limits.direct || !path.is_straight {
            add(&times(&path.throughput, &self.optics.outside), f64::INFINITY);
        }
    }

    /// What a wall emits to the path.
    fn emitted(&self, path: &Path<N>, met: &Met, add: &mut impl FnMut(&[f64; N], f64)) {
        let radiance = &self.optics.radiances[self.world.sheets[met.wall].surface];
        let is_lit = largest(radiance) > 0.0 && self.world.is_bright(met.wall, met.is_front);
        if !is_lit || (path.is_straight && !self.limits.direct) {
            return;
        }
        let part = if path.density.is_finite() {
            let seen = self.world.luminaires.density(path.sought, path.vertex, path.direction, met);
            part(path.density, self.world.chains.chance(path.chain) * seen)
        } else {
            1.0
        };
        add(&scaled(part, &times(&path.throughput, radiance)), path.way);
    }

    /// What the wall does with the path; whether it goes on.
    fn interacts(
        &self,
        path: &mut Path<N>,
        met: &Met,
        medium: &MediumOptics<N>,
        draws: &mut Draws,
        add: &mut impl FnMut(&[f64; N], f64),
    ) -> bool {
        if !self.goes_on_from(path, met) {
            return false;
        }
        let (sheet, material) = (&self.world.sheets[met.wall], self.world.material(met.wall));
        let normal = if met.is_front { met.normal } else { -met.normal };
        if let MaterialKind::Dielectric { .. } = material {
            let beyond = sheet.filling(!met.is_front);
            return self.crosses(path, met, [medium, &self.medium(beyond)], beyond, normal, &mut draws.path);
        }
        if let MaterialKind::Diffuse { .. } = material {
            path.throughput = times(&path.throughput, &self.optics.reflectances[sheet.surface]);
            path.reflections += 1;
            let vertex =
                Vertex { start: self.world.walls.start_on(met, met.is_front), law: Law::Plane(normal) };
            self.by_images(path, &vertex, draws, &mut |_, value, way| add(value, way));
            self.straight(path, &vertex, draws, &mut |_, value, way| add(value, way));
            self.leaves(path, &vertex, &mut draws.path);
            return true;
        }
        if L::MIRROR {
            let passage = reflected(material, &self.optics, medium, path.direction, normal);
            return self.passes(path, met, passage);
        }
        false
    }

    /// Sends the path on from a smooth surface; whether it can still get away.
    fn passes(&self, path: &mut Path<N>, met: &Met, passage: Passage<N>) -> bool {
        let (direction, throughput, stays) = passage.applied(&path.throughput);
        (path.direction, path.throughput) = (direction, throughput);
        path.start = self.world.walls.start_on(met, met.is_front == stays);
        match self.world.chains.after(path.chain, met) {
            Some((chain, plane)) => {
                path.chain = chain;
                (path.vertex, path.sought) = (plane.mirrored(path.vertex), path.sought.mirrored(plane));
            }
            None => path.density = f64::INFINITY,
        }
        path.is_straight = false;
        path.turns += 1;
        path.turns < CAUGHT
    }

    /// Crosses the boundary of two media, or is reflected there.
    fn crosses(
        &self,
        path: &mut Path<N>,
        met: &Met,
        [medium, other]: [&MediumOptics<N>; 2],
        beyond: Filling,
        normal: Vector,
        samples: &mut Samples,
    ) -> bool {
        if L::REFRACTION && medium.index != other.index {
            let passage = refracted([medium, other], path.direction, normal, samples.one());
            path.is_same = false;
            if let Passage::Refracted(..) = passage {
                path.filling = beyond;
            }
            return self.passes(path, met, passage);
        }
        path.start = self.world.walls.start_on(met, !met.is_front);
        path.filling = beyond;
        true
    }

    /// Ends a path of little weight at random, and gives the others the weight of those that ended.
    fn goes_on(&self, path: &mut Path<N>, chance: &mut Random) -> bool {
        let weight = largest(&path.throughput);
        if weight >= FAINT {
            return true;
        }
        let part = weight / FAINT;
        path.throughput = path.throughput.map(|t| t / part);
        weight > 0.0 && chance.next() < part
    }

    /// Lets a path go on from a vertex by its law.
    pub(super) fn leaves(&self, path: &mut Path<N>, vertex: &Vertex<N>, samples: &mut Samples) {
        let direction = vertex.law.direction(self.count(), samples);
        let (weights, density) = vertex.law.weights(direction, self.count());
        path.throughput = times(&path.throughput, &weights);
        (path.start, path.direction, path.vertex) = (vertex.start, direction, vertex.start.position);
        (path.sought, path.chain) = (vertex.sought(), 0);
        path.density = if self.world.luminaires.are_met() { density } else { f64::INFINITY };
        (path.is_straight, path.is_same) = (false, false);
        path.turns = 0;
    }

    /// Scatters a path at a distance along a segment of this length.
    fn scatter(
        &self,
        path: &mut Path<N>,
        medium: &MediumOptics<N>,
        [distance, length]: [f64; 2],
        samples: &mut Samples,
    ) {
        path.way = self.longer(path.way, medium, distance);
        path.scatterings += 1;
        let vertex = self.scattering(path, medium, distance);
        let sought = self.world.luminaires.sought_along(path.start.position, path.direction, length);
        self.leaves(path, &vertex, samples);
        path.sought = sought;
    }

    /// The vertex at a distance along the path.
    fn scattering(&self, path: &Path<N>, medium: &MediumOptics<N>, distance: f64) -> Vertex<N> {
        let position = path.start.position + distance * path.direction;
        let law = Law::Phase { forward: path.direction, asymmetry: medium.asymmetry };
        Vertex { start: self.world.walls.start_free(position), law }
    }

    /// A point of a segment at which light is looked for, and the path as far as there.
    pub(super) fn lit_point(
        &self,
        path: &Path<N>,
        medium: &MediumOptics<N>,
        length: f64,
        pivot: Option<Vector>,
        samples: &mut Samples,
    ) -> Option<(Path<N>, Vertex<N>)> {
        let ray = [path.start.position, path.direction];
        let (distance, factor) = medium.lit_point(ray, length, pivot, self.count(), samples)?;
        let mut lit = *path;
        lit.throughput = times(&path.throughput, &factor);
        lit.way = self.longer(path.way, medium, distance);
        lit.is_same = false;
        Some((lit, self.scattering(path, medium, distance)))
    }
}
