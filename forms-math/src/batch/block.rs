//! A block of rows: the loop that is vectorised, and what stands around it.

use super::method::{Element, Method};

/// The most rows that are computed at once: so many that what it costs to begin is little beside them.
pub(super) const BLOCK: usize = 256;

/// The rows of a block are a multiple of this: some vectors of the widest kind, so that the loop over them has no remainder.
pub(super) const STEP: usize = 32;

/// The arguments of a block: columns with at least its rows.
pub(super) type Arguments<'a, E, const A: usize> = [&'a [E]; A];

/// The values of a block.
pub(super) type Values<E, const O: usize> = [[E; BLOCK]; O];

/// What computes so many rows of a block, and says whether lanes may have given up in it.
pub(super) type Kernel<M, E, const A: usize, const O: usize> =
    unsafe fn(M, &Arguments<'_, E, A>, usize, &mut Values<E, O>) -> bool;

/// Has the function that this is inlined into align its frame to the widest vector. The compiler does so for a local that asks for
/// it, and not for vectors that registers have no room for: those would be loaded and stored across two lines of the cache,
/// depending on where the stack happens to begin. Without functions a formula needs few registers.
#[inline(always)]
fn align_frame() {
    #[repr(align(64))]
    struct Vector {
        _byte: u8,
    }
    std::hint::black_box(&mut Vector { _byte: 0 });
}

/// The method in every row. The values are one parameter, so that the compiler knows that they are not also arguments.
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
    // What the compiler has to know for a loop without a remainder and without checks.
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

/// Whether one of the values is NaN. A loop of its own: within the loop over the rows it would hold on to what the next
/// rows can begin without.
#[inline(always)]
fn has_nan<E: Element>(values: &[E]) -> bool {
    values.iter().fold(E::Bits::default(), |found, value| found | value.nan_bits()) != E::Bits::default()
}

/// The values of a block, with those that lanes give up on.
#[inline(always)]
pub(super) fn compute<M: Method<E, A, O>, E: Element, const A: usize, const O: usize>(
    method: M,
    kernel: Kernel<M, E, A, O>,
    columns: &Arguments<'_, E, A>,
    rows: usize,
    values: &mut Values<E, O>,
) {
    // SAFETY: `Instructions` chose the kernel, and is made only of what the processor has.
    if unsafe { kernel(method, columns, rows, values) } {
        again(method, columns, rows, values);
    }
}

/// Rows with a NaN, in one number.
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

/// Makes the fewest rows of a block begin with these, filled up with the last.
pub(super) fn fill<'b, E: Element>(block: &'b mut [E; STEP], rows: &[E]) -> &'b [E] {
    let (first, rest) = block.split_at_mut(rows.len());
    first.copy_from_slice(rows);
    rest.fill(rows.last().copied().unwrap_or_default());
    block
}

/// The block from there on of the only output, so that it needs no copy; none where there are more.
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
