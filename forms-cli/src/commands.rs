//! The commands, one file each.

mod accuracy;
mod book;
mod check;
mod derive;
mod emit;
mod eval;
mod evaluation;
mod exact;
mod kernels;
mod prove;
mod reference;
mod rounded;
mod serve;
mod show;
mod simulate;
mod topology;
mod tour;
mod view_factors;
mod work;

use crate::arguments::{Arguments, Command};
use crate::status::Status;
use crate::streams::tell;
use forms_radiometry::scene::Scene;
use std::io::{self, Read, Write};

/// Runs the command of the command line.
pub(crate) fn run(arguments: &Arguments, output: &mut dyn Write) -> io::Result<Status> {
    run_with_input(arguments, io::stdin(), output)
}

/// Runs the command of the command line, with rows to evaluate from the given input.
pub(crate) fn run_with_input(
    arguments: &Arguments,
    input: impl Read,
    output: &mut dyn Write,
) -> io::Result<Status> {
    match &arguments.command {
        None => tour::tour(output),
        Some(Command::Prove { files, json, certificate, budget }) => {
            prove::prove(files, *json, (certificate.as_deref(), *budget), output)
        }
        Some(Command::Check { file, allow_uncovered }) => check::check(file, *allow_uncovered, output),
        Some(Command::Show { file, name, topology: true, .. }) => topology::topology(file, name, output),
        Some(Command::Show { file, name, notation, .. }) => show::show(file, name, *notation, output),
        Some(Command::Derive { file, name, notation }) => derive::derive(file, name, *notation, output),
        Some(Command::Eval { file, kernel, precision, tier }) => {
            eval::eval((file, kernel), precision, *tier, input, output)
        }
        Some(Command::Emit { file, kernel, target, precision, prefix, tier }) => {
            let language = (target.as_str(), precision.as_deref());
            let kernel = kernel.as_deref();
            emit::emit(&emit::Request { file, kernel, language, prefix, tier: *tier }, output)
        }
        Some(Command::Accuracy { file, kernel, json, write, pages, samples, no_times }) => {
            let request = accuracy::Request {
                file,
                kernel: kernel.as_deref(),
                json: *json,
                write: *write,
                pages: pages.as_deref(),
                samples: *samples,
                times: !no_times,
            };
            accuracy::accuracy(&request, output)
        }
        Some(Command::Simulate(arguments)) => simulate::simulate(arguments, output),
        Some(Command::Merge { parts, out, vtu, threads, json }) => match threads.make() {
            Ok(()) => simulate::merge(parts, (out.as_deref(), *vtu), *json, output),
            Err(message) => Ok(refuse(&message)),
        },
        Some(Command::ViewFactors(arguments)) => view_factors::view_factors(arguments, output),
        Some(Command::Kernels) => kernels::kernels(output),
        Some(Command::Book { preprocess: true, question, .. }) => book::preprocess(question, output),
        Some(Command::Book { out, .. }) => book::book(out, output),
        Some(Command::Man { command, out }) => reference::man(command.as_deref(), out.as_deref(), output),
        Some(Command::Completions { shell }) => reference::completions(*shell, output),
        Some(Command::Serve { file, bind, port, time_limit }) => {
            serve::serve(file.as_deref(), (*bind, *port), *time_limit, output)
        }
        Some(Command::Work { task, seconds, mebibytes }) => work::work(*task, (*seconds, *mebibytes), output),
    }
}

/// Prints to standard error which parts of a scene are read in another way than they are written.
fn show_notes(scene: &Scene) {
    scene.notes.iter().for_each(|note| tell!("note: {note}"));
}

/// Prints to standard error why a call cannot be carried out.
fn refuse(message: &str) -> Status {
    tell!("error: {message}");
    Status::Error
}
