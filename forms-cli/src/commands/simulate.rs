//! `forms simulate`: prints the plan of a scene, then the answers of its receivers with errors;
//! files contain the answers and the maps.
//!
//! ```text
//! scene ─▶ plan ──▶ table or JSON
//!           └─ simulate (progress: a bar, Ctrl-C; kept: checkpoint, part) ─▶ answers ─┬─▶ table or JSON
//!                                                            parts ─▶ merge ─▶ answers └─▶ files: CSV, EXR, PNG, SVG
//! ```

mod answers;
mod figure;
mod files;
mod instructions;
mod kept;
mod merge;
mod missed;
mod plan;
mod progress;

use super::refuse;
use crate::arguments::ThreadArguments;
use crate::json::write_record;
use crate::layout::seconds;
use crate::palette::Palette;
use crate::status::Status;
use crate::streams::tell;
use forms::math::Instructions;
use forms_radiometry::scene::{Overrides, Scene, SceneError, Sources};
use forms_radiometry::simulation::{self, Budget, Exposure, Identity, Job, Plan, Share, Simulation, State};
use kept::{Checkpoint, Kept, Part, PartOf};
pub(crate) use merge::merge;
use missed::Missed;
use progress::Progress;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Request of the command line.
pub(crate) struct Request<'a> {
    /// File of the scene.
    pub(crate) scene: &'a str,
    /// Output folder, if any; the output file of a share.
    pub(crate) out: Option<&'a str>,
    /// Checkpoint file from which the work resumes, if any, and the interval between writes.
    pub(crate) checkpoint: Option<&'a str>,
    pub(crate) every: Duration,
    /// Share of the work to compute, if not all of it.
    pub(crate) share: Option<Share>,
    /// Number of samples of each number; `None` leaves it to the tolerance.
    pub(crate) budget: Option<Budget>,
    /// Chosen vector instructions, if any.
    pub(crate) instructions: Option<Instructions>,
    /// Exposure time, if exposures are requested.
    pub(crate) exposure: Option<Exposure>,
    /// Values that override the settings of the scene.
    pub(crate) overrides: Overrides,
    /// Number of threads.
    pub(crate) threads: ThreadArguments,
    /// Whether to print one JSON object per line.
    pub(crate) json: bool,
}

/// Options of the output of a simulation.
struct Asked<'a> {
    scene: &'a Scene,
    folder: Option<PathBuf>,
    json: bool,
    /// Whether the work continues until the tolerance is met, instead of for a number of samples.
    is_to_tolerance: bool,
    /// Whether the scene is solved by path tracing.
    is_by_paths: bool,
}

/// Scene with its sources and its plan.
struct Planned {
    scene: Scene,
    sources: Sources,
    plan: Plan,
}

/// Simulates a scene and prints the results.
pub(crate) fn simulate(request: &Request<'_>, output: &mut dyn Write) -> io::Result<Status> {
    let prepared =
        request.instructions.map_or(Ok(()), instructions::choose).and_then(|()| request.threads.make());
    if let Err(message) = prepared {
        return Ok(refuse(&message));
    }
    let planned = match planned(request) {
        Ok(planned) => planned,
        Err(messages) => {
            messages.iter().for_each(|message| tell!("error: {message}"));
            return Ok(Status::Error);
        }
    };
    let mut ready = match ready(request, &planned) {
        Ok(ready) => ready,
        Err(message) => return Ok(refuse(&message)),
    };
    let Planned { scene, plan, .. } = &planned;
    plan::show(plan, scene, request.json, output)?;
    output.flush()?;
    let found = match found(request, &planned, &mut ready) {
        Ok(found) => found,
        Err(message) => return Ok(refuse(&message)),
    };
    let Ready { folder, kept, is_by_paths, .. } = ready;
    let failure = kept.checkpoint.as_ref().and_then(Checkpoint::failure);
    failure.iter().for_each(|message| tell!("error: {message}"));
    let status = match &kept.part {
        Some(part) => shared(request, part, is_by_paths, &found, output)?,
        None => {
            let is_to_tolerance = request.budget.is_none();
            let asked = Asked { scene, folder, json: request.json, is_to_tolerance, is_by_paths };
            finish(&asked, &found, output)?
        }
    };
    Ok(if failure.is_some() { status.max(Status::Error) } else { status })
}

/// Runs the simulation.
fn found(request: &Request<'_>, planned: &Planned, ready: &mut Ready) -> Result<Simulation, String> {
    let share = request.share.unwrap_or(Share::WHOLE);
    let job = Job { budget: request.budget, share, state: ready.state.take(), keeper: Some(&ready.kept) };
    let found = simulation::simulate_job(&planned.plan, job, &ready.progress)
        .map_err(|error| format!("cannot resume from the checkpoint: {error}"));
    ready.progress.end();
    let mut found = found?;
    if let Some(exposure) = request.exposure {
        exposure.add_to(&mut found);
    }
    Ok(found)
}

fn planned(request: &Request<'_>) -> Result<Planned, Vec<String>> {
    let file = request.scene;
    let messages = |errors: Vec<SceneError>| errors.iter().map(SceneError::to_string).collect::<Vec<_>>();
    let (mut scene, sources) = Sources::open(Path::new(file)).map_err(messages)?;
    request.overrides.apply(&mut scene);
    if scene.receivers.is_empty() {
        return Err(vec![nothing_asked(file)]);
    }
    request.exposure.map_or(Ok(()), |exposure| exposure.check(&scene)).map_err(messages)?;
    let plan = simulation::plan(&scene).map_err(messages)?;
    Ok(Planned { scene, sources, plan })
}

