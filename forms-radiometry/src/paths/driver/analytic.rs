//! Analytic answers: questions that need no samples get their numbers and errors.
//!
//! ```text
//! sight  ─ smooth and black surfaces ─▶ sums over rays          (paths/expansion)
//!          error: truncated rays
//! points ─ an attenuating medium ─────▶ integrals over pieces   (radiosity/transmitted)
//!          error: quadrature, rounding
//! sight  ─ single scattering of point
//!          and distant lights ────────▶ integrals along the ray (radiosity/transmitted)
//!          error: quadrature, rounding
//! ```
//! None of the numbers depends on the seed.

use crate::answer::ErrorParts;
use crate::paths::{Estimand, Limits, PathSampler, extinction_alone, scattering_once};
use crate::radiosity::{Measure, Reached, Transmitted, has_exact_pieces};
use crate::scene::{Medium, Receiver, ReceiverKind, Scene};
use serde::{Deserialize, Serialize};

/// A number and its error budget, without the rounding of the number itself.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Computed {
    pub(crate) value: f64,
    pub(crate) parts: ErrorParts,
}

/// Solvers of questions that need no samples.
pub(crate) struct Computing<'s> {
    samplers: &'s [Box<dyn PathSampler + 's>],
    transmitted: Option<Transmitted<'s>>,
    scattered: Option<(&'s Medium, Transmitted<'s>)>,
}

impl<'s> Computing<'s> {
    pub(crate) fn of(
        scene: &'s Scene,
        (computable, limits): (Computable, &Limits),
        samplers: &'s [Box<dyn PathSampler + 's>],
    ) -> Self {
        let transmitted = computable.points.then(|| extinction_alone(scene, limits)).flatten();
        let scattered = computable.rays.then(|| scattering_once(scene, limits)).flatten();
        Self {
            samplers,
            transmitted: transmitted.map(|extinction| Transmitted::of(scene, extinction)),
            scattered: scattered.map(|(medium, extinction)| (medium, Transmitted::of(scene, extinction))),
        }
    }

    /// Returns no solver, for a scene whose answers are known already.
    pub(crate) fn nothing() -> Self {
        Self { samplers: &[], transmitted: None, scattered: None }
    }

    /// Answers a question without samples, number by number and band by band, if that is possible.
    pub(crate) fn answer(&self, estimand: &Estimand) -> Option<Vec<Computed>> {
        let reached = match *estimand {
            Estimand::Plane { position, normal } => {
                self.transmitted.as_ref()?.at(position, &[Measure::Plane(normal)])
            }
            Estimand::Sphere { position } => self.transmitted.as_ref()?.at(position, &Measure::ALL_SIDES),
            Estimand::Sight { origin, direction } => match &self.scattered {
                Some((medium, lights)) => lights.scattered_once([origin, direction], medium),
                None => return self.expanded(estimand),
            },
            Estimand::Surface { .. } | Estimand::Pixel { .. } => return None,
        };
        Some(reached.into_iter().map(Computed::from).collect())
    }

    /// Returns the sum over rays for each band, if all tracers can take it.
    fn expanded(&self, estimand: &Estimand) -> Option<Vec<Computed>> {
        let groups: Option<Vec<_>> =
            self.samplers.iter().map(|path_samplers| path_samplers.expanded(estimand)).collect();
        let found = groups.filter(|groups| !groups.is_empty())?.concat();
        let computed = |[value, orders]: [f64; 2]| Computed {
            value,
            parts: ErrorParts { orders, ..ErrorParts::default() },
        };
        Some(found.into_iter().map(computed).collect())
    }
}

impl From<Reached> for Computed {
    fn from(Reached { value, quadrature, rounding }: Reached) -> Self {
        Self { value, parts: ErrorParts { quadrature, rounding, ..ErrorParts::default() } }
    }
}

/// Kinds of receivers in a scene of media whose answers are computed without samples.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Computable {
    points: bool,
    rays: bool,
}

impl Computable {
    /// Determines the kinds of receivers for a scene, once for all its receivers: that needs the
    /// faces of all surfaces.
    pub(crate) fn of(scene: &Scene, limits: &Limits) -> Self {
        let points = extinction_alone(scene, limits).is_some();
        let rays = scattering_once(scene, limits).is_some();
        let exact = (points || rays) && has_exact_pieces(scene);
        Self { points: points && exact, rays: rays && exact }
    }

    /// Whether the answers of this receiver are computed without samples.
    pub(crate) fn has(self, receiver: &Receiver) -> bool {
        let computes = match receiver.kind {
            ReceiverKind::Point { .. } | ReceiverKind::Sphere { .. } => self.points,
            ReceiverKind::Ray { .. } => self.rays,
            ReceiverKind::Surface { .. } | ReceiverKind::Camera(_) => false,
        };
        computes && receiver.time.is_none()
    }
}
