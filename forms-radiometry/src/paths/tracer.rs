//! Path tracing: a ray and its throughput become contributions, from vertex to vertex.
//!
//! ```text
//! ray ─▶ next wall ─┬─ light of light sources that the medium scatters on the segment (scattering)
//!                   ├─ scattered before it ─▶ a vertex in the medium                  (scattering)
//!                   └─ wall ─▶ emitted radiance, with the MIS weight against next-event estimation
//!                          │   at the last vertex
//!                          ├─ diffuse ─▶ light from light sources, and a vertex on the wall
//!                          └─ mirror, metal, boundary ─▶ a ray
//! ```
//! Throughput never grows: where it has become small, Russian roulette ends the path or continues
//! it with the throughput of the threshold. So no path counts more than the first ones of its kind,
//! and the variance is finite wherever the sum of all orders is.

use super::boundary::Passage;
use super::choice::Sought;
use super::image_sources::Images;
use super::mirror::reflected;
use super::multiple_importance::mis_weight;
use super::optics::{MediumOptics, Optics, largest, scaled, times};
use super::refraction::refracted;
use super::scattering::Flight;
use super::specialisation::Specialisation;
use super::time::longer;
use super::vertex::{Law, Vertex};
use super::world::{Side, World};
use crate::effects::SimulatedEffects;
use crate::geometry::Vector;
use crate::sampling::{Draws, Random, Samples};
use crate::scene::{Effect, Filling, MaterialKind};
use crate::visibility::{Met, Start};
use std::marker::PhantomData;

/// Russian roulette starts below this throughput. A smaller value makes paths longer, and reduces
/// the variance that comes from their random lengths.
const ROULETTE_THRESHOLD: f64 = 0.1;
/// Maximum number of consecutive specular events. A path that reaches it is caught where light from
/// light sources cannot get either; otherwise the scene would have been rejected.
const MAX_SPECULAR_DEPTH: u32 = 4096;

/// Maximum number of diffuse reflections and of scatterings by media, and whether direct light
/// counts. A surface that is seen along a ray reflects once more, towards the eye.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    pub(crate) reflections: Option<u32>,
    pub(crate) scatterings: Option<u32>,
    /// Whether direct light from light sources to a receiver counts.
    pub(crate) direct: bool,
}

impl Limits {
    /// Returns the limits of simulated effects.
    pub(crate) fn of(effects: &SimulatedEffects) -> Self {
        let SimulatedEffects { orders, scatterings, .. } = *effects;
        Self { reflections: orders, scatterings, direct: effects.has(Effect::Direct) }
    }
}

/// Path tracer, specialised for the effects of a member of the lattice.
pub(crate) struct Tracer<'w, L, const N: usize> {
    pub(crate) world: &'w World,
    pub(crate) optics: Optics<N>,
    pub(crate) images: Images<N>,
    pub(crate) limits: Limits,
    pub(crate) effects: PhantomData<L>,
}

/// State of a path.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Path<const N: usize> {
    pub(crate) start: Start,
    pub(crate) direction: Vector,
    pub(crate) filling: Filling,
    pub(crate) throughput: [f64; N],
    /// Optical path length so far, the integral of the index.
    pub(crate) optical_path_length: f64,
    /// The last vertex, as the mirrors since then show it, and the density of the direction there.
    /// The density is infinite if next-event estimation could not have found the light source from
    /// that vertex.
    pub(crate) vertex: Vector,
    pub(crate) density: f64,
    /// Point or segment for which light sources were selected at the last vertex: the vertex, or
    /// the segment on which it lies; as mirrors show it.
    pub(crate) sought: Sought,
    /// The chain of these mirrors.
    pub(crate) chain: usize,
    pub(crate) reflections: u32,
    /// Maximum number of diffuse reflections.
    pub(crate) most: Option<u32>,
    pub(crate) scatterings: u32,
    /// Number of events so far: reflections, refractions and scatterings of any kind.
    pub(crate) events: u32,
    /// Number of specular events since the last vertex.
    pub(crate) specular_depth: u32,
    /// Whether the light has not been reflected, refracted or scattered yet.
    pub(crate) is_straight: bool,
    /// Whether all samples of the estimand have followed the same path so far.
    pub(crate) is_same: bool,
}

pub(crate) fn is_below(count: u32, most: Option<u32>) -> bool {
    most.is_none_or(|most| count < most)
}

