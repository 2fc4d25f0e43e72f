//! `forms prove`: decides every statement of every file, and the claims of its kernels.

use crate::certificate::Certificate;
use crate::decisions::{DecidedFault, DecidedFile, for_each_file};
use crate::json::{Point, StatementRecord, write_error, write_record};
use crate::layout::{duration, wrap};
use crate::palette::Palette;
use crate::status::Status;
use crate::theory_file::{FileError, complain};
use crate::verdict_line::{Decided, INDENT, WORDS, line};
use forms::core::decide::Verdict;
use forms::core::diagnostic::Diagnostic;
use forms::core::diagnostic::counted;
use forms::core::syntax::ast::Claim;
use std::io::{self, Write};
use std::time::{Duration, Instant};

/// Decides the statements of files and prints the verdicts.
pub(crate) fn prove(
    files: &[String],
    json: bool,
    (certificate, budget): (Option<&str>, u32),
    output: &mut dyn Write,
) -> io::Result<Status> {
    let start = Instant::now();
    let certificate = certificate.map(Certificate::new);
    let palette = Palette::of_output();
    let mut report = Report { output, json, palette, totals: Totals::default(), certificate };
    let mut status = Status::AsStated;
    for_each_file(files, budget, |file| {
        status = status.max(match file {
            Ok(file) => report.file(file)?,
            Err(errors) => {
                report.totals.unread += 1;
                report.errors(&errors)?
            }
        });
        Ok(())
    })?;
    if !json {
        report.totals(start.elapsed())?;
    }
    match report.certificate.map(Certificate::write) {
        Some(Err(message)) => Ok(super::refuse(&message)),
        Some(Ok(())) | None => Ok(status),
    }
}

#[derive(Default)]
pub(super) struct Totals {
    proved: usize,
    refuted: usize,
    unknown: usize,
    not_as_stated: usize,
    /// Numbers of false and of undecided claims of kernels.
    false_claims: usize,
    open_claims: usize,
    /// Number of files with errors; their statements are not decided.
    unread: usize,
    time: Duration,
}

impl Totals {
    pub(super) fn count(&mut self, decided: &Decided) {
        match decided.verdict {
            Verdict::Proved(_) => self.proved += 1,
            Verdict::Refuted(_) => self.refuted += 1,
            Verdict::Unknown { .. } | Verdict::Empty { .. } => self.unknown += 1,
        }
        self.not_as_stated += usize::from(!decided.ok());
        self.time += decided.time;
    }

    fn count_fault(&mut self, decided: &DecidedFault) {
        match decided.fault.verdict {
            Verdict::Refuted(_) => self.false_claims += 1,
            _ => self.open_claims += 1,
        }
        self.not_as_stated += 1;
        self.time += decided.time;
    }

    /// Formats the totals: `3 statements: 2 proved, 1 refuted; 1 claim of a kernel refuted`.
    pub(super) fn sentence(&self) -> String {
        let kinds = [(self.proved, "proved"), (self.refuted, "refuted"), (self.unknown, "unknown")];
        let kinds: Vec<String> =
            kinds.iter().filter(|kind| kind.0 > 0).map(|(count, kind)| format!("{count} {kind}")).collect();
        let all = counted(self.count_of_statements(), "statement");
        let statements = if kinds.is_empty() { all } else { format!("{all}: {}", kinds.join(", ")) };
        let claims = [(self.false_claims, "refuted"), (self.open_claims, "unknown")];
        let claims: Vec<String> = claims
            .iter()
            .filter(|kind| kind.0 > 0)
            .map(|(count, kind)| format!("{} of a kernel {kind}", counted(*count, "claim")))
            .collect();
        [vec![statements], claims].concat().join("; ")
    }

    fn count_of_statements(&self) -> usize {
        self.proved + self.refuted + self.unknown
    }

    pub(super) fn all_as_stated(&self) -> bool {
        self.not_as_stated == 0
    }

    pub(super) fn time(&self) -> Duration {
        self.time
    }
}

struct Report<'a> {
    output: &'a mut dyn Write,
    json: bool,
    palette: Palette,
    totals: Totals,
    certificate: Option<Certificate>,
}

