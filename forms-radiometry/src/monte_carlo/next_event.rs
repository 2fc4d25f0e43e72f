//! Next-event estimation: from a vertex of a path a luminaire is looked for, and what it brings is weighed against finding it by chance.
//!
//! ```text
//! vertex ─▶ a luminaire, a direction to it ─┬─ nothing in between ─▶ radiance × law × what media leave, by the power heuristic
//! segment in a medium ─▶ a point of it ─▶ ┘ └─ hidden ─▶ the largest value that was missed
//! ```
//! Source: E. Veach, L. Guibas, Optimally combining sampling techniques for Monte Carlo rendering (1995).

use super::lattice::Lattice;
use super::luminaires::{Source, Towards};
use super::optics::{MediumOptics, mean, scaled, times};
use super::path::{Path, Tracer};
use super::vertex::Vertex;
use crate::geometry::{Start, Vector};
use crate::sampling::Draws;
use crate::scene::{Filling, MaterialKind};

/// A luminaire that is a point is reached where nothing is met before this part of the way.
const REACHED: f64 = 1.0 - 1e-12;

/// The part of two ways to find the same light that one of them has: the power heuristic.
pub(super) fn part(own: f64, other: f64) -> f64 {
    if own.is_infinite() {
        return 1.0;
    }
    let ratio = other / own;
    1.0 / (1.0 + ratio * ratio)
}

impl<L: Lattice, const N: usize> Tracer<'_, L, N> {
    /// What a segment scatters to its start of the light that comes straight from luminaires.
    pub(super) fn lit_segment(
        &self,
        path: &Path<N>,
        medium: &MediumOptics<N>,
        length: f64,
        draws: &mut Draws,
        add: &mut impl FnMut(&[f64; N], f64),
    ) {
        let samples = &mut draws.light;
        if L::MIRROR || L::REFRACTION {
            self.imaged_segment(path, medium, length, samples, add);
        }
        let sought = self.world.luminaires.sought(path.start.position, samples);
        let Some(luminaire) = sought else { return };
        let pivot = luminaire.point(samples.pair());
        let Some((lit, vertex)) = self.lit_point(path, medium, length, pivot, samples) else { return };
        if let Some(towards) = luminaire.towards(vertex.start.position, samples.pair()) {
            self.lit(&lit, &vertex, &towards, &mut draws.hidden, &mut |_, value, way| add(value, way));
        }
    }

    /// What comes straight from a luminaire to a vertex, whose weight the path has by now; with the direction that it comes from.
    pub(super) fn straight(
        &self,
        path: &Path<N>,
        vertex: &Vertex<N>,
        draws: &mut Draws,
        add: &mut impl FnMut(Vector, &[f64; N], f64),
    ) {
        let samples = &mut draws.light;
        if L::MIRROR || L::REFRACTION {
            // what a receiver, or the first thing that a ray meets, gets of them is the same for all its samples
            for image in self.images.choose(samples.one(), path.is_straight) {
                self.imaged(path, vertex, image, add);
            }
        }
        let position = vertex.start.position;
        let Some(luminaire) = self.world.luminaires.sought(position, samples) else { return };
        if let Some(towards) = luminaire.towards(position, samples.pair()) {
            self.lit(path, vertex, &towards, &mut draws.hidden, add);
        }
    }

    /// Adds what a luminaire brings to a vertex, or notes what it would have brought.
    fn lit(
        &self,
        path: &Path<N>,
        vertex: &Vertex<N>,
        towards: &Towards,
        hidden: &mut [f64],
        add: &mut impl FnMut(Vector, &[f64; N], f64),
    ) {
        let densities = vertex.law.density(towards.direction);
        let own = mean(&densities, self.count());
        if own == 0.0 {
            return;
        }
        let (radiance, part) = match towards.source {
            Source::Wall { surface, .. } => (&self.optics.radiances[surface], part(towards.density, own)),
            Source::Beam(light) => (&self.optics.beams[light], 1.0),
        };
        let unhidden = times(&times(&path.throughput, radiance), &densities);
        let unhidden = scaled(part / towards.density, &unhidden);
        let Some(reached) = self.reached(vertex.start, path.filling, path.way, towards) else { return };
        let value = times(&unhidden, &reached.left);
        if !reached.is_hidden {
            add(towards.direction, &value, reached.way);
        } else if !(path.is_same && matches!(towards.source, Source::Beam(_))) {
            // a beam that is hidden from one place is hidden from all samples there
            hidden.iter_mut().zip(value).for_each(|(hidden, value)| *hidden = hidden.max(value));
        }
    }

    /// What is on the way to a luminaire; none where that is not met, or is dark from this side.
    fn reached(
        &self,
        mut start: Start,
        mut filling: Filling,
        way: f64,
        towards: &Towards,
    ) -> Option<Reached<N>> {
        let has_media = L::ABSORPTION || L::SCATTERING;
        let mut reached = Reached { left: [1.0; N], way, is_hidden: false };
        let mut reach = towards.reach;
        loop {
            let within = if reach.is_finite() { REACHED * reach } else { reach };
            let met = self.world.walls.first(start, towards.direction, within);
            let length = met.as_ref().map_or(reach, |met| met.distance);
            let medium = self.medium(filling);
            if has_media {
                reached.left = times(&reached.left, &medium.transmittance(length));
            }
            reached.way = self.longer(reached.way, &medium, length);
            let Some(met) = met else {
                let is_beam = matches!(towards.source, Source::Beam(_));
                return is_beam.then_some(reached);
            };
            match towards.source {
                Source::Wall { wall, .. } if wall == met.wall => {
                    return self.world.is_bright(wall, met.is_front).then_some(reached);
                }
                _ => {}
            }
            let beyond = self.world.sheets[met.wall].filling(!met.is_front);
            let is_boundary = matches!(self.world.material(met.wall), MaterialKind::Dielectric { .. });
            reached.is_hidden |= !is_boundary || (L::REFRACTION && !self.optics.is_clear(filling, beyond));
            if reached.is_hidden && !has_media {
                return Some(reached);
            }
            start = self.world.walls.start_on(&met, !met.is_front);
            filling = beyond;
            reach -= length;
        }
    }
}

/// What is on the way from a vertex to a luminaire.
struct Reached<const N: usize> {
    /// What media leave of light.
    left: [f64; N],
    /// The optical length.
    way: f64,
    /// Whether something stands in between.
    is_hidden: bool,
}
