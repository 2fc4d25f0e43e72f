//! `forms merge`: combines the parts of a simulation into the results of a single run, if all parts
//! are present and belong to the same work.
//!
//! ```text
//! PART… ─▶ read ─▶ of one work? ─▶ each share once? ─▶ states of all shares ─▶ answers, as of one run
//! ```

use super::kept::{LARGEST_STATE, PartOf};
use super::{OutputOptions, finish, plan};
use crate::commands::refuse;
use crate::files::reason;
use crate::status::Status;
use crate::streams::tell;
use forms_radiometry::scene::{Scene, SceneError, read_file};
use forms_radiometry::simulation::{self, Share, Simulation, State, StateFile};
use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::Path;

/// Part that was read.
struct Part<'a> {
    file: &'a str,
    belongs_to: PartOf,
    state: State,
}

/// Combines parts and prints the results.
pub(crate) fn merge(
    files: &[String],
    (out, vtu): (Option<&str>, bool),
    json: bool,
    output: &mut dyn Write,
) -> io::Result<Status> {
    let (parts, mut messages) = read(files);
    let Some(first) = parts.first() else {
        messages.iter().for_each(|message| tell!("error: {message}"));
        return Ok(Status::Error);
    };
    messages.extend(strangers(&parts));
    if messages.is_empty() {
        let (repeated, notes) = repetitions(&parts);
        notes.iter().for_each(|note| tell!("note: {note}"));
        messages = repeated;
    }
    messages.extend(missing(first, &parts));
    if !messages.is_empty() {
        messages.iter().for_each(|message| tell!("error: {message}"));
        return Ok(Status::Error);
    }
    let folder = match out.map(super::files::folder).transpose() {
        Ok(folder) => folder,
        Err(message) => return Ok(refuse(&message)),
    };
    let is_to_tolerance = first.belongs_to.identity.budget().is_none();
    match merged(parts) {
        Ok((scene, planned, found)) => {
            plan::show(&planned, &scene, json, output)?;
            let is_by_paths = planned.is_by_paths();
            finish(
                &OutputOptions {
                    scene: &scene,
                    folder,
                    vtu,
                    json,
                    is_to_tolerance,
                    is_by_paths,
                    ran_out_of_time: false,
                },
                &found,
                output,
            )
        }
        Err(messages) => {
            messages.iter().for_each(|message| tell!("error: {message}"));
            Ok(Status::Error)
        }
    }
}

/// Reads the parts; returns those that can be read, and messages about the others.
fn read(files: &[String]) -> (Vec<Part<'_>>, Vec<String>) {
    let (mut parts, mut messages) = (Vec::new(), Vec::new());
    for file in files {
        let bytes = match read_file(Path::new(file), LARGEST_STATE) {
            Ok(bytes) => bytes,
            Err(error) => {
                messages.push(format!("the part `{file}` cannot be read: {}", reason(&error)));
                continue;
            }
        };
        match StateFile::Part.read::<PartOf>(&bytes) {
            Ok((belongs_to, state)) => parts.push(Part { file, belongs_to, state }),
            Err(error) => messages
                .push(format!("the part `{file}` {error}; create it again with `forms simulate --shard`")),
        }
    }
    (parts, messages)
}

/// Returns messages about parts that do not belong to the work of the first part.
fn strangers(parts: &[Part<'_>]) -> Vec<String> {
    let first = &parts[0];
    let message = |part: &Part<'_>| {
        let [ours, theirs] = [first, part].map(|part| &part.belongs_to);
        let (share, of) = (theirs.identity.share(), ours.identity.share().count());
        let difference = if share.count() != of {
            Some(format!("it is shard {share}, and the other is shard {}", ours.identity.share()))
        } else if ours.exposure != theirs.exposure {
            Some("it has another exposure time".to_owned())
        } else {
            ours.identity.with_share(share).difference(&theirs.identity)
        };
        difference.map(|difference| {
            format!("the part `{}` does not match `{}`: {difference}", part.file, first.file)
        })
    };
    parts.iter().filter_map(message).collect()
}

/// Returns errors about shares that occur twice with different results, and notes about shares that
/// occur twice with the same results.
fn repetitions(parts: &[Part<'_>]) -> (Vec<String>, Vec<String>) {
    let mut seen: BTreeMap<Share, &Part<'_>> = BTreeMap::new();
    let (mut messages, mut notes) = (Vec::new(), Vec::new());
    for part in parts {
        let share = part.belongs_to.identity.share();
        let Some(other) = seen.insert(share, part) else { continue };
        let names = format!("`{}` and `{}` are both shard {share}", other.file, part.file);
        if other.state.is_same_as(&part.state) {
            notes.push(format!("{names} and identical: one of them is used"));
        } else {
            messages.push(format!(
                "{names} but differ, although the same run on the same kind of machine gives identical parts; \
                 create both again"
            ));
        }
    }
    (messages, notes)
}

/// Returns messages about missing shares, with the calls that create them.
fn missing(first: &Part<'_>, parts: &[Part<'_>]) -> Vec<String> {
    let PartOf { identity, sources, overrides, exposure, instructions } = &first.belongs_to;
    let has = |share: &Share| parts.iter().any(|part| part.belongs_to.identity.share() == *share);
    let message = |share: Share| {
        let mut call = format!("forms simulate {} --shard {share}{}", sources.name(), overrides.options());
        if let Some(budget) = identity.budget() {
            call += &format!(" --samples {}", budget.samples());
        }
        if let Some(seconds) = exposure {
            call += &format!(" --exposure {seconds}");
        }
        if let Some(name) = instructions {
            call += &format!(" --isa {name}");
        }
        format!("shard {share} is missing: create it with\n  {call} --out PART")
    };
    identity.share().all().filter(|share| !has(share)).map(message).collect()
}

type Merged = (Scene, simulation::Plan, Simulation);

/// Combines all shares.
fn merged(parts: Vec<Part<'_>>) -> Result<Merged, Vec<String>> {
    let messages = |errors: Vec<SceneError>| errors.iter().map(SceneError::to_string).collect::<Vec<_>>();
    let PartOf { identity, sources, overrides, .. } = &parts[0].belongs_to;
    let (budget, exposure) = (identity.budget(), parts[0].belongs_to.exposure());
    let mut scene = sources.read().map_err(messages)?;
    overrides.apply(&mut scene);
    let plan = simulation::plan(&scene).map_err(messages)?;
    let states: BTreeMap<Share, State> =
        parts.into_iter().map(|part| (part.belongs_to.identity.share(), part.state)).collect();
    let mut found = simulation::merge(&plan, budget, states.into_iter().collect())
        .map_err(|error| vec![format!("the parts cannot be combined: {error}")])?;
    if let Some(exposure) = exposure {
        exposure.add_to(&mut found);
    }
    Ok((scene, plan, found))
}
