//! Runs a scene, and computes the values and the errors that the bench compares.

use forms_radiometry::scene::{MaterialKind, Scene, read};
use forms_radiometry::simulation::{Simulation, Unwatched, plan, simulate};

/// Band of the Cornell box that is simulated: one number for each reflectance.
const BAND: usize = 8;

/// Reads the scene of a file.
pub fn open(text: &str, name: &str) -> Scene {
    read(text, name).unwrap_or_else(|errors| panic!("{}", errors[0]))
}

/// Returns one band of the Cornell box.
pub fn cornell_box() -> Scene {
    let mut scene = open(forms_radiometry::CORNELL_BOX, "cornell_box.toml");
    let only = |values: &mut Vec<f64>| *values = vec![values[BAND]];
    scene.bands = Vec::new();
    for material in &mut scene.materials {
        if let MaterialKind::Diffuse { reflectance } = &mut material.kind {
            only(reflectance);
        }
    }
    scene.surfaces.iter_mut().for_each(|surface| only(&mut surface.radiance));
    only(&mut scene.ambient.radiance);
    scene
}

/// Plans and simulates a scene.
pub fn simulated(scene: &Scene) -> Simulation {
    let plan = plan(scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    simulate(&plan, &Unwatched)
}

/// Returns the cells of all maps, or the answers if there is no map.
pub fn values(simulation: &Simulation) -> Vec<f64> {
    if simulation.maps.is_empty() {
        return simulation.answers.iter().map(|answer| answer.value).collect();
    }
    let cells = simulation.maps.iter().flat_map(|map| &map.values[0]);
    cells.copied().filter(|value| !value.is_nan()).collect()
}

/// Returns the root-mean-square error divided by the mean.
pub fn relative_error(found: &[f64], reference: &[f64]) -> f64 {
    assert_eq!(found.len(), reference.len(), "both have the same cells");
    let squares: f64 = found.iter().zip(reference).map(|(a, b)| (a - b).powi(2)).sum();
    (squares * found.len() as f64).sqrt() / reference.iter().sum::<f64>()
}
