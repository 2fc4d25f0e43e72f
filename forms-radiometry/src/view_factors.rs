//! View factors: the surfaces of a scene become the matrix of the fractions of light that they send to each other.
//!
//! ```text
//! scene ─▶ sides of polygons ─ each with the luminaires it makes ─▶ exchange areas of all pairs ─▶ F = AF/A by surfaces
//! ```
//! A surface sends from its front, and a two-sided one from both sides. Rows are computed independently of each other: how far
//! A₁F₁₂ is from A₂F₂₁ is a check of both.

use crate::geometry::{Exchange, Luminaire, Polygon, exchange_with, resolution};
use crate::scene::{Scene, SceneError, Shape, Surface};
use rayon::prelude::*;

/// View factors below this are computed to the absolute error of one of this size.
const LEAST: f64 = 1e-3;

/// The view factors of a scene.
#[derive(Clone, Debug)]
pub struct ViewFactors {
    /// The names of the surfaces.
    pub names: Vec<String>,
    /// The area that each surface sends from: twice that of its shape where it is two-sided.
    pub areas: Vec<f64>,
    /// For each surface the fractions that arrive at each, with the estimates of their errors.
    pub rows: Vec<Vec<ViewFactor>>,
}

/// A view factor.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ViewFactor {
    /// The fraction of what one surface sends that arrives at the other.
    pub value: f64,
    /// An estimate of its error.
    pub error: f64,
}

/// One side of a polygon.
struct Side {
    surface: usize,
    polygon: Polygon,
    is_back: bool,
}

/// The view factors between the surfaces of a scene, to its tolerance.
///
/// # Errors
/// Where a surface is neither a polygon nor a mesh.
pub fn view_factors(scene: &Scene) -> Result<ViewFactors, Vec<SceneError>> {
    let sides = sides(scene)?;
    let polygons = || {
        let fronts = sides.iter().filter(|side| !side.is_back);
        fronts.map(|side| &side.polygon)
    };
    let resolution = resolution(polygons());
    let luminaires: Vec<Vec<Luminaire>> =
        sides.par_iter().map(|side| Luminaire::of(&side.polygon, true, polygons(), resolution)).collect();
    let count = scene.surfaces.len();
    let mut areas = vec![0.0; count];
    sides.iter().for_each(|side| areas[side.surface] += side.polygon.area());
    let row = |from: &Side| {
        let mut row = vec![Exchange::default(); count];
        let least = LEAST * from.polygon.area();
        for (to, luminaires) in sides.iter().zip(&luminaires) {
            let Exchange { area, error } =
                exchange_with(&from.polygon, &to.polygon, luminaires, [scene.solve.tolerance, least]);
            row[to.surface].area += area;
            row[to.surface].error += error;
        }
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
    Ok(ViewFactors { names, areas, rows })
}

impl ViewFactors {
    /// What arrives anywhere of what a surface sends: 1 in a closed scene.
    pub fn sum(&self, surface: usize) -> f64 {
        self.rows[surface].iter().map(|factor| factor.value).sum()
    }

    /// The largest |A₁F₁₂ − A₂F₂₁|, relative to the smaller area.
    pub fn reciprocity_residual(&self) -> f64 {
        let mut largest: f64 = 0.0;
        for i in 0..self.rows.len() {
            for j in 0..i {
                let [there, back] =
                    [(i, j), (j, i)].map(|(from, to)| self.areas[from] * self.rows[from][to].value);
                largest = largest.max((there - back).abs() / self.areas[i].min(self.areas[j]));
            }
        }
        largest
    }
}

fn sides(scene: &Scene) -> Result<Vec<Side>, Vec<SceneError>> {
    let (mut sides, mut errors) = (Vec::new(), Vec::new());
    for (index, surface) in scene.surfaces.iter().enumerate() {
        match polygons(surface) {
            Ok(polygons) => {
                for polygon in polygons {
                    if surface.two_sided {
                        sides.push(Side { surface: index, polygon: polygon.reversed(), is_back: true });
                    }
                    sides.push(Side { surface: index, polygon, is_back: false });
                }
            }
            Err(error) => errors.push(error),
        }
    }
    if errors.is_empty() { Ok(sides) } else { Err(errors) }
}

fn polygons(surface: &Surface) -> Result<Vec<Polygon>, SceneError> {
    let shape = match &surface.shape {
        Shape::Polygon(polygon) => return Ok(vec![polygon.clone()]),
        Shape::Mesh(mesh) => return Ok(mesh.polygons().collect()),
        Shape::Sphere(_) => "a sphere",
        Shape::Disk(_) => "a disk",
    };
    let message = format!("view factors of the surface `{}`, {shape}, are not computed yet", surface.name);
    Err(SceneError::new(&surface.place, message, "a polygon or a mesh"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::read;

    const CUBE: [(&str, &str); 6] = [
        ("floor", "[[0,0,0], [1,0,0], [1,1,0], [0,1,0]]"),
        ("ceiling", "[[0,0,1], [0,1,1], [1,1,1], [1,0,1]]"),
        ("left", "[[0,0,0], [0,1,0], [0,1,1], [0,0,1]]"),
        ("right", "[[1,0,0], [1,0,1], [1,1,1], [1,1,0]]"),
        ("front", "[[0,0,0], [0,0,1], [1,0,1], [1,0,0]]"),
        ("back", "[[0,1,0], [1,1,0], [1,1,1], [0,1,1]]"),
    ];

    fn scene(more: &str) -> Scene {
        let mut text = "[[material]]\nname = \"grey\"\nkind = \"diffuse\"\nreflectance = 0.5\n".to_string();
        for (name, polygon) in CUBE {
            text += &format!("[[surface]]\nname = \"{name}\"\nmaterial = \"grey\"\npolygon = {polygon}\n");
        }
        read(&(text + more), "cube.toml").unwrap_or_else(|errors| panic!("{}", errors[0]))
    }

    #[test]
    fn the_faces_of_a_cube_send_all_to_each_other_and_the_same_both_ways() {
        let found = view_factors(&scene("[solve]\ntolerance = 1e-13\n")).expect("polygons");
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
        let found = view_factors(&scene(screen)).expect("polygons");
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
    fn a_sphere_is_refused_at_its_place() {
        let sphere = "[[surface]]\nname = \"ball\"\nmaterial = \"grey\"\nsphere = { center = [0.5,0.5,0.5], radius = 0.1 }\n";
        let errors = view_factors(&scene(sphere)).expect_err("a sphere");
        assert!(
            errors[0]
                .to_string()
                .contains("view factors of the surface `ball`, a sphere, are not computed yet")
        );
    }
}
