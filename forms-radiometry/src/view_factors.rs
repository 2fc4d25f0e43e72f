//! View factors: computes the matrix of the fractions of light that the surfaces of a scene send to
//! each other, row by row.
//!
//! ```text
//!          ┌─ closed_forms: spheres and flat shapes that nothing hides ────┐
//! scene ───┼─ pairs: exchange areas of all pairs of faces, each pair once ─┤ the cheapest one
//!          └─ rays: the fractions of rays that arrive at each surface ─────┴─▶ F by row
//! ```
//! A one-sided surface sends light from its front, a two-sided one from both sides. The cost of
//! pairs is that of the faces and their occluders, and depends little on the tolerance. The cost of
//! rays is that of the tolerance, and hardly depends on the number of faces. Both are predicted for
//! each row. No surface sends more than all of its light: a row whose sum exceeds 1 by more than its
//! error is an error of the scene ([`ViewFactors::contradictions`]).

mod closed_forms;
mod coaxial;
mod emitters;
mod enclosure;
mod flat_shapes;
mod pairs;
mod rays;

use crate::answer::ErrorKind;
use crate::faces::is_round;
use crate::scene::{Scene, SceneError, WorkingUnits};
use crate::watch::{Unwatched, Watch};
use closed_forms::ClosedForms;
use emitters::Emitters;
pub use enclosure::{Enclosed, NotEnclosed};
use pairs::Pairs;
use rays::Rays;
use std::ops::Index;
use std::sync::{Arc, OnceLock};

/// View factors below this value are computed to the absolute error of a view factor of this value.
const LEAST: f64 = 1e-3;
/// Rounding error of a view factor, relative to the sum of its row.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// Number of surfaces that an error message names, those with the largest view factors.
const NAMED: usize = 8;
/// Number of standard errors by which a sum of sampled view factors may exceed 1.
const DEVIATIONS: f64 = 5.0;
/// How often a row that sums to more than 1 is computed again, and the factor of its tolerance.
const AGAIN: usize = 3;
const FINER: f64 = 0.1;
/// Number of rays beyond which the row of a scene with disks or spheres is found by pairs of flat
/// faces, whatever their error.
const MOST_RAYS: f64 = 1e10;

/// The view factors of a scene.
#[derive(Clone, Debug)]
pub struct ViewFactors {
    /// The names of the surfaces.
    pub names: Vec<String>,
    /// The area from which each surface sends light, in the square of the scene's unit: twice the
    /// area of its shape where it is two-sided.
    pub areas: Vec<f64>,
    /// For each surface, the fractions of its light that arrive at each surface.
    pub rows: Vec<Row>,
}

/// A view factor.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ViewFactor {
    /// The fraction of the light of one surface that arrives at the other.
    pub value: f64,
    /// Its error, of the kind of its row.
    pub error: f64,
}

/// The view factors of one surface to all surfaces.
#[derive(Clone, Debug)]
pub struct Row {
    /// A view factor for each surface.
    pub factors: Vec<ViewFactor>,
    /// The kind of their errors: bounds of closed forms, estimates of pairs of faces, or standard
    /// errors of rays.
    pub kind: ErrorKind,
}

/// A matrix of view factors whose rows are computed one after the other.
pub struct Rows {
    names: Vec<String>,
    units: WorkingUnits,
    scene: Arc<Scene>,
    pairs: Pairs,
    /// If there are disks or spheres.
    round: Option<RoundScene>,
    emitters: OnceLock<Emitters>,
}

/// What only scenes with disks or spheres need: flat faces have closed forms in pairs.
struct RoundScene {
    closed_forms: ClosedForms,
    /// Pairs of the faces of coarser polyhedra.
    coarse: Pairs,
}

/// Goal of a row: the error of each view factor, relative to the largest of the view factor itself,
/// the mean of the surfaces that are seen, and [`least`].
#[derive(Clone, Copy, Debug)]
struct Goal {
    tolerance: f64,
}

/// Returns the view factor to whose absolute error all smaller ones are computed, among this number
/// of surfaces.
fn least(surfaces: usize) -> f64 {
    LEAST.min(1.0 / surfaces as f64)
}

impl Goal {
    /// Returns by how much the errors exceed the goal; at most 1 where it is met.
    fn excess(self, factors: &[ViewFactor]) -> f64 {
        let seen = factors.iter().filter(|factor| factor.value > 0.0).count().max(1);
        let sum: f64 = factors.iter().map(|factor| factor.value).sum();
        let least = least(factors.len()).max(sum / seen as f64);
        let relative = factors.iter().map(|factor| factor.error / factor.value.max(least));
        relative.fold(0.0, f64::max) / self.tolerance
    }
}

