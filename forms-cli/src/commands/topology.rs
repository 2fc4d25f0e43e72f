//! `forms show --topology`: whether a closed form has a potential, or a cycle that shows that it
//! has none.

use crate::commands::refuse;
use crate::kernel::files;
use crate::status::Status;
use crate::theory_file::complain;
use forms::core::theory::Named;
use forms::core::topology::topology as report_of;
use std::io::{self, Write};

/// Prints the known facts about the potentials of the form with this name.
pub(crate) fn topology(file: &str, name: &str, output: &mut dyn Write) -> io::Result<Status> {
    let files = match files(file) {
        Ok(files) => files,
        Err(errors) => {
            complain(&errors);
            return Ok(Status::Error);
        }
    };
    let declares = |named: Option<&Named>| matches!(named, Some(Named::Object(_)));
    let home = files.iter().find(|file| declares(file.theory.named(name))).or(files.first());
    let Some(home) = home else { return Ok(refuse(&format!("`{name}` is not declared in {file}"))) };
    match report_of(&home.source, name) {
        Ok(report) => {
            write!(output, "{report}")?;
            Ok(Status::AsStated)
        }
        Err(message) => Ok(refuse(&message)),
    }
}
