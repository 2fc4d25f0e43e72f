//! The theory of radiance, statement by statement, and the equations that are wrong as printed in
//! its source.

use super::heading;
use crate::commands::prove::Totals;
use crate::decisions::timed;
use crate::layout::{duration, wrap};
use crate::palette::Palette;
use crate::status::Status;
use crate::theory_file::{complain, from_text};
use crate::verdict_line::Decided;
use forms::core::decide::{Verdict, Witness};
use forms::core::diagnostic::Span;
use forms::core::syntax::Source;
use forms::core::theory::Statement;
use std::io::{self, Write};

/// Indent of the lines below a statement.
const INDENT: usize = 6;

/// Decides every statement and prints it with its time, then the printed equations that are wrong.
pub(super) fn prove(palette: Palette, output: &mut dyn Write) -> io::Result<Status> {
    let file = match from_text(forms_kernels::RADIANCE.name, forms_kernels::RADIANCE.text) {
        Ok(file) => file,
        Err(errors) => {
            complain(&errors);
            return Ok(Status::Error);
        }
    };
    heading(1, "The theory, proved", palette, output)?;
    for line in wrap(
        "Every equation of Lessig, Fiume and Desbrun, \"On the Mathematical Formulation of Radiance\", that states \
         an identity, by its number there: decided exactly, no sampling.",
        2,
    ) {
        writeln!(output, "{line}")?;
    }
    writeln!(output)?;
    let mut theory = file.theory;
    let mut totals = Totals::default();
    let mut wrong = Vec::new();
    for statement in std::mem::take(&mut theory.statements) {
        let decided = timed(&mut theory, statement, 1);
        totals.count(&decided);
        writeln!(output, "{}", decided.line(palette))?;
        output.flush()?;
        if decided.is_wrong_as_printed() {
            wrong.push(decided);
        }
    }
    let sentence = format!("{}, in {}", totals.sentence(), duration(totals.time()));
    writeln!(output, "\n  {sentence}\n")?;
    as_printed(&wrong, &file.source, palette, output)?;
    Ok(if totals.all_as_stated() { Status::AsStated } else { Status::NotAsStated })
}

/// Prints the printed equations that are wrong, each with an exact point at which its sides differ.
fn as_printed(
    wrong: &[Decided],
    source: &Source,
    palette: Palette,
    output: &mut dyn Write,
) -> io::Result<()> {
    if wrong.is_empty() {
        return Ok(());
    }
    writeln!(output, "{}\n", palette.heading("   Wrong as printed"))?;
    for decided in wrong {
        writeln!(output, "  {}", decided.statement.name)?;
        for line in wrap(&equation(source, &decided.statement), INDENT) {
            writeln!(output, "{}", palette.notable(&line))?;
        }
        if let Verdict::Refuted(witness) = &decided.verdict {
            for line in wrap(&difference(witness), INDENT) {
                writeln!(output, "{}", palette.quiet(&line))?;
            }
        }
    }
    writeln!(output)
}

/// Formats a point at which the sides differ, and their values there, to a few digits.
fn difference(witness: &Witness) -> String {
    let point: Vec<String> = witness.point.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    let [left, right] = witness.few_digits();
    format!("{left} ≠ {right} at {}", point.join(", "))
}

/// Returns the equation as written in its file, without its name.
fn equation(source: &Source, statement: &Statement) -> String {
    let Span { start, end } = statement.span;
    let after_name = statement.name_span.end.max(start) as usize;
    let text = source.text.get(after_name..end as usize).unwrap_or(&statement.name);
    text.trim_start_matches(':').trim_end_matches(';').split_whitespace().collect::<Vec<_>>().join(" ")
}
