//! A block of rows: the vectorised loop, and the code around it.

use super::method::{BLOCK, Element, Method};

/// Divisor of the number of rows of a block: several vectors of the widest kind, so that the loop
/// has no remainder.
pub(super) const STEP: usize = 32;

/// Arguments of a block: columns with at least its rows.
pub(super) type Arguments<'a, E, const A: usize> = [&'a [E]; A];

/// Values of a block.
pub(super) type Values<E, const O: usize> = [[E; BLOCK]; O];

/// Function that computes a number of rows of a block, and returns whether lanes can have given up
/// in it.
pub(super) type Kernel<M, E, const A: usize, const O: usize> =
    unsafe fn(M, &Arguments<'_, E, A>, usize, &mut Values<E, O>) -> bool;

/// Makes the function into which this is inlined align its frame to the widest vector. The compiler
/// does so for a local variable that requires it, but not for spilled vectors: those would be
/// loaded and stored across two cache lines, depending on the start of the stack. Formulas without
/// functions need few registers.
#[inline(always)]
fn align_frame() {
    #[repr(align(64))]
    struct Vector {
        _byte: u8,
    }
    core::hint::black_box(&mut Vector { _byte: 0 });
}

/// Applies the method to every row. The values are a single parameter, so that the compiler knows
/// that they do not alias the arguments.
#[inline(always)]
pub(super) fn rows_of<M: Method<E, A, O>, E: Element, const FMA: bool, const A: usize, const O: usize>(
    method: M,
    columns: &Arguments<'_, E, A>,
    rows: usize,
    values: &mut Values<E, O>,
) -> bool {
    if M::MAY_GIVE_UP {
        align_frame();
    }
    // Facts that the compiler needs for a loop without a remainder and without bounds checks.
    let rows = rows.min(BLOCK) / STEP * STEP;
    let mut columns = *columns;
    for column in &mut columns {
        *column = &column[..rows];
    }
    for row in 0..rows {
        let mut arguments = [E::default(); A];
        for (argument, column) in arguments.iter_mut().zip(columns) {
            *argument = column[row];
        }
        for (value, result) in values.iter_mut().zip(method.in_lanes::<FMA>(arguments)) {
            value[row] = result;
        }
    }
    M::MAY_GIVE_UP && values.iter().any(|values| has_nan(&values[..rows]))
}

/// Whether one of the values is NaN. This is a separate loop: inside the loop over the rows it
/// would delay the start of the next rows.
#[inline(always)]
fn has_nan<E: Element>(values: &[E]) -> bool {
    values.iter().fold(E::Bits::default(), |found, value| found | value.nan_bits()) != E::Bits::default()
}

/// Computes the values of a block, including those on which lanes give up.
#[inline(always)]
pub(super) fn compute<M: Method<E, A, O>, E: Element, const A: usize, const O: usize>(
    method: M,
    kernel: Kernel<M, E, A, O>,
    columns: &Arguments<'_, E, A>,
    rows: usize,
    values: &mut Values<E, O>,
) {
    // SAFETY: `Instructions` chose the kernel, and contains only instructions that the processor
    // supports.
    if unsafe { kernel(method, columns, rows, values) } {
        again(method, columns, rows, values);
    }
}

/// Recomputes rows with a NaN as single numbers.
#[cold]
#[inline(never)]
fn again<M: Method<E, A, O>, E: Element, const A: usize, const O: usize>(
    method: M,
    columns: &Arguments<'_, E, A>,
    rows: usize,
    values: &mut Values<E, O>,
) {
    for row in 0..rows {
        if values.iter().any(|column| column[row].is_nan()) {
            let again = method.in_one_number(columns.map(|column| column[row]));
            for (column, value) in values.iter_mut().zip(again) {
                column[row] = value;
            }
        }
    }
}

/// Fills a block of the smallest size with these rows and copies of the last one.
pub(super) fn fill<'b, E: Element>(block: &'b mut [E; STEP], rows: &[E]) -> &'b [E] {
    let (first, rest) = block.split_at_mut(rows.len());
    first.copy_from_slice(rows);
    rest.fill(rows.last().copied().unwrap_or_default());
    block
}

/// Returns the block of the only output from this row on, so that no copy is needed; `None` if
/// there are several outputs.
#[inline(always)]
pub(super) fn in_place<'a, E, const O: usize>(
    outputs: &'a mut [&mut [E]; O],
    start: usize,
) -> Option<&'a mut Values<E, O>> {
    if O != 1 {
        return None;
    }
    outputs.first_mut()?[start..].as_chunks_mut().0.first_chunk_mut()
}
