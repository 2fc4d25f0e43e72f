//! The Cornell box with direct light: numbers at its named points, and its picture.

use super::heading;
use crate::commands::refuse;
use crate::layout::{duration, wrap};
use crate::palette::Palette;
use crate::status::Status;
use crate::streams::tell;
use forms_radiometry::scene::{self, ReceiverKind, SceneError};
use forms_radiometry::{CORNELL_BOX, Picture, ReceiverResult, picture, simulate_direct};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;
use std::time::Instant;

/// Output folder of pictures, below the current directory.
const FOLDER: &str = "forms-output";
/// File name of the picture.
const PICTURE: &str = "cornell_box.png";

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
    let Lit { points: results, picture } = match lit() {
        Ok(lit) => lit,
        Err(errors) => {
            errors.iter().for_each(|error| tell!("error: {error}"));
            return Ok(Status::Error);
        }
    };
    points(&results, palette, output)?;
    let Some((picture, time)) = picture else { return Ok(Status::AsStated) };
    let time = duration(time);
    let written = picture.png().map_err(io::Error::other).and_then(|png| write(&png));
    match written {
        Ok(path) => {
            let size = format!("{} × {} pixels in {time}", picture.width(), picture.height());
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
    /// Answers at its points.
    points: Vec<ReceiverResult>,
    /// Picture of its camera, with the run time.
    picture: Option<(Picture, Duration)>,
}

fn lit() -> Result<Lit, Vec<SceneError>> {
    let scene = scene::read(CORNELL_BOX, "cornell_box.toml")?;
    let points = simulate_direct(&scene)?;
    let camera = scene.receivers.iter().find_map(|receiver| match &receiver.kind {
        ReceiverKind::Camera(camera) => Some(camera),
        _ => None,
    });
    let start = Instant::now();
    let picture = camera.map(|camera| picture(&scene, camera)).transpose()?;
    Ok(Lit { points, picture: picture.map(|picture| (picture, start.elapsed())) })
}

/// Prints the irradiance, summed over the bands, and the fraction of the lamp's light that reaches
/// the point.
fn points(results: &[ReceiverResult], palette: Palette, output: &mut dyn Write) -> io::Result<()> {
    let title = format!("  {:30} {:>16} {:>12}", "", "irradiance", "unshadowed");
    writeln!(output, "{}", palette.quiet(&title))?;
    for result in results {
        let [total, open]: [f64; 2] =
            [&result.irradiance, &result.unoccluded].map(|bands| bands.iter().sum());
        let share = if open > 0.0 { format!("{:.1} %", 100.0 * total / open) } else { "–".to_string() };
        writeln!(output, "  {:30} {total:>10.6} W/m² {share:>12}", result.receiver)?;
    }
    writeln!(output)
}

fn write(png: &[u8]) -> io::Result<PathBuf> {
    std::fs::create_dir_all(FOLDER)?;
    let path = Path::new(FOLDER).join(PICTURE);
    std::fs::write(&path, png)?;
    Ok(path)
}
