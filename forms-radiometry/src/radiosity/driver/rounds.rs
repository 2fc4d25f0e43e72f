//! Rounds of refinement: elements are split where the readings need it, until the readings change
//! no more than the tolerance.
//!
//! ```text
//! elements ─▶ readings ─▶ finer elements ─▶ readings ─▶ …
//! ```

use super::estimate::{Estimate, Found, pool};
use super::goals::Earlier;
use super::precision::{Digits, Value};
use super::readings::Reading;
use super::{ROUNDING, Work};
use crate::answer::{ErrorParts, Moment};
use crate::parallelism::Parallelism;
use crate::progress::{Outlook, foreseen};
use crate::radiosity::{Lights, Radiosity, Scratch, Transport};
use std::time::Instant;

/// Least future change after each refinement, relative to its change, where surfaces may occlude
/// each other. Shadows that fall between the nodes appear when the nodes are closer, and the
/// boundaries of shadows converge no faster than elements shrink.
const BEHIND_SCREENS: [f64; 3] = [10.0, 2.0, 1.0];

impl<'s> Work<'s> {
    /// Returns the solution on elements that are fine enough for all readings, and the readings.
    pub(super) fn refined<'t>(
        &self,
        transport: &'t Transport,
        lights: &'t Lights<'t>,
        history: &mut Vec<Moment>,
    ) -> (Radiosity<'t>, Vec<Found>)
    where
        's: 't,
    {
        let (begin, first) = (self.progress.seconds(), history.len());
        let mut radiosity = Radiosity::new(self.scene, transport, lights, self.question(), self.watch);
        let mut found = self.read(&radiosity, None);
        let mut splits = 0;
        loop {
            let seconds = self.progress.seconds();
            history.push(Moment { seconds, error: self.relative_errors(&found).fold(0.0, f64::max) });
            let until = foreseen(&history[first..], begin, self.scene.solve.tolerance);
            self.progress.begin(until.map_or(Outlook::Unknown, |until| Outlook::Rounds { until }));
            // finer elements do not help where reflected light grows without end
            let grows = radiosity.tail.iter().any(|tail| tail.is_infinite());
            if self.watch.is_stopped() || self.is_enough(&found) || grows {
                return (radiosity, found);
            }
            let (asking, open) = self.asking(&radiosity, &found);
            let Some(mut refined) = radiosity.refine(&asking) else {
                self.settle(&radiosity, &mut found);
                return (radiosity, found);
            };
            if transport.occlusion {
                refined.left = refined.left.max(BEHIND_SCREENS[splits.min(BEHIND_SCREENS.len() - 1)]);
            }
            splits += 1;
            let earlier = Earlier::new(&found, &open, refined);
            let finer = self.read(&radiosity, Some(&earlier));
            if self.watch.is_stopped() {
                return (radiosity, found);
            }
            found = finer;
        }
    }

    /// Removes the errors by elements and of reflections left out from readings that no element
    /// reaches; from all where no light reaches an element.
    fn settle(&self, radiosity: &Radiosity, found: &mut [Found]) {
        let is_unlit = radiosity.is_unlit();
        for (reading, found) in self.readings.iter().zip(found) {
            let goal = reading.goal(self.scene, radiosity.transport());
            let is_reached = goal.is_some_and(|goal| radiosity.reaches(goal));
            // where the work was stopped, it is not known which elements reach the reading
            if (is_unlit || !is_reached) && !self.watch.is_stopped() {
                found.bands.iter_mut().for_each(Estimate::settle_unreached);
            }
        }
    }

    /// Evaluates all readings in all bands; in none where the work was stopped before.
    fn read(&self, radiosity: &Radiosity, earlier: Option<&Earlier>) -> Vec<Found> {
        let is_straight = self.effects.orders == Some(0);
        let digits = Digits::of((self.scene, &self.readings), self.requested, is_straight, radiosity);
        let one = |scratch: &mut Scratch, (index, reading): (usize, &Reading)| {
            let begin = Instant::now();
            let found = (!self.watch.is_stopped())
                .then(|| digits.value((reading, index >= self.requested), self.scene, radiosity, scratch))
                .filter(|_| !self.watch.is_stopped());
            let Some(Value { bands, rounding, has_pieces }) = found else {
                return (Found { bands: Vec::new(), has_pieces: true }, begin.elapsed().as_secs_f64());
            };
            let largest = reading.largest(radiosity.transport());
            let doubts = reading.doubts(self.scene, radiosity, scratch);
            // a ray that meets no surface, or a dark one
            let is_known = reading.goal(self.scene, radiosity.transport()).is_none();
            let of_band = |(band, value): (usize, f64)| {
                let straight = reading.straight_error(radiosity, band);
                let [of_rules, of_rounding] = straight.unwrap_or_default();
                let quadrature = of_rules + doubts[band];
                let rounding = rounding.get(band).copied().unwrap_or(0.0) + of_rounding;
                let integral = ErrorParts { quadrature, rounding, ..ErrorParts::default() };
                if is_known || (self.effects.orders == Some(0) && straight.is_some()) {
                    return Estimate::exact(value, integral);
                }
                let before = earlier.map(|earlier| earlier.of(index, band));
                let orders = largest * radiosity.floor(band);
                Estimate::new(value, before, ErrorParts { orders, ..integral })
            };
            let bands = bands.into_iter().enumerate().map(of_band).collect();
            (Found { bands, has_pieces }, begin.elapsed().as_secs_f64())
        };
        let parallelism = Parallelism::of(radiosity.operations(self.readings.len()));
        let readings: Vec<(usize, &Reading)> = self.readings.iter().enumerate().collect();
        let begin = Instant::now();
        let (mut found, seconds): (Vec<Found>, Vec<f64>) = parallelism.map(readings, one).into_iter().unzip();
        self.times.add(begin, self.readings.iter().map(|reading| reading.receiver).zip(seconds));
        let scales = self.scales(&found);
        pool(&mut found, &scales, &self.groups);
        let spared = earlier.map_or(0.0, |earlier| earlier.refined.spared);
        for (found, scales) in found.iter_mut().zip(scales) {
            for (estimate, scale) in found.bands.iter_mut().zip(scales) {
                if estimate.is_exact() {
                    continue;
                }
                estimate.floor.quadrature += (radiosity.rules() + spared) * scale;
                estimate.floor.rounding += ROUNDING * scale;
            }
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::effects::SimulatedEffects;
    use crate::progress::Progress;
    use crate::radiosity::FirstFaces;
    use crate::radiosity::kept::Kept;
    use crate::radiosity::solution::Reflection;
    use crate::watch::Unwatched;

    #[test]
    fn kept_elements_receive_what_new_ones_would() {
        for (name, more) in [
            ("lamp", ""),
            (
                "sun",
                "[[light]]\nname = \"sun\"\nkind = \"distant\"\ndirection = [0.3, 0.2, -1]\nirradiance = 2\n",
            ),
        ] {
            let text = [crate::CORNELL_BOX, "[solve]\ntolerance = 0.3\n", more].concat();
            let scene =
                crate::scene::read(&text, "test.toml").unwrap_or_else(|errors| panic!("{}", errors[0]));
            let plan = crate::simulation::plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
            let (first, progress) = (FirstFaces::default(), Progress::new(&Unwatched));
            let work = Work::new(&scene, SimulatedEffects::of(plan.effects()), &first, &progress);
            let transport = work.transport(0);
            let lights = Lights::of(&scene, &transport);
            let mut radiosity = Radiosity::new(&scene, &transport, &lights, work.question(), &Unwatched);
            for round in 0..2 {
                let found = work.read(&radiosity, None);
                let (asking, _) = work.asking(&radiosity, &found);
                assert!(radiosity.refine(&asking).is_some(), "{name}, round {round}");
            }
            let operator = |radiosity: &Radiosity| {
                radiosity.reflection.as_ref().map(|Reflection { operator, .. }| operator.clone())
            };
            let kept = (operator(&radiosity), radiosity.direct.clone(), radiosity.beams.clone());
            assert!(radiosity.solve(&Kept::nothing(radiosity.elements.len())));
            assert!(
                kept == (operator(&radiosity), radiosity.direct.clone(), radiosity.beams.clone()),
                "{name}"
            );
        }
    }
}
