//! The kernels of the library and their cost, as written and as generated.

use super::heading;
use crate::kernel::{generated, library};
use crate::layout::{duration, wrap};
use crate::palette::Palette;
use crate::status::Status;
use crate::theory_file::complain;
use forms::core::generation::Generated;
use std::io::{self, Write};
use std::time::Instant;

/// Columns for a kernel's name.
const NAME: usize = 30;

/// Generates every kernel of the library and prints its cost.
pub(super) fn generate(palette: Palette, output: &mut dyn Write) -> io::Result<Status> {
    let start = Instant::now();
    let programs = library().and_then(|files| {
        let kernels = files.iter().flat_map(|file| file.theory.kernels.iter().map(move |k| (file, k)));
        kernels.map(|(file, kernel)| generated(file, kernel)).collect::<Result<Vec<_>, _>>()
    });
    let programs = match programs {
        Ok(programs) => programs,
        Err(errors) => {
            complain(&errors);
            return Ok(Status::Error);
        }
    };
    heading(2, "Kernels, generated from the theory", palette, output)?;
    for line in wrap(
        "The operations of each generated kernel, and the cost of its formula as written and as generated, in \
              additions: a division counts as 4, a square root as 5, a function as 15 to 30.",
        2,
    ) {
        writeln!(output, "{line}")?;
    }
    writeln!(output)?;
    let title =
        format!("  {:NAME$} {:>9} {:>10} {:>9} {:>9}", "", "arguments", "operations", "written", "generated");
    writeln!(output, "{}", palette.quiet(&title))?;
    for Generated { written, optimised, .. } in &programs {
        let (before, after) = (written.cost(), optimised.cost());
        let arguments = written.arguments().len();
        let count = optimised.operations();
        let operations = count.arithmetic() + count.function_calls;
        writeln!(
            output,
            "  {:NAME$} {arguments:>9} {operations:>10} {before:>9} {after:>9}",
            written.name()
        )?;
    }
    let proved = programs.iter().filter(|generated| generated.translation.is_proved()).count();
    let (all, time) = (programs.len(), duration(start.elapsed()));
    writeln!(output, "\n  {all} kernels in {time}, {proved} of them proved equal to their formulas")?;
    writeln!(output, "  forms emit - --target rust prints them\n")?;
    Ok(Status::AsStated)
}
