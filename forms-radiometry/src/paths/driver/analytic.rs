//! Analytic answers: questions that need no samples get their numbers and errors.
//!
//! ```text
//! sight  ─ smooth and black surfaces ─▶ sums over rays          (paths/expansion)
//!          error: truncated rays
//! points ─ a vacuum, direct light ─────▶ closed forms           (radiosity/closed_form)
//!          error: rounding
//! points ─ an attenuating medium ─────▶ integrals over pieces   (radiosity/transmitted)
//!          error: quadrature, rounding
//! sight  ─ single scattering of point
//!          and distant lights ────────▶ integrals along the ray (radiosity/transmitted)
//!          error: quadrature, rounding
//! ```
//! None of the numbers depends on the seed.

use crate::answer::ErrorParts;
use crate::geometry::Vector;
use crate::paths::{Estimand, Limits, PathSampler, extinction_alone, scattering_once};
use crate::radiosity::{
    FirstFaces, Lights, Measure, Reached, Scratch, Transmitted, Transport, has_exact_pieces,
};
use crate::scene::{Medium, Receiver, ReceiverKind, Scene};
use serde::{Deserialize, Serialize};

/// A number and its error budget, without the rounding of the number itself.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Computed {
    pub(crate) value: f64,
    pub(crate) parts: ErrorParts,
}

/// Solvers of questions that need no samples.
pub(crate) struct Computing<'s> {
    samplers: &'s [Box<dyn PathSampler + 's>],
    transmitted: Option<Transmitted<'s>>,
    scattered: Option<(&'s Medium, Transmitted<'s>)>,
    straight: Option<StraightLight<'s>>,
}

/// The luminaires of a scene of flat faces in a vacuum, whose direct light has closed forms.
struct StraightLight<'s> {
    transport: Transport,
    lights: Lights<'s>,
}

impl<'s> StraightLight<'s> {
    fn of(scene: &'s Scene, first: &FirstFaces) -> Self {
        let (faces, screens) = (first.faces(scene), first.screens(scene));
        let transport = Transport { faces, screens, occlusion: true, hides_outside: true, accuracy: 1.0 };
        let lights = Lights::of(scene, &transport);
        Self { transport, lights }
    }

    fn at(&self, position: Vector, measures: &[Measure]) -> Vec<Computed> {
        let mut scratch = Scratch::default();
        let of_measure = |&measure: &Measure| {
            self.lights.precisely((position, measure), false, &self.transport, &mut scratch).bands
        };
        let computed = |[value, rounding]: [f64; 2]| Computed {
            value,
            parts: ErrorParts { rounding, ..ErrorParts::default() },
        };
        measures.iter().flat_map(of_measure).map(computed).collect()
    }
}

impl<'s> Computing<'s> {
    pub(crate) fn of(
        scene: &'s Scene,
        (computable, limits): (Computable, &Limits),
        first: &FirstFaces,
        samplers: &'s [Box<dyn PathSampler + 's>],
    ) -> Self {
        let transmitted = computable.points.then(|| extinction_alone(scene, limits)).flatten();
        let scattered = computable.rays.then(|| scattering_once(scene, limits)).flatten();
        Self {
            samplers,
            transmitted: transmitted.map(|extinction| Transmitted::of(scene, extinction)),
            scattered: scattered.map(|(medium, extinction)| (medium, Transmitted::of(scene, extinction))),
            straight: computable.straight.then(|| StraightLight::of(scene, first)),
        }
    }

    /// Returns no solver, for a scene whose answers are known already.
    pub(crate) fn nothing() -> Self {
        Self { samplers: &[], transmitted: None, scattered: None, straight: None }
    }

    /// Answers a question without samples, number by number and band by band, if that is possible.
    pub(crate) fn answer(&self, estimand: &Estimand) -> Option<Vec<Computed>> {
        let reached = match *estimand {
            Estimand::Plane { position, normal } if self.straight.is_some() => {
                return Some(self.straight.as_ref()?.at(position, &[Measure::Plane(normal)]));
            }
            Estimand::Sphere { position } if self.straight.is_some() => {
                return Some(self.straight.as_ref()?.at(position, &Measure::ALL_SIDES));
            }
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
    /// Whether the direct light at points and in cells has closed forms, which are to be used.
    straight: bool,
}

impl Computable {
    /// Determines the kinds of receivers for a scene, once for all its receivers: that needs the
    /// faces of all surfaces.
    pub(crate) fn of(scene: &Scene, limits: &Limits) -> Self {
        let points = extinction_alone(scene, limits).is_some();
        let rays = scattering_once(scene, limits).is_some();
        let exact = (points || rays) && has_exact_pieces(scene);
        Self { points: points && exact, rays: rays && exact, straight: false }
    }

    /// Returns the same with the direct light of flat faces in a vacuum by closed forms, at points
    /// and in the cells of maps.
    pub(crate) fn with_straight(self) -> Self {
        Self { straight: true, ..self }
    }

    /// Whether direct light at points and in cells has closed forms.
    pub(crate) fn is_straight(self) -> bool {
        self.straight
    }

    /// Whether the answers of this receiver are computed without samples.
    pub(crate) fn has(self, receiver: &Receiver) -> bool {
        let computes = match receiver.kind {
            ReceiverKind::Point { .. } | ReceiverKind::Points(_) | ReceiverKind::Sphere { .. } => {
                self.points || self.straight
            }
            ReceiverKind::Ray { .. } => self.rays,
            ReceiverKind::Surface { .. } | ReceiverKind::Faces { .. } | ReceiverKind::Camera(_) => false,
        };
        computes && receiver.time.is_none()
    }
}
