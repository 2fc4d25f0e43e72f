//! Vertices: points where light is scattered into many directions, and the directional density
//! (law) of the scattering.
//!
//! ```text
//! plane    cos θ/π      a diffuse surface, or a flat receiver: E = π ∫ L cos θ/π dω
//! sphere   1/(4π)       a receiver of light from all sides: φ = 4π ∫ L/(4π) dω
//! coated   (1 − F) cos θ/π, a diffuse surface below a coat; not normalised
//! rough    the bidirectional reflectance of microfacets times cos θ; not normalised
//! phase    Henyey and Greenstein, of each band: light that a medium scatters
//! ```
//! All laws are densities of directions. If several bands have different laws, one band, selected
//! at random, gives the direction, whose density is the mean over all bands.

use super::choice::Sought;
use super::optics::mean;
use super::rough_lobes::RoughLobes;
use super::warps::{
    cosine_hemisphere_pdf, cosine_hemisphere_sample, fresnel_dielectric, henyey_greenstein,
    henyey_greenstein_direction_sample, uniform_sphere_pdf, uniform_sphere_sample,
};
use crate::geometry::Vector;
use crate::sampling::{Frame, Samples};
use crate::visibility::Start;

/// A point where light is scattered or received.
#[derive(Clone, Copy, Debug)]
pub(super) struct Vertex<'w, const N: usize> {
    pub(super) start: Start,
    pub(super) law: Law<'w, N>,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Law<'w, const N: usize> {
    /// The unit normal of the side that receives.
    Plane(Vector),
    /// The unit normal of a diffuse base below a coat with this index.
    Coated {
        normal: Vector,
        index: f64,
    },
    /// The lobes of a rough surface.
    Rough(RoughLobes<'w, N>),
    Sphere,
    /// The direction of unscattered light, seen from the receiver, and the mean cosine of each
    /// band.
    Phase {
        forward: Vector,
        asymmetry: [f64; N],
    },
}

impl<const N: usize> Vertex<'_, N> {
    /// Returns the point for which lights are selected at the vertex.
    pub(super) fn sought(&self) -> Sought {
        let normal = match self.law {
            Law::Plane(normal) | Law::Coated { normal, .. } => Some(normal),
            Law::Rough(lobes) => Some(lobes.normal()),
            Law::Sphere | Law::Phase { .. } => None,
        };
        Sought::at(self.start.position, normal)
    }
}

impl<const N: usize> Law<'_, N> {
    /// Returns the density of a direction in each band.
    pub(super) fn density(&self, direction: Vector) -> [f64; N] {
        match self {
            Self::Plane(normal) => {
                let cosine = normal.dot(direction);
                // the density depends on the cosine alone
                [if cosine > 0.0 { cosine_hemisphere_pdf(1.0, 0.0, cosine.min(1.0)) } else { 0.0 }; N]
            }
            Self::Coated { normal, index } => {
                let transmitted = transmitted(*normal, *index, direction);
                Self::Plane(*normal).density(direction).map(|density| transmitted * density)
            }
            Self::Rough(lobes) => lobes.value(direction),
            Self::Sphere => [uniform_sphere_pdf(0.0, 0.0, 1.0); N],
            Self::Phase { forward, asymmetry } => {
                let cosine = forward.dot(direction).clamp(-1.0, 1.0);
                asymmetry.map(|g| henyey_greenstein(g, cosine))
            }
        }
    }

    /// Samples a direction by the law of `count` bands.
    pub(super) fn direction(&self, count: usize, samples: &mut Samples) -> Vector {
        let [u, v] = samples.pair();
        match self {
            Self::Plane(normal) | Self::Coated { normal, .. } => {
                Frame::about(*normal).place(cosine_hemisphere_sample(u, v))
            }
            Self::Rough(lobes) => lobes.sample([u, v]),
            Self::Sphere => {
                let [x, y, z] = uniform_sphere_sample(u, v);
                Vector::new(x, y, z)
            }
            Self::Phase { forward, asymmetry } => {
                let g = asymmetry[one_of(count, samples)];
                let [x, y, z] = henyey_greenstein_direction_sample(g, u, v);
                // isotropic directions use a frame that does not turn with the path, and so depend
                // on these two numbers alone
                if g == 0.0 { Vector::new(x, y, z) } else { Frame::about(*forward).place([x, y, z]) }
            }
        }
    }

    /// Returns the density of each band relative to the density of the sampled direction, and the
    /// latter. Below a coat, and on a rough surface, the latter is that of the law, like
    /// [`density`](Self::density), so that the MIS weights of both techniques agree.
    pub(super) fn weights(&self, direction: Vector, count: usize) -> ([f64; N], f64) {
        let densities = self.density(direction);
        if let Self::Coated { normal, index } = self {
            // the direction was sampled without the coat
            return ([transmitted(*normal, *index, direction); N], densities[0]);
        }
        if let Self::Rough(lobes) = self {
            let taken = lobes.density(direction);
            let weight = |value: f64| if taken > 0.0 { value / taken } else { 0.0 };
            return (densities.map(weight), mean(&densities, count));
        }
        let taken = mean(&densities, count);
        (densities.map(|density| density / taken), taken)
    }
}

/// Returns the part of the light that a coat transmits to a direction.
fn transmitted(normal: Vector, index: f64, direction: Vector) -> f64 {
    1.0 - fresnel_dielectric(index, normal.dot(direction).clamp(0.0, 1.0))
}

/// Selects one of `count` bands at random.
pub(super) fn one_of(count: usize, samples: &mut Samples) -> usize {
    if count == 1 { 0 } else { ((samples.one() * count as f64) as usize).min(count - 1) }
}
