//! Eight numbers in an AVX-512 register.

use super::{Vector, elementary};
use std::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Neg, Sub};

#[derive(Clone, Copy)]
/// Eight numbers in a register of AVX-512.
pub struct F64x8(__m512d);

impl F64x8 {
    /// Returns 2ᵏ for an integer k.
    #[inline(always)]
    fn power_of_two(k: Self) -> Self {
        // SAFETY: the caller has AVX-512.
        F64x8(unsafe { _mm512_scalef_pd(_mm512_set1_pd(1.0), k.0) })
    }

    #[inline(always)]
    fn round(self) -> Self {
        // SAFETY: the caller has AVX-512.
        F64x8(unsafe { _mm512_roundscale_pd::<{ _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC }>(self.0) })
    }

    #[inline(always)]
    fn sign() -> __m512d {
        // SAFETY: the caller has AVX-512.
        unsafe { _mm512_set1_pd(-0.0) }
    }
}

impl Vector for F64x8 {
    const LANES: usize = 8;
    #[inline(always)]
    fn splat(value: f64) -> Self {
        // SAFETY: the caller has AVX-512.
        F64x8(unsafe { _mm512_set1_pd(value) })
    }
    #[inline(always)]
    unsafe fn load(from: *const f64) -> Self {
        // SAFETY: the caller has AVX-512, and `from` points to that many numbers.
        F64x8(unsafe { _mm512_loadu_pd(from) })
    }
    #[inline(always)]
    unsafe fn store(self, to: *mut f64) {
        // SAFETY: the caller has AVX-512, and `to` points to memory for that many numbers.
        unsafe { _mm512_storeu_pd(to, self.0) }
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, summand: Self) -> Self {
        // SAFETY: the caller has AVX-512.
        F64x8(unsafe { _mm512_fmadd_pd(self.0, factor.0, summand.0) })
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        // SAFETY: the caller has AVX-512.
        F64x8(unsafe { _mm512_sqrt_pd(self.0) })
    }
    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: the caller has AVX-512.
        F64x8(unsafe { _mm512_andnot_pd(Self::sign(), self.0) })
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        // SAFETY: the caller has AVX-512.
        F64x8(unsafe { _mm512_max_pd(self.0, other.0) })
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        // SAFETY: the caller has AVX-512.
        F64x8(unsafe { _mm512_min_pd(self.0, other.0) })
    }
    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        // SAFETY: the caller has AVX-512.
        F64x8(unsafe { _mm512_or_pd(self.abs().0, _mm512_and_pd(Self::sign(), sign.0)) })
    }
    #[inline(always)]
    fn if_less(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
        // SAFETY: the caller has AVX-512.
        F64x8(unsafe {
            _mm512_mask_blend_pd(_mm512_cmp_pd_mask::<_CMP_LT_OQ>(left.0, right.0), otherwise.0, then.0)
        })
    }
    #[inline(always)]
    fn exp_and_exp_m1(self) -> (Self, Self) {
        elementary::exp_and_exp_m1(self, Self::round, Self::power_of_two)
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        elementary::atan2(self, x)
    }
    #[inline(always)]
    fn angle_over_sine(self, x: Self) -> Self {
        elementary::angle_over_sine(self, x)
    }
}

/// Implements an operator of the language by an instruction.
macro_rules! operator {
    ($operator:ident, $method:ident, $instruction:ident) => {
        impl $operator for F64x8 {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // SAFETY: the caller has AVX-512.
                F64x8(unsafe { $instruction(self.0, other.0) })
            }
        }
    };
}
operator!(Add, add, _mm512_add_pd);
operator!(Sub, sub, _mm512_sub_pd);
operator!(Mul, mul, _mm512_mul_pd);
operator!(Div, div, _mm512_div_pd);

impl Neg for F64x8 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        // SAFETY: the caller has AVX-512.
        F64x8(unsafe { _mm512_xor_pd(self.0, Self::sign()) })
    }
}
