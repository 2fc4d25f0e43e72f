//! A scene becomes values, and these the error that a bench is about.

use forms_radiometry::scene::{MaterialKind, Scene, read};
use forms_radiometry::simulation::{Simulation, Unwatched, plan, simulate};

/// The band of the Cornell box that is simulated: one number for each reflectance.
const BAND: usize = 8;

/// The scene that a file says.
pub(crate) fn open(text: &str, name: &str) -> Scene {
    read(text, name).unwrap_or_else(|errors| panic!("{}", errors[0]))
}

/// One band of the Cornell box.
pub(crate) fn cornell_box() -> Scene {
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

/// The plan and the simulation.
pub(crate) fn simulated(scene: &Scene) -> Simulation {
    let plan = plan(scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    simulate(scene, &plan, &Unwatched)
}

/// The cells of all maps; where there is no map, the answers.
pub(crate) fn values(simulation: &Simulation) -> Vec<f64> {
    if simulation.maps.is_empty() {
        return simulation.answers.iter().map(|answer| answer.value).collect();
    }
    let cells = simulation.maps.iter().flat_map(|map| &map.values[0]);
    cells.copied().filter(|value| !value.is_nan()).collect()
}

/// The root of the mean square error over the mean.
pub(crate) fn relative_error(found: &[f64], reference: &[f64]) -> f64 {
    assert_eq!(found.len(), reference.len(), "both have the same cells");
    let squares: f64 = found.iter().zip(reference).map(|(a, b)| (a - b).powi(2)).sum();
    (squares * found.len() as f64).sqrt() / reference.iter().sum::<f64>()
}
