//! Boundaries: what becomes of a ray that meets a mirror, a metal or the smooth boundary of two media.
//!
//! ```text
//! mirror, metal   d − 2 (d·n) n, times ρ or Fresnel's R
//! dielectric      with the chance R the same, else bent: n₁ sin θ₁ = n₂ sin θ₂
//! ```
//! Seen backwards a ray that gets from index n₁ into n₂ brings radiance from there: L₁ = L₂ n₁²/n₂². The chance takes the place of
//! the factors R and 1 − R.

use super::optics::{MediumOptics, Optics, times};
use super::warps::{fresnel_conductor, fresnel_dielectric};
use crate::geometry::Vector;
use crate::kernels::basic_radiance;
use crate::scene::MaterialKind;

/// What a ray does at a smooth boundary.
pub(super) enum Passage<const N: usize> {
    /// It goes on to this direction on the side it came from, with this factor.
    Reflected(Vector, [f64; N]),
    /// It goes on to this direction beyond the boundary, with this factor.
    Refracted(Vector, f64),
}

/// The direction of the mirror image, for a unit normal.
fn mirrored(direction: Vector, normal: Vector) -> Vector {
    let reflected = direction - (2.0 * normal.dot(direction)) * normal;
    // so that rounding does not add up from mirror to mirror
    reflected.unit().unwrap_or(reflected)
}

/// Reflection by a mirror or a metal in front of which is this medium; `normal` points to the ray.
pub(super) fn reflected<const N: usize>(
    material: &MaterialKind,
    optics: &Optics<N>,
    medium: &MediumOptics<N>,
    direction: Vector,
    normal: Vector,
) -> Passage<N> {
    let cosine = (-normal.dot(direction)).clamp(0.0, 1.0);
    let [first, count] = optics.bands;
    let of_band = |values: &[f64], band: usize| if band < count { values[first + band] } else { 0.0 };
    let factor = match material {
        MaterialKind::Mirror { reflectance } => std::array::from_fn(|band| of_band(reflectance, band)),
        MaterialKind::Conductor { eta, k } => std::array::from_fn(|band| {
            let relative = |values: &[f64]| of_band(values, band) / medium.index;
            if band < count { fresnel_conductor(relative(eta), relative(k), cosine) } else { 0.0 }
        }),
        MaterialKind::Diffuse { .. } | MaterialKind::Dielectric { .. } => [0.0; N],
    };
    Passage::Reflected(mirrored(direction, normal), factor)
}

/// What can happen at the boundary from one medium to another, each with its part of the light: reflection, and passage where there is
/// any; `normal` points to the ray.
pub(super) fn passages<const N: usize>(
    [from, to]: [&MediumOptics<N>; 2],
    direction: Vector,
    normal: Vector,
) -> [Option<(f64, Passage<N>)>; 2] {
    let cosine = (-normal.dot(direction)).clamp(0.0, 1.0);
    let relative = to.index / from.index;
    let reflectance = fresnel_dielectric(relative, cosine);
    // by Snell's law; what is left under the root is positive where not all is reflected
    let radicand = (relative - 1.0) * (relative + 1.0) + cosine * cosine;
    let bent = (radicand > 0.0 && reflectance < 1.0)
        .then(|| (direction + (cosine - radicand.sqrt()) * normal).unit())
        .flatten();
    let passed = bent
        .map(|bent| (1.0 - reflectance, Passage::Refracted(bent, basic_radiance(1.0, to.index, from.index))));
    let part = if passed.is_some() { reflectance } else { 1.0 };
    [Some((part, Passage::Reflected(mirrored(direction, normal), [1.0; N]))), passed]
}

/// What happens there, by a number from 0 to 1.
pub(super) fn refracted<const N: usize>(
    media: [&MediumOptics<N>; 2],
    direction: Vector,
    normal: Vector,
    number: f64,
) -> Passage<N> {
    match passages(media, direction, normal) {
        [Some((part, _)), Some((_, passed))] if number >= part => passed,
        [reflected, _] => reflected.map_or(Passage::Reflected(direction, [0.0; N]), |(_, passage)| passage),
    }
}

impl<const N: usize> Passage<N> {
    /// The direction, the factor of what comes from there, and whether the ray stays on its side.
    pub(super) fn applied(self, throughput: &[f64; N]) -> (Vector, [f64; N], bool) {
        match self {
            Self::Reflected(direction, factor) => (direction, times(throughput, &factor), true),
            Self::Refracted(direction, factor) => (direction, throughput.map(|t| factor * t), false),
        }
    }
}
