//! Task `derive`: the steps that decide one statement of a text.

use super::Refusal;
use super::record::{mathml, read};
use crate::json::write_record;
use forms::core::derivation::{Line, derive as derivation_of};
use serde::{Deserialize, Serialize};
use std::io::{self, Write};

#[derive(Deserialize)]
pub(super) struct Request {
    text: String,
    /// Name of a statement.
    name: String,
}

#[derive(Serialize)]
struct Steps<'a> {
    steps: Vec<StepRecord<'a>>,
}

#[derive(Serialize)]
struct StepRecord<'a> {
    title: &'a str,
    lines: Vec<LineRecord<'a>>,
}

/// Sentence, or a formula in the notation of the language and in MathML.
#[derive(Serialize)]
#[serde(untagged)]
enum LineRecord<'a> {
    Words { words: &'a str },
    Formula { text: &'a str, mathml: Option<String> },
}

/// Writes the steps, or a refusal if there is no such statement.
pub(super) fn derive(request: &Request, output: &mut dyn Write) -> io::Result<()> {
    let Some((_, file)) = read(&request.text, output)? else { return Ok(()) };
    let Some(derivation) = derivation_of(&file.source, &request.name) else {
        let refusal = format!("there is no statement named `{}`", request.name);
        return write_record(output, &Refusal { refusal });
    };
    let steps = derivation
        .steps
        .iter()
        .map(|step| StepRecord { title: &step.title, lines: step.lines.iter().map(record).collect() });
    write_record(output, &Steps { steps: steps.collect() })
}

fn record(line: &Line) -> LineRecord<'_> {
    match line {
        Line::Words(words) => LineRecord::Words { words },
        Line::Formula(formula) => LineRecord::Formula { text: &formula.text, mathml: mathml(&formula.latex) },
    }
}
