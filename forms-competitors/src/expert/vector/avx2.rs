//! Four numbers in an AVX2 register, with fused multiply-add.

use super::{Vector, elementary};
use std::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Neg, Sub};

#[derive(Clone, Copy)]
/// Four numbers in a register of AVX2.
pub struct F64x4(__m256d);

/// 3 · 2⁵¹. The low bits of its sum with an integer below 2⁵¹ in magnitude are that integer.
const WHOLE: f64 = 6_755_399_441_055_744.0;

impl F64x4 {
    /// Returns 2ᵏ for an integer −1022 ≤ k ≤ 1023: its bits become the exponent.
    #[inline(always)]
    fn power_of_two(k: Self) -> Self {
        // SAFETY: the caller has AVX2.
        unsafe {
            let bits = _mm256_castpd_si256(_mm256_add_pd(k.0, _mm256_set1_pd(WHOLE)));
            let exponent = _mm256_slli_epi64::<52>(bits);
            let one = _mm256_castpd_si256(_mm256_set1_pd(1.0));
            F64x4(_mm256_castsi256_pd(_mm256_add_epi64(exponent, one)))
        }
    }

    #[inline(always)]
    fn round(self) -> Self {
        // SAFETY: the caller has AVX2.
        F64x4(unsafe { _mm256_round_pd::<{ _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC }>(self.0) })
    }

    #[inline(always)]
    fn sign() -> __m256d {
        // SAFETY: the caller has AVX2.
        unsafe { _mm256_set1_pd(-0.0) }
    }
}

impl Vector for F64x4 {
    const LANES: usize = 4;
    #[inline(always)]
    fn splat(value: f64) -> Self {
        // SAFETY: the caller has AVX2.
        F64x4(unsafe { _mm256_set1_pd(value) })
    }
    #[inline(always)]
    unsafe fn load(from: *const f64) -> Self {
        // SAFETY: the caller has AVX2, and `from` points to that many numbers.
        F64x4(unsafe { _mm256_loadu_pd(from) })
    }
    #[inline(always)]
    unsafe fn store(self, to: *mut f64) {
        // SAFETY: the caller has AVX2, and `to` points to memory for that many numbers.
        unsafe { _mm256_storeu_pd(to, self.0) }
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, summand: Self) -> Self {
        // SAFETY: the caller has fused multiply-add.
        F64x4(unsafe { _mm256_fmadd_pd(self.0, factor.0, summand.0) })
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        // SAFETY: the caller has AVX2.
        F64x4(unsafe { _mm256_sqrt_pd(self.0) })
    }
    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: the caller has AVX2.
        F64x4(unsafe { _mm256_andnot_pd(Self::sign(), self.0) })
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        // SAFETY: the caller has AVX2.
        F64x4(unsafe { _mm256_max_pd(self.0, other.0) })
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        // SAFETY: the caller has AVX2.
        F64x4(unsafe { _mm256_min_pd(self.0, other.0) })
    }
    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        // SAFETY: the caller has AVX2.
        F64x4(unsafe { _mm256_or_pd(self.abs().0, _mm256_and_pd(Self::sign(), sign.0)) })
    }
    #[inline(always)]
    fn if_less(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
        // SAFETY: the caller has AVX2.
        F64x4(unsafe { _mm256_blendv_pd(otherwise.0, then.0, _mm256_cmp_pd::<_CMP_LT_OQ>(left.0, right.0)) })
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
        impl $operator for F64x4 {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // SAFETY: the caller has AVX2.
                F64x4(unsafe { $instruction(self.0, other.0) })
            }
        }
    };
}
operator!(Add, add, _mm256_add_pd);
operator!(Sub, sub, _mm256_sub_pd);
operator!(Mul, mul, _mm256_mul_pd);
operator!(Div, div, _mm256_div_pd);

impl Neg for F64x4 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        // SAFETY: the caller has AVX2.
        F64x4(unsafe { _mm256_xor_pd(self.0, Self::sign()) })
    }
}
