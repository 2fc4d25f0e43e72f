//! `forms simulate`: a scene's plan is printed, then what its receivers get, with errors; files hold the same and maps.
//!
//! ```text
//! scene ─▶ plan ──▶ table or JSON
//!           └─ simulate (progress: a bar, Ctrl-C) ─▶ answers ─┬─▶ table or JSON
//!                                                             └─▶ files: CSV, EXR, PNG, SVG
//! ```

mod answers;
mod digits;
mod figure;
mod files;
mod plan;
mod progress;

use super::refuse;
use crate::palette::Palette;
use crate::status::Status;
use forms_radiometry::scene::{self, Scene, SceneError};
use forms_radiometry::simulation::{self, Exposure, Plan, Simulation};
use progress::Progress;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// What is asked for.
pub(crate) struct Request<'a> {
    /// The file of the scene.
    pub(crate) scene: &'a str,
    /// Where files are written, if anywhere.
    pub(crate) out: Option<&'a str>,
    /// The time of which exposures are added, if any are.
    pub(crate) exposure: Option<Exposure>,
    /// One JSON object a line.
    pub(crate) json: bool,
}

/// What was found, and how long it took.
struct Work {
    found: Simulation,
    time: Duration,
}

/// Simulates a scene and shows what was found.
pub(crate) fn simulate(request: &Request<'_>, output: &mut dyn Write) -> io::Result<Status> {
    let (scene, plan) = match planned(request) {
        Ok(planned) => planned,
        Err(messages) => {
            messages.iter().for_each(|message| eprintln!("error: {message}"));
            return Ok(Status::Error);
        }
    };
    let ready = request.out.map(files::folder).transpose();
    let (folder, progress) = match ready.and_then(|folder| Ok((folder, Progress::watch()?))) {
        Ok(ready) => ready,
        Err(message) => return Ok(refuse(&message)),
    };
    if request.json { plan::lines(&plan, output) } else { plan::table(&plan, &scene, output) }?;
    output.flush()?;
    let start = Instant::now();
    let mut found = simulation::simulate(&scene, &plan, &progress);
    if let Some(exposure) = request.exposure {
        exposure.add_to(&mut found);
    }
    let work = Work { found, time: start.elapsed() };
    progress.end();
    finish(request, &scene, &work, folder, output)
}

fn planned(request: &Request<'_>) -> Result<(Scene, Plan), Vec<String>> {
    let file = request.scene;
    let messages = |errors: Vec<SceneError>| errors.iter().map(SceneError::to_string).collect::<Vec<_>>();
    let scene = scene::open(Path::new(file)).map_err(messages)?;
    if scene.receivers.is_empty() {
        return Err(vec![nothing_asked(file)]);
    }
    request.exposure.map_or(Ok(()), |exposure| exposure.check(&scene)).map_err(messages)?;
    let plan = simulation::plan(&scene).map_err(messages)?;
    Ok((scene, plan))
}

/// What to add to a scene that has no receiver.
fn nothing_asked(file: &str) -> String {
    let add = if file.to_lowercase().ends_with(".xml") {
        "add a sensor, for example\n  <shape type=\"rectangle\"><sensor type=\"irradiancemeter\">\
         <film type=\"hdrfilm\"><integer name=\"width\" value=\"1\"/><integer name=\"height\" value=\"1\"/></film>\
         </sensor></shape>"
    } else {
        "add a receiver, for example\n  [[receiver]]\n  name = \"here\"\n  kind = \"point\"\n  \
         position = [0, 0, 0]\n  normal = [0, 0, 1]"
    };
    format!("{file}: the scene has no receiver, so there is nothing to simulate: {add}")
}

/// Writes the files first: whoever reads the output may go away.
fn finish(
    request: &Request<'_>,
    scene: &Scene,
    Work { found, time }: &Work,
    folder: Option<PathBuf>,
    output: &mut dyn Write,
) -> io::Result<Status> {
    let (written, refused) =
        folder.as_ref().map(|folder| files::write(scene, found, folder)).unwrap_or_default();
    let mut status = if refused.is_empty() { Status::AsStated } else { Status::Error };
    refused.iter().for_each(|message| eprintln!("error: {message}"));
    if found.stopped {
        eprintln!("stopped: answers may be missing, or be less exact than was asked for");
        status = Status::Stopped;
    }
    if request.json {
        answers::lines(&found.answers, output)?;
    } else {
        answers::table(found, *time, scene.solve.tolerance, output)?;
        if let Some(folder) = folder.filter(|_| !written.is_empty()) {
            let line = format!("written to {}: {}", folder.display(), written.join(", "));
            writeln!(output, "{}", Palette::of_output().quiet(&line))?;
        }
    }
    Ok(status)
}
