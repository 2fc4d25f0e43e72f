//! A formula over columns of arguments.
//!
//! ```text
//! columns ─▶ length checked ─▶ blocks of rows ─▶ lanes, by the best available instructions ─▶ outputs
//!                                                          └─ rows with a NaN ─▶ the formula in one number ─┘
//! ```
//! Every row is computed by the same instructions at every position; if there are fewer rows than a
//! vector holds, it is filled with copies of the last row. Therefore the value of a row does not
//! depend on the rows next to it. A NaN from a lane function for an argument outside its range is
//! recomputed, so that a NaN in an output is a NaN of the formula.

mod block;
mod compiled;
mod length;
mod method;

use crate::escalate::beyond_lane_computed;
use crate::instructions::Instructions;
use crate::lane::{Bounded, in_fused_lanes};
use crate::{Computation, Formula};
use alloc::vec::Vec;
use block::{Kernel, STEP};
use core::ops::Range;
pub use length::{Column, LengthMismatch};
use method::{BLOCK, Element, Plain};
use method::{Method, Within, WithinDouble};

/// Computes the values of a formula in `f64`, one row for each position of the columns.
///
/// # Errors
/// If the length of a column differs from the first.
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

/// Computes [`batch`] in `f32`.
///
/// # Errors
/// If the length of a column differs from the first.
pub fn batch_f32<F: Formula<A, O>, const A: usize, const O: usize>(
    columns: [&[f32]; A],
    outputs: [&mut [f32]; O],
) -> Result<(), LengthMismatch> {
    batch_f32_by::<F, A, O>(Instructions::best(), columns, outputs)
}

/// Computes [`batch`] with given instructions: to measure them, or for the same bits on all
/// processors that have them.
///
/// # Errors
/// If the length of a column differs from the first.
pub fn batch_by<F: Formula<A, O>, const A: usize, const O: usize>(
    instructions: Instructions,
    columns: [&[f64]; A],
    outputs: [&mut [f64]; O],
) -> Result<(), LengthMismatch> {
    length::common(&columns, &outputs)?;
    over_blocks(Plain::<F>::new(), instructions, columns, outputs);
    Ok(())
}

/// Computes [`batch_f32`] with given instructions.
///
/// # Errors
/// If the length of a column differs from the first.
pub fn batch_f32_by<F: Formula<A, O>, const A: usize, const O: usize>(
    instructions: Instructions,
    columns: [&[f32]; A],
    outputs: [&mut [f32]; O],
) -> Result<(), LengthMismatch> {
    length::common(&columns, &outputs)?;
    over_blocks(Plain::<F>::new(), instructions, columns, outputs);
    Ok(())
}

/// Computes the values of a formula within a relative error of `within` · 2⁻⁵³, like
/// [`escalate`](crate::escalate): lanes compute error bounds, and rows whose bound is insufficient
/// are escalated.
///
/// # Errors
/// If the length of a column differs from the first.
pub fn batch_within<F: Formula<A, O>, const A: usize, const O: usize>(
    columns: [&[f64]; A],
    outputs: [&mut [f64]; O],
    within: f64,
) -> Result<(), LengthMismatch> {
    batch_within_by::<F, A, O>(Instructions::best(), columns, outputs, within)
}

/// Computes [`batch_within`] with given instructions.
///
/// # Errors
/// If the length of a column differs from the first.
pub fn batch_within_by<F: Formula<A, O>, const A: usize, const O: usize>(
    instructions: Instructions,
    columns: [&[f64]; A],
    outputs: [&mut [f64]; O],
    within: f64,
) -> Result<(), LengthMismatch> {
    length::common(&columns, &outputs)?;
    over_blocks(Within::<F>::new(within), instructions, columns, outputs);
    Ok(())
}

/// Computes [`without_escalation`](crate::without_escalation) of each row.
///
/// # Errors
/// If the length of a column differs from the first.
pub fn batch_without_escalation<F: Formula<A, O>, const A: usize, const O: usize>(
    columns: [&[f64]; A],
    outputs: [&mut [f64]; O],
    within: f64,
) -> Result<(), LengthMismatch> {
    length::common(&columns, &outputs)?;
    over_blocks(WithinDouble(Within::<F>::new(within)), Instructions::best(), columns, outputs);
    Ok(())
}

/// Computes one row as [`batch_within`] does, for a formula that is known only at run time.
pub fn row_within(
    computation: &impl Computation,
    arguments: &[f64],
    outputs: usize,
    within: f64,
) -> Vec<f64> {
    let values = in_fused_lanes(computation, arguments);
    let values: Vec<f64> = values.into_iter().map(|value| value.value_within(within)).collect();
    if values.iter().any(|value| value.is_nan()) {
        let values = beyond_lane_computed(computation, arguments, outputs, within);
        return values.into_iter().map(|(value, _)| value).collect();
    }
    values
}

