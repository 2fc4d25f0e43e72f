//! CSV output: every number of a simulation, one for each line.

use crate::answer::{ErrorKind, Map, Simulation};
use std::fmt::Display;
use std::io::{self, Write};

const HEADER: [&str; 9] = ["receiver", "quantity", "band", "bin", "i", "j", "value", "error", "kind"];

/// Writes the answers, then the cells of the maps, band by band and row by row: cell (i, j) is in
/// column i and row j.
///
/// Fields that do not apply are empty: an answer has no cell, and a single band has no number.
/// Numbers are the shortest that parse to the same `f64`; a cell without a value is `NaN`.
pub fn csv(simulation: &Simulation, output: impl Write) -> io::Result<()> {
    let mut lines = Lines { writer: ::csv::Writer::from_writer(output), number: String::new() };
    lines.writer.write_record(HEADER)?;
    for answer in &simulation.answers {
        lines.begin(&answer.receiver, answer.quantity.name(), [answer.band, answer.bin])?;
        lines.end(None, [answer.value, answer.error], answer.kind)?;
    }
    simulation.maps.iter().try_for_each(|map| lines.map(map))?;
    lines.writer.flush()
}

struct Lines<W: Write> {
    writer: ::csv::Writer<W>,
    /// Buffer for formatting a number.
    number: String,
}

impl<W: Write> Lines<W> {
    fn map(&mut self, map: &Map) -> io::Result<()> {
        let is_single = map.values.len() == 1;
        for (band, (values, errors)) in map.values.iter().zip(&map.errors).enumerate() {
            let band = (!is_single).then_some(band);
            for (cell, (&value, &error)) in values.iter().zip(errors).enumerate() {
                self.begin(&map.receiver, map.quantity.name(), [band, None])?;
                self.end(Some([cell % map.size[0], cell / map.size[0]]), [value, error], map.kind)?;
            }
        }
        Ok(())
    }

    /// Writes the receiver, the quantity, the band and the bin.
    fn begin(&mut self, receiver: &str, quantity: &str, [band, bin]: [Option<usize>; 2]) -> io::Result<()> {
        self.writer.write_field(receiver)?;
        self.writer.write_field(quantity)?;
        self.optional(band)?;
        self.optional(bin)
    }

    /// Writes the cell, the value, the error and the kind of error.
    fn end(&mut self, cell: Option<[usize; 2]>, [value, error]: [f64; 2], kind: ErrorKind) -> io::Result<()> {
        self.optional(cell.map(|[i, _]| i))?;
        self.optional(cell.map(|[_, j]| j))?;
        self.field(format_args!("{value:?}"))?;
        self.field(format_args!("{error:?}"))?;
        self.writer.write_field(kind.name())?;
        self.writer.write_record(None::<&[u8]>).map_err(io::Error::from)
    }

    fn optional(&mut self, number: Option<usize>) -> io::Result<()> {
        match number {
            Some(number) => self.field(number),
            None => self.writer.write_field("").map_err(io::Error::from),
        }
    }

    fn field(&mut self, number: impl Display) -> io::Result<()> {
        use std::fmt::Write;
        self.number.clear();
        write!(self.number, "{number}").expect("a String takes all text");
        self.writer.write_field(&self.number).map_err(io::Error::from)
    }
}
