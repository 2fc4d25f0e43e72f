//! View factors: computes the matrix of the fractions of light that the surfaces of a scene send to
//! each other.
//!
//! ```text
//! scene ─▶ bright faces, their occluders ─▶ exchange areas of all pairs ─▶ F = AF/A by surface
//! ```
//! A one-sided surface sends light from its front, a two-sided one from both sides. Rows are
//! computed independently of each other: the difference between A₁F₁₂ and A₂F₂₁ is a check of both.
//! No surface sends more than all of its light: a row whose sum exceeds 1 by more than its error is
//! an error of the scene ([`ViewFactors::contradictions`]).

use crate::faces::{faces, is_bright, is_round};
use crate::form_factor::{Exchange, exchange_with};
use crate::scene::{Scene, SceneError};
use crate::visibility::{Face, Screens};
use rayon::prelude::*;

/// View factors below this value are computed to the absolute error of a view factor of this value.
const LEAST: f64 = 1e-3;
/// Rounding error of a view factor, relative to the sum of its row.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// Number of surfaces that an error message names, those with the largest view factors.
const NAMED: usize = 8;

/// The view factors of a scene.
#[derive(Clone, Debug)]
pub struct ViewFactors {
    /// The names of the surfaces.
    pub names: Vec<String>,
    /// The area from which each surface sends light, in the square of the scene's unit: twice the
    /// area of its shape where it is two-sided.
    pub areas: Vec<f64>,
    /// For each surface, the fractions of its light that arrive at each surface, with error
    /// estimates.
    pub rows: Vec<Vec<ViewFactor>>,
}

/// A view factor.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ViewFactor {
    /// The fraction of the light of one surface that arrives at the other.
    pub value: f64,
    /// An estimate of its error.
    pub error: f64,
}

/// Computes the view factors between the surfaces of a scene, to its tolerance. For disks and
/// spheres, the errors include the change under one refinement of the tessellation to twice as many
/// edges.
pub fn view_factors(scene: &Scene) -> ViewFactors {
    let working = scene.in_working_units();
    let mut found = with_fineness(&working.scene, 0);
    if is_round(scene) {
        let coarse = std::mem::replace(&mut found, with_fineness(&working.scene, 1));
        for (fine, coarse) in found.rows.iter_mut().flatten().zip(coarse.rows.iter().flatten()) {
            fine.error += (fine.value - coarse.value).abs();
        }
    }
    found.areas.iter_mut().for_each(|area| *area = *area / working.units.factor / working.units.factor);
    found
}

/// Computes the view factors with this tessellation level of disks and spheres.
fn with_fineness(scene: &Scene, fineness: usize) -> ViewFactors {
    let all = faces(scene, fineness);
    let screens = Screens::of(&all);
    let sides: Vec<&Face> = all.iter().filter(|face| is_bright(scene, face)).collect();
    let count = scene.surfaces.len();
    let mut areas = vec![0.0; count];
    sides.iter().for_each(|side| areas[side.surface] += side.area);
    let row = |from: &&Face| {
        let mut row = vec![Exchange::default(); count];
        let tolerances = [scene.solve.tolerance, LEAST * from.area];
        sides
            .iter()
            .for_each(|to| row[to.surface] += exchange_with(from, to, &screens, tolerances, || false));
        row
    };
    let of_sides: Vec<Vec<Exchange>> = sides.par_iter().map(row).collect();
    let mut rows = vec![vec![ViewFactor::default(); count]; count];
    for (side, row) in sides.iter().zip(of_sides) {
        for (factor, Exchange { area, error }) in rows[side.surface].iter_mut().zip(row) {
            factor.value += area / areas[side.surface];
            factor.error += error / areas[side.surface];
        }
    }
    let names = scene.surfaces.iter().map(|surface| surface.name.clone()).collect();
    ViewFactors { names, areas, rows }
}

