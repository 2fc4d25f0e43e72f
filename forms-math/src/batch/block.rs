//! A block of rows: the loop that is vectorised, and what stands around it.

use crate::{Formula, Lane32, Lane64, Real};
use std::ops::BitOr;

/// The rows that are computed at once: many vectors of the widest kind, so that the loop over them has no remainder, and
/// what it costs to begin is little beside it.
pub(super) const BLOCK: usize = 256;

/// A number of a column, and the lane it is computed in.
pub(super) trait Element: Real + Default + Send + Sync + 'static {
    /// A block of zeros.
    const ZEROS: &'static [Self; BLOCK];
    /// A whole number as wide as this, so that as many go into a vector.
    type Bits: Copy + Default + Eq + BitOr<Output = Self::Bits>;
    /// The lane, with or without fused multiply-add.
    type Lane<const FMA: bool>: Real;
    /// In the lane.
    fn lane<const FMA: bool>(self) -> Self::Lane<FMA>;
    /// Out of the lane.
    fn of<const FMA: bool>(lane: Self::Lane<FMA>) -> Self;
    /// Whether this is NaN.
    fn is_nan(self) -> bool;
    /// All bits where this is NaN, none elsewhere.
    fn nan_bits(self) -> Self::Bits;
}

macro_rules! element {
    ($raw:ident, $lane:ident, $bits:ident) => {
        impl Element for $raw {
            const ZEROS: &'static [Self; BLOCK] = &[0.0; BLOCK];
            type Bits = $bits;
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
            #[inline(always)]
            fn nan_bits(self) -> $bits {
                $bits::from(self.is_nan()).wrapping_neg()
            }
        }
    };
}

element!(f64, Lane64, u64);
element!(f32, Lane32, u32);

/// The arguments of a block.
pub(super) type Arguments<'a, E, const A: usize> = [&'a [E; BLOCK]; A];

/// The values of a block.
pub(super) type Values<E, const O: usize> = [[E; BLOCK]; O];

/// What computes a block, and says whether lanes may have given up in it.
pub(super) type Kernel<E, const A: usize, const O: usize> =
    unsafe fn(&Arguments<'_, E, A>, &mut Values<E, O>) -> bool;

/// The formula in every row. The values are one parameter, so that the compiler knows that they are not also arguments.
#[inline(always)]
pub(super) fn rows_of<E: Element, F: Formula<A, O>, const FMA: bool, const A: usize, const O: usize>(
    columns: &Arguments<'_, E, A>,
    values: &mut Values<E, O>,
) -> bool {
    let mut found = E::Bits::default();
    for row in 0..BLOCK {
        let mut arguments = [E::default().lane::<FMA>(); A];
        for (argument, column) in arguments.iter_mut().zip(columns) {
            *argument = column[row].lane::<FMA>();
        }
        for (value, result) in values.iter_mut().zip(F::value(arguments)) {
            value[row] = E::of::<FMA>(result);
            if F::MAY_GIVE_UP {
                found = found | value[row].nan_bits();
            }
        }
    }
    found != E::Bits::default()
}

/// The values of a block, with those that lanes give up on.
#[inline(always)]
pub(super) fn compute<E: Element, F: Formula<A, O>, const A: usize, const O: usize>(
    kernel: Kernel<E, A, O>,
    columns: &Arguments<'_, E, A>,
    values: &mut Values<E, O>,
) {
    // SAFETY: `Instructions` chose the kernel, and is made only of what the processor has.
    if unsafe { kernel(columns, values) } {
        again::<E, F, A, O>(columns, values);
    }
}

/// Rows with a NaN, in one number.
#[cold]
#[inline(never)]
fn again<E: Element, F: Formula<A, O>, const A: usize, const O: usize>(
    columns: &Arguments<'_, E, A>,
    values: &mut Values<E, O>,
) {
    for row in 0..BLOCK {
        if values.iter().any(|column| column[row].is_nan()) {
            let again = F::value(columns.map(|column| column[row]));
            for (column, value) in values.iter_mut().zip(again) {
                column[row] = value;
            }
        }
    }
}

/// A block that begins with these rows, filled up with the last.
pub(super) fn filled<E: Element>(rows: &[E]) -> [E; BLOCK] {
    let mut block = [rows.last().copied().unwrap_or_default(); BLOCK];
    for (place, row) in block.iter_mut().zip(rows) {
        *place = *row;
    }
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
