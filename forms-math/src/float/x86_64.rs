//! Roots and fused multiply-add by the instructions for which the program is compiled, so that loops
//! over lanes are vectorised: functions of `libm` are calls.

use core::arch::x86_64::{_mm_cvtsd_f64, _mm_cvtss_f32, _mm_set_sd, _mm_set_ss, _mm_sqrt_sd, _mm_sqrt_ss};
#[cfg(target_feature = "fma")]
use core::arch::x86_64::{_mm_fmadd_sd, _mm_fmadd_ss};

/// Functions of one format, by the instructions on the first element of a vector.
macro_rules! functions {
    ($raw:ident, $set:ident, $first:ident, $sqrt:expr, $fmadd:ident) => {
        pub(crate) mod $raw {
            use super::*;

            /// √x
            #[inline(always)]
            pub(crate) fn sqrt(x: $raw) -> $raw {
                // SAFETY: the program is compiled for processors with the instruction.
                unsafe { $first($sqrt($set(x))) }
            }

            /// Computes x · factor + summand with one rounding.
            #[cfg(target_feature = "fma")]
            #[inline(always)]
            pub(crate) fn mul_add(x: $raw, factor: $raw, summand: $raw) -> $raw {
                // SAFETY: the program is compiled for processors with the instruction.
                unsafe { $first($fmadd($set(x), $set(factor), $set(summand))) }
            }
        }
    };
}

functions! { f64, _mm_set_sd, _mm_cvtsd_f64, |x| _mm_sqrt_sd(x, x), _mm_fmadd_sd }
functions! { f32, _mm_set_ss, _mm_cvtss_f32, _mm_sqrt_ss, _mm_fmadd_ss }
