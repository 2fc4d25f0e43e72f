//! The loop over a block, compiled for each set of instructions: functions that are unsafe to call elsewhere.

use super::block::{Arguments, Kernel, Values, rows_of};
use super::method::{Element, Method};
use crate::instructions::{Instructions, Set};

impl Instructions {
    /// Returns the loop over a block, compiled for these instructions.
    pub(super) fn kernel<M: Method<E, A, O>, E: Element, const A: usize, const O: usize>(
        self,
    ) -> Kernel<M, E, A, O> {
        match self.0 {
            Set::Baseline => baseline::<M, E, A, O>,
            #[cfg(target_arch = "x86_64")]
            Set::Avx2 => avx2::<M, E, A, O>,
            #[cfg(target_arch = "x86_64")]
            Set::Avx512 => avx512::<M, E, A, O>,
        }
    }
}

fn baseline<M: Method<E, A, O>, E: Element, const A: usize, const O: usize>(
    method: M,
    columns: &Arguments<'_, E, A>,
    rows: usize,
    values: &mut Values<E, O>,
) -> bool {
    // NEON has fused multiply-add; on other processors it can be missing, and would be a function
    // call.
    #[cfg(target_arch = "aarch64")]
    return rows_of::<M, E, true, A, O>(method, columns, rows, values);
    #[cfg(not(target_arch = "aarch64"))]
    rows_of::<M, E, false, A, O>(method, columns, rows, values)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn avx2<M: Method<E, A, O>, E: Element, const A: usize, const O: usize>(
    method: M,
    columns: &Arguments<'_, E, A>,
    rows: usize,
    values: &mut Values<E, O>,
) -> bool {
    rows_of::<M, E, true, A, O>(method, columns, rows, values)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq,avx512vl,avx2,fma")]
fn avx512<M: Method<E, A, O>, E: Element, const A: usize, const O: usize>(
    method: M,
    columns: &Arguments<'_, E, A>,
    rows: usize,
    values: &mut Values<E, O>,
) -> bool {
    rows_of::<M, E, true, A, O>(method, columns, rows, values)
}
