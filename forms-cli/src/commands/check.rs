//! `forms check`: a certificate, checked without the prover.

use super::refuse;
use crate::certificate::place_of;
use crate::layout::{duration, wrap};
use crate::palette::Palette;
use crate::status::Status;
use crate::theory_file::text;
use forms::core::diagnostic::counted;
use forms_check::{Checked, Outcome};
use std::io::{self, Write};
use std::time::Instant;

/// Where a reason begins.
const INDENT: usize = 6;

/// Checks every entry of a certificate and prints what became of each.
pub(crate) fn check(file: &str, allow_uncovered: bool, output: &mut dyn Write) -> io::Result<Status> {
    let start = Instant::now();
    let read = |name: &str| {
        let place = place_of(file, name);
        text(&place).map_err(|message| format!("{place}: {message}"))
    };
    let certificate = match text(file) {
        Ok(certificate) => certificate,
        Err(message) => return Ok(refuse(&format!("{file}: {message}"))),
    };
    let checked = match forms_check::check(&certificate, read) {
        Ok(checked) => checked,
        Err(message) => return Ok(refuse(&format!("{file}: {message}"))),
    };
    report(&checked, output)?;
    writeln!(output, "{}", Palette::of_output().quiet(&duration(start.elapsed())))?;
    let is_harmless = |one: &Checked| match one.outcome {
        Outcome::Accepted => true,
        Outcome::NotCovered(_) => allow_uncovered,
        Outcome::Rejected(_) => false,
    };
    Ok(if checked.iter().all(is_harmless) { Status::AsStated } else { Status::NotAsStated })
}

fn report(checked: &[Checked], output: &mut dyn Write) -> io::Result<()> {
    let palette = Palette::of_output();
    let mut file = "";
    for one in checked {
        if one.file != file {
            file = &one.file;
            writeln!(output, "{}", palette.heading(file))?;
        }
        let (mark, words, why) = match &one.outcome {
            Outcome::Accepted => (palette.good("✓"), "accepted", ""),
            Outcome::Rejected(why) => (palette.bad("✗"), "rejected", why.as_str()),
            Outcome::NotCovered(why) => (palette.notable("·"), "not covered", why.as_str()),
        };
        writeln!(output, "  {mark} {:44}  {words}", one.name)?;
        for line in wrap(why, INDENT) {
            writeln!(output, "{}", palette.quiet(&line))?;
        }
    }
    let count = |is: fn(&Outcome) -> bool| checked.iter().filter(|one| is(&one.outcome)).count();
    let (rejected, open) = (
        count(|outcome| matches!(outcome, Outcome::Rejected(_))),
        count(|outcome| matches!(outcome, Outcome::NotCovered(_))),
    );
    let all = counted(checked.len(), "statement");
    let accepted = checked.len() - rejected - open;
    writeln!(output, "\n{all}: {accepted} accepted, {rejected} rejected, {open} not covered")
}
