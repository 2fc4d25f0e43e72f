//! Estimates: what is known of a reading, from how it changed while elements became finer.
//!
//! ```text
//! error = 1.5 λₙ max(Δₙ, λₙ₋₁ Δₙ₋₁/4, pooled change)          where elements were made finer for others: no less than εₙ₋₁ − Δₙ/2
//! ```
//! λ is what all refinements to come are expected to settle, relative to what the last one settled, both as elements matter to the
//! answers. A change may cancel by chance: so what the change before let expect counts too, and the changes of all readings together, most
//! of all those of the same receiver: the components of a vector, the cells of a map. A reading that does not change at all is none
//! of the elements'.

use super::answer::ErrorKind;
use super::parts::ErrorParts;
use super::solver::DARK;

/// The safety of the estimate.
const SAFETY: f64 = 1.5;
/// The least and the largest that refinements to come are taken to settle.
const LEFT: [f64; 2] = [0.05, 10.0];
/// What refinements to come are taken to settle at least where there was a single one: how fast light settles is not seen yet.
const AT_FIRST: f64 = 0.5;
/// The part of what the change before let expect that each change is taken to have had at least.
const CARRIED: f64 = 0.25;
/// The part of a change that was settled where elements were made finer for other readings: the rest may have come anew.
const SETTLED: f64 = 0.5;
/// The part of the changes of all readings that each one is taken to have had at least, relative to its scale.
const POOLED: f64 = 0.3;

/// The part of the largest change in its group, relative to the scale of each, that each reading is taken to have had at least.
const GROUPED: f64 = 0.5;

/// What is known of one reading in one band.
#[derive(Clone, Copy, Debug)]
pub(super) struct Estimate {
    pub(super) value: f64,
    /// By how much it changed last, and by how much it may have.
    changed: f64,
    change: f64,
    /// What refinements to come settle, relative to what the last one settled.
    left: f64,
    /// What is left of the error before, if elements were made finer for other readings only.
    kept: f64,
    /// What finer elements leave: the solution of the equations, rules of integration, the shape of surfaces, and rounding.
    pub(super) floor: ErrorParts,
}

/// What is known of a reading before elements became finer.
#[derive(Clone, Copy)]
pub(super) struct Before<'e> {
    pub(super) estimate: &'e Estimate,
    /// Whether it was one of those that they became finer for.
    pub(super) was_asked: bool,
    /// What refinements to come settle, relative to what this one settled.
    pub(super) left: f64,
}

impl Estimate {
    /// A first value, or one that comes after another.
    pub(super) fn new(value: f64, before: Option<Before>, floor: ErrorParts) -> Self {
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

    /// A value that finer elements do not change, with its error.
    pub(super) fn exact(value: f64, floor: ErrorParts) -> Self {
        let (value, floor) = known(value, floor);
        Self { value, changed: 0.0, change: 0.0, left: 0.0, kept: 0.0, floor }
    }

    /// Finer elements do not change it.
    pub(super) fn settle(&mut self) {
        *self = Self::exact(self.value, self.floor);
    }

    /// What its error means: rules of integration, elements and flat pieces in the place of round shapes leave no more than estimates.
    pub(super) fn kind(&self, has_pieces: bool) -> ErrorKind {
        let parts = self.parts();
        if parts.sampling > 0.0 {
            ErrorKind::Confidence
        } else if self.is_exact() && !has_pieces && parts.quadrature == 0.0 && parts.orders == 0.0 {
            ErrorKind::Bound
        } else {
            ErrorKind::Estimate
        }
    }

    /// Whether finer elements do not change it.
    pub(super) fn is_exact(&self) -> bool {
        self.left == 0.0
    }

    /// What its error is made of: what elements leave is of the quadrature.
    pub(super) fn parts(&self) -> ErrorParts {
        let refined =
            if self.change == 0.0 { 0.0 } else { SAFETY * self.left.clamp(LEFT[0], LEFT[1]) * self.change };
        let quadrature = self.kept.max(refined + self.floor.quadrature);
        let parts = ErrorParts { quadrature, ..self.floor };
        known(self.value, parts).1
    }

    pub(super) fn error(&self) -> f64 {
        self.parts().error(ErrorKind::Bound)
    }
}

/// A value and its error, where numbers beyond the range of `f64` left none: then nothing is known of it, and it says so.
fn known(value: f64, error: ErrorParts) -> (f64, ErrorParts) {
    let unknown = ErrorParts { quadrature: f64::INFINITY, ..ErrorParts::default() };
    match (value.is_nan(), error.error(ErrorKind::Bound).is_nan()) {
        (true, _) => (0.0, unknown),
        (false, true) => (value, unknown),
        (false, false) => (value, error),
    }
}

/// A reading in all bands, in none if it was not reached.
#[derive(Clone, Debug)]
pub(super) struct Found {
    pub(super) bands: Vec<Estimate>,
    /// Whether flat pieces may stand for a round shape in it.
    pub(super) has_pieces: bool,
}

impl Found {
    /// Whether it was not reached.
    pub(super) fn is_missing(&self) -> bool {
        self.bands.is_empty()
    }
}

/// Raises changes that are small beside those of all readings, each relative to its scale, and beside those of its group.
pub(super) fn pool(found: &mut [Found], scales: &[Vec<f64>], groups: &[usize]) {
    let (mut sum, mut count) = (0.0, 0.0);
    // of what is dark beside all others, changes are no more than rounding
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
