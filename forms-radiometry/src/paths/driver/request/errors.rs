//! Errors of estimands: the spread of their replicates, and the light that samples may have missed.
//!
//! ```text
//! error² = (spread of replicates)² + (what one more sample could add / samples)²
//! ```
//! A standard error does not know of events that no sample has met. What one of them could add at
//! most is known from the scene: a light source that was hidden from all samples, light that is
//! found only by chance, or where all samples found the same, the brightest light.

use super::Request;
use crate::answer::{ErrorKind, ErrorParts};
use crate::job::MOST_SAMPLES;
use crate::radiosity::driver::ROUNDING;

/// Samples of each replicate after which more are useless, if all of them found nothing.
const NOTHING: u32 = 1 << 14;
/// Difference between the values of samples by rounding, relative to their mean.
const SAME: f64 = 1e-12;
/// Rule of three: an event that none of n samples met is rarer than this over n, as a rule.
const UNMET: f64 = 3.0;

impl Request {
    /// Returns the kind of its errors.
    pub(crate) fn kind(&self) -> ErrorKind {
        match &self.computed {
            None => ErrorKind::Sigma,
            Some(computed) if computed.iter().all(|one| one.parts.quadrature == 0.0) => ErrorKind::Bound,
            Some(_) => ErrorKind::Estimate,
        }
    }

    /// Returns a value and its error.
    pub(crate) fn found(&self, place: usize) -> [f64; 2] {
        let (value, parts) = self.found_in_parts(place);
        [value, parts.error(self.kind())]
    }

    /// Returns a value and its error budget: truncated rays, path samples, omitted image sources,
    /// and rounding.
    pub(crate) fn found_in_parts(&self, place: usize) -> (f64, ErrorParts) {
        let (value, own) = match &self.computed {
            Some(computed) => (computed[place].value, computed[place].parts),
            None => {
                let (value, [spread, unseen, unmet]) = self.sampled(place);
                let sampling = spread.hypot(unseen).hypot(unmet);
                (value, ErrorParts { sampling, ..ErrorParts::default() })
            }
        };
        let [rounding, images] = [ROUNDING, self.left_out].map(|part| part * value.abs());
        (value, own + ErrorParts { rounding, orders: images, ..ErrorParts::default() })
    }

    /// Returns the mean of the samples of a value, and the parts of its error: the spread of its
    /// replicates, the light that samples may have missed, and the light of luminaires under
    /// next-event estimation that no random direction has met. The part of the latter is the square
    /// of their probability per sample.
    fn sampled(&self, place: usize) -> (f64, [f64; 3]) {
        let [value, error] = self.replicates.found(place);
        let is_nothing = self.is_nothing([value, error]);
        let unmet = if is_nothing { (UNMET / self.replicates.count()).powi(2) * value.abs() } else { 0.0 };
        let told = self.spreads.get(place);
        let spread = told.map_or(error, |told| told.error(error, self.replicates.samples));
        (value, [spread, self.unseen(place, is_nothing), unmet])
    }

    /// Whether no sample found anything by chance: all samples have the same value, and it is not
    /// the value of an emitter that a ray sees.
    fn is_nothing(&self, [value, error]: [f64; 2]) -> bool {
        error <= SAME * value.abs() && (value == 0.0 || !self.seen.is_emitter)
    }

    /// Returns the largest amount that one more sample could add to a value: a luminaire that was
    /// hidden from all other samples, or light that is found only by chance. Where no sample found
    /// anything, it is the brightest light, in the part of a pixel that may show any.
    fn unseen(&self, place: usize, is_nothing: bool) -> f64 {
        if self.replicates.samples == 0 {
            return 0.0;
        }
        let rare = 1.0 / self.replicates.count();
        let band = self.replicates.band(place);
        let brightest = if is_nothing { self.brightest[band] * self.shown.min(rare) } else { 0.0 };
        brightest.max(rare * self.by_chance[band].max(self.replicates.missed(place)))
    }

    /// Returns the largest number that any light of the scene causes.
    pub(crate) fn brightest(&self) -> f64 {
        self.brightest.iter().copied().fold(0.0, f64::max)
    }

    /// Returns the largest value of each band.
    pub(crate) fn largest(&self, bands: usize) -> Vec<f64> {
        let mut largest = vec![0.0_f64; bands];
        for place in 0..self.replicates.len() {
            let band = self.replicates.band(place);
            largest[band] = largest[band].max(self.found(place)[0].abs());
        }
        largest
    }

    /// Returns the scale of a value, given the scales of bands; for a cell, at least its own value;
    /// where nothing was found, the brightest light.
    fn scale(&self, place: usize, value: f64, scales: &[f64]) -> f64 {
        let own = if self.cell.is_some() { value.abs() } else { 0.0 };
        let scale = scales[self.replicates.band(place)].max(own);
        if scale > 0.0 { scale } else { self.brightest() }
    }

    /// Returns the largest error relative to the scales.
    pub(crate) fn error(&self, scales: &[f64]) -> f64 {
        let relative = |place: usize| {
            let [value, error] = self.found(place);
            if error == 0.0 { 0.0 } else { error / self.scale(place, value, scales) }
        };
        (0..self.replicates.len()).map(relative).fold(0.0, f64::max)
    }

    /// Predicts the samples of a replicate after which the error meets this tolerance with these
    /// scales. The spread of samples falls as the inverse square root of their number, what they
    /// may have missed as the inverse of their number: σ²/x + u²/x² = ε² with x times the samples.
    pub(in crate::paths::driver) fn needed(&self, scales: &[f64], tolerance: f64) -> f64 {
        let times = |place: usize| {
            let (value, [spread, unseen, unmet]) = self.sampled(place);
            let [spread, unseen] = [spread, unseen.hypot(unmet)].map(|error| error * error);
            let goal = (tolerance * self.scale(place, value, scales)).powi(2);
            if spread + unseen == 0.0 {
                0.0
            } else {
                (spread + spread.hypot(2.0 * (goal * unseen).sqrt())) / (2.0 * goal)
            }
        };
        let most = (0..self.replicates.len()).map(times).fold(0.0, f64::max);
        f64::from(self.replicates.samples) * most
    }

    /// Whether no sample found anything.
    fn has_found_nothing(&self) -> bool {
        (0..self.replicates.len()).all(|place| self.replicates.found(place) == [0.0; 2])
    }

    /// Predicts the samples of a replicate with which the error meets this tolerance with these
    /// scales, if they are doubled until then.
    pub(crate) fn foreseen(&self, scales: &[f64], tolerance: f64) -> f64 {
        let (samples, most) = (f64::from(self.replicates.samples), f64::from(MOST_SAMPLES));
        let doublings = (self.needed(scales, tolerance) / samples).log2().ceil().max(0.0);
        (samples * doublings.exp2()).min(most).max(f64::from(self.target))
    }

    pub(crate) fn may_go_on(&self) -> bool {
        if self.computed.is_some() {
            return false;
        }
        let samples = self.replicates.samples;
        samples < MOST_SAMPLES && !(samples >= NOTHING && self.has_found_nothing())
    }
}
