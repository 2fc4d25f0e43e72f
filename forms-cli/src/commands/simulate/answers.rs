//! Output of the answers after the work: a table, or a JSON object for each number.

use super::missed::Missed;
use crate::json::write_record;
use crate::layout::{columns, seconds};
use crate::palette::Palette;
use forms::core::diagnostic::counted;
use forms_radiometry::output::{measured, rough};
use forms_radiometry::simulation::{Answer, ErrorParts, Simulation};
use std::io::{self, Write};

/// JSON record of a number.
#[derive(serde::Serialize)]
struct Record<'a> {
    receiver: &'a str,
    quantity: &'a str,
    unit: &'a str,
    band: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    bin: Option<usize>,
    value: f64,
    error: f64,
    kind: &'a str,
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    missed: bool,
    seconds: f64,
}

/// JSON record of the time shared by all answers.
#[derive(serde::Serialize)]
struct SharedRecord {
    shared: &'static str,
    seconds: f64,
}

/// Returns the name of the work shared by all receivers.
fn shared(is_by_paths: bool) -> &'static str {
    if is_by_paths { "preparation" } else { "solution" }
}

/// Writes an object for each number, and one for the time shared by all of them. A number is marked
/// if it misses the tolerance, or if it is the mean of a map or image with cells that miss it.
pub(super) fn lines(
    found: &Simulation,
    missed: &Missed<'_>,
    is_by_paths: bool,
    output: &mut dyn Write,
) -> io::Result<()> {
    found.answers.iter().enumerate().try_for_each(|(place, answer)| {
        let Answer { receiver, quantity, band, bin, value, error, kind, seconds, .. } = answer;
        let record = Record {
            receiver,
            quantity: quantity.name(),
            unit: answer.unit(),
            band: *band,
            bin: *bin,
            value: *value,
            error: *error,
            kind: kind.name(),
            missed: missed.has(place, answer),
            seconds: *seconds,
        };
        write_record(output, &record)
    })?;
    write_record(output, &SharedRecord { shared: shared(is_by_paths), seconds: found.shared_seconds() })
}

/// Writes a line for each number and one for the time shared by all of them, the total time, the
/// largest error, and the components of that error if there are several.
pub(super) fn table(
    found: &Simulation,
    tolerance: f64,
    is_by_paths: bool,
    output: &mut dyn Write,
) -> io::Result<()> {
    let palette = Palette::of_output();
    let head = ["receiver", "quantity", "band", "bin", "value", "", "unit", "time"].map(str::to_owned);
    let mut rows: Vec<[String; 8]> = std::iter::once(head).chain(found.answers.iter().map(row)).collect();
    rows.push(shared_row(found, is_by_paths));
    point_below_point(&mut rows);
    let right = [false, false, true, true, true, false, false, true];
    for (place, line) in columns(&rows, right).iter().enumerate() {
        let line = format!("  {line}");
        writeln!(output, "{}", if place == 0 { palette.quiet(&line) } else { line })?;
    }
    writeln!(output)?;
    let Some(end) = found.history.last() else { return Ok(()) };
    let summary = format!(
        "{} in {}; largest error relative to its answer: {} (tolerance {tolerance:e})",
        counted(found.answers.len(), "number"),
        seconds(found.seconds),
        rough(end.error)
    );
    writeln!(
        output,
        "{}",
        if end.error <= tolerance { palette.quiet(&summary) } else { palette.notable(&summary) }
    )?;
    // The components of the errors of cells are not known.
    let accuracy = found.accuracy();
    let worst = accuracy.worst_answer().filter(|worst| worst.error >= accuracy.largest_of_cells());
    let made_of = worst.map(|worst| parts(&worst.answer.parts)).filter(|parts| parts.len() > 1);
    made_of.map_or(Ok(()), |parts| {
        let line = format!("this error consists of {}", parts.join(", "));
        writeln!(output, "{}", palette.quiet(&line))
    })
}

/// Lists the components that make up at least 1 % of an error, the largest first: `93% quadrature`.
fn parts(parts: &ErrorParts) -> Vec<String> {
    let all = parts.all();
    let sum: f64 = all.iter().sum();
    let shares =
        all.into_iter().zip(ErrorParts::NAMES).map(|(part, name)| ((100.0 * part / sum).round(), name));
    let mut shares: Vec<(f64, &str)> = shares.filter(|(percent, _)| *percent >= 1.0).collect();
    shares.sort_by(|one, other| other.0.total_cmp(&one.0));
    shares.into_iter().map(|(percent, name)| format!("{percent}% {name}")).collect()
}

/// Column of the values.
const VALUE: usize = 4;

/// Appends spaces to the values, so that their decimal points align when the column is
/// right-aligned.
fn point_below_point(rows: &mut [[String; 8]]) {
    let behind = |value: &str| value.find('.').map_or(0, |point| value.len() - point);
    let most = rows.iter().skip(1).map(|row| behind(&row[VALUE])).max().unwrap_or(0);
    for row in rows.iter_mut().skip(1) {
        let missing = most - behind(&row[VALUE]);
        row[VALUE].extend(std::iter::repeat_n(' ', missing));
    }
}

/// Returns the row of the time shared by all receivers.
fn shared_row(found: &Simulation, is_by_paths: bool) -> [String; 8] {
    let mut row: [String; 8] = Default::default();
    row[0] = "(shared)".to_owned();
    row[1] = shared(is_by_paths).to_owned();
    row[7] = seconds(found.shared_seconds());
    row
}

fn row(answer: &Answer) -> [String; 8] {
    let [value, error] = measured(answer.value, answer.error);
    let meaning = answer.kind.words();
    [
        answer.receiver.clone(),
        answer.quantity.name().to_owned(),
        answer.band.map_or(String::new(), |band| band.to_string()),
        answer.bin.map_or(String::new(), |bin| bin.to_string()),
        value,
        format!("± {error} ({meaning})"),
        answer.unit().to_owned(),
        seconds(answer.seconds),
    ]
}
