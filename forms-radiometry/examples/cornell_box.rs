//! The Cornell box with direct light: prints the irradiance at its named points, and writes its
//! picture to the file given on the command line, or to `cornell_box.png`.

use forms_radiometry::CORNELL_BOX;
use forms_radiometry::output::photograph;
use forms_radiometry::scene::{self, Overrides, ReceiverKind, Scene, SceneError};
use forms_radiometry::simulation::{Simulation, Unwatched, plan, simulate};
use std::time::Instant;

type Problem = Box<dyn std::error::Error>;

fn main() -> Result<(), Problem> {
    let scene = scene::read(CORNELL_BOX, "cornell_box.toml").map_err(joined)?;
    let mut points = scene.clone();
    points.receivers.retain(|receiver| matches!(receiver.kind, ReceiverKind::Point { .. }));
    let (_, found) = simulated(&points, "interreflection=off,bands=on")?;
    let (_, open) = simulated(&points, "interreflection=off,bands=on,occlusion=off")?;
    for receiver in &points.receivers {
        let [total, unoccluded] = [&found, &open].map(|simulation| total(simulation, &receiver.name));
        println!("{:18} {total:12.8} W/m² of {unoccluded:12.8} W/m² without occlusion", receiver.name);
    }
    let path = std::env::args().nth(1).unwrap_or_else(|| "cornell_box.png".to_owned());
    let mut view = scene;
    view.receivers.retain(|receiver| matches!(receiver.kind, ReceiverKind::Camera(_)));
    let start = Instant::now();
    let (view, found) = simulated(&view, "interreflection=off,bands=on")?;
    println!("{path}: direct light only, {:.3} s", start.elapsed().as_secs_f64());
    for image in &found.maps {
        std::fs::write(&path, photograph(image, &view)?)?;
    }
    Ok(())
}

/// Simulates a scene with these effects forced.
fn simulated(scene: &Scene, effects: &str) -> Result<(Scene, Simulation), Problem> {
    let mut scene = scene.clone();
    Overrides { effects: Some(effects.parse()?), ..Overrides::default() }.apply(&mut scene);
    let plan = plan(&scene).map_err(joined)?;
    let found = simulate(&plan, &Unwatched);
    Ok((scene, found))
}

/// Returns the irradiance of a receiver, summed over the bands.
fn total(simulation: &Simulation, receiver: &str) -> f64 {
    simulation.answers.iter().filter(|answer| answer.receiver == receiver).map(|answer| answer.value).sum()
}

fn joined(errors: Vec<SceneError>) -> String {
    errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n\n")
}