/// Returns the bounds that lanes with fused multiply-add show for the relative errors, in units of
/// 2⁻⁵³; ∞ where they show none.
pub fn bounds_in_lanes(computation: &impl Computation, arguments: &[f64]) -> Vec<f64> {
    in_fused_lanes(computation, arguments).into_iter().map(Bounded::units).collect()
}

/// Computes [`batch`] on all processors.
///
/// # Errors
/// If the length of a column differs from the first.
#[cfg(feature = "rayon")]
pub fn batch_parallel<F: Formula<A, O>, const A: usize, const O: usize>(
    columns: [&[f64]; A],
    outputs: [&mut [f64]; O],
) -> Result<(), LengthMismatch> {
    let length = length::common(&columns, &outputs)?;
    parallel::over_shares(columns, outputs, length, &|columns, outputs| {
        over_blocks(Plain::<F>::new(), Instructions::best(), columns, outputs);
    });
    Ok(())
}

/// Computes [`batch_within`] on all processors.
///
/// # Errors
/// If the length of a column differs from the first.
#[cfg(feature = "rayon")]
pub fn batch_within_parallel<F: Formula<A, O>, const A: usize, const O: usize>(
    columns: [&[f64]; A],
    outputs: [&mut [f64]; O],
    within: f64,
) -> Result<(), LengthMismatch> {
    let length = length::common(&columns, &outputs)?;
    parallel::over_shares(columns, outputs, length, &|columns, outputs| {
        over_blocks(Within::<F>::new(within), Instructions::best(), columns, outputs);
    });
    Ok(())
}

/// Computes [`batch_f32`] on all processors.
///
/// # Errors
/// If the length of a column differs from the first.
#[cfg(feature = "rayon")]
pub fn batch_f32_parallel<F: Formula<A, O>, const A: usize, const O: usize>(
    columns: [&[f32]; A],
    outputs: [&mut [f32]; O],
) -> Result<(), LengthMismatch> {
    let length = length::common(&columns, &outputs)?;
    parallel::over_shares(columns, outputs, length, &|columns, outputs| {
        over_blocks(Plain::<F>::new(), Instructions::best(), columns, outputs);
    });
    Ok(())
}

#[cfg(feature = "rayon")]
mod parallel;

/// Evaluates columns of the same length block by block.
fn over_blocks<M: Method<E, A, O>, E: Element, const A: usize, const O: usize>(
    method: M,
    instructions: Instructions,
    columns: [&[E]; A],
    mut outputs: [&mut [E]; O],
) {
    let kernel = instructions.kernel::<M, E, A, O>();
    let length = length::of(&columns, &outputs);
    let whole = length / STEP * STEP;
    for start in (0..whole).step_by(BLOCK) {
        let rows = BLOCK.min(whole - start);
        let block = from(&columns, start);
        if let Some(place) = block::in_place(&mut outputs, start) {
            block::compute(method, kernel, &block, rows, place);
        } else {
            copied(method, kernel, &block, rows, &mut outputs, start..start + rows);
        }
    }
    if whole < length {
        last_rows(method, kernel, columns, &mut outputs, length);
    }
}

/// Evaluates the rows that do not fill a vector: together with some of the rows before, which are
/// computed again, or with copies of the last row. It is a separate function so that larger batches
/// do not touch the stack for its copies.
#[inline(never)]
fn last_rows<M: Method<E, A, O>, E: Element, const A: usize, const O: usize>(
    method: M,
    kernel: Kernel<M, E, A, O>,
    columns: [&[E]; A],
    outputs: &mut [&mut [E]; O],
    length: usize,
) {
    if let Some(start) = length.checked_sub(STEP) {
        return copied(method, kernel, &from(&columns, start), STEP, outputs, start..length);
    }
    let mut filled = [[E::default(); STEP]; A];
    let mut block = columns;
    for (column, filled) in block.iter_mut().zip(&mut filled) {
        *column = block::fill(filled, column);
    }
    copied(method, kernel, &block, STEP, outputs, 0..length);
}

/// Returns the columns from a row on. `map` is avoided, since it is a call that copies all columns.
fn from<'a, E, const A: usize>(columns: &[&'a [E]; A], start: usize) -> block::Arguments<'a, E, A> {
    let mut rest = *columns;
    for column in &mut rest {
        *column = &column[start..];
    }
    rest
}

/// Computes the values of this number of rows; the first of them go to these rows of the outputs.
#[inline(never)]
fn copied<M: Method<E, A, O>, E: Element, const A: usize, const O: usize>(
    method: M,
    kernel: Kernel<M, E, A, O>,
    block: &block::Arguments<'_, E, A>,
    rows: usize,
    outputs: &mut [&mut [E]; O],
    to: Range<usize>,
) {
    let mut values = [*E::ZEROS; O];
    block::compute(method, kernel, block, rows, &mut values);
    for (output, values) in outputs.iter_mut().zip(&values) {
        output[to.clone()].copy_from_slice(&values[..to.len()]);
    }
}
