//! The Cornell box with direct light: numbers at its named points, and its picture.

use super::heading;
use crate::commands::refuse;
use crate::layout::{duration, wrap};
use crate::palette::Palette;
use crate::status::Status;
use crate::streams::tell;
use forms_radiometry::CORNELL_BOX;
use forms_radiometry::output::photograph;
use forms_radiometry::scene::{
    self, Effect, Force, ForcedEffect, Place, Receiver, ReceiverKind, Scene, SceneError,
};
use forms_radiometry::simulation::{Answer, Map, Unwatched, plan, simulate};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Output folder of pictures, below the current directory.
const FOLDER: &str = "forms-output";
/// File name of the picture.
const PICTURE: &str = "cornell_box.png";
/// Tolerance of the pixels of the picture: about one step of its eight bits.
const TOLERANCE: f64 = 1e-2;

/// Computes the direct light of the scene, prints the irradiance at its points and writes its
/// picture.
pub(super) fn light(palette: Palette, output: &mut dyn Write) -> io::Result<Status> {
    heading(3, "The Cornell box, lit", palette, output)?;
    let about =
        "Direct light of the lamp in closed form, with exact shadows; interreflection is not included.";
    for line in wrap(about, 2) {
        writeln!(output, "{line}")?;
    }
    writeln!(output)?;
    let Lit { points: irradiances, scene, image, time } = match lit() {
        Ok(lit) => lit,
        Err(errors) => {
            errors.iter().for_each(|error| tell!("error: {error}"));
            return Ok(Status::Error);
        }
    };
    points(&irradiances, palette, output)?;
    let Some(image) = image else { return Ok(Status::AsStated) };
    match photograph(&image, &scene).and_then(|png| write(&png)) {
        Ok(path) => {
            let [width, height] = image.size;
            let size = format!("{width} × {height} pixels in {}", duration(time));
            writeln!(output, "  {}  {}\n", path.display(), palette.quiet(&size))?;
            Ok(Status::AsStated)
        }
        Err(error) => {
            let path = Path::new(FOLDER).join(PICTURE);
            Ok(refuse(&format!("cannot write the picture {}: {error}", path.display())))
        }
    }
}

/// Results of the scene with direct light.
struct Lit {
    /// Irradiance at its points.
    points: Vec<Irradiance>,
    /// Scene of the image.
    scene: Scene,
    /// Image of its camera.
    image: Option<Map>,
    /// Run time of the image.
    time: Duration,
}

/// Irradiance at a point, summed over the bands, in W/m².
struct Irradiance {
    receiver: String,
    total: f64,
    /// Irradiance without occlusion of the lamp.
    unoccluded: f64,
}

fn lit() -> Result<Lit, Vec<SceneError>> {
    let scene = scene::read(CORNELL_BOX, "cornell_box.toml")?;
    let is_point = |receiver: &Receiver| matches!(receiver.kind, ReceiverKind::Point { .. });
    let is_camera = |receiver: &Receiver| matches!(receiver.kind, ReceiverKind::Camera(_));
    let [occluded, unoccluded] =
        [Force::On, Force::Off].map(|occlusion| totals(&with_receivers(&scene, is_point, occlusion)));
    let points = occluded?.into_iter().zip(unoccluded?);
    let points =
        points.map(|((receiver, total), (_, unoccluded))| Irradiance { receiver, total, unoccluded });
    let mut scene = with_receivers(&scene, is_camera, Force::On);
    scene.solve.tolerance = TOLERANCE;
    let start = Instant::now();
    let image = simulate(&plan(&scene)?, &Unwatched).maps.pop();
    Ok(Lit { points: points.collect(), scene, image, time: start.elapsed() })
}

/// Returns the scene with some of its receivers, in direct light.
fn with_receivers(scene: &Scene, is_kept: fn(&Receiver) -> bool, occlusion: Force) -> Scene {
    let mut scene = scene.clone();
    scene.receivers.retain(is_kept);
    let forced =
        [(Effect::Bands, Force::On), (Effect::Occlusion, occlusion), (Effect::Interreflection, Force::Off)];
    let of_effect = |(effect, force)| ForcedEffect { effect, force, place: Place::default() };
    scene.solve.forced = forced.map(of_effect).into();
    scene
}

/// Returns the irradiance of every receiver, summed over the bands.
fn totals(scene: &Scene) -> Result<Vec<(String, f64)>, Vec<SceneError>> {
    let answers = simulate(&plan(scene)?, &Unwatched).answers;
    let of_receiver = answers.chunk_by(|a, b| a.receiver == b.receiver);
    let total = |bands: &[Answer]| bands.iter().map(|answer| answer.value).sum();
    Ok(of_receiver.map(|bands| (bands[0].receiver.clone(), total(bands))).collect())
}

/// Prints the irradiance, and the fraction of the lamp's light that reaches the point.
fn points(irradiances: &[Irradiance], palette: Palette, output: &mut dyn Write) -> io::Result<()> {
    let title = format!("  {:30} {:>16} {:>12}", "", "irradiance", "unshadowed");
    writeln!(output, "{}", palette.quiet(&title))?;
    for Irradiance { receiver, total, unoccluded } in irradiances {
        let share = if *unoccluded > 0.0 {
            format!("{:.1} %", 100.0 * total / unoccluded)
        } else {
            "–".to_string()
        };
        writeln!(output, "  {receiver:30} {total:>10.6} W/m² {share:>12}")?;
    }
    writeln!(output)
}

fn write(png: &[u8]) -> io::Result<PathBuf> {
    std::fs::create_dir_all(FOLDER)?;
    let path = Path::new(FOLDER).join(PICTURE);
    std::fs::write(&path, png)?;
    Ok(path)
}