impl<L: Specialisation, const N: usize> Tracer<'_, L, N> {
    /// Returns the number of bands.
    pub(crate) fn count(&self) -> usize {
        if N == 1 { 1 } else { self.optics.bands[1] }
    }

    pub(crate) fn medium(&self, filling: Filling) -> MediumOptics<N> {
        self.optics.medium(filling)
    }

    /// Returns the optical path length after a further distance. It stays unchanged if no receiver
    /// is time-resolved.
    pub(crate) fn longer(&self, optical_path_length: f64, medium: &MediumOptics<N>, distance: f64) -> f64 {
        if L::TIME { longer(optical_path_length, medium, distance) } else { optical_path_length }
    }

    /// Traces a path to its end, and adds its contributions: a value for each band, and the optical
    /// path length.
    pub(crate) fn follow(&self, mut path: Path<N>, draws: &mut Draws, add: &mut impl FnMut(&[f64; N], f64)) {
        while !draws.is_cut() {
            let met = self.world.walls.first(path.start, path.direction, f64::INFINITY);
            let length = met.as_ref().map_or(f64::INFINITY, |met| met.distance);
            let medium = self.medium(path.filling);
            let scatters = L::SCATTERING && medium.scatters();
            let may_scatter = is_below(path.scatterings, self.limits.scatterings);
            if scatters && may_scatter && self.is_allowed(path.events + 1) {
                self.lit_segment(&path, &medium, length, draws, add);
                match self.flight(&path, &medium, met.as_ref(), &mut draws.path, add) {
                    Flight::Scattered(distance, factor) => {
                        path.throughput = times(&path.throughput, &factor);
                        self.scatter_in_medium(&mut path, &medium, [distance, length], &mut draws.path);
                        if self.is_endless(&path, &medium)
                            || !self.russian_roulette(&mut path, &mut draws.chance)
                        {
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
                || !self.russian_roulette(&mut path, &mut draws.chance)
            {
                return;
            }
        }
    }

    /// Adds the light from the end of a segment to a path that reached it.
    pub(crate) fn arrives(
        &self,
        path: &mut Path<N>,
        met: Option<&Met>,
        medium: &MediumOptics<N>,
        add: &mut impl FnMut(&[f64; N], f64),
    ) {
        if let Some(met) = met {
            path.optical_path_length = self.longer(path.optical_path_length, medium, met.distance);
            self.emitted(path, met, add);
        } else if self.limits.direct || !path.is_straight {
            self.light_from_outside(path, add);
        }
    }

    /// Adds the light from outside, which next-event estimation at the last vertex could have sampled
    /// if there is an environment map and no mirror since then.
    fn light_from_outside(&self, path: &Path<N>, add: &mut impl FnMut(&[f64; N], f64)) {
        let part = match &self.world.environment {
            Some(light) if path.density.is_finite() && path.chain == 0 => {
                mis_weight(path.density, light.density(path.direction))
            }
            _ => 1.0,
        };
        let radiance = self.optics.outside(path.direction);
        add(&scaled(part, &times(&path.throughput, &radiance)), f64::INFINITY);
    }

    /// Adds the light that a wall emits into the path.
    fn emitted(&self, path: &Path<N>, met: &Met, add: &mut impl FnMut(&[f64; N], f64)) {
        let radiance = &self.optics.radiances[self.world.interfaces[met.wall].surface];
        let is_lit = largest(radiance) > 0.0 && self.world.is_bright(met.wall, met.is_front);
        if !is_lit || (path.is_straight && !self.limits.direct) {
            return;
        }
        let part = if path.density.is_finite() {
            let seen = self.world.luminaires.density(path.sought, path.vertex, path.direction, met);
            mis_weight(path.density, self.world.chains.chance(path.chain) * seen)
        } else {
            1.0
        };
        add(&scaled(part, &times(&path.throughput, radiance)), path.optical_path_length);
    }

    /// Applies the interaction of the wall to the path; returns whether the path continues.
    fn interacts(
        &self,
        path: &mut Path<N>,
        met: &Met,
        medium: &MediumOptics<N>,
        draws: &mut Draws,
        add: &mut impl FnMut(&[f64; N], f64),
    ) -> bool {
        if !self.continues_from(path, met) {
            return false;
        }
        let (interface, material) = (&self.world.interfaces[met.wall], self.world.material(met.wall));
        let Side { is_front, normal, is_smooth } = self.world.side(met, path.direction);
        if let MaterialKind::Dielectric { .. } = material {
            let beyond = interface.filling(!met.is_front);
            let media = [medium, &self.medium(beyond)];
            let continues = self.crosses(path, met, media, beyond, normal, &mut draws.path);
            if is_smooth {
                path.filling = interface.filling(met.normal.dot(path.direction) > 0.0);
            }
            return continues;
        }
        if let MaterialKind::Diffuse { .. } = material {
            path.throughput = times(&path.throughput, &self.world.reflectance(&self.optics, met));
            let start = self.world.walls.start_on(met, is_front);
            self.scatters(path, &Vertex { start, law: Law::Plane(normal) }, draws, add);
            return true;
        }
        if let MaterialKind::Plastic { .. } = material {
            return self.coated(path, met, (is_front, normal), draws, add);
        }
        if let MaterialKind::Rough(_) = material {
            return self.roughened(path, met, medium, (is_front, normal), draws, add);
        }
        if L::MIRROR {
            let passage = reflected(material, &self.optics, medium, path.direction, normal);
            return self.passes(path, met, passage);
        }
        false
    }

    /// Adds the direct light at a vertex on a surface that scatters light, and continues the path from
    /// there.
    pub(super) fn scatters(
        &self,
        path: &mut Path<N>,
        vertex: &Vertex<N>,
        draws: &mut Draws,
        add: &mut impl FnMut(&[f64; N], f64),
    ) {
        path.reflections += 1;
        path.events += 1;
        self.by_images(path, vertex, draws, &mut |_, value, optical_path_length| {
            add(value, optical_path_length);
        });
        self.sample_direct_light(path, vertex, draws, &mut |_, value, optical_path_length| {
            add(value, optical_path_length);
        });
        self.scatter(path, vertex, &mut draws.path);
    }

    /// Continues the path from a smooth surface; returns whether the path can still escape.
    pub(super) fn passes(&self, path: &mut Path<N>, met: &Met, passage: Passage<N>) -> bool {
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
        path.specular_depth += 1;
        path.events += 1;
        path.specular_depth < MAX_SPECULAR_DEPTH
    }

    /// Crosses the boundary of two media, or is reflected there; returns whether the path
    /// continues.
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

    /// Whether a path can have this number of events.
    pub(crate) fn is_allowed(&self, events: u32) -> bool {
        self.world.scene.solve.events.is_none_or(|most| events <= most)
    }

    /// Plays Russian roulette with a path of small throughput; survivors get the throughput of the
    /// threshold.
    fn russian_roulette(&self, path: &mut Path<N>, chance: &mut Random) -> bool {
        let weight = largest(&path.throughput);
        if weight >= ROULETTE_THRESHOLD {
            return true;
        }
        let part = weight / ROULETTE_THRESHOLD;
        path.throughput = path.throughput.map(|t| t / part);
        weight > 0.0 && chance.next() < part
    }

    /// Continues a path from a vertex in a direction sampled by the law of the vertex.
    pub(crate) fn scatter(&self, path: &mut Path<N>, vertex: &Vertex<N>, samples: &mut Samples) {
        let direction = vertex.law.direction(self.count(), samples);
        let (weights, density) = vertex.law.weights(direction, self.count());
        path.throughput = times(&path.throughput, &weights);
        (path.start, path.direction, path.vertex) = (vertex.start, direction, vertex.start.position);
        (path.sought, path.chain) = (vertex.sought(), 0);
        path.density = if self.world.samples_lights() { density } else { f64::INFINITY };
        (path.is_straight, path.is_same) = (false, false);
        path.specular_depth = 0;
    }

    /// Scatters a path at a distance along a segment of this length.
    fn scatter_in_medium(
        &self,
        path: &mut Path<N>,
        medium: &MediumOptics<N>,
        [distance, length]: [f64; 2],
        samples: &mut Samples,
    ) {
        path.optical_path_length = self.longer(path.optical_path_length, medium, distance);
        path.scatterings += 1;
        path.events += 1;
        let vertex = self.scattering(path, medium, distance);
        let sought = self.world.luminaires.sought_along(path.start.position, path.direction, length);
        self.scatter(path, &vertex, samples);
        path.sought = sought;
    }

    /// Returns the vertex at a distance along the path.
    fn scattering(&self, path: &Path<N>, medium: &MediumOptics<N>, distance: f64) -> Vertex<'_, N> {
        let position = path.start.position + distance * path.direction;
        let law = Law::Phase { forward: path.direction, asymmetry: medium.asymmetry };
        Vertex { start: self.world.walls.start_free(position), law }
    }

    /// Samples a point of a segment from which light sources are sampled, and returns the path up
    /// to that point.
    pub(crate) fn lit_point(
        &self,
        path: &Path<N>,
        medium: &MediumOptics<N>,
        length: f64,
        pivot: Option<Vector>,
        samples: &mut Samples,
    ) -> Option<(Path<N>, Vertex<'_, N>)> {
        let ray = [path.start.position, path.direction];
        let (distance, factor) = medium.lit_point(ray, length, pivot, self.count(), samples)?;
        let mut lit = *path;
        lit.throughput = times(&path.throughput, &factor);
        lit.events += 1;
        lit.optical_path_length = self.longer(path.optical_path_length, medium, distance);
        lit.is_same = false;
        Some((lit, self.scattering(path, medium, distance)))
    }
}
