//! Goals: the readings that are not accurate enough determine which elements are refined.

use super::Work;
use super::estimate::{Before, Estimate, Found};
use crate::answer::relative;
use crate::radiosity::{Asking, Goal, Radiosity, Refined};

/// Part of the tolerance left for elements that are not split although they are expected to change.
const SPARED: f64 = 0.3;

/// Estimates of all readings before a refinement, and the change that it leaves to future ones.
pub(crate) struct Earlier<'f> {
    found: &'f [Found],
    /// Remaining change of each reading that the elements were refined for, relative to the last
    /// change.
    left: Vec<Option<f64>>,
    pub(crate) refined: Refined,
}

impl<'f> Earlier<'f> {
    /// Collects the estimates before a refinement. `open` are the readings whose goals were
    /// requested, in the order of the goals.
    pub(crate) fn new(found: &'f [Found], open: &[usize], refined: Refined) -> Self {
        let mut left = vec![None; found.len()];
        open.iter().zip(&refined.of_goals).for_each(|(&reading, &of_goal)| left[reading] = Some(of_goal));
        Self { found, left, refined }
    }

    /// Returns the earlier estimate of a reading in a band.
    pub(crate) fn of(&self, reading: usize, band: usize) -> Before<'f> {
        let own = self.left[reading];
        Before {
            estimate: &self.found[reading].bands[band],
            was_asked: own.is_some(),
            left: own.map_or(self.refined.left, |own| own.max(self.refined.left)),
        }
    }
}

impl Work<'_> {
    /// Returns the readings that are not accurate enough, as goals weighted by their errors, and
    /// the indices of these readings.
    pub(crate) fn asking(&self, radiosity: &Radiosity, found: &[Found]) -> (Asking, Vec<usize>) {
        let sparing = SPARED * self.scene.solve.tolerance;
        let (mut asking, mut open) = (Asking { goals: Vec::new(), errors: [0.0; 2], sparing }, Vec::new());
        let readings = self.readings.iter().zip(found).zip(self.targets(found));
        for (index, ((reading, found), scales)) in readings.enumerate() {
            let worst = worst(found, &scales);
            let errors = found.bands.iter().map(Estimate::error).filter(|error| error.is_finite());
            // the weight of a reading that is zero so far is relative to its error, or to 1 if that
            // is zero too
            let scale = [scales.iter().copied().fold(0.0, f64::max), errors.fold(0.0, f64::max)];
            let scale = scale.into_iter().find(|&scale| scale > 0.0).unwrap_or(1.0);
            let weight = if worst.is_finite() { worst / scale } else { 1.0 / scale };
            let weight = weight * reading.of_goal(radiosity.transport());
            let Some(what) = reading.goal(self.scene, radiosity.transport()) else { continue };
            if worst > self.scene.solve.tolerance && weight.is_finite() {
                open.push(index);
                asking.goals.push(Goal { what, weight });
                asking.errors[0] += worst;
                asking.errors[1] += worst * worst;
            }
        }
        (asking, open)
    }

    /// Returns the errors of all readings in all bands, relative to the scales of their tolerances.
    /// The error of a reading that was not reached is infinite.
    pub(crate) fn relative_errors(&self, found: &[Found]) -> impl Iterator<Item = f64> {
        let relative = |(estimate, scale): (&Estimate, f64)| relative(estimate.error(), scale);
        let pairs = found.iter().zip(self.targets(found));
        let mut errors: Vec<f64> =
            pairs.flat_map(|(found, scales)| found.bands.iter().zip(scales).map(relative)).collect();
        errors.extend(found.iter().any(Found::is_missing).then_some(f64::INFINITY));
        errors.into_iter()
    }

    pub(crate) fn is_enough(&self, found: &[Found]) -> bool {
        self.relative_errors(found).all(|error| error <= self.scene.solve.tolerance)
    }
}

/// Returns the largest error of a reading in any band, relative to its scales.
fn worst(found: &Found, scales: &[f64]) -> f64 {
    let relative = |(estimate, scale): (&Estimate, &f64)| {
        let error = estimate.error();
        if error.is_finite() { error / scale } else { f64::INFINITY }
    };
    found.bands.iter().zip(scales).map(relative).fold(0.0, f64::max)
}
