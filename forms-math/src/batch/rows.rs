//! Batches over the rows of a matrix.

use super::{LengthMismatch, batch, batch_within};
use crate::Formula;
use ndarray::{ArrayView2, ArrayViewMut2};

/// Computes [`batch`] over rows: row i of `arguments` holds the arguments, and row i of `outputs`
/// receives the values.
///
/// Columns that are contiguous in memory (Fortran order) are used directly, others are copied.
///
/// # Errors
/// If the numbers of columns do not match the formula, or the numbers of rows differ.
pub fn batch_rows<F: Formula<A, O>, const A: usize, const O: usize>(
    arguments: ArrayView2<'_, f64>,
    outputs: ArrayViewMut2<'_, f64>,
) -> Result<(), RowsMismatch> {
    over_columns(arguments, outputs, batch::<F, A, O>)
}

/// Computes [`batch_within`] over rows, like [`batch_rows`].
///
/// # Errors
/// If the numbers of columns do not match the formula, or the numbers of rows differ.
pub fn batch_rows_within<F: Formula<A, O>, const A: usize, const O: usize>(
    arguments: ArrayView2<'_, f64>,
    outputs: ArrayViewMut2<'_, f64>,
    within: f64,
) -> Result<(), RowsMismatch> {
    over_columns(arguments, outputs, |columns, outputs| batch_within::<F, A, O>(columns, outputs, within))
}

/// Evaluates a batch on the columns of matrices.
fn over_columns<const A: usize, const O: usize>(
    arguments: ArrayView2<'_, f64>,
    mut outputs: ArrayViewMut2<'_, f64>,
    batch: impl Fn([&[f64]; A], [&mut [f64]; O]) -> Result<(), LengthMismatch>,
) -> Result<(), RowsMismatch> {
    let found = [arguments.ncols(), outputs.ncols()];
    if found != [A, O] {
        return Err(RowsMismatch::Columns { expected: [A, O], found });
    }
    let columns: [_; A] = std::array::from_fn(|index| column(arguments.column(index)));
    let mut values: [Vec<f64>; O] = std::array::from_fn(|_| vec![0.0; outputs.nrows()]);
    batch(columns.each_ref().map(|column| &column[..]), values.each_mut().map(|value| &mut value[..]))
        .map_err(RowsMismatch::Rows)?;
    for (mut output, values) in outputs.columns_mut().into_iter().zip(values) {
        output.assign(&ndarray::ArrayView1::from(&values));
    }
    Ok(())
}

/// Returns a column as a slice, or a copy of it.
fn column(column: ndarray::ArrayView1<'_, f64>) -> std::borrow::Cow<'_, [f64]> {
    match column.to_slice() {
        Some(slice) => slice.into(),
        None => column.to_vec().into(),
    }
}

/// Error: matrices that do not match a formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RowsMismatch {
    /// The numbers of columns of the arguments and of the outputs do not match.
    Columns {
        /// Numbers of columns of the formula.
        expected: [usize; 2],
        /// Numbers of columns of the matrices.
        found: [usize; 2],
    },
    /// The numbers of rows differ.
    Rows(LengthMismatch),
}

impl std::fmt::Display for RowsMismatch {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Columns { expected, found } => write!(
                f,
                "the formula has {} arguments and {} values, the matrices have {} and {} columns",
                expected[0], expected[1], found[0], found[1]
            ),
            Self::Rows(mismatch) => mismatch.fmt(f),
        }
    }
}

impl std::error::Error for RowsMismatch {}
