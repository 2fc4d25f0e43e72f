//! Writers of view factors: a matrix as CSV, pairs as CSV, or records as JSON.

use crate::arguments::ViewFactorArguments;
use crate::json::write_record;
use forms_radiometry::Row;
use std::io::{self, Write};

/// Writes rows in one of the formats.
pub(super) struct Writer {
    format: Format,
    names: Vec<String>,
    /// The area from which each surface sends light, in m².
    areas: Vec<f64>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Format {
    /// One line for each surface: its factors to all surfaces, their sum, and its area.
    Matrix,
    /// One line for each pair with a factor above zero.
    Pairs,
    /// One object for each pair.
    Records,
}

/// JSON record of a view factor.
#[derive(serde::Serialize)]
struct Record<'a> {
    from: &'a str,
    to: &'a str,
    value: f64,
    error: f64,
    /// Kind of the error.
    kind: &'static str,
    /// Emitting area of `from`.
    area: f64,
}

impl Writer {
    pub(super) fn new(arguments: &ViewFactorArguments, names: Vec<String>, areas: Vec<f64>) -> Self {
        let format = match (arguments.json, arguments.sparse) {
            (true, _) => Format::Records,
            (_, true) => Format::Pairs,
            _ => Format::Matrix,
        };
        Self { format, names, areas }
    }

    pub(super) fn name(&self, surface: usize) -> &str {
        &self.names[surface]
    }

    pub(super) fn areas(&self) -> &[f64] {
        &self.areas
    }

    /// Writes the names of the columns.
    pub(super) fn begin(&self, output: &mut dyn Write) -> io::Result<()> {
        match self.format {
            Format::Matrix => {
                let names = self.names.iter().map(String::as_str);
                record(output, std::iter::once("from").chain(names).chain(["sum", "area"]))
            }
            Format::Pairs => record(output, ["from", "to", "factor", "error"].into_iter()),
            Format::Records => Ok(()),
        }
    }

    /// Writes the row of a surface.
    pub(super) fn row(&self, surface: usize, row: &Row, output: &mut dyn Write) -> io::Result<()> {
        let (from, area) = (self.names[surface].as_str(), self.areas[surface]);
        let pairs = self.names.iter().map(String::as_str).zip(&row.factors);
        match self.format {
            Format::Matrix => {
                let values = row.factors.iter().map(|factor| factor.value).chain([row.sum(), area]);
                record(output, std::iter::once(from.to_owned()).chain(values.map(number)))
            }
            Format::Pairs => {
                for (to, factor) in pairs.filter(|(_, factor)| factor.value > 0.0) {
                    let numbers = [number(factor.value), number(factor.error)];
                    record(output, [from, to, &numbers[0], &numbers[1]].into_iter())?;
                }
                Ok(())
            }
            Format::Records => {
                for (to, factor) in pairs {
                    let (value, error, kind) = (factor.value, factor.error, row.kind.name());
                    write_record(output, &Record { from, to, value, error, kind, area })?;
                }
                Ok(())
            }
        }
    }
}

fn number(value: f64) -> String {
    format!("{value:?}")
}

/// Writes one line of CSV.
fn record<T: AsRef<[u8]>>(output: &mut dyn Write, fields: impl Iterator<Item = T>) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(output);
    writer.write_record(fields)?;
    writer.flush()
}
