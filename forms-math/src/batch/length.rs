//! Columns of a batch have one length.

use std::fmt;

/// A column of a batch, by its position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Column {
    /// Of the arguments, from 0.
    Argument(usize),
    /// Of the outputs, from 0.
    Output(usize),
}

/// A column whose length is not that of the first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LengthMismatch {
    /// Which column.
    pub column: Column,
    /// The length of the first column.
    pub expected: usize,
    /// The length of this one.
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

impl std::error::Error for LengthMismatch {}

/// The length of the first column.
pub(super) fn of<E>(columns: &[&[E]], outputs: &[&mut [E]]) -> usize {
    columns.first().map(|column| column.len()).or(outputs.first().map(|output| output.len())).unwrap_or(0)
}

/// The length of all columns.
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
