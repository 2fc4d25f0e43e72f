//! Coats: a ray meets a diffuse base below a smooth coat, and is reflected by one of the two.
//!
//! ```text
//! with probability p reflected by the coat, times F(θᵢ) s/p; otherwise by the base,
//! times (1 − F(θᵢ)) ρ/(1 − p), in a direction with the law (1 − F(θₒ)) cos θₒ/π
//! ```
//! p is the share of the coat in the reflected light, as far as the angle of incidence tells.

use super::boundary::{Passage, mirrored};
use super::optics::{largest, scaled, times};
use super::specialisation::Specialisation;
use super::tracer::{Path, Tracer};
use super::vertex::{Law, Vertex};
use super::warps::fresnel_dielectric;
use crate::geometry::Vector;
use crate::sampling::Draws;
use crate::scene::MaterialKind;
use crate::visibility::Met;

impl<L: Specialisation, const N: usize> Tracer<'_, L, N> {
    /// Applies the interaction of a coated wall to the path; returns whether the path continues.
    pub(super) fn coated(
        &self,
        path: &mut Path<N>,
        met: &Met,
        (is_front, normal): (bool, Vector),
        draws: &mut Draws,
        add: &mut impl FnMut(&[f64; N], f64),
    ) -> bool {
        let MaterialKind::Plastic { specular, index, .. } = self.world.material(met.wall) else {
            return false;
        };
        let cosine = (-normal.dot(path.direction)).clamp(0.0, 1.0);
        let reflected = fresnel_dielectric(*index, cosine);
        let [first, count] = self.optics.bands;
        let mirror: [f64; N] = std::array::from_fn(|band| match band < count && L::MIRROR {
            true => reflected * specular[first + band],
            false => 0.0,
        });
        let base = match self.reflects_diffusely(path, met) {
            true => scaled(1.0 - reflected, &self.world.reflectance(&self.optics, met)),
            false => [0.0; N],
        };
        let both = largest(&mirror) + largest(&base);
        if both <= 0.0 {
            return false;
        }
        let chance = largest(&mirror) / both;
        path.is_same = false;
        if draws.path.one() < chance {
            let direction = mirrored(path.direction, normal);
            return self.passes(path, met, Passage::Reflected(direction, scaled(1.0 / chance, &mirror)));
        }
        path.throughput = times(&path.throughput, &scaled(1.0 / (1.0 - chance), &base));
        let start = self.world.walls.start_on(met, is_front);
        self.scatters(path, &Vertex { start, law: Law::Coated { normal, index: *index } }, draws, add);
        true
    }
}
