//! A block of rows: the loop that is vectorised, and what stands around it.

use crate::{Formula, Lane32, Lane64, Real};

/// The rows of a block: a few vectors of the widest kind, so that the loop over them has no remainder.
pub(super) const BLOCK: usize = 64;

/// A number of a column, and the lane it is computed in.
pub(super) trait Element: Real + Default + Send + Sync + 'static {
    /// The lane, with or without fused multiply-add.
    type Lane<const FMA: bool>: Real;
    /// In the lane.
    fn lane<const FMA: bool>(self) -> Self::Lane<FMA>;
    /// Out of the lane.
    fn of<const FMA: bool>(lane: Self::Lane<FMA>) -> Self;
    /// Whether this is NaN.
    fn is_nan(self) -> bool;
}

macro_rules! element {
    ($raw:ident, $lane:ident) => {
        impl Element for $raw {
            type Lane<const FMA: bool> = $lane<FMA>;
            #[inline(always)]
            fn lane<const FMA: bool>(self) -> $lane<FMA> {
                $lane(self)
            }
            #[inline(always)]
            fn of<const FMA: bool>(lane: $lane<FMA>) -> Self {
                lane.0
            }
            #[inline(always)]
            fn is_nan(self) -> bool {
                $raw::is_nan(self)
            }
        }
    };
}

element!(f64, Lane64);
element!(f32, Lane32);

/// The arguments of a block.
pub(super) type Arguments<'a, E, const A: usize> = [&'a [E; BLOCK]; A];

/// What computes a block, and says whether there is a NaN in it.
pub(super) type Kernel<E, const A: usize, const O: usize> =
    unsafe fn(&Arguments<'_, E, A>, &mut [[E; BLOCK]; O]) -> bool;

/// The formula in every row. The outputs are one parameter, so that the compiler knows that they are not also arguments.
#[inline(always)]
pub(super) fn rows_of<E: Element, F: Formula<A, O>, const FMA: bool, const A: usize, const O: usize>(
    columns: &Arguments<'_, E, A>,
    outputs: &mut [[E; BLOCK]; O],
) -> bool {
    for row in 0..BLOCK {
        let mut arguments = [E::default().lane::<FMA>(); A];
        for (argument, column) in arguments.iter_mut().zip(columns) {
            *argument = column[row].lane::<FMA>();
        }
        for (output, value) in outputs.iter_mut().zip(F::value(arguments)) {
            output[row] = E::of::<FMA>(value);
        }
    }
    outputs.iter().flatten().fold(false, |found, value| found | value.is_nan())
}

/// The block of a column that begins there.
#[inline(always)]
pub(super) fn rows<E>(column: &[E], start: usize) -> &[E; BLOCK] {
    column[start..].first_chunk().expect("only whole blocks are taken from a column")
}

/// A block that begins with these rows, filled up with the last.
pub(super) fn filled<E: Element>(rows: &[E]) -> [E; BLOCK] {
    std::array::from_fn(|row| rows[row.min(rows.len() - 1)])
}

/// The values of the first `count` rows of a block to the outputs from `start` on.
#[inline(always)]
pub(super) fn compute<E: Element, F: Formula<A, O>, const A: usize, const O: usize>(
    kernel: Kernel<E, A, O>,
    rows: &Arguments<'_, E, A>,
    outputs: &mut [&mut [E]; O],
    start: usize,
    count: usize,
) {
    let mut values = [[E::default(); BLOCK]; O];
    // SAFETY: `Instructions` chose the kernel, and is made only of what the processor has.
    if unsafe { kernel(rows, &mut values) } {
        again::<E, F, A, O>(rows, &mut values);
    }
    for (output, values) in outputs.iter_mut().zip(&values) {
        output[start..start + count].copy_from_slice(&values[..count]);
    }
}

/// Rows with a NaN, in one number.
#[cold]
#[inline(never)]
fn again<E: Element, F: Formula<A, O>, const A: usize, const O: usize>(
    rows: &Arguments<'_, E, A>,
    values: &mut [[E; BLOCK]; O],
) {
    for row in 0..BLOCK {
        if values.iter().any(|column| column[row].is_nan()) {
            let again = F::value(rows.map(|column| column[row]));
            for (column, value) in values.iter_mut().zip(again) {
                column[row] = value;
            }
        }
    }
}
