//! `forms check`: checks a certificate without the prover.
//!
//! Files with errors are refused as by `forms prove`. The verdicts on statements rest on the
//! checker alone. Certificates do not cover the claims of kernels: the prover decides these again,
//! and the output says so.

use super::prove::write_fault_lines;
use super::refuse;
use crate::certificate::place_of;
use crate::decisions::{DecidedFault, faults_of_kernels};
use crate::layout::{duration, wrap};
use crate::palette::Palette;
use crate::status::Status;
use crate::theory_file::{complain, from_text, text};
use forms::core::diagnostic::counted;
use forms_check::{Checked, Claim, Outcome};
use std::io::{self, Write};
use std::time::Instant;

/// Indent of a reason.
const INDENT: usize = 6;

/// Checks every entry of a certificate, and prints the result of each and whether it agrees with
/// the file.
pub(crate) fn check(file: &str, allow_uncovered: bool, output: &mut dyn Write) -> io::Result<Status> {
    let start = Instant::now();
    let mut sources: Vec<(String, String)> = Vec::new();
    let read = |name: &str| {
        let place = place_of(file, name);
        let source = text(&place).map_err(|message| format!("{place}: {message}"))?;
        sources.push((place, source.clone()));
        Ok(source)
    };
    let certificate = match text(file) {
        Ok(certificate) => certificate,
        Err(message) => return Ok(refuse(&format!("{file}: {message}"))),
    };
    let checked = match forms_check::check(&certificate, read) {
        Ok(checked) => checked,
        Err(message) => return Ok(refuse(&format!("{file}: {message}"))),
    };
    let mut faults = Vec::new();
    for (place, source) in sources {
        match from_text(&place, source) {
            Ok(mut file) => faults.extend(faults_of_kernels(&mut file.theory)),
            Err(errors) => {
                complain(&errors);
                return Ok(Status::Error);
            }
        }
    }
    report(&checked, &faults, output)?;
    writeln!(output, "{}", Palette::of_output().quiet(&duration(start.elapsed())))?;
    let is_harmless = |one: &Checked| match one.outcome {
        Outcome::Accepted => one.is_as_stated(),
        Outcome::NotCovered(_) => allow_uncovered,
        Outcome::Rejected(_) => false,
    };
    let is_as_stated = checked.iter().all(is_harmless) && faults.is_empty();
    Ok(if is_as_stated { Status::AsStated } else { Status::NotAsStated })
}

/// Describes the result of an accepted entry, and whether it agrees with the file.
fn shown(one: &Checked) -> String {
    let verdict = match one.shown {
        Some(Claim::Prove) => "proved",
        Some(Claim::Refute) => "refuted",
        None => "nothing shown",
    };
    let agreement = if one.is_as_stated() { "as stated" } else { "not as stated" };
    format!("accepted: {verdict}, {agreement}")
}

fn report(checked: &[Checked], faults: &[DecidedFault], output: &mut dyn Write) -> io::Result<()> {
    let palette = Palette::of_output();
    let mut file = "";
    for one in checked {
        if one.file != file {
            file = &one.file;
            writeln!(output, "{}", palette.heading(file))?;
        }
        let (mark, words, why) = match &one.outcome {
            Outcome::Accepted if one.is_as_stated() => (palette.good("✓"), shown(one), ""),
            Outcome::Accepted => (palette.bad("✗"), shown(one), ""),
            Outcome::Rejected(why) => (palette.bad("✗"), "rejected".into(), why.as_str()),
            Outcome::NotCovered(why) => (palette.notable("·"), "not covered".into(), why.as_str()),
        };
        writeln!(output, "  {mark} {:44}  {words}", one.name)?;
        for line in wrap(why, INDENT) {
            writeln!(output, "{}", palette.quiet(&line))?;
        }
    }
    if !faults.is_empty() {
        writeln!(output, "{}", palette.heading("claims of kernels, decided by the prover"))?;
    }
    for decided in faults {
        write_fault_lines(output, decided, palette)?;
    }
    let count = |is: fn(&Checked) -> bool| checked.iter().filter(|one| is(one)).count();
    let rejected = count(|one| matches!(one.outcome, Outcome::Rejected(_)));
    let open = count(|one| matches!(one.outcome, Outcome::NotCovered(_)));
    let others = count(|one| one.outcome == Outcome::Accepted && !one.is_as_stated());
    let all = counted(checked.len(), "statement");
    let accepted = checked.len() - rejected - open;
    write!(output, "\n{all}: {accepted} accepted, {rejected} rejected, {open} not covered")?;
    if others > 0 {
        write!(output, "; {others} of the accepted are not as stated")?;
    }
    if !faults.is_empty() {
        write!(output, "; {} of kernels not proved", counted(faults.len(), "claim"))?;
    }
    writeln!(output)
}
