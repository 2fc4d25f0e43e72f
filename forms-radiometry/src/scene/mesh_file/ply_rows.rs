//! PLY data: parses the rows after a PLY header, in text or binary format, into numbers.

use super::Fault;
use super::ply_header::{Element, Format, Scalar};
use super::words::{Word, extent, words};
use forms::core::diagnostic::counted;
use std::ops::Range;

/// What is missing in a file that ends too early.
const DECLARED: &str = "as many rows as the header declares";

/// A sequence of rows of numbers.
pub(super) trait Rows {
    /// Begins the next row.
    fn begin(&mut self, element: &Element, row: u64) -> Result<(), Stop>;
    /// Returns the next number of the row.
    fn number(&mut self, scalar: Scalar) -> Result<f64, Stop>;
    /// Whether the row has more numbers.
    fn has_more(&self) -> bool;
    /// Returns what follows the last row: "3 lines", "20 bytes"; `None` if nothing does.
    fn rest(&mut self) -> Option<String>;
    /// Returns the place of the last number, or of the declaration of its element.
    fn place(&self) -> Range<usize>;
    /// Returns the place of the whole row.
    fn row_place(&self) -> Range<usize>;
    /// Returns the prefix of messages that identifies the row where the place alone does not.
    fn prefix(&self) -> String;
}

/// The reason why a row was not read, and whether reading stops there.
pub(super) struct Stop {
    pub(super) fault: Fault,
    pub(super) for_good: bool,
}

/// Rows in text format, one for each line.
pub(super) struct TextRows<'t, L> {
    lines: L,
    row: Vec<Word<'t>>,
    next: usize,
    end_of_text: usize,
}

impl<'t, L: Iterator<Item = (usize, &'t str)>> TextRows<'t, L> {
    pub(super) fn new(lines: L, end_of_text: usize) -> Self {
        Self { lines, row: Vec::new(), next: 0, end_of_text }
    }
}

fn passing(fault: Fault) -> Stop {
    Stop { fault, for_good: false }
}

impl<'t, L: Iterator<Item = (usize, &'t str)>> Rows for TextRows<'t, L> {
    fn begin(&mut self, element: &Element, row: u64) -> Result<(), Stop> {
        self.next = 0;
        for (start, line) in self.lines.by_ref() {
            self.row = words(start, line).collect();
            if !self.row.is_empty() {
                return Ok(());
            }
        }
        let message = format!("the file ends before {} {} of {}", element.name, row + 1, element.rows);
        Err(Stop { fault: Fault::new(self.end_of_text..self.end_of_text, message, DECLARED), for_good: true })
    }

    fn number(&mut self, scalar: Scalar) -> Result<f64, Stop> {
        let Some(word) = self.row.get(self.next) else {
            let place = self.row_place();
            return Err(passing(Fault::new(
                place.end..place.end,
                "the line has too few numbers",
                "another number",
            )));
        };
        self.next += 1;
        if matches!(scalar, Scalar::F32 | Scalar::F64) {
            return word.float().map_err(passing);
        }
        let whole = word.whole().map_err(passing)?;
        let (low, high) = scalar.range();
        if !(low..=high).contains(&whole) {
            let message = format!("{whole} is out of range for its type");
            let expected = format!("an integer from {low} to {high}");
            return Err(passing(Fault::new(word.range.clone(), message, expected)));
        }
        Ok(whole as f64)
    }

    fn has_more(&self) -> bool {
        self.next < self.row.len()
    }

    fn rest(&mut self) -> Option<String> {
        let lines = self.lines.by_ref().filter(|(_, line)| !line.trim().is_empty()).count();
        (lines > 0).then(|| counted(lines, "line"))
    }

    fn place(&self) -> Range<usize> {
        self.row.get(self.next.saturating_sub(1)).map_or(0..0, |word| word.range.clone())
    }

    fn row_place(&self) -> Range<usize> {
        extent(&self.row)
    }

    fn prefix(&self) -> String {
        String::new()
    }
}

/// Rows in binary format. Places are those of the element's declaration in the header, since bytes
/// cannot be quoted.
pub(super) struct ByteRows<'b> {
    bytes: &'b [u8],
    next: usize,
    is_big_endian: bool,
    place: Range<usize>,
    row: String,
}

impl<'b> ByteRows<'b> {
    /// Creates the rows that start at a byte of a file.
    pub(super) fn new(bytes: &'b [u8], from: usize, format: Format) -> Self {
        let is_big_endian = format == Format::BigEndian;
        Self { bytes, next: from, is_big_endian, place: 0..0, row: String::new() }
    }

    fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        let taken: &[u8; N] = self.bytes.get(self.next..)?.first_chunk()?;
        self.next += N;
        let mut bytes = *taken;
        if self.is_big_endian {
            bytes.reverse();
        }
        Some(bytes)
    }
}

impl Rows for ByteRows<'_> {
    fn begin(&mut self, element: &Element, row: u64) -> Result<(), Stop> {
        self.place = element.place.clone();
        self.row = format!("{} {} (byte {}): ", element.name, row + 1, self.next);
        Ok(())
    }

    fn number(&mut self, scalar: Scalar) -> Result<f64, Stop> {
        let number = match scalar {
            Scalar::I8 => self.take().map(|b| f64::from(i8::from_le_bytes(b))),
            Scalar::U8 => self.take().map(|b| f64::from(u8::from_le_bytes(b))),
            Scalar::I16 => self.take().map(|b| f64::from(i16::from_le_bytes(b))),
            Scalar::U16 => self.take().map(|b| f64::from(u16::from_le_bytes(b))),
            Scalar::I32 => self.take().map(|b| f64::from(i32::from_le_bytes(b))),
            Scalar::U32 => self.take().map(|b| f64::from(u32::from_le_bytes(b))),
            Scalar::F32 => self.take().map(|b| f64::from(f32::from_le_bytes(b))),
            Scalar::F64 => self.take().map(f64::from_le_bytes),
        };
        number.ok_or_else(|| {
            let message = format!("{}the file ends within this row", self.row);
            Stop { fault: Fault::new(self.place.clone(), message, DECLARED), for_good: true }
        })
    }

    fn has_more(&self) -> bool {
        false
    }

    fn rest(&mut self) -> Option<String> {
        let rest = self.bytes[self.next..].trim_ascii();
        (!rest.is_empty()).then(|| counted(rest.len(), "byte"))
    }

    fn place(&self) -> Range<usize> {
        self.place.clone()
    }

    fn row_place(&self) -> Range<usize> {
        self.place.clone()
    }

    fn prefix(&self) -> String {
        self.row.clone()
    }
}

impl Scalar {
    /// Returns the smallest and the largest integer of a type.
    fn range(self) -> (i64, i64) {
        match self {
            Self::I8 => (i8::MIN.into(), i8::MAX.into()),
            Self::U8 => (0, u8::MAX.into()),
            Self::I16 => (i16::MIN.into(), i16::MAX.into()),
            Self::U16 => (0, u16::MAX.into()),
            Self::I32 => (i32::MIN.into(), i32::MAX.into()),
            Self::U32 => (0, u32::MAX.into()),
            Self::F32 | Self::F64 => (i64::MIN, i64::MAX),
        }
    }
}
