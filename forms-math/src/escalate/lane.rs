//! The first attempt: one lane with an error bound. It has no branches, and costs a fraction of
//! [`Guarded<f64>`](crate::guarded::Guarded), which can bound more: values beyond the exponents of `f64` and functions
//! that lanes do not have.
//!
//! Where fused multiply-add is missing, its replacement would cost as much as guarded numbers: there is no such
//! attempt.

use alloc::vec::Vec;

use crate::instructions::Instructions;
use crate::lane::{in_fused_lanes, values_within};
use crate::{Computation, Formula};

/// Returns the outputs if one lane bounds the relative error of each by `units` · 2⁻⁵³.
#[inline(always)]
pub(super) fn in_one_lane<F: Formula<A, O>, const A: usize, const O: usize>(
    arguments: [f64; A],
    units: f64,
) -> Option<[f64; O]> {
    if !is_available() {
        return None;
    }
    // SAFETY: the processor has the instructions.
    #[allow(unused_unsafe, reason = "safe where every processor has them")]
    let values = unsafe { fused::<F, A, O>(arguments, units) };
    values.iter().all(|value| !value.is_nan()).then_some(values)
}

/// The same for a formula that is known only at run time.
pub(super) fn in_one_lane_computed(
    computation: &impl Computation,
    arguments: &[f64],
    units: f64,
) -> Option<Vec<f64>> {
    if !is_available() {
        return None;
    }
    let values = in_fused_lanes(computation, arguments).into_iter().map(|value| value.value_within(units));
    values.map(|value| (!value.is_nan()).then_some(value)).collect()
}

/// Whether the processor has fused multiply-add, and it is among the chosen instructions.
#[inline]
fn is_available() -> bool {
    cfg!(any(target_arch = "x86_64", target_arch = "aarch64")) && Instructions::best_are_fused()
}

/// Units of 2⁻⁵³ in a unit of 2⁻²⁴, in which errors of `f32` are stated.
const UNITS_OF_F32: f64 = (1_u64 << 29) as f64;
/// Rounding to a normal `f32`, in units of 2⁻²⁴, with a margin for the error of the rounded value.
const ROUNDING: f64 = 1.001;

/// Returns the outputs, each as a normal `f32` or zero, if one lane of `f64` bounds the relative error of each
/// sufficiently.
#[inline(always)]
pub(super) fn in_one_lane_for_f32<F: Formula<A, O>, const A: usize, const O: usize>(
    arguments: [f64; A],
    units: f64,
) -> Option<[f32; O]> {
    if units <= ROUNDING {
        return None;
    }
    let values = in_one_lane::<F, A, O>(arguments, (units - ROUNDING) * UNITS_OF_F32)?;
    let has_all_digits = |value: &f64| *value == 0.0 || (*value as f32).is_normal();
    values.iter().all(has_all_digits).then(|| values.map(|value| value as f32))
}

#[cfg_attr(target_arch = "x86_64", target_feature(enable = "avx2,fma"))]
#[inline]
fn fused<F: Formula<A, O>, const A: usize, const O: usize>(arguments: [f64; A], units: f64) -> [f64; O] {
    values_within::<F, true, A, O>(arguments, units)
}
