//! `forms simulate`: prints the plan of a scene, then the answers of its receivers with errors;
//! files contain the answers and the maps.
//!
//! ```text
//! scene ─▶ plan ──▶ table or JSON
//!           └─ simulate (progress: a bar, Ctrl-C; kept: checkpoint, part) ─▶ answers ─┬─▶ table or JSON
//!                                                            parts ─▶ merge ─▶ answers └─▶ files: CSV, EXR, PNG, SVG, VTU
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

use super::{refuse, show_notes};
use crate::arguments::SimulateArguments;
use crate::json::write_record;
use crate::layout::seconds;
use crate::palette::Palette;
use crate::status::Status;
use crate::streams::tell;
use forms_radiometry::scene::{Scene, SceneError, Sources, open};
use forms_radiometry::simulation::{self, Exposure, Identity, Job, Plan, Share, Simulation, State};
use kept::{Checkpoint, Kept, Part, PartOf};
pub(crate) use merge::merge;
use missed::Missed;
pub(super) use progress::Progress;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Options of the output of a simulation.
struct OutputOptions<'a> {
    scene: &'a Scene,
    folder: Option<PathBuf>,
    /// Whether files of VTK are written, too.
    vtu: bool,
    json: bool,
    /// Whether the work continues until the tolerance is met, instead of for a number of samples.
    is_to_tolerance: bool,
    /// Whether the scene is solved by path tracing.
    is_by_paths: bool,
    /// Whether the time of the run was over before its work was done.
    ran_out_of_time: bool,
}

/// Scene with its plan.
struct Planned {
    scene: Scene,
    /// The input files, if the run is to be identified or finished elsewhere.
    sources: Option<Sources>,
    plan: Plan,
}

/// Simulates a scene and prints the results.
pub(crate) fn simulate(arguments: &SimulateArguments, output: &mut dyn Write) -> io::Result<Status> {
    let deadline = arguments.time.deadline();
    let prepared = arguments.isa.map_or(Ok(()), instructions::choose).and_then(|()| arguments.threads.make());
    if let Err(message) = prepared {
        return Ok(refuse(&message));
    }
    let planned = match planned(arguments) {
        Ok(planned) => planned,
        Err(messages) => {
            messages.iter().for_each(|message| tell!("error: {message}"));
            return Ok(Status::Error);
        }
    };
    let mut ready = match ready(arguments, &planned, deadline) {
        Ok(ready) => ready,
        Err(message) => return Ok(refuse(&message)),
    };
    let Planned { scene, plan, .. } = &planned;
    plan::show(plan, scene, arguments.json, output)?;
    output.flush()?;
    let found = match found(arguments, &planned, &mut ready) {
        Ok(found) => found,
        Err(message) => return Ok(refuse(&message)),
    };
    let Ready { folder, kept, is_by_paths, progress, .. } = ready;
    let failure = kept.checkpoint.as_ref().and_then(Checkpoint::failure);
    failure.iter().for_each(|message| tell!("error: {message}"));
    let status = match &kept.part {
        Some(part) => shared(arguments, part, is_by_paths, &found, output)?,
        None => {
            let is_to_tolerance = arguments.samples.is_none();
            let ran_out_of_time = progress.ran_out_of_time();
            let (vtu, json) = (arguments.vtu, arguments.json);
            let options =
                OutputOptions { scene, folder, vtu, json, is_to_tolerance, is_by_paths, ran_out_of_time };
            finish(&options, &found, output)?
        }
    };
    Ok(if failure.is_some() { status.max(Status::Error) } else { status })
}

/// Runs the simulation.
fn found(arguments: &SimulateArguments, planned: &Planned, ready: &mut Ready) -> Result<Simulation, String> {
    let share = arguments.shard.unwrap_or(Share::WHOLE);
    let job = Job { budget: arguments.samples, share, state: ready.state.take(), keeper: Some(&ready.kept) };
    let found = simulation::simulate_job(&planned.plan, job, &ready.progress)
        .map_err(|error| format!("cannot resume from the checkpoint: {error}"));
    ready.progress.end();
    let mut found = found?;
    if let Some(exposure) = arguments.exposure {
        exposure.add_to(&mut found);
    }
    Ok(found)
}

