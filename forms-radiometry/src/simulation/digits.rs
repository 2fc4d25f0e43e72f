//! Digits: readings of what comes straight from lights become values with bounds on their rounding.
//!
//! ```text
//! few edges in all ─▶ to the last digit, round shapes as a whole
//! many ─▶ in f64, with a bound for all points ─ too large ─▶ with one of their own ─ too large ─▶ to the last digit
//! ```
//! A bound is too large if it is more than rules of integration may leave.

use super::readings::Reading;
use super::solver::RULES;
use crate::radiosity::{Radiosity, Scratch, Straight, is_precise};
use crate::scene::Scene;
use std::borrow::Cow;

/// How readings are computed.
pub(super) enum Digits {
    /// They are not closed forms alone: of their rounding nothing is known yet.
    Unknown,
    /// To the last digit.
    All,
    /// In `f64`; for each band, what rounding changes of any reading at a point.
    Some(Vec<f64>),
}

/// A reading.
pub(super) struct Value<'d> {
    /// In each band.
    pub(super) bands: Vec<f64>,
    /// What rounding changes of it in each band, as far as that is known.
    pub(super) rounding: Cow<'d, [f64]>,
    /// Whether flat pieces may stand for a round shape in it.
    pub(super) has_pieces: bool,
}

impl Digits {
    /// Of readings of a scene, the first `answers` of which are answers; those after them are watched.
    pub(super) fn of(
        (scene, readings): (&Scene, &[Reading]),
        answers: usize,
        is_straight: bool,
        radiosity: &Radiosity,
    ) -> Self {
        if !is_straight {
            return Self::Unknown;
        }
        let (lights, transport) = (radiosity.lights(), radiosity.transport());
        if is_precise(scene, &transport.faces, answers) {
            return Self::All;
        }
        let points: Vec<_> = readings.iter().filter_map(Reading::at_point).map(|(point, _)| point).collect();
        Self::Some(lights.rounding_of_all(&points, transport))
    }

    /// A reading in each band. One that is watched is as those are of which it tells.
    pub(super) fn value(
        &self,
        (reading, is_watched): (&Reading, bool),
        scene: &Scene,
        radiosity: &Radiosity,
        scratch: &mut Scratch,
    ) -> Value<'_> {
        let precise = |scratch: &mut Scratch| {
            let Straight { bands, has_pieces } = reading.precise(is_watched, radiosity, scratch)?;
            let (bands, rounding) = bands.into_iter().map(|[value, own]| (value, own)).unzip();
            Some(Value { bands, rounding: Cow::Owned(rounding), has_pieces })
        };
        let summed = |bands, rounding| Value { bands, rounding, has_pieces: true };
        let of_all = match self {
            Self::Unknown => return summed(reading.value(scene, radiosity, scratch), Cow::Borrowed(&[])),
            Self::All if is_watched => None,
            Self::All => {
                if let Some(precise) = precise(scratch) {
                    return precise;
                }
                None
            }
            Self::Some(of_all) => reading.at_point().is_some().then_some(of_all),
        };
        let values = reading.value(scene, radiosity, scratch);
        let is_rough = |rounding: &[f64]| {
            let allowed = RULES * scene.solve.tolerance;
            values.iter().zip(rounding).any(|(value, rounding)| *rounding > allowed * value.abs())
        };
        if let Some(of_all) = of_all.filter(|of_all| !is_rough(of_all)) {
            return summed(values, Cow::Borrowed(of_all));
        }
        let own = reading.rounding(&values, scene, radiosity);
        let precise = if is_rough(&own) { precise(scratch) } else { None };
        precise.unwrap_or_else(|| summed(values, Cow::Owned(own)))
    }
}
