//! Microfacets: a rough surface is made of mirrors that are too small to be seen, whose normals have a
//! known distribution.
//!
//! ```text
//! D(m)                        density of normals m, with ∫ D(m) cos θₘ dm = 1
//! G₁(ω)                       part of the mirrors that are not hidden from a direction (Smith)
//! F D G₁(ωᵢ) G₁(ωₒ)/(4 cos θᵢ)  reflected light: bidirectional reflectance times cos θₒ
//! ```
//! Light that meets several mirrors one after the other is lost.
//!
//! Source: B. Walter et al., Microfacet models for refraction through rough surfaces (2007), also for
//! the rational approximation of G₁ of Beckmann’s distribution, whose relative error is below 0.35 %.

use forms_kernels::{beckmann_sample, fresnel_dielectric, ggx_sample, ggx_visible_sample};
use std::f64::consts::PI;

/// Numbers of normals by their angle to the mean normal, and by their azimuth, for a mean over them.
const NORMALS: [usize; 2] = [64, 32];
/// Number of cosines at which a transmittance is tabulated, as in Mitsuba.
const COSINES: usize = 64;
/// The least of these cosines.
const GRAZING: f64 = 1e-6;

/// Kinds of distributions of normals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Distribution {
    /// Beckmann’s: slopes have a normal distribution.
    Beckmann,
    /// GGX, also called the distribution of Trowbridge and Reitz.
    Ggx,
}

/// A distribution of the normals of microfacets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Microfacets {
    /// The kind of the distribution.
    pub distribution: Distribution,
    /// The roughness α: the root mean square slope, for Beckmann’s distribution, times √2.
    pub alpha: f64,
}

impl Microfacets {
    /// Returns the density D of normals with this cosine to the mean normal.
    pub(crate) fn density(&self, cosine: f64) -> f64 {
        let squared = cosine * cosine;
        let (alpha, slope) = (self.alpha * self.alpha, (1.0 - squared).max(0.0) / squared);
        match self.distribution {
            Distribution::Beckmann => (-slope / alpha).exp() / (PI * alpha * squared * squared),
            Distribution::Ggx => alpha / (PI * (squared * (alpha + slope)).powi(2)),
        }
    }

    /// Returns the part G₁ of the microfacets that is not hidden from a direction with this cosine.
    pub(crate) fn shown(&self, cosine: f64) -> f64 {
        let slope = self.alpha * ((1.0 - cosine * cosine).max(0.0)).sqrt() / cosine;
        match self.distribution {
            Distribution::Ggx => 2.0 / (1.0 + (1.0 + slope * slope).sqrt()),
            Distribution::Beckmann if slope * 1.6 <= 1.0 => 1.0,
            Distribution::Beckmann => {
                let a = 1.0 / slope;
                a * (3.535 + 2.181 * a) / (1.0 + a * (2.276 + 2.577 * a))
            }
        }
    }

    /// Returns the reflected light of perfect mirrors, the bidirectional reflectance times cos θₒ, for
    /// the cosines of both directions and of the normal between them.
    pub(crate) fn reflected(&self, [from, to]: [f64; 2], half: f64) -> f64 {
        self.density(half) * self.shown(from) * self.shown(to) / (4.0 * from)
    }

    /// Returns a normal by a point of the unit square, with the density D cos θₘ.
    pub(crate) fn normal(&self, [u, v]: [f64; 2]) -> [f64; 3] {
        match self.distribution {
            Distribution::Beckmann => beckmann_sample(self.alpha, u, v),
            Distribution::Ggx => ggx_sample(self.alpha, u, v),
        }
    }

    /// Returns the mean of a quantity over the microfacets that are seen from a direction with this
    /// cosine: of the product of the direction and the normal, and the cosine of the normal.
    fn mean(&self, cosine: f64, quantity: impl Fn(f64, f64) -> f64) -> f64 {
        let sine = (1.0 - cosine * cosine).sqrt();
        let [rows, columns] = NORMALS;
        let (mut sum, mut all) = (0.0, 0.0);
        for index in 0..rows * columns {
            // the other half of all azimuths is symmetric
            let u = ((index / columns) as f64 + 0.5) / rows as f64;
            let v = 0.5 * ((index % columns) as f64 + 0.5) / columns as f64;
            // normals of GGX are those that are seen; others are seen in proportion to their product
            // with the direction over their cosine
            let [x, _, z] = match self.distribution {
                Distribution::Ggx => ggx_visible_sample(self.alpha, sine, 0.0, cosine, u, v),
                Distribution::Beckmann => self.normal([u, v]),
            };
            let along = sine * x + cosine * z;
            let weight = if self.distribution == Distribution::Ggx { 1.0 } else { along / z };
            if along > 0.0 {
                all += weight;
                sum += weight * quantity(along, z);
            }
        }
        sum / all
    }

