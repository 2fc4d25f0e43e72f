//! Digits: readings of what comes straight from lights become values with bounds on their rounding.
//!
//! ```text
//! few edges in all ─▶ to the last digit
//! many ─▶ in f64, with a bound for all points ─ too large ─▶ with one of their own ─ too large ─▶ to the last digit
//! ```
//! A bound is too large if it is more than rules of integration may leave.

use super::readings::Reading;
use super::solver::RULES;
use crate::radiosity::{Radiosity, Scratch};
use crate::scene::Scene;
use std::borrow::Cow;

/// So many edges are seen from all points together in double-double at most, each in some 2 µs; what is seen of more is summed in `f64`.
const PRECISE_EDGES: usize = 1024;

/// How readings are computed.
pub(super) enum Digits {
    /// They are not closed forms alone: of their rounding nothing is known yet.
    Unknown,
    /// To the last digit.
    All,
    /// In `f64`; for each band, what rounding changes of any reading at a point.
    Some(Vec<f64>),
}

impl Digits {
    pub(super) fn of(readings: &[Reading], is_straight: bool, radiosity: &Radiosity) -> Self {
        if !is_straight {
            return Self::Unknown;
        }
        let (lights, transport) = (radiosity.lights(), radiosity.transport());
        if lights.edges(transport) * readings.len() <= PRECISE_EDGES {
            return Self::All;
        }
        let points: Vec<_> = readings.iter().filter_map(Reading::at_point).map(|(point, _)| point).collect();
        Self::Some(lights.rounding_of_all(&points, transport))
    }

    /// A reading in each band, and what rounding changes of it.
    pub(super) fn value(
        &self,
        reading: &Reading,
        scene: &Scene,
        radiosity: &Radiosity,
        scratch: &mut Scratch,
    ) -> (Vec<f64>, Cow<'_, [f64]>) {
        let precise = |scratch: &mut Scratch| {
            let [mut values, mut rounding] = [Vec::new(), Vec::new()];
            for [value, own] in reading.precise(radiosity, scratch)? {
                values.push(value);
                rounding.push(own);
            }
            Some((values, Cow::Owned(rounding)))
        };
        let of_all = match self {
            Self::Unknown => return (reading.value(scene, radiosity, scratch), Cow::Borrowed(&[])),
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
            return (values, Cow::Borrowed(of_all));
        }
        let own = reading.rounding(&values, scene, radiosity);
        let precise = if is_rough(&own) { precise(scratch) } else { None };
        precise.unwrap_or((values, Cow::Owned(own)))
    }
}
