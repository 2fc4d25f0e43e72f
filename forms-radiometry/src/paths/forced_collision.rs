//! Forced collisions: if a path in a medium cannot continue from the wall that its ray hits, it is
//! forced to scatter before that wall.
//!
//! ```text
//! segment ─▶ wall that only emits ─┬─ emitted radiance times e^(−σ d), added immediately
//!                                  └─ a forced collision, times 1 − e^(−σ d)
//! ```

use super::optics::{MediumOptics, largest, times};
use super::scattering::Flight;
use super::specialisation::Specialisation;
use super::tracer::{Path, Tracer, is_below};
use crate::sampling::Samples;
use crate::scene::MaterialKind;
use crate::visibility::Met;

impl<L: Specialisation, const N: usize> Tracer<'_, L, N> {
    /// Samples a free flight over the segment up to the next wall. If the path cannot continue from
    /// there, the light that the segment transmits is added immediately and the flight is a forced
    /// collision, so that no path ends by chance. Forced collisions make paths longer. They pay off
    /// as long as the samples are of low discrepancy, so that the errors of a smooth integrand
    /// cancel.
    pub(crate) fn flight(
        &self,
        path: &Path<N>,
        medium: &MediumOptics<N>,
        met: Option<&Met>,
        samples: &mut Samples,
        add: &mut impl FnMut(&[f64; N], f64),
    ) -> Flight<N> {
        let length = met.map_or(f64::INFINITY, |met| met.distance);
        if !samples.are_even() || met.is_some_and(|met| self.continues_from(path, met)) {
            return medium.flight(length, self.count(), samples);
        }
        let mut passing = *path;
        passing.throughput = times(&path.throughput, &medium.transmittance(length));
        self.arrives(&mut passing, met, medium, add);
        medium.flight_within(length, self.count(), samples)
    }

    /// Whether a path can continue from a wall.
    pub(crate) fn continues_from(&self, path: &Path<N>, met: &Met) -> bool {
        let interface = &self.world.interfaces[met.wall];
        let [front, back] = [true, false].map(|is_front| interface.filling(is_front));
        let is_allowed = self.is_allowed(path.events + 1);
        let is_bright = self.world.is_bright(met.wall, self.world.side(met, path.direction).is_front);
        match self.world.material(met.wall) {
            MaterialKind::Dielectric { .. } => is_allowed || self.optics.is_clear(front, back),
            MaterialKind::Diffuse { .. } | MaterialKind::Rough(_) => {
                is_bright && is_allowed && self.reflects_diffusely(path, met)
            }
            MaterialKind::Plastic { .. } => {
                is_bright && is_allowed && (L::MIRROR || self.reflects_diffusely(path, met))
            }
            MaterialKind::Mirror { .. } | MaterialKind::Conductor { .. } => {
                is_bright && is_allowed && L::MIRROR
            }
        }
    }

    /// Whether a wall has a diffuse reflectance, and the path can have another diffuse reflection.
    pub(crate) fn reflects_diffusely(&self, path: &Path<N>, met: &Met) -> bool {
        let reflectance = &self.optics.reflectances[self.world.interfaces[met.wall].surface];
        is_below(path.reflections, path.most) && largest(reflectance) > 0.0
    }
}
