//! `forms derive`: the steps that decide one statement, in a form that a reader can check.

use crate::arguments::Notation;
use crate::commands::refuse;
use crate::kernel::files;
use crate::status::Status;
use crate::theory_file::complain;
use forms::core::derivation::{Derivation, derive as derivation_of};
use forms_book::{escaped, steps};
use std::io::{self, Write};

/// Prints the derivation of the statement with this name.
pub(crate) fn derive(
    file: &str,
    name: &str,
    notation: Notation,
    output: &mut dyn Write,
) -> io::Result<Status> {
    let files = match files(file) {
        Ok(files) => files,
        Err(errors) => {
            complain(&errors);
            return Ok(Status::Error);
        }
    };
    let Some(derivation) = files.iter().find_map(|file| derivation_of(&file.source, name)) else {
        let names: Vec<&str> =
            files.iter().flat_map(|file| &file.theory.statements).map(|s| s.name.as_str()).collect();
        let known =
            if names.is_empty() { "it has none".into() } else { format!("it has {}", names.join(", ")) };
        return Ok(refuse(&format!("there is no statement named `{name}` in {file}; {known}")));
    };
    match notation {
        Notation::Text => write!(output, "{}", derivation.text())?,
        Notation::Latex => write!(output, "{}", derivation.latex())?,
        Notation::Mathml => match page(&derivation) {
            Ok(page) => write!(output, "{page}")?,
            Err(error) => return Ok(refuse(&format!("`{name}` cannot be written in MathML: {error}"))),
        },
    }
    Ok(if derivation.ok { Status::AsStated } else { Status::NotAsStated })
}

/// Returns a self-contained page for a browser: steps as a list, formulas as MathML.
fn page(derivation: &Derivation) -> Result<String, String> {
    let name = escaped(&derivation.name);
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{name}</title>\n\
         <style>\n{STYLE}</style>\n</head>\n<body>\n<h1>{name}</h1>\n"
    );
    page.push_str(&steps(derivation)?);
    page.push_str("</body>\n</html>\n");
    Ok(page)
}

/// Style sheet: readable in light and dark mode; a formula wider than the page scrolls separately.
const STYLE: &str = "\
:root { color-scheme: light dark; }
body { font: 1.05rem/1.5 system-ui, sans-serif; max-width: 52rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font: 1.4rem/1.3 ui-monospace, monospace; overflow-wrap: anywhere; }
.step { font-size: 1.05rem; font-weight: bold; margin: 1.5rem 0 .25rem; }
ol { padding-left: 1.5rem; }
li::marker { font-weight: bold; }
p { margin: .25rem 0; overflow-wrap: anywhere; }
div { overflow-x: auto; overflow-y: hidden; padding: .15rem 0; }
math { font-size: 1.15rem; }
";