impl Report<'_> {
    fn file(&mut self, file: DecidedFile) -> io::Result<Status> {
        let DecidedFile { source, mut theory, statements, faults } = file;
        if !self.json {
            writeln!(self.output, "{}", self.palette.heading(&source.name))?;
        }
        if let Some(certificate) = &mut self.certificate {
            certificate.begin(&source, &mut theory);
        }
        let mut status = Status::AsStated;
        let mut errors = Vec::new();
        for decided in &statements {
            let statement = &decided.statement;
            if let Verdict::Empty { reason } = &decided.verdict {
                let message = format!("`{}` is vacuous: {reason}", statement.name);
                errors.push(FileError::at(&source, &Diagnostic::new(statement.span, message)));
            }
            status = status.max(if decided.ok() { Status::AsStated } else { Status::NotAsStated });
            self.statement(&source.name, decided)?;
            if let Some(certificate) = &mut self.certificate {
                certificate.add(&mut theory, statement, &decided.verdict);
            }
        }
        for decided in &faults {
            status = status.max(Status::NotAsStated);
            self.fault(&source.name, decided)?;
        }
        if !self.json {
            writeln!(self.output)?;
        }
        if !errors.is_empty() {
            status = self.errors(&errors)?;
        }
        self.output.flush()?;
        Ok(status)
    }

    fn statement(&mut self, file: &str, decided: &Decided) -> io::Result<()> {
        self.totals.count(decided);
        if self.json {
            return write_statement(self.output, file, decided);
        }
        writeln!(self.output, "{}", decided.line(self.palette))?;
        for line in decided.grounds(self.palette) {
            writeln!(self.output, "{line}")?;
        }
        Ok(())
    }

    /// Reports a claim of a kernel that was not proved, like a statement that is not as stated.
    fn fault(&mut self, file: &str, decided: &DecidedFault) -> io::Result<()> {
        self.totals.count_fault(decided);
        if self.json {
            return write_fault(self.output, file, decided);
        }
        write_fault_lines(self.output, decided, self.palette)
    }

    fn errors(&mut self, errors: &[FileError]) -> io::Result<Status> {
        if self.json {
            for error in errors {
                write_error(self.output, error)?;
            }
        } else {
            self.output.flush()?;
            complain(errors);
        }
        Ok(Status::Error)
    }

    fn totals(&mut self, all: Duration) -> io::Result<()> {
        let totals = &self.totals;
        if totals.unread > 0 {
            let errors = format!("{} with errors, not decided", counted(totals.unread, "file"));
            writeln!(self.output, "{}", self.palette.bad(&errors))?;
            if totals.count_of_statements() == 0 && totals.not_as_stated == 0 {
                return Ok(());
            }
        }
        let end = match totals.not_as_stated {
            0 => self.palette.good("all as stated"),
            1 => self.palette.bad("1 is not as stated"),
            some => self.palette.bad(&format!("{some} are not as stated")),
        };
        writeln!(self.output, "{}; {end}", totals.sentence())?;
        let times = format!("{} of proof time, {} elapsed", duration(totals.time), duration(all));
        writeln!(self.output, "{}", self.palette.quiet(&times))
    }
}

/// Writes a claim that was not proved in one line, and the reason below it.
pub(super) fn write_fault_lines(
    output: &mut dyn Write,
    decided: &DecidedFault,
    palette: Palette,
) -> io::Result<()> {
    writeln!(output, "{}", fault_line(decided, palette))?;
    for line in wrap(&decided.fault.diagnostic.message, INDENT) {
        writeln!(output, "{}", palette.quiet(&line))?;
    }
    Ok(())
}

/// Formats mark, kernel and claim, verdict and time in one line.
fn fault_line(decided: &DecidedFault, palette: Palette) -> String {
    let DecidedFault { fault, time } = decided;
    let words = match fault.verdict {
        Verdict::Refuted(_) => "does not hold",
        _ => "unknown",
    };
    let name = format!("{}: {}", fault.kernel, fault.claim.name());
    line(palette, &palette.bad("✗"), &name, &palette.bad(&format!("{words:WORDS$}")), *time)
}

fn write_fault(output: &mut dyn Write, file: &str, decided: &DecidedFault) -> io::Result<()> {
    let DecidedFault { fault, time } = decided;
    let (conditions, witness): (&[String], _) = match &fault.verdict {
        Verdict::Refuted(witness) => (&witness.conditions, Some(Point(&witness.point))),
        _ => (&[], None),
    };
    let record = StatementRecord {
        file,
        name: &fault.kernel,
        kind: fault.claim.name(),
        verdict: fault.verdict.name(),
        ok: false,
        conditions,
        witness,
        micros: u64::try_from(time.as_micros()).unwrap_or(u64::MAX),
    };
    write_record(output, &record)
}

/// Writes the record of a statement. A vacuous statement is an error; the error record is written
/// in its place.
fn write_statement(output: &mut dyn Write, file: &str, decided: &Decided) -> io::Result<()> {
    let Decided { statement, verdict, time } = decided;
    let (conditions, witness): (&[String], _) = match verdict {
        Verdict::Proved(theorem) => (&theorem.conditions, None),
        Verdict::Refuted(witness) => (&witness.conditions, Some(Point(&witness.point))),
        Verdict::Unknown { .. } => (&[], None),
        Verdict::Empty { .. } => return Ok(()),
    };
    let record = StatementRecord {
        file,
        name: &statement.name,
        kind: match statement.claim {
            Claim::Prove => "prove",
            Claim::Refute => "refute",
        },
        verdict: verdict.name(),
        ok: decided.ok(),
        conditions,
        witness,
        micros: u64::try_from(time.as_micros()).unwrap_or(u64::MAX),
    };
    write_record(output, &record)
}
