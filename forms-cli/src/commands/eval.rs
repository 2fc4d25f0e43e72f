//! `forms eval`: evaluates a kernel on rows of CSV and appends its values to them.

use crate::arguments::Tier;
use crate::commands::evaluation::{Computed, Evaluation};
use crate::commands::exact::Exact;
use crate::commands::refuse;
use crate::commands::rounded::Rounded;
use crate::kernel::{files, find, generated};
use crate::status::Status;
use crate::streams::Output;
use crate::tell;
use crate::theory_file::complain;
use forms::math::DoubleDouble;
use std::cell::Cell;
use std::io::{self, Write};
use std::rc::Rc;

/// Limit of the length of a row in bytes, not counting read-ahead.
const LONGEST_ROW: usize = 1 << 20;

/// Number of rows that are still checked after the reader of the output has gone away.
const MOST_UNREAD_ROWS: u64 = 1 << 20;

/// Values of `--precision`.
const PRECISIONS: [&str; 4] = ["f32", "f64", "dd", "exact"];

/// File name used in messages about rows from standard input.
const INPUT: &str = "<stdin>";

/// Evaluates a kernel on the rows of an input.
pub(crate) fn eval(
    (file, kernel): (&str, &str),
    precision: &str,
    tier: Tier,
    input: impl io::Read,
    output: &mut dyn Write,
) -> io::Result<Status> {
    if !PRECISIONS.contains(&precision) {
        let known = PRECISIONS.map(|name| format!("`{name}`")).join(", ");
        return Ok(refuse(&format!("there is no precision `{precision}`; there are {known}")));
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
    if precision == "exact" {
        return table(&Exact::new(file, kernel), input, output);
    }
    let (program, within) = match generated(file, kernel) {
        Ok(generated) if tier == Tier::Stable && precision == "dd" => {
            (generated.exact().clone(), generated.promise)
        }
        Ok(generated) if tier == Tier::Stable => {
            let within = generated.within();
            (generated.optimised, within)
        }
        Ok(generated) => (generated.written, None),
        Err(errors) => {
            complain(&errors);
            return Ok(Status::Error);
        }
    };
    match (precision, within) {
        ("f32", _) => table(&Rounded::<f32>::new(&program), input, output),
        ("dd", None) => table(&Rounded::<DoubleDouble>::new(&program), input, output),
        ("dd", Some(_)) => table(&Rounded::to_29_digits(&program), input, output),
        (_, None) => table(&Rounded::<f64>::new(&program), input, output),
        (_, Some(within)) => table(&Rounded::within(&program, within), input, output),
    }
}

/// Rows with values for which no precision was sufficient.
#[derive(Default)]
struct Undecided {
    rows: u64,
    /// Line of the first such row.
    first: u64,
}

impl Undecided {
    /// Records undecided values and returns the texts of a row's values.
    fn note(&mut self, values: Vec<Computed>, line: u64) -> Vec<String> {
        if values.iter().any(|value| value.is_undecided) {
            self.rows += 1;
            self.first = if self.rows == 1 { line } else { self.first };
        }
        values.into_iter().map(|value| value.text).collect()
    }

    /// Reports why values are missing in the table.
    fn report(&self, kernel: &str) {
        if self.rows > 0 {
            let rows =
                forms::core::diagnostic::counted(usize::try_from(self.rows).unwrap_or(usize::MAX), "row");
            tell!(
                "warning: {rows} without a value of `{kernel}`: no available precision reaches the promised accuracy\n \
                 --> {INPUT}:{}",
                self.first
            );
        }
    }
}

/// Input that fails on a row longer than the limit.
struct Bounded<R> {
    input: R,
    /// Number of bytes read since the start of the row.
    read: Rc<Cell<usize>>,
}

impl<R: io::Read> Bounded<R> {
    fn new(input: R) -> Self {
        Bounded { input, read: Rc::default() }
    }

    /// Returns the byte counter of the row; the caller resets it at each new row.
    fn counter(&self) -> Rc<Cell<usize>> {
        Rc::clone(&self.read)
    }
}

impl<R: io::Read> io::Read for Bounded<R> {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        if self.read.get() > LONGEST_ROW {
            return Err(io::Error::other(format!(
                "a row is longer than the limit of {} MiB",
                LONGEST_ROW >> 20
            )));
        }
        let count = self.input.read(bytes)?;
        self.read.set(self.read.get() + count);
        Ok(count)
    }
}

