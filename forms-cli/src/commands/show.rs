//! `forms show`: prints one named object, simplified, in the requested notation.

use crate::arguments::Notation;
use crate::commands::refuse;
use crate::kernel::files;
use crate::status::Status;
use crate::theory_file::complain;
use forms::core::notation::{latex_of_named, text_of_named};
use forms_book::display;
use std::io::{self, Write};

/// Prints the object with this name.
pub(crate) fn show(file: &str, name: &str, notation: Notation, output: &mut dyn Write) -> io::Result<Status> {
    let mut files = match files(file) {
        Ok(files) => files,
        Err(errors) => {
            complain(&errors);
            return Ok(Status::Error);
        }
    };
    let of_name = if notation == Notation::Text { text_of_named } else { latex_of_named };
    let shown = files.iter_mut().find_map(|file| of_name(&mut file.theory, name));
    let Some(shown) = shown else {
        return Ok(refuse(&format!("`{name}` is neither declared nor a statement in {file}")));
    };
    if notation != Notation::Mathml {
        writeln!(output, "{shown}")?;
        return Ok(Status::AsStated);
    }
    match display(&shown) {
        Ok(mathml) => {
            writeln!(output, "{mathml}")?;
            Ok(Status::AsStated)
        }
        Err(error) => Ok(refuse(&format!("`{name}` cannot be written in MathML: {error}"))),
    }
}
