//! Image light: the light of the images of point and distant lights in flat walls, and of emitters
//! in flat mirrors, is gathered at vertices and scattered by media.

use super::chains::Chain;
use super::choice::Sought;
use super::image_sources::Image;
use super::luminaires::{LightSample, Luminaire};
use super::optics::{MediumOptics, scaled, times};
use super::specialisation::Specialisation;
use super::tracer::{Path, Tracer};
use super::vertex::Vertex;
use crate::geometry::Vector;
use crate::sampling::{Draws, Samples};

/// An emitter that is sampled through a chain of mirrors, and the probability of selecting both.
struct Mirrored<'w> {
    chain: &'w Chain,
    luminaire: &'w Luminaire,
    chance: f64,
}

impl<L: Specialisation, const N: usize> Tracer<'_, L, N> {
    /// Adds the light of images at a vertex, with the direction that it comes from. The throughput
    /// of the path already includes the weight of the vertex.
    pub(crate) fn by_images(
        &self,
        path: &Path<N>,
        vertex: &Vertex<N>,
        draws: &mut Draws,
        add: &mut impl FnMut(Vector, &[f64; N], f64),
    ) {
        if L::MIRROR || L::REFRACTION {
            // the light of the images at a receiver, or at the first wall that a ray hits, is the
            // same for all samples
            for image in self.images.choose(draws.light.one(), path.is_straight) {
                self.imaged(path, vertex, image, add);
            }
        }
        let position = vertex.start.position;
        let Some(mirrored) = self.mirrored(vertex.sought(), &mut draws.light) else { return };
        if !self.is_allowed(path.events + mirrored.chain.steps.len() as u32) {
            return;
        }
        if let Some(towards) = self.towards(&mirrored, position, draws.light.pair()) {
            self.add_light_sample(path, vertex, (&towards, &mirrored.chain.steps), &mut draws.hidden, add);
        }
    }

    /// Adds the light of images that a segment scatters.
    pub(crate) fn imaged_segment(
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
                self.imaged(&lit, &vertex, (image, chance), &mut |_, value, optical_path_length| {
                    add(value, optical_path_length);
                });
            }
        }
        let Some(mirrored) = self.mirrored(sought, samples) else { return };
        if !self.is_allowed(path.events + 1 + mirrored.chain.steps.len() as u32) {
            return;
        }
        let point = mirrored.luminaire.point(samples.pair());
        let pivot = point.map(|point| self.world.chains.seen(mirrored.chain, point));
        let Some((lit, vertex)) = self.lit_point(path, medium, length, pivot, samples) else { return };
        if let Some(towards) = self.towards(&mirrored, vertex.start.position, samples.pair()) {
            let (steps, hidden) = (&mirrored.chain.steps, &mut draws.hidden);
            self.add_light_sample(
                &lit,
                &vertex,
                (&towards, steps),
                hidden,
                &mut |_, value, optical_path_length| add(value, optical_path_length),
            );
        }
    }

    /// Adds the light of one image of a light at a vertex.
    fn imaged(
        &self,
        path: &Path<N>,
        vertex: &Vertex<N>,
        (image, chance): (&Image<N>, f64),
        add: &mut impl FnMut(Vector, &[f64; N], f64),
    ) {
        if !self.is_allowed(path.events + image.events()) {
            return;
        }
        let Some(coming) = image.coming(self.world, &self.optics, vertex.start, path.filling) else { return };
        let densities = vertex.law.density(coming.direction);
        let value = times(&times(&path.throughput, &coming.irradiance), &densities);
        add(
            coming.direction,
            &scaled(1.0 / chance, &value),
            path.optical_path_length + coming.optical_path_length,
        );
    }

    /// Selects a chain of mirrors and an emitter to sample through it, if there are any.
    fn mirrored(&self, sought: Sought, samples: &mut Samples) -> Option<Mirrored<'_>> {
        let chains = &self.world.chains;
        if !L::MIRROR || chains.are_none() {
            return None;
        }
        let chain = chains.choose(samples.one())?;
        let (luminaire, chance) = self.world.luminaires.wall(chains.sought(chain, sought), samples)?;
        Some(Mirrored { chain, luminaire, chance: chain.chance * chance })
    }

    /// Samples a direction from a point to an emitter seen in mirrors.
    fn towards(&self, mirrored: &Mirrored<'_>, from: Vector, square: [f64; 2]) -> Option<LightSample> {
        let (chains, chain) = (&self.world.chains, mirrored.chain);
        if !chains.is_before(chain, from) {
            return None;
        }
        let towards = mirrored.luminaire.towards(chains.image(chain, from), square, mirrored.chance)?;
        Some(LightSample { direction: chains.seen_along(chain, towards.direction), ..towards })
    }
}
