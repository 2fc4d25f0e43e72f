//! Check that all columns of a batch have the same length.

use core::fmt;

/// Column of a batch, by its position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Column {
    /// Column of the arguments, from 0.
    Argument(usize),
    /// Column of the outputs, from 0.
    Output(usize),
}

/// Error: the length of a column differs from the first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LengthMismatch {
    /// The column.
    pub column: Column,
    /// Length of the first column.
    pub expected: usize,
    /// Length of this column.
    pub found: usize,
}

impl fmt::Display for LengthMismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (kind, position) = match self.column {
            Column::Argument(position) => ("argument", position),
            Column::Output(position) => ("output", position),
        };
        let Self { expected, found, .. } = self;
        write!(f, "column {position} of the {kind}s has {found} values where the first column has {expected}")
    }
}

impl core::error::Error for LengthMismatch {}

/// Returns the length of the first column.
pub(super) fn of<E>(columns: &[&[E]], outputs: &[&mut [E]]) -> usize {
    columns.first().map(|column| column.len()).or(outputs.first().map(|output| output.len())).unwrap_or(0)
}

/// Returns the common length of all columns.
pub(super) fn common<E>(columns: &[&[E]], outputs: &[&mut [E]]) -> Result<usize, LengthMismatch> {
    let expected = of(columns, outputs);
    let arguments =
        columns.iter().enumerate().map(|(position, column)| (Column::Argument(position), column.len()));
    let values =
        outputs.iter().enumerate().map(|(position, output)| (Column::Output(position), output.len()));
    match arguments.chain(values).find(|(_, found)| *found != expected) {
        Some((column, found)) => Err(LengthMismatch { column, expected, found }),
        None => Ok(expected),
    }
}
