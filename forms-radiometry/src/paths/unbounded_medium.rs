//! Unbounded media: scattering, non-absorbing media around a whole scene, in which a path that has
//! escaped never ends.
//!
//! ```text
//! estimands ─ paths, as long as they last ─▶ one is scattered outside all walls:
//!                                      it returns with probability < 1, and nothing can end it
//! ```
//! Radiance in such a medium is well defined, but the number of events of a path has an infinite
//! mean.

use super::estimand::{Begin, Estimand};
use super::light_trap::{Ray, Search};
use super::optics::MediumOptics;
use super::specialisation::Specialisation;
use super::tracer::{Limits, Path, Tracer};
use super::vertex::Law;
use super::warps::free_flight_sample;
use super::world::World;
use crate::sampling::{Samples, key};
use crate::scene::SceneError;
use rayon::prelude::*;

/// Number of test paths, and the maximum number of events of each.
const PATHS: usize = 1024;
const TURNS: u32 = 1024;

/// Returns an error for the medium in which paths from the estimands of a scene never end, if there
/// is one.
pub(crate) fn endless(
    world: &World,
    estimands: impl FnOnce() -> Vec<Estimand>,
    limits: &Limits,
) -> Option<SceneError> {
    let scene = &*world.scene;
    if limits.scatterings.is_some() {
        return None;
    }
    let is_conservative = |search: &Search| search.optics.medium(scene.ambient.medium).is_conservative();
    let search = (0..scene.band_count()).map(|band| Search::of(world, band)).find(is_conservative)?;
    let estimands = estimands();
    if estimands.is_empty() {
        return None;
    }
    let gets_out = |path: usize| {
        let estimand = &estimands[path * estimands.len() / PATHS];
        search.gets_out(estimand, &mut Samples::new(key(23, 0), path as u32))
    };
    (0..PATHS).into_par_iter().any(gets_out).then(|| {
        let medium = &scene.media[scene.ambient.medium.expect("a conservative medium is around the scene")];
        let message = format!(
            "the medium `{}` is unbounded and absorbs nothing: light that escapes into it \
             is scattered forever",
            medium.name
        );
        let expected =
            "a `sigma_a` above 0, surfaces around the medium, or `effects = { scattering = 1 }` or more";
        SceneError::new(&medium.place, message, expected)
    })
}

impl Search<'_> {
    /// Whether a path from an estimand is scattered outside all walls by an unbounded medium.
    fn gets_out(&self, estimand: &Estimand, samples: &mut Samples) -> bool {
        let Some(mut ray) = self.begun(estimand, samples) else { return false };
        for _ in 0..TURNS {
            match self.scattered_or_met(&mut ray, samples) {
                Turn::Beyond => return true,
                Turn::End => return false,
                Turn::On => {}
            }
        }
        false
    }

    /// Returns the first ray of a path.
    fn begun(&self, estimand: &Estimand, samples: &mut Samples) -> Option<Ray> {
        let (start, direction) = match estimand.begin(self.world, samples)? {
            Begin::Sight { start, direction } => (start, direction),
            Begin::Receiver { start, normal } => {
                let law: Law<1> = normal.map_or(Law::Sphere, Law::Plane);
                (start, law.direction(1, samples))
            }
        };
        Some(Ray { start, direction, filling: self.world.medium_at(start, direction) })
    }

    /// Traces a path to its next event. The fraction of the light lost there is the probability
    /// that the path ends.
    fn scattered_or_met(&self, ray: &mut Ray, samples: &mut Samples) -> Turn {
        let medium = self.optics.medium(ray.filling);
        let met = self.world.walls.first(ray.start, ray.direction, f64::INFINITY);
        let ([extinction], [scattering]) = (medium.extinction, medium.scattering);
        if extinction > 0.0 {
            let distance = free_flight_sample(extinction, samples.one());
            if met.is_none_or(|met| distance < met.distance) {
                self.scatter(ray, distance, samples);
                // light can be scattered forever only in a medium that absorbs nothing
                let is_beyond = medium.is_conservative() && !self.world.walls.surround(ray.start.position);
                return match samples.one() * extinction < scattering {
                    true if is_beyond => Turn::Beyond,
                    true => Turn::On,
                    false => Turn::End,
                };
            }
        }
        let left = met.map_or(0.0, |met| self.meets(ray, &met, samples));
        if samples.one() < left { Turn::On } else { Turn::End }
    }
}

impl<L: Specialisation, const N: usize> Tracer<'_, L, N> {
    /// Whether the path has escaped to where an unbounded medium scatters it forever. A scene in
    /// which this happens to more than a thousandth of the paths has been rejected. The light that
    /// is lost by ending such a path is therefore negligible compared with the statistical error of
    /// the result.
    pub(crate) fn is_endless(&self, path: &Path<N>, medium: &MediumOptics<N>) -> bool {
        self.limits.scatterings.is_none()
            && medium.is_conservative()
            && !self.world.walls.surround(path.start.position)
            && path.filling == self.world.scene.ambient.medium
    }
}

/// Outcome of one event of a path.
enum Turn {
    On,
    End,
    /// The path was scattered outside all walls, and nothing ends it.
    Beyond,
}
