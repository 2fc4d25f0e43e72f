//! A formula over columns of arguments.
//!
//! ```text
//! columns ─▶ length checked ─▶ blocks of BLOCK rows ─▶ lanes, by the best instructions there are ─▶ outputs
//!                                                          └─ rows with a NaN ─▶ the formula in one number ─┘
//! ```
//! Every row goes through the same instructions wherever it stands, the last block being filled up by copies of its last
//! row: the value of a row does not depend on the rows beside it. A NaN that a function of lanes gives for an argument out
//! of its reach is computed again, so that what is NaN in an output is NaN by the formula.

mod block;
mod instructions;
mod length;
#[cfg(feature = "ndarray")]
mod rows;
#[cfg(test)]
mod tests;

use crate::Formula;
use block::{BLOCK, Element};
pub use instructions::Instructions;
pub use length::{Column, LengthMismatch};
#[cfg(feature = "ndarray")]
pub use rows::batch_rows;

/// The values of a formula in `f64`, one row at each position of the columns.
///
/// # Errors
/// Where a column's length is not that of the first.
///
/// ```
/// use forms_math::{Formula, Real, batch};
/// /// The length of the vector (x, y).
/// struct Length;
/// impl Formula<2, 1> for Length {
///     #[inline(always)]
///     fn value<T: Real>([x, y]: [T; 2]) -> [T; 1] {
///         [x.mul_add(x, y * y).sqrt()]
///     }
/// }
/// let mut lengths = [0.0; 3];
/// batch::<Length, 2, 1>([&[3.0, 5.0, 8.0], &[4.0, 12.0, 15.0]], [&mut lengths])?;
/// assert_eq!(lengths, [5.0, 13.0, 17.0]);
/// # Ok::<(), forms_math::LengthMismatch>(())
/// ```
pub fn batch<F: Formula<A, O>, const A: usize, const O: usize>(
    columns: [&[f64]; A],
    outputs: [&mut [f64]; O],
) -> Result<(), LengthMismatch> {
    batch_by::<F, A, O>(Instructions::best(), columns, outputs)
}

/// [`batch`] in `f32`.
///
/// # Errors
/// Where a column's length is not that of the first.
pub fn batch_f32<F: Formula<A, O>, const A: usize, const O: usize>(
    columns: [&[f32]; A],
    outputs: [&mut [f32]; O],
) -> Result<(), LengthMismatch> {
    batch_f32_by::<F, A, O>(Instructions::best(), columns, outputs)
}

/// [`batch`] with given instructions: to measure them, or for the same bits on all processors that have them.
///
/// # Errors
/// Where a column's length is not that of the first.
pub fn batch_by<F: Formula<A, O>, const A: usize, const O: usize>(
    instructions: Instructions,
    columns: [&[f64]; A],
    outputs: [&mut [f64]; O],
) -> Result<(), LengthMismatch> {
    length::common(&columns, &outputs)?;
    over_blocks::<f64, F, A, O>(instructions, columns, outputs);
    Ok(())
}

/// [`batch_f32`] with given instructions.
///
/// # Errors
/// Where a column's length is not that of the first.
pub fn batch_f32_by<F: Formula<A, O>, const A: usize, const O: usize>(
    instructions: Instructions,
    columns: [&[f32]; A],
    outputs: [&mut [f32]; O],
) -> Result<(), LengthMismatch> {
    length::common(&columns, &outputs)?;
    over_blocks::<f32, F, A, O>(instructions, columns, outputs);
    Ok(())
}

/// [`batch`] on all processors.
///
/// # Errors
/// Where a column's length is not that of the first.
#[cfg(feature = "rayon")]
pub fn batch_parallel<F: Formula<A, O>, const A: usize, const O: usize>(
    columns: [&[f64]; A],
    outputs: [&mut [f64]; O],
) -> Result<(), LengthMismatch> {
    let length = length::common(&columns, &outputs)?;
    parallel::over_shares(columns, outputs, length, &|columns, outputs| {
        over_blocks::<f64, F, A, O>(Instructions::best(), columns, outputs);
    });
    Ok(())
}

/// [`batch_f32`] on all processors.
///
/// # Errors
/// Where a column's length is not that of the first.
#[cfg(feature = "rayon")]
pub fn batch_f32_parallel<F: Formula<A, O>, const A: usize, const O: usize>(
    columns: [&[f32]; A],
    outputs: [&mut [f32]; O],
) -> Result<(), LengthMismatch> {
    let length = length::common(&columns, &outputs)?;
    parallel::over_shares(columns, outputs, length, &|columns, outputs| {
        over_blocks::<f32, F, A, O>(Instructions::best(), columns, outputs);
    });
    Ok(())
}

#[cfg(feature = "rayon")]
mod parallel;

/// Columns of one length, block by block.
fn over_blocks<E: Element, F: Formula<A, O>, const A: usize, const O: usize>(
    instructions: Instructions,
    columns: [&[E]; A],
    mut outputs: [&mut [E]; O],
) {
    let kernel = instructions.kernel::<E, F, A, O>();
    let length = length::of(&columns, &outputs);
    let whole = length - length % BLOCK;
    for start in (0..whole).step_by(BLOCK) {
        let rows = columns.map(|column| block::rows(column, start));
        block::compute::<E, F, A, O>(kernel, &rows, &mut outputs, start, BLOCK);
    }
    if whole < length {
        let filled = columns.map(|column| block::filled(&column[whole..]));
        block::compute::<E, F, A, O>(kernel, &filled.each_ref(), &mut outputs, whole, length - whole);
    }
}
