//! Batches of kernels over the rows of a matrix of `ndarray`, which generated code calls.

use forms_math::{Formula, LengthMismatch, batch, batch_within};
use ndarray::{ArrayView2, ArrayViewMut2};

/// Matrix library of [`batch_rows`].
pub use ndarray;

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

#[cfg(test)]
mod tests {
    use super::*;
    use forms_math::{Column, Real};
    use ndarray::{Array2, ShapeBuilder};

    /// Sum, difference and product of two numbers.
    struct Pair;

    impl Formula<2, 3> for Pair {
        #[inline(always)]
        fn value<T: Real>([x, y]: [T; 2]) -> [T; 3] {
            [x + y, x - y, x * y]
        }
    }

    #[test]
    fn rows_of_a_matrix_are_rows_of_a_batch() {
        let argument = |(row, column): (usize, usize)| (row as f64 + 0.1).sin() * (column + 1) as f64;
        let [first, second]: [Vec<f64>; 2] =
            [0, 1].map(|column| (0..300).map(|row| argument((row, column))).collect());
        let mut serial: [Vec<f64>; 3] = std::array::from_fn(|_| vec![0.0; 300]);
        batch::<Pair, 2, 3>([&first, &second], serial.each_mut().map(|output| &mut output[..]))
            .expect("one length");
        let in_rows = Array2::from_shape_fn((300, 2), argument);
        let in_columns = Array2::from_shape_fn((300, 2).f(), argument);
        for arguments in [in_rows, in_columns] {
            let mut outputs = Array2::zeros((300, 3));
            batch_rows::<Pair, 2, 3>(arguments.view(), outputs.view_mut()).expect("the matrices fit");
            assert!(outputs.indexed_iter().all(|((row, column), value)| *value == serial[column][row]));
        }
    }

    #[test]
    fn matrices_that_do_not_match_the_formula_are_an_error() {
        let found = |arguments: (usize, usize), outputs: (usize, usize)| {
            let (arguments, mut outputs) = (Array2::zeros(arguments), Array2::zeros(outputs));
            batch_rows::<Pair, 2, 3>(arguments.view(), outputs.view_mut())
        };
        let columns = RowsMismatch::Columns { expected: [2, 3], found: [2, 2] };
        assert_eq!(found((4, 2), (4, 2)), Err(columns));
        let mismatch = LengthMismatch { column: Column::Output(0), expected: 4, found: 5 };
        assert_eq!(found((4, 2), (5, 3)), Err(RowsMismatch::Rows(mismatch)));
    }
}
