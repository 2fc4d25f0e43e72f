//! Refraction: reflection or transmission of a ray at the smooth boundary of two media.
//!
//! ```text
//! with probability R reflected, otherwise refracted: n₁ sin θ₁ = n₂ sin θ₂
//! ```
//! Paths are traced backwards: a ray that passes from index n₁ into n₂ carries radiance from there,
//! L₁ = L₂ n₁²/n₂². The probability replaces the factors R and 1 − R.

use super::boundary::{Passage, mirrored};
use super::optics::MediumOptics;
use super::warps::fresnel_dielectric;
use crate::geometry::Vector;
use forms_kernels::basic_radiance;

/// Returns the possible outcomes at the boundary from one medium to another, each with its fraction
/// of the light: reflection, and refraction if there is any; `normal` points to the side of the
/// ray.
pub(super) fn passages<const N: usize>(
    [from, to]: [&MediumOptics<N>; 2],
    direction: Vector,
    normal: Vector,
) -> [Option<(f64, Passage<N>)>; 2] {
    let cosine = (-normal.dot(direction)).clamp(0.0, 1.0);
    let relative = to.index / from.index;
    let reflectance = fresnel_dielectric(relative, cosine);
    // by Snell's law; the radicand is positive unless the reflection is total
    let radicand = (relative - 1.0) * (relative + 1.0) + cosine * cosine;
    let bent = (radicand > 0.0 && reflectance < 1.0)
        .then(|| (direction + (cosine - radicand.sqrt()) * normal).unit())
        .flatten();
    let passed = bent
        .map(|bent| (1.0 - reflectance, Passage::Refracted(bent, basic_radiance(1.0, to.index, from.index))));
    let part = if passed.is_some() { reflectance } else { 1.0 };
    [Some((part, Passage::Reflected(mirrored(direction, normal), [1.0; N]))), passed]
}

/// Selects one of the outcomes at the boundary by a number from 0 to 1.
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
