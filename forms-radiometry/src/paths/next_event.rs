//! Next-event estimation: samples a light source from a vertex of a path, and weights its
//! contribution against path sampling by multiple importance sampling.
//!
//! ```text
//! vertex, or a point of a segment in a medium ─▶ a light source, a direction to it
//!     ├─ visible ─▶ radiance × law × transmittance × weight by the power heuristic
//!     └─ occluded ─▶ the largest contribution that was lost
//! ```
//! Source: E. Veach, L. Guibas, Optimally combining sampling techniques for Monte Carlo rendering
//! (1995).

use super::chains::Step;
use super::luminaires::{LightSample, Source};
use super::mirror::reflected;
use super::multiple_importance::mis_weight;
use super::optics::{MediumOptics, mean, scaled, times};
use super::specialisation::Specialisation;
use super::tracer::{Path, Tracer};
use super::vertex::Vertex;
use crate::geometry::Vector;
use crate::sampling::{Draws, Samples};
use crate::scene::MaterialKind;
use crate::visibility::Start;

/// A light source is reached if the ray hits nothing before this fraction of its distance.
const REACHED: f64 = 1.0 - 1e-12;

/// Returns the distance before which walls hide a light source at this distance.
fn before(reach: f64) -> f64 {
    if reach.is_finite() { REACHED * reach } else { reach }
}