impl ViewFactors {
    /// Returns the fraction of a surface's light that arrives anywhere: 1 in a closed scene.
    pub fn sum(&self, surface: usize) -> f64 {
        self.rows[surface].iter().map(|factor| factor.value).sum()
    }

    /// Returns the error of the sum of a row: the errors of its view factors, plus rounding.
    pub fn sum_error(&self, surface: usize) -> f64 {
        let row = &self.rows[surface];
        let errors: f64 = row.iter().map(|factor| factor.error).sum();
        errors + ROUNDING * row.len() as f64 * self.sum(surface)
    }

    /// Returns an error for each surface of the scene whose row has a sum above 1 by more than its
    /// error: surfaces to which it sends light overlap.
    pub fn contradictions(&self, scene: &Scene) -> Vec<SceneError> {
        let is_above_one = |&row: &usize| self.sum(row) > 1.0 + self.sum_error(row);
        let error = |row: usize| {
            let message = format!(
                "the view factors of `{}` sum to {:.6}, above 1 by more than the error of \
                 the sum, {:.1e}: {}",
                self.names[row],
                self.sum(row),
                self.sum_error(row),
                self.contributors(row),
            );
            let expected = "surfaces that do not overlap or pass through each other";
            SceneError::new(&scene.surfaces[row].place, message, expected)
        };
        (0..self.names.len()).filter(is_above_one).map(error).collect()
    }

    /// Lists the terms of the sum of a row, the largest first: "0.6 to `a`, 0.5 to `b`".
    fn contributors(&self, row: usize) -> String {
        let factors = self.rows[row].iter().zip(&self.names).map(|(factor, name)| (factor.value, name));
        let mut factors: Vec<(f64, &String)> = factors.filter(|(value, _)| *value > 0.0).collect();
        factors.sort_by(|a, b| b.0.total_cmp(&a.0));
        let others = factors.len().saturating_sub(NAMED);
        let named = factors.iter().take(NAMED).map(|(value, name)| format!("{value:.4} to `{name}`"));
        let mut parts: Vec<String> = named.collect();
        if others > 0 {
            parts.push(format!("the rest to {others} more"));
        }
        parts.join(", ")
    }