fn planned(arguments: &SimulateArguments) -> Result<Planned, Vec<String>> {
    let file = &arguments.scene;
    let messages = |errors: Vec<SceneError>| errors.iter().map(SceneError::to_string).collect::<Vec<_>>();
    let is_kept = arguments.checkpoint.is_some() || arguments.shard.is_some();
    let (mut scene, sources) = match is_kept {
        true => Sources::open(Path::new(file)).map(|(scene, sources)| (scene, Some(sources))),
        false => open(Path::new(file)).map(|scene| (scene, None)),
    }
    .map_err(messages)?;
    show_notes(&scene);
    arguments.solve.overrides().apply(&mut scene);
    if scene.receivers.is_empty() {
        return Err(vec![nothing_asked(file)]);
    }
    arguments.exposure.map_or(Ok(()), |exposure| exposure.check(&scene)).map_err(messages)?;
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
fn ready(
    arguments: &SimulateArguments,
    planned: &Planned,
    deadline: Option<Instant>,
) -> Result<Ready, String> {
    let (mut kept, mut state) = (Kept::default(), None);
    let is_by_paths = planned.plan.is_by_paths();
    if !is_by_paths {
        solved_as_a_whole(arguments)?;
    }
    let share = arguments.shard.unwrap_or(Share::WHOLE);
    let identity = |sources| Identity::new(sources, &planned.plan, arguments.samples, share);
    if let (Some(file), Some(sources)) = (&arguments.checkpoint, &planned.sources) {
        let (checkpoint, found) = Checkpoint::open(file, identity(sources), arguments.every)?;
        if found.is_some() {
            tell!("note: resuming from `{file}`");
        }
        (kept.checkpoint, state) = (Some(checkpoint), found);
    }
    if let (Some(_), Some(file), Some(sources)) = (arguments.shard, &arguments.out, &planned.sources) {
        let belongs_to = PartOf {
            identity: identity(sources),
            sources: sources.clone(),
            overrides: arguments.solve.overrides(),
            exposure: arguments.exposure.map(Exposure::seconds),
            instructions: arguments.isa.map(|set| set.name().to_lowercase()),
        };
        kept.part = Some(Part::new(file, belongs_to)?);
    }
    let folder =
        arguments.out.as_deref().filter(|_| arguments.shard.is_none()).map(files::folder).transpose()?;
    Ok(Ready { folder, kept, state, is_by_paths, progress: Progress::watch(deadline)? })
}

/// Checks a request for a scene that is solved as a whole: it has no samples and cannot be divided
/// into shares.
fn solved_as_a_whole(arguments: &SimulateArguments) -> Result<(), String> {
    let why = "this scene is solved as a whole, without paths";
    if arguments.samples.is_some() {
        return Err(format!("{why}, so it has no samples: omit --samples"));
    }
    if let Some(share) = arguments.shard.filter(|share| !share.is_whole()) {
        tell!("note: {why}: all of the work belongs to shard {}, and none to the others", share.first());
    }
    if arguments.checkpoint.is_some() {
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
    arguments: &SimulateArguments,
    part: &Part,
    is_by_paths: bool,
    found: &Simulation,
    output: &mut dyn Write,
) -> io::Result<Status> {
    let (share, file) =
        (arguments.shard.unwrap_or(Share::WHOLE), arguments.out.as_deref().unwrap_or_default());
    let [own, all] = match part.written() {
        Some(Ok(units)) => units,
        Some(Err(message)) => return Ok(refuse(&message)),
        None => {
            let rest =
                if arguments.checkpoint.is_some() { "the same call resumes it" } else { "no state is saved" };
            tell!("stopped: shard {share} is not complete, and `{file}` is not written; {rest}");
            return Ok(Status::Stopped);
        }
    };
    if arguments.json {
        let record = SharedRecord { share: share.to_string(), part: file, units: own, of: all };
        write_record(output, &record)?;
        return Ok(Status::AsStated);
    }
    let units = if arguments.samples.is_some() {
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
        let more = if arguments.samples.is_some() {
            ""
        } else {
            "; with --samples each is divided into 32 replicates"
        };
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
fn finish(options: &OutputOptions<'_>, found: &Simulation, output: &mut dyn Write) -> io::Result<Status> {
    let OutputOptions { scene, folder, vtu, json, is_to_tolerance, is_by_paths, ran_out_of_time } = options;
    let (written, refused) =
        folder.as_ref().map(|folder| files::write(scene, found, (folder, *vtu))).unwrap_or_default();
    let mut status = if refused.is_empty() { Status::AsStated } else { Status::Error };
    refused.iter().for_each(|message| tell!("error: {message}"));
    let is_late = found.stopped && *ran_out_of_time;
    if is_late {
        tell!("the time is over: answers may be missing or less accurate than requested");
        status = status.max(Status::Missed);
    } else if found.stopped {
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
    let Some(sentence) = missed.sentence().filter(|_| is_late || !found.stopped) else { return Ok(status) };
    output.flush()?;
    tell!("missed: {sentence}");
    Ok(status.max(Status::Missed))
}
