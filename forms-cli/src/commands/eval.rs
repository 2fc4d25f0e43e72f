//! `forms eval`: rows of CSV in, the same rows with a kernel's values out.

use crate::arguments::Tier;
use crate::commands::refuse;
use crate::decimal::nearest;
use crate::kernel::{files, find, generated};
use crate::status::Status;
use crate::theory_file::complain;
use forms::core::kernel::Program;
use std::io::{self, Write};

/// The file name that rows from standard input are reported under.
const INPUT: &str = "<stdin>";

/// Evaluates a kernel on the rows of standard input.
pub(crate) fn eval(
    file: &str,
    kernel: &str,
    precision: &str,
    tier: Tier,
    output: &mut dyn Write,
) -> io::Result<Status> {
    match precision {
        "f64" => {}
        "f32" | "dd" | "exact" => {
            let message =
                format!("the precision `{precision}` is not available in this version; there is `f64`");
            return Ok(refuse(&message));
        }
        _ => return Ok(refuse(&format!("there is no precision `{precision}`; there is `f64`"))),
    }
    let files = match files(file) {
        Ok(files) => files,
        Err(errors) => {
            complain(&errors);
            return Ok(Status::Error);
        }
    };
    let (file, kernel) = match find(&files, kernel) {
        Ok(found) => found,
        Err(message) => return Ok(refuse(&format!("{message} (in {file})"))),
    };
    let program = match generated(file, kernel) {
        Ok(generated) if tier == Tier::Stable => generated.optimised,
        Ok(generated) => generated.written,
        Err(errors) => {
            complain(&errors);
            return Ok(Status::Error);
        }
    };
    if program.arguments().is_empty() {
        return constant(&program, output);
    }
    rows(&program, io::stdin().lock(), output)
}

/// A kernel without arguments has one row, and needs no input for it.
fn constant(program: &Program, output: &mut dyn Write) -> io::Result<Status> {
    let mut writer = csv::Writer::from_writer(output);
    writer.write_record(header(program))?;
    writer.write_record(program.interpret(&[]).into_iter().map(digits))?;
    writer.flush()?;
    Ok(Status::AsStated)
}

/// Reads rows and writes them with their values until one of them is malformed.
fn rows(program: &Program, input: impl io::Read, output: &mut dyn Write) -> io::Result<Status> {
    let mut reader = csv::ReaderBuilder::new().flexible(true).trim(csv::Trim::All).from_reader(input);
    let columns = match reader.headers().map_err(|error| unreadable(&error)).and_then(|h| columns(program, h))
    {
        Ok(columns) => columns,
        Err(message) => return Ok(refuse(&format!("{message}\n --> {INPUT}:1"))),
    };
    let mut writer = csv::Writer::from_writer(output);
    writer.write_record(header(program))?;
    let mut record = csv::StringRecord::new();
    loop {
        let row = match reader.read_record(&mut record) {
            Ok(false) => break,
            Ok(true) => arguments(program, &columns, &record),
            Err(error) => Err(unreadable(&error)),
        };
        match row {
            Ok(arguments) => {
                let values = program.interpret(&arguments);
                writer.write_record(arguments.iter().chain(&values).map(|&value| digits(value)))?;
            }
            Err(message) => {
                writer.flush()?;
                let line = record.position().map_or(reader.position().line(), csv::Position::line);
                return Ok(refuse(&format!("{message}\n --> {INPUT}:{line}")));
            }
        }
    }
    writer.flush()?;
    Ok(Status::AsStated)
}

fn unreadable(error: &csv::Error) -> String {
    match error.kind() {
        csv::ErrorKind::Utf8 { .. } => "the input is not UTF-8 text".to_string(),
        _ => format!("cannot read the input: {error}"),
    }
}

/// The column of each argument of the kernel.
fn columns(program: &Program, header: &csv::StringRecord) -> Result<Vec<usize>, String> {
    let wanted = || program.arguments().join(", ");
    let header: Vec<&str> = header.iter().map(|name| name.trim_start_matches('\u{feff}')).collect();
    if header.is_empty() {
        return Err(format!("the input has no header; expected the columns {}", wanted()));
    }
    for (place, name) in header.iter().enumerate() {
        if !program.arguments().iter().any(|argument| argument == name) {
            let (kernel, wanted) = (program.name(), wanted());
            return Err(format!("`{name}` is no argument of `{kernel}`; expected the columns {wanted}"));
        }
        if header[..place].contains(name) {
            return Err(format!("the column `{name}` occurs twice"));
        }
    }
    let column = |argument: &String| {
        let place = header.iter().position(|name| name == argument);
        place.ok_or_else(|| format!("the column `{argument}` is missing; expected {}", wanted()))
    };
    program.arguments().iter().map(column).collect()
}

/// The kernel's arguments from one row.
fn arguments(program: &Program, columns: &[usize], row: &csv::StringRecord) -> Result<Vec<f64>, String> {
    if row.len() != columns.len() {
        let expected = crate::layout::counted(columns.len(), "number");
        return Err(format!("expected {expected} in this row, found {}", row.len()));
    }
    let named = program.arguments().iter().zip(columns);
    named
        .map(|(name, &column)| {
            let text = &row[column];
            nearest(text).ok_or_else(|| {
                let found: String = text.chars().take(40).collect();
                format!("expected a number such as 0.5, 1e-3 or 1/3 for `{name}`, found `{found}`")
            })
        })
        .collect()
}

/// The arguments, then the kernel's name, or `NAME_0`, `NAME_1`, … if it has several values.
fn header(program: &Program) -> Vec<String> {
    let mut names = program.arguments().to_vec();
    match program.outputs().len() {
        1 => names.push(program.name().to_string()),
        several => names.extend((0..several).map(|place| format!("{}_{place}", program.name()))),
    }
    names
}

/// Seventeen significant digits, which tell any two numbers apart.
fn digits(value: f64) -> String {
    if value.is_finite() { format!("{value:.16e}") } else { value.to_string() }
}

#[cfg(test)]
mod tests {
    use super::digits;

    #[test]
    fn seventeen_digits_give_the_same_number_back() {
        for value in [0.1, 1.0 / 3.0, 5e-324, f64::MAX, -0.0] {
            assert_eq!(digits(value).parse::<f64>().map(f64::to_bits), Ok(value.to_bits()));
        }
        assert_eq!((digits(f64::NAN), digits(0.5)), ("NaN".into(), "5.0000000000000000e-1".into()));
    }
}
