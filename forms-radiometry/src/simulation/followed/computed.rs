//! What is computed: questions that need no samples get their numbers, and what these may be off by.
//!
//! ```text
//! sight  ─ smooth and black walls ──────────────────▶ terms of rays           (monte_carlo/expansion)      what is given up
//! points ─ a medium that only takes light away ─────▶ integrals over pieces   (radiosity/transmitted)      quadrature, rounding
//! ```
//! All of it is the same for every seed.

use super::super::parts::ErrorParts;
use crate::monte_carlo::{Follow, Limits, Question, extinction_alone};
use crate::radiosity::{Measure, Reached, Transmitted, has_exact_pieces};
use crate::scene::{Receiver, ReceiverKind, Scene};
use serde::{Deserialize, Serialize};

/// A number and what its error is made of, but for rounding of the number itself.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Computed {
    pub(super) value: f64,
    pub(super) parts: ErrorParts,
}

/// What answers without samples.
pub(super) struct Computing<'s> {
    pub(super) followers: &'s [Box<dyn Follow + 's>],
    transmitted: Option<Transmitted<'s>>,
}

impl<'s> Computing<'s> {
    pub(super) fn of(scene: &'s Scene, limits: &Limits, followers: &'s [Box<dyn Follow + 's>]) -> Self {
        let extinction = extinction_alone(scene, limits).filter(|_| has_exact_pieces(scene));
        Self { followers, transmitted: extinction.map(|extinction| Transmitted::of(scene, extinction)) }
    }

    /// Nothing, for a scene whose answers are known already.
    pub(super) fn nothing() -> Self {
        Self { followers: &[], transmitted: None }
    }

    /// What answers a question without samples, number by number and band by band, if anything does.
    pub(super) fn answer(&self, question: &Question) -> Option<Vec<Computed>> {
        let measures: &[Measure] = match question {
            Question::Plane { normal, .. } => &[Measure::Plane(*normal)],
            Question::Sphere { .. } => &Measure::ALL_SIDES,
            _ => return self.expanded(question),
        };
        let (Question::Plane { position, .. } | Question::Sphere { position }) = question else {
            return None;
        };
        let reached = self.transmitted.as_ref()?.at(*position, measures);
        Some(reached.into_iter().map(Computed::from).collect())
    }

    /// The terms of a sum, for each band, if all followers can take it.
    fn expanded(&self, question: &Question) -> Option<Vec<Computed>> {
        let groups: Option<Vec<_>> =
            self.followers.iter().map(|follower| follower.expanded(question)).collect();
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

/// Whether what points get in a scene is computed.
pub(in super::super) fn computes_points(scene: &Scene, limits: &Limits) -> bool {
    extinction_alone(scene, limits).is_some() && has_exact_pieces(scene)
}

/// Whether a receiver asks for what points get, and for nothing else.
pub(in super::super) fn is_at_point(receiver: &Receiver) -> bool {
    let is_point = matches!(receiver.kind, ReceiverKind::Point { .. } | ReceiverKind::Sphere { .. });
    is_point && receiver.time.is_none()
}