impl Rows {
    /// Prepares the view factors between the surfaces of a scene, to its tolerance.
    pub fn of(scene: &Scene) -> Self {
        let names = scene.surfaces.iter().map(|surface| surface.name.clone()).collect();
        let (scene, units) = scene.clone().into_working_units();
        let scene = Arc::new(scene);
        let is_round = is_round(&scene);
        let pairs = Pairs::of(&scene, usize::from(is_round));
        let round = is_round.then(|| RoundScene {
            closed_forms: ClosedForms::of(Arc::clone(&scene)),
            coarse: Pairs::of(&scene, 0),
        });
        Self { names, units, scene, pairs, round, emitters: OnceLock::new() }
    }

    /// Returns the names of the surfaces: one for each row and each column.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Returns the area from which a surface sends light, in the square of the scene's unit.
    pub fn area(&self, surface: usize) -> f64 {
        let area = match self.round {
            Some(_) => self.emitters().area(surface),
            None => self.pairs.area(surface),
        };
        area / self.units.factor / self.units.factor
    }

    fn emitters(&self) -> &Emitters {
        self.emitters.get_or_init(|| Emitters::of(&self.scene))
    }

    /// Returns the row of a surface: by pairs of faces or by rays, whichever is expected to cost
    /// less. `None` if the work is stopped before the row meets its tolerance.
    pub fn row(&mut self, surface: usize, watch: &dyn Watch) -> Option<Row> {
        let tolerance = self.scene.solve.tolerance;
        let goal = Goal { tolerance };
        let known = match &self.round {
            Some(round) => round.closed_forms.known(surface),
            None => vec![None; self.names.len()],
        };
        if let Some(row) = ClosedForms::row(&known) {
            return Some(row);
        }
        let known = known.into_iter().map(|known| known.map(|(factor, _)| factor)).collect();
        let cost = self.pairs.expected_cost(surface, tolerance);
        let row = if self.round.is_none() && cost <= Rays::fewest(tolerance) {
            self.of_flat(surface, watch)
        } else {
            let mut rays = Rays::pilot(self.emitters(), surface, known, self.scene.solve.seed);
            let most = if self.round.is_some() { MOST_RAYS } else { cost };
            if rays.need_at_most(most, goal) {
                rays.reach(goal, watch);
                rays.row()
            } else {
                self.by_pairs(surface, watch)
            }
        };
        (!watch.is_stopped()).then_some(row)
    }

    /// Returns the row of a scene of flat faces by pairs. Estimates of errors can be too small: a row
    /// that sums to more than it can is computed again to lower tolerances before it counts as an
    /// error of the scene.
    fn of_flat(&mut self, surface: usize, watch: &dyn Watch) -> Row {
        let mut tolerance = self.scene.solve.tolerance;
        let mut row = self.pairs.row(surface, tolerance, watch);
        for _ in 0..AGAIN {
            if row.excess().is_none() || watch.is_stopped() {
                break;
            }
            tolerance *= FINER;
            row = self.pairs.row_again(surface, tolerance, watch);
        }
        row
    }

    /// Returns the row by pairs of faces. For disks and spheres, the errors include the change from
    /// polyhedra with half as many edges.
    fn by_pairs(&mut self, surface: usize, watch: &dyn Watch) -> Row {
        let tolerance = self.scene.solve.tolerance;
        let Some(round) = &mut self.round else { return self.of_flat(surface, watch) };
        let mut row = self.pairs.row(surface, tolerance, watch);
        let coarse = round.coarse.row(surface, tolerance, watch);
        for (fine, coarse) in row.factors.iter_mut().zip(&coarse.factors) {
            fine.error += (fine.value - coarse.value).abs();
        }
        row
    }
}

impl Row {
    /// Whether the errors meet a tolerance, relative to each view factor or to the mean of the
    /// surfaces that are seen; view factors below 10⁻³ count as 10⁻³.
    pub fn meets(&self, tolerance: f64) -> bool {
        Goal { tolerance }.excess(&self.factors) <= 1.0
    }

    /// Returns the fraction of the surface's light that arrives anywhere: 1 in a closed scene.
    pub fn sum(&self) -> f64 {
        self.factors.iter().map(|factor| factor.value).sum()
    }