impl<L: Specialisation, const N: usize> Tracer<'_, L, N> {
    /// Adds the light from light sources that a segment scatters towards its start, both direct and
    /// from images.
    pub(super) fn lit_segment(
        &self,
        path: &Path<N>,
        medium: &MediumOptics<N>,
        length: f64,
        draws: &mut Draws,
        add: &mut impl FnMut(&[f64; N], f64),
    ) {
        let sought = self.world.luminaires.sought_along(path.start.position, path.direction, length);
        self.imaged_segment((path, sought), medium, length, draws, add);
        let Draws { light: samples, hidden, .. } = draws;
        let luminaires = &self.world.luminaires;
        let beams = luminaires.beams(sought, samples);
        if let Some(towards) = self.towards_environment(samples)
            && let Some((lit, vertex)) = self.lit_point(path, medium, length, None, samples)
        {
            self.add_light_sample(&lit, &vertex, (&towards, &[]), hidden, &mut |_, value, length| {
                add(value, length);
            });
        }
        for (luminaire, chance) in beams.chain(luminaires.wall(sought, samples)) {
            let pivot = luminaire.point(samples.pair());
            let lit = self.lit_point(path, medium, length, pivot, samples);
            let Some((lit, vertex)) = lit else { continue };
            if let Some(towards) = luminaire.towards(vertex.start.position, samples.pair(), chance) {
                self.add_light_sample(
                    &lit,
                    &vertex,
                    (&towards, &[]),
                    hidden,
                    &mut |_, value, optical_path_length| add(value, optical_path_length),
                );
            }
        }
    }

    /// Adds the direct light from light sources at a vertex, with the direction that it comes from.
    /// The throughput of the path already includes the weight of the vertex.
    pub(super) fn sample_direct_light(
        &self,
        path: &Path<N>,
        vertex: &Vertex<N>,
        draws: &mut Draws,
        add: &mut impl FnMut(Vector, &[f64; N], f64),
    ) {
        let Draws { light: samples, hidden, .. } = draws;
        let position = vertex.start.position;
        let luminaires = &self.world.luminaires;
        for (beam, chance) in luminaires.beams(vertex.sought(), samples) {
            if let Some(towards) = beam.towards(position, [0.0; 2], chance) {
                self.add_light_sample(path, vertex, (&towards, &[]), hidden, add);
            }
        }
        if let Some(towards) = self.towards_environment(samples) {
            self.add_light_sample(path, vertex, (&towards, &[]), hidden, add);
        }
        let Some((luminaire, chance)) = luminaires.wall(vertex.sought(), samples) else { return };
        if let Some(towards) = luminaire.towards(position, samples.pair(), chance) {
            self.add_light_sample(path, vertex, (&towards, &[]), hidden, add);
        }
    }

    /// Samples a direction to the environment map, if there is one.
    fn towards_environment(&self, samples: &mut Samples) -> Option<LightSample> {
        let (direction, density) = self.world.environment.as_ref()?.sample(samples.pair())?;
        let source = Source::Environment;
        Some(LightSample { source, direction, reach: f64::INFINITY, density, chance: 1.0 })
    }

    /// Adds the contribution of a light source at a vertex by these mirrors, or records it as lost
    /// to occlusion.
    pub(super) fn add_light_sample(
        &self,
        path: &Path<N>,
        vertex: &Vertex<N>,
        (towards, steps): (&LightSample, &[Step]),
        hidden: &mut [f64],
        add: &mut impl FnMut(Vector, &[f64; N], f64),
    ) {
        let densities = vertex.law.density(towards.direction);
        let own = mean(&densities, self.count());
        if own == 0.0 {
            return;
        }
        let (radiance, part) = match towards.source {
            Source::Wall { surface, .. } => {
                (self.optics.radiances[surface], mis_weight(towards.density, own))
            }
            Source::Environment => (self.optics.outside(towards.direction), mis_weight(towards.density, own)),
            Source::Beam(light) => (self.optics.beams[light], 1.0),
        };
        let brings = times(&path.throughput, &radiance);
        let unhidden = scaled(part / towards.density, &times(&brings, &densities));
        let Some(reached) = self.reached(path, vertex.start, towards, steps) else { return };
        let value = times(&unhidden, &reached.left);
        if !reached.is_hidden {
            add(towards.direction, &value, reached.optical_path_length);
        } else if !(path.is_same && towards.chance == 1.0 && matches!(towards.source, Source::Beam(_))) {
            // a beam that is occluded at one place is occluded for all samples there
            miss(hidden, &value);
        }
    }

    /// Traces a ray from a vertex to a light source that every other wall hides: whichever wall is met
    /// hides it. `None` if the ray misses the light source or hits its dark side.
    fn reached_past_all(&self, path: &Path<N>, start: Start, towards: &LightSample) -> Option<Reached<N>> {
        let (walls, direction) = (&self.world.walls, towards.direction);
        let (reach, but) = match towards.source {
            Source::Wall { wall, .. } => {
                let (distance, is_front) = walls.at(wall, start, direction)?;
                (self.world.is_bright(wall, is_front).then_some(distance)?, Some(wall))
            }
            Source::Beam(_) | Source::Environment => (towards.reach, None),
        };
        let is_hidden = walls.are_between(start, direction, before(reach), but);
        let medium = self.medium(path.filling);
        let optical_path_length = self.longer(path.optical_path_length, &medium, reach);
        Some(Reached { left: [1.0; N], optical_path_length, is_hidden })
    }

    /// Traces a ray from a vertex to a light source. `None` if the ray misses the light source or
    /// hits its dark side. A mirror that is not where the chain needs it counts as an occluder.
    fn reached(
        &self,
        path: &Path<N>,
        mut start: Start,
        towards: &LightSample,
        steps: &[Step],
    ) -> Option<Reached<N>> {
        let has_media = L::ABSORPTION || L::SCATTERING;
        let mut reached =
            Reached { left: [1.0; N], optical_path_length: path.optical_path_length, is_hidden: false };
        if self.world.is_opaque && steps.is_empty() && !has_media {
            return self.reached_past_all(path, start, towards);
        }
        let (mut filling, mut direction, mut reach) = (path.filling, towards.direction, towards.reach);
        let mut steps = steps.iter();
        loop {
            let met = self.world.walls.first(start, direction, before(reach));
            let length = met.as_ref().map_or(reach, |met| met.distance);
            let medium = self.medium(filling);
            if has_media {
                reached.left = times(&reached.left, &medium.transmittance(length));
            }
            reached.optical_path_length = self.longer(reached.optical_path_length, &medium, length);
            let Some(met) = met else {
                let is_wall = matches!(towards.source, Source::Wall { .. });
                reached.is_hidden |= steps.len() > 0;
                return (!is_wall || reached.is_hidden).then_some(reached);
            };
            match towards.source {
                Source::Wall { wall, .. } if wall == met.wall && steps.len() == 0 => {
                    return self.world.is_bright(wall, met.is_front).then_some(reached);
                }
                _ => {}
            }
            if steps.as_slice().first().is_some_and(|&step| self.world.chains.is_at(step, &met)) {
                steps.next();
                let normal = if met.is_front { met.normal } else { -met.normal };
                let material = self.world.material(met.wall);
                let passage = reflected(material, &self.optics, &medium, direction, normal);
                (direction, reached.left, _) = passage.applied(&reached.left);
                start = self.world.walls.start_on(&met, met.is_front);
                continue;
            }
            let beyond = self.world.interfaces[met.wall].filling(!met.is_front);
            let is_boundary = matches!(self.world.material(met.wall), MaterialKind::Dielectric { .. });
            reached.is_hidden |= !is_boundary || (L::REFRACTION && !self.optics.is_clear(filling, beyond));
            if reached.is_hidden && (!has_media || steps.len() > 0) {
                return Some(reached);
            }
            start = self.world.walls.start_on(&met, !met.is_front);
            filling = beyond;
            reach -= length;
        }
    }
}

/// Records the contribution that a sample lost to occlusion.
fn miss<const N: usize>(hidden: &mut [f64], values: &[f64; N]) {
    hidden.iter_mut().zip(values).for_each(|(hidden, &value)| *hidden = hidden.max(value));
}

/// Result of tracing a ray from a vertex to a light source.
struct Reached<const N: usize> {
    /// Transmittance of the media times reflectance of the mirrors.
    left: [f64; N],
    /// Optical path length.
    optical_path_length: f64,
    /// Whether an occluder is in the way.
    is_hidden: bool,
}
