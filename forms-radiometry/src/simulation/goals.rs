//! Goals: the readings that are not exact enough say which elements are made finer.

use super::accuracy::relative;
use super::estimate::{Estimate, Found};
use super::solver::Work;
use crate::radiosity::{Asking, Goal, Radiosity};

/// The part that elements may take which are not split though they are expected to change.
const SPARED: f64 = 0.3;

impl Work<'_> {
    /// The readings that are not exact enough, each weighted by how far it is from that.
    pub(super) fn asking(&self, radiosity: &Radiosity, found: &[Found]) -> Asking {
        let sparing = SPARED * self.scene.solve.tolerance;
        let mut asking = Asking { goals: Vec::new(), errors: [0.0; 2], sparing };
        for ((reading, found), scales) in self.readings.iter().zip(found).zip(self.targets(found)) {
            let relative = |(estimate, scale): (&Estimate, &f64)| {
                let error = estimate.error();
                if error.is_finite() { error / scale } else { f64::INFINITY }
            };
            let worst = found.bands.iter().zip(&scales).map(relative).fold(0.0, f64::max);
            let errors = found.bands.iter().map(Estimate::error).filter(|error| error.is_finite());
            // what is nothing so far is relative to what it may be, or to anything
            let scale = [scales.iter().copied().fold(0.0, f64::max), errors.fold(0.0, f64::max)];
            let scale = scale.into_iter().find(|&scale| scale > 0.0).unwrap_or(1.0);
            let weight = if worst.is_finite() { worst / scale } else { 1.0 / scale };
            let weight = weight * reading.of_goal(radiosity.transport());
            let Some(what) = reading.goal(self.scene, radiosity.transport()) else { continue };
            if worst > self.scene.solve.tolerance && weight.is_finite() {
                asking.goals.push(Goal { what, weight });
                asking.errors[0] += worst;
                asking.errors[1] += worst * worst;
            }
        }
        asking
    }

    /// The errors of all readings in all bands, relative to what their tolerances are. Of what was not reached nothing is known.
    pub(super) fn relative_errors(&self, found: &[Found]) -> impl Iterator<Item = f64> {
        let relative = |(estimate, scale): (&Estimate, f64)| relative(estimate.error(), scale);
        let pairs = found.iter().zip(self.targets(found));
        let mut errors: Vec<f64> =
            pairs.flat_map(|(found, scales)| found.bands.iter().zip(scales).map(relative)).collect();
        errors.extend(found.iter().any(Found::is_missing).then_some(f64::INFINITY));
        errors.into_iter()
    }

    pub(super) fn is_enough(&self, found: &[Found]) -> bool {
        self.relative_errors(found).all(|error| error <= self.scene.solve.tolerance)
    }
}