    /// Returns the part of light from a direction with this cosine that a boundary with this relative
    /// index reflects.
    fn reflectance(&self, index: f64, cosine: f64) -> f64 {
        self.mean(cosine, |along, normal| {
            let leaves = 2.0 * along * normal - cosine;
            let shown = if leaves > 0.0 { self.shown(leaves) } else { 0.0 };
            fresnel_dielectric(index, along.min(1.0)) * shown
        })
    }

    /// Returns the part of light from a direction with this cosine that a boundary with this relative
    /// index transmits.
    fn transmittance(&self, index: f64, cosine: f64) -> f64 {
        self.mean(cosine, |along, normal| {
            let squared = 1.0 - (1.0 - along * along) / (index * index);
            let leaves = cosine / index - normal * (along / index - squared.max(0.0).sqrt());
            let shown = if squared > 0.0 && leaves > 0.0 { self.shown(leaves) } else { 0.0 };
            (1.0 - fresnel_dielectric(index, along.min(1.0))) * shown
        })
    }

    /// Returns the part of diffuse light from inside a coat that its surface reflects, for the index
    /// of the coat relative to its exterior. Like in Mitsuba, it is a mean of 64 cosines.
    pub(crate) fn inner_reflectance(&self, index: f64) -> f64 {
        let of_cosine = |place: usize| {
            let cosine = cosine_at(place);
            2.0 * cosine * self.reflectance(1.0 / index, cosine)
        };
        (0..COSINES).map(of_cosine).sum::<f64>() / COSINES as f64
    }
}

/// Transmittance of a rough boundary by the cosine of the angle of incidence, linear between equally
/// spaced cosines.
#[derive(Clone, Debug)]
pub(crate) struct RoughTransmittance([f64; COSINES]);

impl RoughTransmittance {
    /// Returns the transmittance of a boundary with this relative index.
    pub(crate) fn of(facets: &Microfacets, index: f64) -> Self {
        Self(std::array::from_fn(|place| facets.transmittance(index, cosine_at(place))))
    }

    pub(crate) fn at(&self, cosine: f64) -> f64 {
        let place = cosine.clamp(0.0, 1.0) * (COSINES - 1) as f64;
        let first = (place as usize).min(COSINES - 2);
        let part = place - first as f64;
        self.0[first] + part * (self.0[first + 1] - self.0[first])
    }
}

fn cosine_at(place: usize) -> f64 {
    (place as f64 / (COSINES - 1) as f64).max(GRAZING)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The bidirectional reflectance times cos θₒ of Mitsuba 3.9.1, `roughplastic` of index 1.5,
    /// roughness 0.2 and diffuse reflectance 0.5, for ωᵢ = (sin θ, 0, cos θ).
    const PLASTIC: [(Distribution, bool, f64, [f64; 3], f64); 8] = [
        (Distribution::Beckmann, false, 1.0, [0.0, 0.0, 1.0], 0.228_196),
        (Distribution::Beckmann, false, 0.6, [-0.8, 0.0, 0.6], 0.297_742),
        (Distribution::Beckmann, false, 0.2, [-0.8, 0.0, 0.6], 0.452_057),
        (Distribution::Beckmann, true, 0.6, [0.0, 0.0, 1.0], 0.088_256),
        (Distribution::Ggx, false, 1.0, [0.0, 0.0, 1.0], 0.205_748),
        (Distribution::Ggx, false, 0.2, [-0.8, 0.0, 0.6], 0.281_365),
        (Distribution::Ggx, true, 0.2, [0.0, 0.0, 1.0], 0.071_793),
        (Distribution::Ggx, true, 1.0, [-0.8, 0.0, 0.6], 0.051_876),
    ];

    #[test]
    fn rough_plastic_reflects_as_in_mitsuba() {
        let index = 1.5;
        for (distribution, is_nonlinear, from, to, expected) in PLASTIC {
            let facets = Microfacets { distribution, alpha: 0.2 };
            let transmittance = RoughTransmittance::of(&facets, index);
            let half = [(1.0 - from * from).sqrt() + to[0], to[1], from + to[2]];
            let length = half.iter().map(|x| x * x).sum::<f64>().sqrt();
            let fresnel = fresnel_dielectric(index, length / 2.0);
            let inner = facets.inner_reflectance(index) * if is_nonlinear { 0.5 } else { 1.0 };
            let base = 0.5 / (index * index * (1.0 - inner));
            let both = transmittance.at(from) * transmittance.at(to[2]);
            let value =
                fresnel * facets.reflected([from, to[2]], half[2] / length) + base * both * to[2] / PI;
            assert!(
                (value - expected).abs() < 2e-3 * expected,
                "{distribution:?} {from}: {value} {expected}"
            );
        }
    }
}
