//! Simulates a scene: the plan lists its effects with the reason for each, and each answer has an
//! error.
//!
//! ```text
//! scene in TOML ─▶ plan: effects that are on, effects that are off, why ─▶ answers with errors
//! ```
//! `cargo run --release --example room`, or with the path of a scene after `--`.

use forms_radiometry::scene::{Scene, SceneError, open, read};
use forms_radiometry::simulation::{Unwatched, plan, simulate};
use std::path::Path;

const ROOM: &str = r#"
[[material]]
name = "grey"
kind = "diffuse"
reflectance = 0.5

[[surface]]
name = "floor"
material = "grey"
polygon = [[0, 0, 0], [3, 0, 0], [3, 2, 0], [0, 2, 0]]

[[surface]]
name = "wall"
material = "grey"
polygon = [[0, 0, 0], [0, 2, 0], [0, 2, 2], [0, 0, 2]]

[[surface]]
name = "lamp"
material = "grey"
polygon = [[1, 0.5, 2], [1, 1.5, 2], [2, 1.5, 2], [2, 0.5, 2]]
radiance = 10

[[receiver]]
name = "desk"
kind = "point"
position = [1, 1, 0.7]
normal = [0, 0, 1]

[[receiver]]
name = "floor"
kind = "surface"
surface = "floor"
"#;

fn scene() -> Result<Scene, Vec<SceneError>> {
    match std::env::args().nth(1) {
        Some(path) => open(Path::new(&path)),
        None => read(ROOM, "the text of this program"),
    }
}

/// Simulates the scene and prints the answers.
fn show() -> Result<(), Vec<SceneError>> {
    let scene = scene()?;
    let plan = plan(&scene)?;
    for effect in plan.effects() {
        println!("{:4}{:16}{}", if effect.on { "on" } else { "off" }, effect.effect.name(), effect.why);
    }
    let found = simulate(&plan, &Unwatched);
    for answer in &found.answers {
        let (quantity, unit) = (answer.quantity.name(), answer.unit());
        println!("{}, {quantity}: {:.5} ± {:.0e} {unit}", answer.receiver, answer.value, answer.error);
    }
    Ok(())
}

fn main() -> std::process::ExitCode {
    match show() {
        Ok(()) => std::process::ExitCode::SUCCESS,
        Err(errors) => {
            errors.iter().for_each(|error| eprintln!("error: {error}"));
            std::process::ExitCode::FAILURE
        }
    }
}
