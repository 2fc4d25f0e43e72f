//! Light of images: what flat walls make of lights without extent is gathered at vertices, and scattered by media.

use super::images::Image;
use super::lattice::Lattice;
use super::optics::{MediumOptics, scaled, times};
use super::path::{Path, Tracer};
use super::vertex::Vertex;
use crate::geometry::Vector;
use crate::sampling::Samples;

impl<L: Lattice, const N: usize> Tracer<'_, L, N> {
    /// What comes from an image of a light to a vertex.
    pub(super) fn imaged(
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

    /// What a segment scatters of the light of an image.
    pub(super) fn imaged_segment(
        &self,
        path: &Path<N>,
        medium: &MediumOptics<N>,
        length: f64,
        samples: &mut Samples,
        add: &mut impl FnMut(&[f64; N], f64),
    ) {
        for (image, chance) in self.images.choose(samples.one(), false) {
            let lit = self.lit_point(path, medium, length, image.point(), samples);
            let Some((lit, vertex)) = lit else { continue };
            self.imaged(&lit, &vertex, (image, chance), &mut |_, value, way| add(value, way));
        }
    }
}
