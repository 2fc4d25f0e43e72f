//! Expansion: the radiance along a ray that meets nothing but smooth walls, luminaires and what is black is a sum of a few terms, and needs no
//! samples.
//!
//! ```text
//! ray ─▶ wall ─┬─ what it emits, times what is left
//!              ├─ mirror, metal ─▶ one ray            what is left of a ray is 1 at first, and is multiplied by ρ or R, 1 − R, e^(−σ d)
//!              └─ boundary ─▶ two rays
//! ```
//! Rays of which hardly anything is left are given up: that and the brightest radiance that there can be bound the error. What a wall emits and
//! what it reflects add up, L ≤ Lₑ + ρ L, so that no L/n² is above the largest Lₑ/(n² (1 − ρ)) of a wall; at boundaries L/n² is a mean of both
//! sides.

use super::boundary::Passage;
use super::lattice::Lattice;
use super::mirror::reflected;
use super::optics::{MediumOptics, largest, scaled, times};
use super::path::Tracer;
use super::refraction::passages;
use crate::geometry::{Met, Start, Vector};
use crate::scene::{Filling, MaterialKind};

/// The most rays; an expansion into more is not begun with.
const MOST: usize = 1 << 14;
/// The part of the tolerance that what is given up may have.
const GIVEN_UP: f64 = 1e-3;

/// A ray and what is left of it.
struct Ray<const N: usize> {
    start: Start,
    direction: Vector,
    filling: Filling,
    left: [f64; N],
    is_straight: bool,
}

/// For each band a sum, and what may be missing.
struct Terms<const N: usize> {
    sum: [f64; N],
    missing: [f64; N],
}

impl<L: Lattice, const N: usize> Tracer<'_, L, N> {
    /// The radiance along a ray in each band, with its error; none where light is scattered or reflected by a diffuse surface on the way.
    pub(super) fn expansion(&self, start: Start, direction: Vector) -> Option<Vec<[f64; 2]>> {
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

    /// For each band what no radiance is above; none where walls that emit light reflect or transmit all of some light.
    fn brightest(&self) -> Option<[f64; N]> {
        let mut brightest = self.optics.outside;
        for (surface, radiance) in
            self.optics.radiances.iter().enumerate().filter(|(_, radiance)| largest(*radiance) > 0.0)
        {
            let reflectance = self.optics.reflectances[surface];
            let kind = &self.world.scene.materials[self.world.scene.surfaces[surface].material].kind;
            if matches!(kind, MaterialKind::Dielectric { .. } | MaterialKind::Conductor { .. }) {
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

    /// Adds what a ray meets, and the rays that go on from there.
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
            add(&self.optics.outside, &times(&ray.left, &medium.transmittance(f64::INFINITY)));
            return Some(());
        };
        let left = times(&ray.left, &medium.transmittance(met.distance));
        let surface = self.world.sheets[met.wall].surface;
        let is_bright = self.world.is_bright(met.wall, met.is_front);
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
                if stays { ray.filling } else { self.world.sheets[met.wall].filling(!met.is_front) };
            let start = self.world.walls.start_on(&met, met.is_front == stays);
            let is_straight = ray.is_straight && is_straight;
            waiting.push(Ray { start, direction, filling, left, is_straight });
        }
        Some(())
    }

    /// The rays that go on from a wall: the factor, whether they stay on their side, the direction, and whether nothing happens to them.
    #[expect(clippy::type_complexity, reason = "a list of few fields that is taken apart at once")]
    fn rays_from(
        &self,
        ray: &Ray<N>,
        met: &Met,
        medium: &MediumOptics<N>,
        is_bright: bool,
    ) -> Option<Vec<([f64; N], bool, Vector, bool)>> {
        let normal = if met.is_front { met.normal } else { -met.normal };
        let material = self.world.material(met.wall);
        let surface = self.world.sheets[met.wall].surface;
        match material {
            MaterialKind::Dielectric { .. } => {
                let other = self.optics.medium(self.world.sheets[met.wall].filling(!met.is_front));
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
            _ if !L::MIRROR => Some(Vec::new()),
            material => match reflected(material, &self.optics, medium, ray.direction, normal) {
                Passage::Reflected(direction, factor) => Some(vec![(factor, true, direction, false)]),
                Passage::Refracted(..) => None,
            },
        }
    }
}
