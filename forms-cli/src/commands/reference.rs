//! `forms man` and `forms completions`: manual pages and shell completions, generated from the
//! command line.

use crate::arguments::Arguments;
use crate::commands::refuse;
use crate::files::reason;
use crate::status::Status;
use clap::{Command, CommandFactory};
use clap_complete::{Shell, generate};
use clap_mangen::{Man, generate_to};
use std::io::{self, Write};

/// Prints a manual page, or writes all of them into a folder.
pub(crate) fn man(command: Option<&str>, out: Option<&str>, output: &mut dyn Write) -> io::Result<Status> {
    let mut program = Arguments::command();
    if let Some(folder) = out {
        let written = std::fs::create_dir_all(folder).and_then(|()| generate_to(program, folder));
        return Ok(match written {
            Ok(()) => Status::AsStated,
            Err(error) => refuse(&format!("cannot write the manual to {folder}: {}", reason(&error))),
        });
    }
    program.build();
    let Some(command) = command else { return print(program, output) };
    match program.find_subcommand(command).cloned() {
        Some(found) => print(found, output),
        None => Ok(refuse(&format!("there is no command named `{command}`; `forms --help` lists them"))),
    }
}

fn print(command: Command, mut output: &mut dyn Write) -> io::Result<Status> {
    Man::new(command).render(&mut output)?;
    Ok(Status::AsStated)
}

/// Prints the completion script of a shell.
pub(crate) fn completions(shell: Shell, mut output: &mut dyn Write) -> io::Result<Status> {
    generate(shell, &mut Arguments::command(), "forms", &mut output);
    Ok(Status::AsStated)
}
