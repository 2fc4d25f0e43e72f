//! The Cornell box with direct light: prints the irradiance at its named points, and writes its
//! picture to the file given on the command line, or to `cornell_box.png`.

use forms_radiometry::scene::{self, ReceiverKind, SceneError};
use forms_radiometry::{CORNELL_BOX, picture, simulate_direct};
use std::time::Instant;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let all =
        |errors: Vec<SceneError>| errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n\n");
    let scene = scene::read(CORNELL_BOX, "cornell_box.toml").map_err(all)?;
    for result in simulate_direct(&scene).map_err(all)? {
        let total: f64 = result.irradiance.iter().sum();
        let unoccluded: f64 = result.unoccluded.iter().sum();
        println!("{:18} {total:12.8} W/m² of {unoccluded:12.8} W/m² without occlusion", result.receiver);
    }
    let path = std::env::args().nth(1).unwrap_or_else(|| "cornell_box.png".to_owned());
    for receiver in &scene.receivers {
        let ReceiverKind::Camera(camera) = &receiver.kind else { continue };
        let start = Instant::now();
        let picture = picture(&scene, camera).map_err(all)?;
        println!("{path}: direct light only, {:.3} s", start.elapsed().as_secs_f64());
        std::fs::write(&path, picture.png()?)?;
    }
    Ok(())
}
