//! Precision: readings of direct light become values with bounds on their rounding error.
//!
//! ```text
//! few edges in all ─▶ double-double, disks and spheres as whole shapes
//! many edges       ─▶ f64 with one bound for all points; where that is too large, with its own
//!                     bound; where that is too large too, double-double
//! ```
//! A bound is too large if it exceeds the error that quadrature is allowed.

use super::RULES;
use super::readings::Reading;
use crate::radiosity::{Radiosity, Scratch, Straight, is_precise};
use crate::scene::Scene;
use std::borrow::Cow;

/// Precision of the readings.
pub(crate) enum Digits {
    /// The readings are not closed forms alone. Their rounding error is not known yet.
    Unknown,
    /// In double-double.
    All,
    /// In `f64`, with a bound for each band on the rounding error of any reading at a point.
    Some(Vec<f64>),
}

/// Value of a reading.
pub(crate) struct Value<'d> {
    /// Value in each band.
    pub(crate) bands: Vec<f64>,
    /// Bound on its rounding error in each band, where it is known.
    pub(crate) rounding: Cow<'d, [f64]>,
    /// Whether tessellated faces may replace a disk or a sphere in it.
    pub(crate) has_pieces: bool,
}

impl Digits {
    /// Chooses the precision for the readings of a scene. The first readings are `requested`; the
    /// others are watched.
    pub(crate) fn of(
        (scene, readings): (&Scene, &[Reading]),
        requested: usize,
        is_straight: bool,
        radiosity: &Radiosity,
    ) -> Self {
        if !is_straight {
            return Self::Unknown;
        }
        let (lights, transport) = (radiosity.lights(), radiosity.transport());
        if is_precise(scene, &transport.faces, requested) {
            return Self::All;
        }
        let points: Vec<_> = readings.iter().filter_map(Reading::at_point).map(|(point, _)| point).collect();
        Self::Some(lights.rounding_of_all(&points, transport))
    }

    /// Returns a reading in each band. A watched reading is evaluated like the cells that it
    /// represents.
    pub(crate) fn value(
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