/// Reads rows and writes them with their values. A kernel without arguments has one row, which
/// needs no input.
fn table(kernel: &impl Evaluation, input: impl io::Read, output: &mut dyn Write) -> io::Result<Status> {
    if kernel.arguments().is_empty() {
        let mut writer = csv::Writer::from_writer(output);
        writer.write_record(header(kernel))?;
        let mut undecided = Undecided::default();
        writer.write_record(undecided.note(kernel.values(&[]), 1))?;
        writer.flush()?;
        undecided.report(kernel.name());
        return Ok(Status::AsStated);
    }
    rows(kernel, input, output)
}

/// Reads rows and writes them with their values, up to the first malformed row.
fn rows(kernel: &impl Evaluation, input: impl io::Read, output: &mut dyn Write) -> io::Result<Status> {
    let rows = Bounded::new(input);
    let begin_row = rows.counter();
    let mut reader = csv::ReaderBuilder::new().flexible(true).trim(csv::Trim::All).from_reader(rows);
    let columns = match reader.headers().map_err(|error| unreadable(&error)).and_then(|h| columns(kernel, h))
    {
        Ok(columns) => columns,
        Err(message) => return Ok(refuse(&format!("{message}\n --> {INPUT}:1"))),
    };
    let mut writer = csv::Writer::from_writer(output);
    writer.write_record(header(kernel))?;
    let mut record = csv::StringRecord::new();
    let (mut unread, mut undecided) = (0, Undecided::default());
    loop {
        begin_row.set(0);
        unread += u64::from(Output::is_gone());
        if unread > MOST_UNREAD_ROWS {
            return Ok(refuse(&format!(
                "the output is closed, and the input has more than {MOST_UNREAD_ROWS} further rows"
            )));
        }
        let row = match reader.read_record(&mut record) {
            Ok(false) => break,
            Ok(true) => arguments(kernel, &columns, &record),
            Err(error) => Err(unreadable(&error)),
        };
        match row {
            Ok(_) if Output::is_gone() => {}
            Ok(arguments) => {
                let line = record.position().map_or(0, csv::Position::line);
                let values = undecided.note(kernel.values(&arguments), line);
                let written = arguments.iter().map(|argument| kernel.written(argument));
                writer.write_record(written.chain(values))?;
            }
            Err(message) => {
                writer.flush()?;
                let line = record.position().map_or(reader.position().line(), csv::Position::line);
                return Ok(refuse(&format!("{message}\n --> {INPUT}:{line}")));
            }
        }
    }
    writer.flush()?;
    undecided.report(kernel.name());
    Ok(Status::AsStated)
}

fn unreadable(error: &csv::Error) -> String {
    match error.kind() {
        csv::ErrorKind::Utf8 { .. } => "the input is not UTF-8 text".to_string(),
        csv::ErrorKind::Io(error) => format!("cannot read the input: {error}"),
        _ => format!("cannot read the input: {error}"),
    }
}

/// Returns the column of each argument of the kernel.
fn columns(kernel: &impl Evaluation, header: &csv::StringRecord) -> Result<Vec<usize>, String> {
    let wanted = || kernel.arguments().join(", ");
    let header: Vec<&str> = header.iter().map(|name| name.trim_start_matches('\u{feff}')).collect();
    if header.is_empty() {
        return Err(format!("the input has no header; expected the columns {}", wanted()));
    }
    for (place, name) in header.iter().enumerate() {
        if !kernel.arguments().iter().any(|argument| argument == name) {
            let (kernel, wanted) = (kernel.name(), wanted());
            return Err(format!("`{name}` is not an argument of `{kernel}`; expected the columns {wanted}"));
        }
        if header[..place].contains(name) {
            return Err(format!("the column `{name}` occurs twice"));
        }
    }
    let column = |argument: &String| {
        let place = header.iter().position(|name| name == argument);
        place.ok_or_else(|| format!("the column `{argument}` is missing; expected {}", wanted()))
    };
    kernel.arguments().iter().map(column).collect()
}

/// Parses the kernel's arguments from one row.
fn arguments<K: Evaluation>(
    kernel: &K,
    columns: &[usize],
    row: &csv::StringRecord,
) -> Result<Vec<K::Number>, String> {
    if row.len() != columns.len() {
        let expected = forms::core::diagnostic::counted(columns.len(), "number");
        return Err(format!("expected {expected} in this row, found {}", row.len()));
    }
    let named = kernel.arguments().iter().zip(columns);
    named
        .map(|(name, &column)| {
            let text = &row[column];
            kernel.read(text).map_err(|unread| unread.message(name, text))
        })
        .collect()
}

/// Returns the column names: the arguments, then the kernel's name, or `NAME_0`, `NAME_1`, … if it
/// has several values. The entries of an array have names such as `p_0` and `NAME_1_2`.
fn header(kernel: &impl Evaluation) -> Vec<String> {
    let mut names = kernel.arguments().to_vec();
    names.extend(kernel.columns());
    names
}
