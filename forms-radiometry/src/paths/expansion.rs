//! Specular expansion: the radiance along a ray that meets only smooth walls, emitters and black
//! surfaces is a sum of a few terms, and needs no samples.
//!
//! ```text
//! ray ─▶ wall ─┬─ emitted radiance × throughput     the throughput is 1 at first,
//!              ├─ mirror, metal ─▶ one ray          and is multiplied by ρ or R, 1 − R, e^(−σ d)
//!              └─ boundary ─▶ two rays
//! ```
//! Rays with negligible throughput are dropped. Their throughput times an upper bound on the
//! radiance bounds the error. The emitted and the reflected radiance of a wall add up,
//! L ≤ Lₑ + ρ L, so that no L/n² exceeds the largest Lₑ/(n² (1 − ρ)) of a wall; at boundaries L/n²
//! is a mean of the values on both sides.

use super::boundary::Passage;
use super::mirror::reflected;
use super::optics::{MediumOptics, largest, scaled, times};
use super::refraction::passages;
use super::specialisation::Specialisation;
use super::tracer::Tracer;
use super::world::Side;
use crate::geometry::Vector;
use crate::scene::{Filling, MaterialKind};
use crate::visibility::{Met, Start};

/// Maximum number of rays; an expansion that needs more is abandoned.
const MOST: usize = 1 << 14;
/// Throughput below which a ray is dropped, as a fraction of the tolerance.
const GIVEN_UP: f64 = 1e-3;

/// A ray and its throughput.
struct Ray<const N: usize> {
    start: Start,
    direction: Vector,
    filling: Filling,
    left: [f64; N],
    is_straight: bool,
}

/// For each band the sum, and the throughput of the dropped rays.
struct Terms<const N: usize> {
    sum: [f64; N],
    missing: [f64; N],
}

