//! Light of images: what flat walls make of lights without extent, and flat mirrors of luminaires, is gathered at vertices, and scattered
//! by media.

use super::chains::Chain;
use super::choice::Sought;
use super::images::Image;
use super::lattice::Lattice;
use super::luminaires::{Luminaire, Towards};
use super::optics::{MediumOptics, scaled, times};
use super::path::{Path, Tracer};
use super::vertex::Vertex;
use crate::geometry::Vector;
use crate::sampling::{Draws, Samples};

/// A luminaire that is looked for in a chain of mirrors, and how likely these two are chosen.
struct Mirrored<'w> {
    chain: &'w Chain,
    luminaire: &'w Luminaire,
    chance: f64,
}

impl<L: Lattice, const N: usize> Tracer<'_, L, N> {
    /// What comes from images to a vertex, whose weight the path has by now; with the direction that it comes from.
    pub(super) fn by_images(
        &self,
        path: &Path<N>,
        vertex: &Vertex<N>,
        draws: &mut Draws,
        add: &mut impl FnMut(Vector, &[f64; N], f64),
    ) {
        if L::MIRROR || L::REFRACTION {
            // what a receiver, or the first thing that a ray meets, gets of them is the same for all its samples
            for image in self.images.choose(draws.light.one(), path.is_straight) {
                self.imaged(path, vertex, image, add);
            }
        }
        let position = vertex.start.position;
        let Some(mirrored) = self.mirrored(vertex.sought(), &mut draws.light) else { return };
        if let Some(towards) = self.towards(&mirrored, position, draws.light.pair()) {
            self.lit(path, vertex, (&towards, &mirrored.chain.steps), &mut draws.hidden, add);
        }
    }

    /// What a segment scatters of the light of images.
    pub(super) fn imaged_segment(
        &self,
        (path, sought): (&Path<N>, Sought),
        medium: &MediumOptics<N>,
        length: f64,
        draws: &mut Draws,
        add: &mut impl FnMut(&[f64; N], f64),
    ) {
        let samples = &mut draws.light;
        if L::MIRROR || L::REFRACTION {
            for (image, chance) in self.images.choose(samples.one(), false) {
                let lit = self.lit_point(path, medium, length, image.point(), samples);
                let Some((lit, vertex)) = lit else { continue };
                self.imaged(&lit, &vertex, (image, chance), &mut |_, value, way| add(value, way));
            }
        }
        let Some(mirrored) = self.mirrored(sought, samples) else { return };
        let point = mirrored.luminaire.point(samples.pair());
        let pivot = point.map(|point| self.world.chains.seen(mirrored.chain, point));
        let Some((lit, vertex)) = self.lit_point(path, medium, length, pivot, samples) else { return };
        if let Some(towards) = self.towards(&mirrored, vertex.start.position, samples.pair()) {
            let (steps, hidden) = (&mirrored.chain.steps, &mut draws.hidden);
            self.lit(&lit, &vertex, (&towards, steps), hidden, &mut |_, value, way| add(value, way));
        }
    }

    /// What comes from an image of a light to a vertex.
    fn imaged(
        &self,
        path: &Path<N>,
        vertex: &Vertex<N>,
        (image, chance): (&Image<N>, f64),
        add: &mut impl FnMut(Vector, &[f64; N], f64),
    ) {
        let Some(coming) = image.coming(self.world, &self.optics, vertex.start, path.filling) else { return };
        let densities = vertex.law.density(coming.direction);
        let value = times(&times(&path.throughput, &coming.irradiance), &densities);
        add(coming.direction, &scaled(1.0 / chance, &value), path.way + coming.way);
    }

    /// A luminaire that is looked for in mirrors, if any is.
    fn mirrored(&self, sought: Sought, samples: &mut Samples) -> Option<Mirrored<'_>> {
        let chains = &self.world.chains;
        if !L::MIRROR || chains.are_none() {
            return None;
        }
        let chain = chains.choose(samples.one())?;
        let (luminaire, chance) = self.world.luminaires.wall(chains.sought(chain, sought), samples)?;
        Some(Mirrored { chain, luminaire, chance: chain.chance * chance })
    }

    /// A direction from a point to a luminaire in mirrors.
    fn towards(&self, mirrored: &Mirrored<'_>, from: Vector, square: [f64; 2]) -> Option<Towards> {
        let (chains, chain) = (&self.world.chains, mirrored.chain);
        if !chains.is_before(chain, from) {
            return None;
        }
        let towards = mirrored.luminaire.towards(chains.image(chain, from), square, mirrored.chance)?;
        Some(Towards { direction: chains.seen_along(chain, towards.direction), ..towards })
    }
}
