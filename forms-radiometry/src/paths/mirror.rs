//! Mirrors and metals: a ray is reflected, times ρ or the Fresnel reflectance R.

use super::boundary::{Passage, mirrored};
use super::optics::{MediumOptics, Optics};
use super::warps::fresnel_conductor;
use crate::geometry::Vector;
use crate::scene::MaterialKind;

/// Returns the reflection by a mirror or metal with this medium in front of it; `normal` points to
/// the side of the ray.
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
        MaterialKind::Diffuse { .. }
        | MaterialKind::Dielectric { .. }
        | MaterialKind::Plastic { .. }
        | MaterialKind::Rough(_) => [0.0; N],
    };
    Passage::Reflected(mirrored(direction, normal), factor)
}