    /// Returns the largest |A₁F₁₂ − A₂F₂₁|, relative to the smaller area.
    pub fn reciprocity_residual(&self) -> f64 {
        let mut largest: f64 = 0.0;
        for i in 0..self.rows.len() {
            for j in 0..i {
                let smaller = self.areas[i].min(self.areas[j]);
                let [there, back] =
                    [(i, j), (j, i)].map(|(from, to)| self.areas[from] / smaller * self.rows[from][to].value);
                largest = largest.max((there - back).abs());
            }
        }
        largest
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::read;
    use forms_kernels::{view_factor_coaxial_disks, view_factor_sphere_disk, view_factor_spheres};
    use forms_testing::scene_text::{CUBE, material, polygon, surface};

    fn scene(more: &str) -> Scene {
        let faces = CUBE.map(|(name, corners)| surface(name, "grey", &polygon(&corners)));
        let text = material("grey", 0.5) + &faces.concat() + more;
        read(&text, "cube.toml").unwrap_or_else(|errors| panic!("{}", errors[0]))
    }

    #[test]
    fn the_faces_of_a_cube_send_all_to_each_other_and_the_same_both_ways() {
        let found = view_factors(&scene("[solve]\ntolerance = 1e-13\n"));
        for surface in 0..6 {
            assert!((found.sum(surface) - 1.0).abs() < 1e-12, "{}", found.names[surface]);
            assert_eq!(found.rows[surface][surface], ViewFactor::default());
        }
        // Howell C-11 for opposed unit squares at distance 1
        assert!((found.rows[0][1].value - 0.199_824_895_698_387).abs() < 1e-12);
        assert!(found.reciprocity_residual() < 1e-14);
    }

    #[test]
    fn a_screen_with_two_sides_takes_what_it_hides() {
        let screen = "[[surface]]\nname = \"screen\"\nmaterial = \"grey\"\ntwo_sided = true
            polygon = [[0.25,0.25,0.5], [0.75,0.25,0.5], [0.75,0.75,0.5], [0.25,0.75,0.5]]\n";
        let found = view_factors(&scene(screen));
        assert!((found.areas[6] - 0.5).abs() < 1e-15, "both sides");
        for surface in 0..7 {
            let error: f64 = found.rows[surface].iter().map(|factor| factor.error).sum();
            let residual = (found.sum(surface) - 1.0).abs();
            assert!(
                residual <= error && error < 4e-3,
                "{}: {residual:e}, said {error:e}",
                found.names[surface]
            );
        }
        assert!(found.rows[0][1].value < 0.15, "hidden in part");
        assert!(found.reciprocity_residual() < 1e-3);
    }

    #[test]
    fn what_a_ball_in_a_cube_hides_arrives_at_the_ball() {
        let ball = "[[surface]]\nname = \"ball\"\nmaterial = \"grey\"
            sphere = { center = [0.5,0.5,0.5], radius = 0.3 }\n[solve]\ntolerance = 0.01\n";
        let found = view_factors(&scene(ball));
        for surface in 0..7 {
            let error: f64 = found.rows[surface].iter().map(|factor| factor.error).sum();
            let residual = (found.sum(surface) - 1.0).abs();
            assert!(residual <= error && error < 0.05, "{surface}: {residual:e}, said {error:e}");
        }
        // all light of the ball goes to the cube, a sixth to each face
        let ViewFactor { value, error } = found.rows[6][0];
        let off = (value - 1.0 / 6.0).abs();
        assert!(off <= error && found.rows[6][6].value == 0.0, "off by {off:e}, said {error:e}");
        assert!(found.rows[0][1].value < 0.1, "the ball hides half of the opposite face");
    }

    /// Builds a scene of these surfaces, given as name, shape and sides.
    fn only(surfaces: &[(&str, &str, bool)]) -> Scene {
        let of = |(name, shape, two_sided): &(&str, &str, bool)| {
            surface(name, "grey", &format!("{shape}\ntwo_sided = {two_sided}"))
        };
        let text = material("grey", 0.5) + &surfaces.iter().map(of).collect::<String>();
        read(&text, "round.toml").unwrap_or_else(|errors| panic!("{}", errors[0]))
    }

    #[test]
    fn disks_and_spheres_are_as_in_the_catalogue_within_what_is_said() {
        let disk = |height: f64, up: f64, radius: f64| {
            format!("disk = {{ center = [0.1,0.2,{height:?}], normal = [0,0,{up:?}], radius = {radius:?} }}")
        };
        let ball = |height: f64, radius: f64| {
            format!("sphere = {{ center = [0.1,0.2,{height:?}], radius = {radius:?} }}")
        };
        let cases = [
            (
                "coaxial disks",
                disk(0.0, 1.0, 1.0),
                disk(2.0, -1.0, 0.5),
                view_factor_coaxial_disks(1.0, 0.5, 2.0),
            ),
            (
                "near disks",
                disk(0.0, 1.0, 1.0),
                disk(0.3, -1.0, 1.0),
                view_factor_coaxial_disks(1.0, 1.0, 0.3),
            ),
            ("sphere to disk", ball(0.0, 0.5), disk(1.5, -1.0, 1.0), view_factor_sphere_disk(1.0, 1.5)),
            ("spheres", ball(0.0, 1.0), ball(3.0, 0.5), view_factor_spheres(1.0, 0.5, 3.0)),
        ];
        for (name, from, to, expected) in cases {
            let found = view_factors(&only(&[("from", &from, false), ("to", &to, false)]));
            let ViewFactor { value, error } = found.rows[0][1];
            let off = (value - expected).abs();
            assert!(off <= error, "{name}: off by {off:e}, said {error:e}");
            assert!(error < 0.02 * expected, "{name}: said {error:e} of {expected}");
        }
    }
}
