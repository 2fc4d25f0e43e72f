//! Task `check`: writes the errors, or the statements and kernels of a text, then the verdict on
//! each statement and the claims of kernels that were not proved.

use super::record::{Place, mathml, read, tell};
use crate::decisions::timed;
use crate::json::{Point, write_record};
use crate::theory_file::{FileError, TheoryFile};
use crate::verdict_line::Decided;
use forms::core::accuracy::ranges;
use forms::core::decide::{Verdict, Witness};
use forms::core::diagnostic::Diagnostic;
use forms::core::generation::{Fault, faults};
use forms::core::notation::{latex, latex_as_written, latex_of_condition};
use forms::core::syntax::ast::{Claim, File, ItemKind, Name};
use forms::core::theory::{Kernel, Theory, Value};
use serde::{Deserialize, Serialize};
use std::io::{self, Write};

#[derive(Deserialize)]
pub(super) struct Request {
    text: String,
}

/// Declarations of a text, sent before any decision.
#[derive(Serialize)]
struct Declared<'a> {
    statements: Vec<StatementRecord<'a>>,
    kernels: Vec<KernelRecord<'a>>,
}

#[derive(Serialize)]
struct StatementRecord<'a> {
    name: &'a str,
    kind: &'a str,
    /// Place of its name.
    #[serde(flatten)]
    place: Place,
    /// Equation as written.
    mathml: Option<String>,
}

#[derive(Serialize)]
struct KernelRecord<'a> {
    name: &'a str,
    docs: &'a [String],
    #[serde(flatten)]
    place: Place,
    arguments: Vec<ArgumentRecord<'a>>,
    outputs: usize,
    mathml: Option<String>,
}

#[derive(Serialize)]
struct ArgumentRecord<'a> {
    name: &'a str,
    unit: Option<&'a str>,
    /// Ends of its range, if the domain bounds it by numbers.
    from: Option<f64>,
    to: Option<f64>,
}

#[derive(Serialize)]
struct Verdicts<'a> {
    verdicts: [VerdictRecord<'a>; 1],
}

#[derive(Serialize)]
struct VerdictRecord<'a> {
    name: &'a str,
    verdict: &'a str,
    ok: bool,
    words: &'a str,
    conditions: &'a [String],
    witness: Option<WitnessRecord<'a>>,
    /// Reason why the statement was not decided.
    reason: Option<String>,
    micros: u64,
}

#[derive(Serialize)]
struct WitnessRecord<'a> {
    point: Point<'a>,
    component: &'a str,
    left: &'a str,
    right: &'a str,
    difference: &'a str,
    ratio: Option<String>,
}

/// Writes the errors of a text, or its declarations and the verdicts on its statements.
pub(super) fn check(request: &Request, output: &mut dyn Write) -> io::Result<()> {
    let Some((file, mut theory_file)) = read(&request.text, output)? else { return Ok(()) };
    declared(&file, &theory_file, output)?;
    output.flush()?;
    for statement in theory_file.theory.statements.clone() {
        let decided = timed(&mut theory_file.theory, statement, 1);
        verdict(&theory_file, &decided, output)?;
        output.flush()?;
    }
    for kernel in theory_file.theory.kernels.clone() {
        let faults = faults(&mut theory_file.theory.pool, &kernel);
        if !faults.is_empty() {
            let error = |fault: &Fault| FileError::at(&theory_file.source, &fault.diagnostic);
            tell(&faults.iter().map(error).collect::<Vec<_>>(), output)?;
            output.flush()?;
        }
    }
    Ok(())
}

fn declared(file: &File, theory_file: &TheoryFile, output: &mut dyn Write) -> io::Result<()> {
    let TheoryFile { source, theory, .. } = theory_file;
    let statements = theory.statements.iter().map(|known| {
        let written = written(file, &known.name);
        StatementRecord {
            name: &known.name,
            kind: match known.claim {
                Claim::Prove => "prove",
                Claim::Refute => "refute",
            },
            place: Place::of(source, written.map_or(known.span, |(name, _)| name.span)),
            mathml: written.and_then(|(_, item)| mathml(&formula(theory, item)?)),
        }
    });
    let kernels = theory.kernels.iter().map(|known| kernel(theory_file, known));
    write_record(output, &Declared { statements: statements.collect(), kernels: kernels.collect() })
}

/// Finds the item of a statement, with its name; `None` if the statement follows from a warp and
/// has no item of its own.
fn written<'a>(file: &'a File, wanted: &str) -> Option<(&'a Name, &'a ItemKind)> {
    file.items.iter().find_map(|item| match &item.kind {
        ItemKind::Statement { name, .. } if name.text == wanted => Some((name, &item.kind)),
        _ => None,
    })
}

/// Returns a statement as written, in LaTeX.
fn formula(theory: &Theory, item: &ItemKind) -> Option<String> {
    let ItemKind::Statement { left, right, conditions, .. } = item else { return None };
    let equation = format!("{} = {}", latex_as_written(theory, left), latex_as_written(theory, right));
    let conditions: Vec<String> =
        conditions.iter().map(|condition| latex_of_condition(theory, condition)).collect();
    let apart = if conditions.is_empty() { "" } else { ",\\quad " };
    Some(equation + apart + &conditions.join(",\\; "))
}

fn kernel<'a>(TheoryFile { source, theory, .. }: &'a TheoryFile, kernel: &'a Kernel) -> KernelRecord<'a> {
    let units = kernel.units.arguments.iter().map(Option::as_deref).chain(std::iter::repeat(None));
    let arguments = kernel.arguments.iter().zip(ranges(&theory.pool, kernel)).zip(units);
    let argument = |((&symbol, (from, to)), unit)| {
        let name = theory.pool.symbol_name(symbol);
        ArgumentRecord { name, unit, from, to }
    };
    let outputs: Vec<String> =
        kernel.outputs.iter().map(|&output| latex(theory, &Value::Scalar(output))).collect();
    KernelRecord {
        name: &kernel.name,
        docs: &kernel.docs,
        place: Place::of(source, kernel.span),
        arguments: arguments.map(argument).collect(),
        outputs: outputs.len(),
        mathml: mathml(&outputs.join(",\\quad ")),
    }
}

fn verdict(theory_file: &TheoryFile, decided: &Decided, output: &mut dyn Write) -> io::Result<()> {
    let Decided { statement, verdict, time } = decided;
    let (conditions, witness): (&[String], _) = match verdict {
        Verdict::Proved(theorem) => (&theorem.conditions, None),
        Verdict::Refuted(witness) => (&witness.conditions, Some(record_of(witness))),
        Verdict::Unknown { .. } | Verdict::Empty { .. } => (&[], None),
    };
    if let Verdict::Empty { reason } = verdict {
        let message = format!("`{}` is vacuous: {reason}", statement.name);
        let error = Diagnostic::new(statement.span, message);
        tell(&[FileError::at(&theory_file.source, &error)], output)?;
    }
    let record = VerdictRecord {
        name: &statement.name,
        verdict: verdict.name(),
        ok: decided.ok(),
        words: decided.words(),
        conditions,
        witness,
        reason: verdict.reason(),
        micros: u64::try_from(time.as_micros()).unwrap_or(u64::MAX),
    };
    write_record(output, &Verdicts { verdicts: [record] })
}

fn record_of(witness: &Witness) -> WitnessRecord<'_> {
    WitnessRecord {
        point: Point(&witness.point),
        component: &witness.component,
        left: &witness.left,
        right: &witness.right,
        difference: &witness.difference,
        ratio: witness.ratio.as_ref().map(ToString::to_string),
    }
}
