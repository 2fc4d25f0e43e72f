//! Choice of forms: better forms are searched, proved, and written to a file next to the input.

use crate::commands::refuse;
use crate::files::replace;
use crate::kernel::LIBRARY;
use crate::palette::Palette;
use crate::status::Status;
use crate::theory_file::{choices_beside, complain, from_text, text};
use forms::core::stability::{Budget, Found, search, written};
use std::fs::File;
use std::io::{self, Write};
use std::time::SystemTime;

/// Searches the best form of every kernel in a file that does not specify its own form.
pub(super) fn choose(path: &str, output: &mut dyn Write) -> io::Result<Status> {
    if path == LIBRARY {
        return Ok(refuse("--write needs a FILE: the forms are written to a file next to it"));
    }
    let source = match text(path) {
        Ok(source) => source,
        Err(message) => return Ok(refuse(&format!("{message} ({path})"))),
    };
    let mut file = match from_text(path, source) {
        Ok(file) => file,
        Err(errors) => {
            complain(&errors);
            return Ok(Status::Error);
        }
    };
    let palette = Palette::of_output();
    let kernels = file.theory.kernels.clone();
    let mut choices: Vec<(usize, Found)> = Vec::new();
    for (place, kernel) in kernels.iter().enumerate() {
        let name = &kernel.name;
        if kernel.has_form() {
            writeln!(output, "{name}: {}", palette.quiet("skipped, since it has its own `by` or `within`"))?;
            continue;
        }
        let Some(found) = search(&mut file.theory.pool, kernel, Budget::default()) else {
            writeln!(output, "{name}: {}", palette.notable("no arguments with a certain value were found"))?;
            continue;
        };
        let (form, promise) = found.chosen();
        let change = format!("{:.2} -> {:.2} bits lost", found.written.loss, form.loss);
        let promise = promise
            .map_or(String::new(), |units| format!("; `within {units}`, with more precision where needed"));
        writeln!(output, "{name}: {change}, cost {} -> {}{promise}", found.written.cost, form.cost)?;
        choices.push((place, found));
    }
    let pairs: Vec<_> = choices.iter().map(|(place, found)| (&kernels[*place], found)).collect();
    let beside = choices_beside(path);
    let told = match written(&file.theory.pool, &pairs) {
        Some(text) => {
            let is_first = !beside.exists();
            replace(&beside, |output| output.write_all(text.as_bytes()))?;
            if is_first {
                // Cargo compares the times of files that it knows, and does not know this one yet
                File::options()
                    .append(true)
                    .open(path)
                    .and_then(|file| file.set_modified(SystemTime::now()))?;
            }
            format!("written to {}", beside.display())
        }
        None => "no form is better than the formula as written; no file was written".to_string(),
    };
    writeln!(output, "{}", palette.quiet(&told))?;
    Ok(Status::AsStated)
}
