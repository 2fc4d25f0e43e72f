//! Estimates: the value of a reading, and its error from its changes while elements were refined.
//!
//! ```text
//! error = 1.5 λₙ max(Δₙ, λₙ₋₁ Δₙ₋₁/4, pooled change)
//!         at least εₙ₋₁ − Δₙ/2 where elements were refined for other readings
//! ```
//! λ is the change that all future refinements are expected to make, relative to the change made by
//! the last one. Both are weighted by the importance of the elements for the answers. A change may
//! cancel by chance. Therefore the change expected from the previous refinement counts too, and so
//! do the changes of all readings together, most of all those of the same receiver: the components
//! of a vector, the cells of a map. A reading that does not change at all does not depend on the
//! elements.

use crate::answer::{DARK, ErrorKind, ErrorParts};

/// Safety factor of the estimate.
const SAFETY: f64 = 1.5;
/// Smallest and largest λ that the estimate uses.
const LEFT: [f64; 2] = [0.05, 10.0];
/// Least λ after a single refinement: the rate of convergence is not known yet.
const AT_FIRST: f64 = 0.5;
/// Each change counts as at least this part of the change expected from the previous refinement.
const CARRIED: f64 = 0.25;
/// Part of a change that reduces the error where elements were refined for other readings: the rest
/// may be new error.
const SETTLED: f64 = 0.5;
/// Each change counts as at least this part of the changes of all readings, relative to its scale.
const POOLED: f64 = 0.3;

/// Each change counts as at least this part of the largest change in its group, both relative to
/// their scales.
const GROUPED: f64 = 0.5;

/// Estimate of one reading in one band.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Estimate {
    pub(crate) value: f64,
    /// Last change, and the change that it may have been.
    changed: f64,
    change: f64,
    /// λ: change by future refinements, relative to the change by the last one.
    left: f64,
    /// Remainder of the previous error, if elements were refined for other readings only.
    kept: f64,
    /// Error that refinement does not reduce: solution of the equations, quadrature, tessellation,
    /// and rounding.
    pub(crate) floor: ErrorParts,
}

/// Estimate of a reading before a refinement.
#[derive(Clone, Copy)]
pub(crate) struct Before<'e> {
    pub(crate) estimate: &'e Estimate,
    /// Whether elements were refined for this reading.
    pub(crate) was_asked: bool,
    /// Change by future refinements, relative to the change by this one.
    pub(crate) left: f64,
}

impl Estimate {
    /// Returns the estimate from a first value, or from a value after a refinement.
    pub(crate) fn new(value: f64, before: Option<Before>, floor: ErrorParts) -> Self {
        let (value, floor) = known(value, floor);
        let unknown = f64::INFINITY;
        let Some(Before { estimate: before, was_asked, left }) = before else {
            return Self { value, changed: unknown, change: unknown, left: 1.0, kept: 0.0, floor };
        };
        let changed = (value - before.value).abs();
        let is_first = !before.changed.is_finite();
        let left = if is_first { left.max(AT_FIRST) } else { left };
        let kept = if was_asked { 0.0 } else { (before.parts().quadrature - SETTLED * changed).max(0.0) };
        let carried = if is_first { 0.0 } else { CARRIED * before.left.min(1.0) * before.changed };
        Self { value, changed, change: changed.max(carried), left: left.max(f64::MIN_POSITIVE), kept, floor }
    }

    /// Returns the estimate of a value that refinement does not change.
    pub(crate) fn exact(value: f64, floor: ErrorParts) -> Self {
        let (value, floor) = known(value, floor);
        Self { value, changed: 0.0, change: 0.0, left: 0.0, kept: 0.0, floor }
    }

    /// Records that no reflected light is part of the value.
    pub(crate) fn settle_unreached(&mut self) {
        *self = Self::exact(self.value, ErrorParts { orders: 0.0, ..self.floor });
    }

    /// Returns the kind of its error. Quadrature, elements, and tessellated disks and spheres leave
    /// no more than estimates.
    pub(crate) fn kind(&self, has_pieces: bool) -> ErrorKind {
        let parts = self.parts();
        if self.is_exact() && !has_pieces && parts.quadrature == 0.0 && parts.orders == 0.0 {
            ErrorKind::Bound
        } else {
            ErrorKind::Estimate
        }
    }

    /// Whether refinement does not change the value.
    pub(crate) fn is_exact(&self) -> bool {
        self.left == 0.0
    }

    /// Returns its error budget. The error by elements counts as quadrature.
    pub(crate) fn parts(&self) -> ErrorParts {
        let refined =
            if self.change == 0.0 { 0.0 } else { SAFETY * self.left.clamp(LEFT[0], LEFT[1]) * self.change };
        let quadrature = self.kept.max(refined + self.floor.quadrature);
        let parts = ErrorParts { quadrature, ..self.floor };
        known(self.value, parts).1
    }

    pub(crate) fn error(&self) -> f64 {
        self.parts().error(ErrorKind::Bound)
    }
}

/// Returns a value and its error, with NaN replaced. Numbers beyond the range of `f64` leave NaN:
/// the error is then infinite, and a NaN value becomes 0.
fn known(value: f64, error: ErrorParts) -> (f64, ErrorParts) {
    let unknown = ErrorParts { quadrature: f64::INFINITY, ..ErrorParts::default() };
    match (value.is_nan(), error.error(ErrorKind::Bound).is_nan()) {
        (true, _) => (0.0, unknown),
        (false, true) => (value, unknown),
        (false, false) => (value, error),
    }
}

/// Reading in all bands; in none if it was not reached.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    pub(crate) bands: Vec<Estimate>,
    /// Whether tessellated faces may replace a disk or a sphere in it.
    pub(crate) has_pieces: bool,
}

impl Found {
    /// Whether the reading was not reached.
    pub(crate) fn is_missing(&self) -> bool {
        self.bands.is_empty()
    }
}

/// Raises changes that are small compared with the changes of all readings, each relative to its
/// scale, and with those of the reading's group.
pub(crate) fn pool(found: &mut [Found], scales: &[Vec<f64>], groups: &[usize]) {
    let (mut sum, mut count) = (0.0, 0.0);
    // a reading that is dark compared with all others changes by rounding only
    let dark = DARK * scales.iter().flatten().copied().fold(0.0, f64::max);
    let mut largest = vec![vec![0.0_f64; scales.first().map_or(0, Vec::len)]; found.len()];
    for ((found, scales), &group) in found.iter().zip(scales).zip(groups) {
        for ((estimate, &scale), largest) in found.bands.iter().zip(scales).zip(&mut largest[group]) {
            if estimate.changed.is_finite() && scale > dark {
                sum += (estimate.changed / scale).powi(2);
                count += 1.0;
                *largest = largest.max(estimate.changed / scale);
            }
        }
    }
    let typical = if count > 0.0 { POOLED * (sum / count).sqrt() } else { 0.0 };
    for ((found, scales), &group) in found.iter_mut().zip(scales).zip(groups) {
        for ((estimate, &scale), &largest) in found.bands.iter_mut().zip(scales).zip(&largest[group]) {
            if !estimate.is_exact() && estimate.changed > 0.0 {
                estimate.change = estimate.change.max(typical.max(GROUPED * largest) * scale);
            }
        }
    }
}