impl<L: Specialisation, const N: usize> Tracer<'_, L, N> {
    /// Returns the radiance along a ray in each band, with its error. `None` if a medium or a
    /// diffuse surface on the way scatters or reflects light, or if the number of events is limited.
    pub(super) fn expansion(&self, start: Start, direction: Vector) -> Option<Vec<[f64; 2]>> {
        if self.world.scene.solve.events.is_some() {
            return None;
        }
        let brightest = self.brightest()?;
        let filling = self.world.medium_at(start, direction);
        let mut waiting = vec![Ray { start, direction, filling, left: [1.0; N], is_straight: true }];
        let mut terms = Terms { sum: [0.0; N], missing: [0.0; N] };
        let least = GIVEN_UP * self.world.scene.solve.tolerance;
        let mut rays = 0;
        while let Some(ray) = waiting.pop() {
            rays += 1;
            if rays > MOST {
                return None;
            }
            self.expand(ray, least, &mut terms, &mut waiting)?;
        }
        let [_, count] = self.optics.bands;
        Some((0..count).map(|band| [terms.sum[band], brightest[band] * terms.missing[band]]).collect())
    }

    /// Returns an upper bound on the radiance in each band. `None` if an emitting wall can reflect
    /// or transmit light completely.
    fn brightest(&self) -> Option<[f64; N]> {
        let mut brightest = self.optics.brightest_outside;
        for (surface, radiance) in
            self.optics.radiances.iter().enumerate().filter(|(_, radiance)| largest(*radiance) > 0.0)
        {
            let reflectance = self.optics.reflectances[surface];
            let kind = &self.world.scene.materials[self.world.scene.surfaces[surface].material].kind;
            let is_known = matches!(kind, MaterialKind::Diffuse { .. } | MaterialKind::Mirror { .. });
            if !is_known {
                return None;
            }
            // where light meets a diffuse wall that reflects, there is no expansion
            let reflectance =
                if matches!(kind, MaterialKind::Mirror { .. }) { reflectance } else { [0.0; N] };
            if largest(&reflectance) >= 1.0 {
                return None;
            }
            brightest =
                std::array::from_fn(|band| brightest[band].max(radiance[band] / (1.0 - reflectance[band])));
        }
        let [least, most] = self.optics.indices();
        Some(scaled((most / least).powi(2), &brightest))
    }

    /// Adds the radiance from the wall that a ray hits, and queues the rays that continue from
    /// there.
    fn expand(&self, ray: Ray<N>, least: f64, terms: &mut Terms<N>, waiting: &mut Vec<Ray<N>>) -> Option<()> {
        let counts = self.limits.direct || !ray.is_straight;
        let medium = self.optics.medium(ray.filling);
        if L::SCATTERING && medium.scatters() {
            return None;
        }
        let mut add = |radiance: &[f64; N], left: &[f64; N]| {
            if counts {
                terms.sum = std::array::from_fn(|band| terms.sum[band] + radiance[band] * left[band]);
            }
        };
        let Some(met) = self.world.walls.first(ray.start, ray.direction, f64::INFINITY) else {
            add(&self.optics.outside(ray.direction), &times(&ray.left, &medium.transmittance(f64::INFINITY)));
            return Some(());
        };
        let left = times(&ray.left, &medium.transmittance(met.distance));
        let surface = self.world.interfaces[met.wall].surface;
        let is_bright = self.world.is_bright(met.wall, self.world.side(&met, ray.direction).is_front);
        if is_bright {
            add(&self.optics.radiances[surface], &left);
        }
        for (factor, stays, direction, is_straight) in self.rays_from(&ray, &met, &medium, is_bright)? {
            let left = times(&left, &factor);
            if largest(&left) <= least {
                terms.missing = std::array::from_fn(|band| terms.missing[band] + left[band]);
                continue;
            }
            let filling =
                if stays { ray.filling } else { self.world.interfaces[met.wall].filling(!met.is_front) };
            let start = self.world.walls.start_on(&met, met.is_front == stays);
            let is_straight = ray.is_straight && is_straight;
            waiting.push(Ray { start, direction, filling, left, is_straight });
        }
        Some(())
    }

    /// Returns the rays that continue from a wall: the factor, whether the ray stays on its side,
    /// the direction, and whether the ray passes unchanged.
    #[expect(clippy::type_complexity, reason = "a list of few fields that is taken apart at once")]
    fn rays_from(
        &self,
        ray: &Ray<N>,
        met: &Met,
        medium: &MediumOptics<N>,
        is_bright: bool,
    ) -> Option<Vec<([f64; N], bool, Vector, bool)>> {
        let Side { normal, is_smooth, .. } = self.world.side(met, ray.direction);
        if is_smooth && is_bright {
            return None;
        }
        let material = self.world.material(met.wall);
        let surface = self.world.interfaces[met.wall].surface;
        match material {
            MaterialKind::Dielectric { .. } => {
                let other = self.optics.medium(self.world.interfaces[met.wall].filling(!met.is_front));
                if !L::REFRACTION || medium.index == other.index {
                    return Some(vec![([1.0; N], false, ray.direction, true)]);
                }
                let both = passages([medium, &other], ray.direction, normal).into_iter().flatten();
                let ray = |(part, passage): (f64, Passage<N>)| match passage {
                    Passage::Reflected(direction, factor) => (scaled(part, &factor), true, direction, false),
                    Passage::Refracted(direction, factor) => ([part * factor; N], false, direction, false),
                };
                Some(both.map(ray).collect())
            }
            _ if !is_bright => Some(Vec::new()),
            MaterialKind::Diffuse { .. } => {
                (largest(&self.optics.reflectances[surface]) == 0.0).then(Vec::new)
            }
            MaterialKind::Plastic { .. } | MaterialKind::Rough(_) => None,
            _ if !L::MIRROR => Some(Vec::new()),
            material => match reflected(material, &self.optics, medium, ray.direction, normal) {
                Passage::Reflected(direction, factor) => Some(vec![(factor, true, direction, false)]),
                Passage::Refracted(..) => None,
            },
        }
    }
}