/// Resources of a run: output folder, checkpoint and part, initial state, and progress.
struct Ready {
    folder: Option<PathBuf>,
    kept: Kept,
    state: Option<State>,
    is_by_paths: bool,
    progress: Progress,
}

/// Checks, before the work begins, that it can be done as requested, and prepares its resources.
fn ready(request: &Request<'_>, planned: &Planned) -> Result<Ready, String> {
    let (mut kept, mut state) = (Kept::default(), None);
    let is_by_paths = planned.plan.is_by_paths();
    if !is_by_paths {
        solved_as_a_whole(request)?;
    }
    let share = request.share.unwrap_or(Share::WHOLE);
    let identity = || Identity::new(&planned.sources, &planned.plan, request.budget, share);
    if let Some(file) = request.checkpoint {
        let (checkpoint, found) = Checkpoint::open(file, identity(), request.every)?;
        if found.is_some() {
            tell!("note: resuming from `{file}`");
        }
        (kept.checkpoint, state) = (Some(checkpoint), found);
    }
    if let (Some(_), Some(file)) = (request.share, request.out) {
        let belongs_to = PartOf {
            identity: identity(),
            sources: planned.sources.clone(),
            overrides: request.overrides.clone(),
            exposure: request.exposure.map(Exposure::seconds),
            instructions: request.instructions.map(|set| set.name().to_lowercase()),
        };
        kept.part = Some(Part::new(file, belongs_to)?);
    }
    let folder = request.out.filter(|_| request.share.is_none()).map(files::folder).transpose()?;
    Ok(Ready { folder, kept, state, is_by_paths, progress: Progress::watch()? })
}

/// Checks a request for a scene that is solved as a whole: it has no samples and cannot be divided
/// into shares.
fn solved_as_a_whole(request: &Request<'_>) -> Result<(), String> {
    let why = "this scene is solved as a whole, without paths";
    if request.budget.is_some() {
        return Err(format!("{why}, so it has no samples: omit --samples"));
    }
    if let Some(share) = request.share.filter(|share| !share.is_whole()) {
        tell!("note: {why}: all of the work belongs to shard {}, and none to the others", share.first());
    }
    if request.checkpoint.is_some() {
        tell!(
            "note: {why}: the checkpoint is written only at the end; a run that is killed before then starts again"
        );
    }
    Ok(())
}

/// Returns the message for a scene without a receiver, with an example of one.
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

/// Reports the result of a share.
fn shared(
    request: &Request<'_>,
    part: &Part,
    is_by_paths: bool,
    found: &Simulation,
    output: &mut dyn Write,
) -> io::Result<Status> {
    let (share, file) = (request.share.unwrap_or(Share::WHOLE), request.out.unwrap_or_default());
    let [own, all] = match part.written() {
        Some(Ok(units)) => units,
        Some(Err(message)) => return Ok(refuse(&message)),
        None => {
            let rest =
                if request.checkpoint.is_some() { "the same call resumes it" } else { "no state is saved" };
            tell!("stopped: shard {share} is not complete, and `{file}` is not written; {rest}");
            return Ok(Status::Stopped);
        }
    };
    if request.json {
        let record = SharedRecord { share: share.to_string(), part: file, units: own, of: all };
        write_record(output, &record)?;
        return Ok(Status::AsStated);
    }
    let units = if request.budget.is_some() {
        "replicates of numbers, cells and pixels"
    } else {
        "numbers, cells and pixels"
    };
    let what = match (is_by_paths, own) {
        (true, _) => format!("{own} of {all} {units}"),
        (false, 0) => "nothing".to_owned(),
        (false, _) => "all of the work".to_owned(),
    };
    let taken = seconds(found.seconds);
    let line = format!("shard {share}, {what}, in {taken}, written to {file}");
    writeln!(output, "{}", Palette::of_output().quiet(&line))?;
    if is_by_paths && own == 0 {
        let more =
            if request.budget.is_some() { "" } else { "; with --samples each is divided into 32 replicates" };
        tell!("note: there are fewer {units} than shards, and none is left for this one{more}");
    }
    Ok(Status::AsStated)
}

/// JSON record of a completed share.
#[derive(serde::Serialize)]
struct SharedRecord<'a> {
    share: String,
    part: &'a str,
    units: usize,
    of: usize,
}

/// Writes the files, then prints the answers: the reader of the output can go away.
fn finish(asked: &Asked<'_>, found: &Simulation, output: &mut dyn Write) -> io::Result<Status> {
    let Asked { scene, folder, json, is_to_tolerance, is_by_paths } = asked;
    let (written, refused) =
        folder.as_ref().map(|folder| files::write(scene, found, folder)).unwrap_or_default();
    let mut status = if refused.is_empty() { Status::AsStated } else { Status::Error };
    refused.iter().for_each(|message| tell!("error: {message}"));
    if found.stopped {
        tell!("stopped: answers may be missing or less accurate than requested");
        status = Status::Stopped;
    }
    let missed =
        if *is_to_tolerance { Missed::of(found, scene.solve.tolerance) } else { Missed::nothing(found) };
    if *json {
        answers::lines(found, &missed, *is_by_paths, output)?;
    } else {
        answers::table(found, scene.solve.tolerance, *is_by_paths, output)?;
        if let Some(folder) = folder.as_ref().filter(|_| !written.is_empty()) {
            let line = format!("written to {}: {}", folder.display(), written.join(", "));
            writeln!(output, "{}", Palette::of_output().quiet(&line))?;
        }
    }
    let Some(sentence) = missed.sentence().filter(|_| !found.stopped) else { return Ok(status) };
    output.flush()?;
    tell!("missed: {sentence}");
    Ok(status.max(Status::Missed))
}
