//! Rough materials: microfacets of a metal, of a perfect mirror, or of a coat above a diffuse base.

use super::microfacets::Microfacets;

/// Reflection by a rough surface. Optical lists have one number for each band.
#[derive(Clone, Debug, PartialEq)]
pub struct Rough {
    /// The distribution of the normals of the microfacets.
    pub facets: Microfacets,
    /// What the microfacets are made of.
    pub facet: Facet,
    /// Factor of the reflection by microfacets, from 0 to 1.
    pub specular: Vec<f64>,
    /// ρ of the diffuse base below a coat, with all reflections inside the coat, and both refractions:
    /// with the transmittance T of the coat, the base reflects T(θᵢ) T(θₒ) ρ/π. It is 0 without a
    /// coat.
    pub base: Vec<f64>,
    /// A bound on the reflected part of light from any direction.
    pub albedo: Vec<f64>,
}

/// Substances of microfacets.
#[derive(Clone, Debug, PartialEq)]
pub enum Facet {
    /// Reflection of all light.
    Mirror,
    /// Fresnel reflection by a metal with the complex index η + ik.
    Conductor {
        /// Real part of the index.
        eta: Vec<f64>,
        /// Imaginary part of the index, not negative.
        k: Vec<f64>,
    },
    /// Fresnel reflection by a coat.
    Coat {
        /// Index of the coat relative to the medium in front of it, above 1.
        index: f64,
    },
}

impl Rough {
    /// Returns all lists with one number for each band.
    pub(crate) fn spectra(&self) -> impl Iterator<Item = &Vec<f64>> {
        let metal = match &self.facet {
            Facet::Conductor { eta, k } => vec![eta, k],
            Facet::Mirror | Facet::Coat { .. } => Vec::new(),
        };
        metal.into_iter().chain([&self.specular, &self.base, &self.albedo])
    }

    /// Calls `change` with all lists that have one number for each band.
    pub(crate) fn change_spectra(&mut self, change: impl FnMut(&mut Vec<f64>)) {
        let metal = match &mut self.facet {
            Facet::Conductor { eta, k } => vec![eta, k],
            Facet::Mirror | Facet::Coat { .. } => Vec::new(),
        };
        metal.into_iter().chain([&mut self.specular, &mut self.base, &mut self.albedo]).for_each(change);
    }
}
