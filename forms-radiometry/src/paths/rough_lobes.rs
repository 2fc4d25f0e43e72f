//! Lobes of rough surfaces: the light that microfacets reflect from one direction to all others, and that a
//! diffuse base below a rough coat reflects.
//!
//! ```text
//! directions    with probability p by the normals of microfacets, otherwise by cos θ/π
//! microfacets   s F D G₁(θᵢ) G₁(θₒ)/(4 cos θᵢ)
//! base          T(θᵢ) T(θₒ) ρ cos θₒ/π
//! ```
//! p follows from the light that the coat transmits from the direction of the ray. For GGX,
//! normals are sampled among the visible ones; for Beckmann’s distribution, with the density D cos θₘ.

use super::optics::{MediumOptics, largest};
use super::warps::{
    cosine_hemisphere_pdf, cosine_hemisphere_sample, fresnel_conductor, fresnel_dielectric,
    ggx_visible_sample,
};
use crate::geometry::Vector;
use crate::sampling::Frame;
use crate::scene::{Distribution, Facet, Material, MaterialKind, Microfacets, Rough, RoughTransmittance};
use std::f64::consts::PI;

/// Returns the transmittance of the coat of a rough material, if it has one.
pub(super) fn rough_coat(material: &Material) -> Option<Box<RoughTransmittance>> {
    match &material.kind {
        MaterialKind::Rough(Rough { facets, facet: Facet::Coat { index }, .. }) => {
            Some(Box::new(RoughTransmittance::of(facets, *index)))
        }
        _ => None,
    }
}

/// Light that a rough surface reflects from one direction, in N bands.
#[derive(Clone, Copy, Debug)]
pub(super) struct RoughLobes<'w, const N: usize> {
    /// The unit normal, and the unit vector to the origin of the ray.
    normal: Vector,
    towards: Vector,
    facets: Microfacets,
    fresnel: Fresnel<N>,
    specular: [f64; N],
    base: [f64; N],
    coat: Option<&'w RoughTransmittance>,
    /// Probability of a direction by microfacets.
    chance: f64,
}

/// Fresnel reflectance of microfacets.
#[derive(Clone, Copy, Debug)]
enum Fresnel<const N: usize> {
    Mirror,
    Conductor { eta: [f64; N], k: [f64; N] },
    Coat { index: f64 },
}

impl<'w, const N: usize> RoughLobes<'w, N> {
    /// Returns the lobes of a rough material in these bands, with this medium in front of it, the
    /// transmittance of its coat, and the reflectance of its base, for the unit normal on the side of a
    /// ray and the unit vector to its origin. `None` if the surface is seen from behind.
    pub(super) fn of(
        (rough, coat): (&Rough, Option<&'w RoughTransmittance>),
        base: [f64; N],
        bands: [usize; 2],
        medium: &MediumOptics<N>,
        [normal, towards]: [Vector; 2],
    ) -> Option<Self> {
        let cosine = normal.dot(towards);
        if cosine <= 0.0 {
            return None;
        }
        let fresnel = match &rough.facet {
            Facet::Mirror => Fresnel::Mirror,
            Facet::Conductor { eta, k } => {
                let relative = |values: &[f64]| group(values, bands, 1.0).map(|value| value / medium.index);
                Fresnel::Conductor { eta: relative(eta), k: relative(k) }
            }
            Facet::Coat { index } => Fresnel::Coat { index: *index },
        };
        let (facets, specular) = (rough.facets, group(&rough.specular, bands, 0.0));
        let lobes = Self { normal, towards, facets, fresnel, specular, base, coat, chance: 1.0 };
        Some(Self { chance: lobes.chance_of_facets(cosine), ..lobes })
    }

    pub(super) fn normal(&self) -> Vector {
        self.normal
    }

    fn chance_of_facets(&self, cosine: f64) -> f64 {
        let (Some(coat), Fresnel::Coat { index }) = (self.coat, self.fresnel) else { return 1.0 };
        let transmitted = coat.at(cosine);
        let specular = (1.0 - transmitted) * largest(&self.specular);
        let base = transmitted * index * index * largest(&self.base);
        if specular + base > 0.0 { specular / (specular + base) } else { 1.0 }
    }

    /// Returns the cosines of both directions to the normal, and of the normal of a microfacet between
    /// them to the normal and to the directions. `None` if no light is reflected in the direction.
    fn cosines(&self, direction: Vector) -> Option<([f64; 2], [f64; 2])> {
        let both = [self.normal.dot(self.towards), self.normal.dot(direction)];
        let half = (self.towards + direction).unit()?;
        let of_half = [self.normal.dot(half).min(1.0), self.towards.dot(half).min(1.0)];
        (both[1] > 0.0 && of_half[0] > 0.0 && of_half[1] > 0.0).then_some((both, of_half))
    }

    /// Returns the bidirectional reflectance times the cosine of a direction, in each band.
    pub(super) fn value(&self, direction: Vector) -> [f64; N] {
        let Some((both, [half, along])) = self.cosines(direction) else { return [0.0; N] };
        let mirrored = self.facets.reflected(both, half);
        let base = self.coat.map_or(0.0, |coat| coat.at(both[0]) * coat.at(both[1]) * both[1] / PI);
        let reflectance = self.reflectance(along);
        std::array::from_fn(|band| {
            self.specular[band] * reflectance[band] * mirrored + self.base[band] * base
        })
    }

    /// Returns the Fresnel reflectance of a microfacet for this cosine.
    fn reflectance(&self, cosine: f64) -> [f64; N] {
        match &self.fresnel {
            Fresnel::Mirror => [1.0; N],
            Fresnel::Conductor { eta, k } => {
                std::array::from_fn(|band| fresnel_conductor(eta[band], k[band], cosine))
            }
            Fresnel::Coat { index } => [fresnel_dielectric(*index, cosine); N],
        }
    }

    /// Samples a direction by a point of the unit square; it can point into the surface, where nothing
    /// is reflected.
    pub(super) fn sample(&self, [u, v]: [f64; 2]) -> Vector {
        let frame = Frame::about(self.normal);
        if u >= self.chance {
            let u = (u - self.chance) / (1.0 - self.chance);
            return frame.place(cosine_hemisphere_sample(u, v));
        }
        let square = [(u / self.chance).min(1.0 - f64::EPSILON), v];
        let facet = match self.facets.distribution {
            Distribution::Beckmann => self.facets.normal(square),
            Distribution::Ggx => {
                let [x, y, z] = frame.coordinates(self.towards);
                ggx_visible_sample(self.facets.alpha, x, y, z, square[0], square[1])
            }
        };
        let direction = -self.towards.mirrored(frame.place(facet));
        direction.unit().unwrap_or(direction)
    }

    /// Returns the density of a sampled direction.
    pub(super) fn density(&self, direction: Vector) -> f64 {
        let Some((both, [half, along])) = self.cosines(direction) else { return 0.0 };
        let of_facets = match self.facets.distribution {
            Distribution::Beckmann => self.facets.density(half) * half / (4.0 * along),
            Distribution::Ggx => self.facets.density(half) * self.facets.shown(both[0]) / (4.0 * both[0]),
        };
        let of_base = cosine_hemisphere_pdf(1.0, 0.0, both[1].min(1.0));
        self.chance * of_facets + (1.0 - self.chance) * of_base
    }
}

/// Returns the values of a group of bands, and this number for unused ones.
pub(super) fn group<const N: usize>(values: &[f64], [first, count]: [usize; 2], unused: f64) -> [f64; N] {
    std::array::from_fn(|band| if band < count { values[first + band] } else { unused })
}