    /// Returns the error of the sum: the errors of its view factors, plus rounding.
    pub fn sum_error(&self) -> f64 {
        let errors: f64 = self.factors.iter().map(|factor| factor.error).sum();
        errors + ROUNDING * self.factors.len() as f64 * self.sum()
    }

    /// Returns an error of the scene if this row of a surface has a sum above 1 by more than its
    /// error: surfaces to which it sends light overlap.
    pub fn contradiction(&self, scene: &Scene, surface: usize) -> Option<SceneError> {
        let error = self.excess()?;
        let message = format!(
            "the view factors of `{}` sum to {:.6}, above 1 by more than the error of \
             the sum, {error:.1e}: {}",
            scene.surfaces[surface].name,
            self.sum(),
            self.contributors(scene),
        );
        let expected = "surfaces that do not overlap or pass through each other";
        Some(SceneError::new(&scene.surfaces[surface].place, message, expected))
    }

    /// Returns the error of the sum if it exceeds 1 by more than that.
    fn excess(&self) -> Option<f64> {
        let error = match self.kind {
            ErrorKind::Sigma => DEVIATIONS * self.sum_error(),
            ErrorKind::Bound | ErrorKind::Estimate => self.sum_error(),
        };
        (self.sum() > 1.0 + error).then_some(error)
    }

    /// Lists the terms of the sum, the largest first: "0.6 to `a`, 0.5 to `b`".
    fn contributors(&self, scene: &Scene) -> String {
        let factors = self.factors.iter().zip(&scene.surfaces);
        let mut factors: Vec<(f64, &String)> = factors
            .map(|(factor, surface)| (factor.value, &surface.name))
            .filter(|(value, _)| *value > 0.0)
            .collect();
        factors.sort_by(|a, b| b.0.total_cmp(&a.0));
        let others = factors.len().saturating_sub(NAMED);
        let named = factors.iter().take(NAMED).map(|(value, name)| format!("{value:.4} to `{name}`"));
        let mut parts: Vec<String> = named.collect();
        if others > 0 {
            parts.push(format!("the rest to {others} more"));
        }
        parts.join(", ")
    }
}

impl Index<usize> for Row {
    type Output = ViewFactor;

    /// Returns the view factor to a surface.
    fn index(&self, surface: usize) -> &ViewFactor {
        &self.factors[surface]
    }
}

impl<'r> IntoIterator for &'r Row {
    type Item = &'r ViewFactor;
    type IntoIter = std::slice::Iter<'r, ViewFactor>;

    fn into_iter(self) -> Self::IntoIter {
        self.factors.iter()
    }
}

/// Computes the view factors between the surfaces of a scene, to its tolerance.
pub fn view_factors(scene: &Scene) -> ViewFactors {
    let mut rows = Rows::of(scene);
    let count = rows.names.len();
    let areas = (0..count).map(|surface| rows.area(surface)).collect();
    let row = |surface| rows.row(surface, &Unwatched).expect("nobody stops the work");
    let of_rows = (0..count).map(row).collect();
    ViewFactors { names: rows.names, areas, rows: of_rows }
}

impl ViewFactors {
    /// Returns the fraction of a surface's light that arrives anywhere: 1 in a closed scene.
    pub fn sum(&self, surface: usize) -> f64 {
        self.rows[surface].sum()
    }

    /// Returns the error of that sum.
    pub fn sum_error(&self, surface: usize) -> f64 {
        self.rows[surface].sum_error()
    }

    /// Returns an error for each surface of the scene whose row has a sum above 1 by more than its
    /// error.
    pub fn contradictions(&self, scene: &Scene) -> Vec<SceneError> {
        let rows = self.rows.iter().enumerate();
        rows.filter_map(|(surface, row)| row.contradiction(scene, surface)).collect()
    }

    /// Returns the largest |A₁F₁₂ − A₂F₂₁|, relative to the smaller area.
    pub fn reciprocity_residual(&self) -> f64 {
        let mut largest: f64 = 0.0;
        for i in 0..self.rows.len() {
            for j in 0..i {
                let smaller = self.areas[i].min(self.areas[j]);
                let [there, back] = [(i, j), (j, i)]
                    .map(|(from, to)| self.areas[from] / smaller * self.rows[from].factors[to].value);
                largest = largest.max((there - back).abs());
            }
        }
        largest
    }
}

#[cfg(test)]
mod tests;
