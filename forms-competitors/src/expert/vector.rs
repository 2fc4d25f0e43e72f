//! The vectors that the competitors compute with: one `f64`, four in an AVX2 register, eight in an
//! AVX-512 register.
//!
//! Every operation is one instruction or a few, always inlined into a function that has the
//! instruction set. A value of a register type exists only within such functions. Each `unsafe`
//! here rests on this invariant.

use std::ops::{Add, Div, Mul, Neg, Sub};

#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(target_arch = "x86_64")]
mod avx512;
pub mod elementary;

#[cfg(target_arch = "x86_64")]
pub use {avx2::F64x4, avx512::F64x8};

/// Vector of `f64` lanes.
pub trait Vector:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// Number of lanes.
    const LANES: usize;
    /// Returns the same number in every lane.
    fn splat(value: f64) -> Self;
    /// # Safety
    /// `from` points to `LANES` numbers.
    unsafe fn load(from: *const f64) -> Self;
    /// # Safety
    /// `to` points to memory for `LANES` numbers.
    unsafe fn store(self, to: *mut f64);
    /// self · factor + summand
    fn mul_add(self, factor: Self, summand: Self) -> Self;
    /// Returns the square root.
    fn sqrt(self) -> Self;
    /// Returns the magnitude.
    fn abs(self) -> Self;
    /// Returns the greater of both.
    fn max(self, other: Self) -> Self;
    /// Returns the lesser of both.
    fn min(self, other: Self) -> Self;
    /// Returns the magnitude of `self` with the sign of `sign`.
    fn copysign(self, sign: Self) -> Self;
    /// Returns `then` where left < right, else `otherwise`.
    fn if_less(left: Self, right: Self, then: Self, otherwise: Self) -> Self;
    /// Returns eˣ and eˣ − 1, with x clamped to −708 ≤ x ≤ 708.
    fn exp_and_exp_m1(self) -> (Self, Self);
    /// Returns the angle of the point (x, y) with y = `self`.
    fn atan2(self, x: Self) -> Self;
    /// Returns γ/s with γ the angle in [0, π] of the point (x, s), where s = `self` ≥ 0.
    fn angle_over_sine(self, x: Self) -> Self;
}

/// One lane, with the functions of the standard library.
impl Vector for f64 {
    const LANES: usize = 1;
    #[inline(always)]
    fn splat(value: f64) -> Self {
        value
    }
    #[inline(always)]
    unsafe fn load(from: *const f64) -> Self {
        // SAFETY: as the caller promises.
        unsafe { *from }
    }
    #[inline(always)]
    unsafe fn store(self, to: *mut f64) {
        // SAFETY: as the caller promises.
        unsafe { *to = self };
    }
    /// Rounds twice: without the instruction, a single rounding costs a function call.
    #[inline(always)]
    fn mul_add(self, factor: Self, summand: Self) -> Self {
        self * factor + summand
    }
    #[inline(always)]
    /// Returns the square root.
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline(always)]
    /// Returns the magnitude.
    fn abs(self) -> Self {
        f64::abs(self)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        f64::max(self, other)
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        f64::min(self, other)
    }
    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        f64::copysign(self, sign)
    }
    #[inline(always)]
    fn if_less(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
        if left < right { then } else { otherwise }
    }
    #[inline(always)]
    fn exp_and_exp_m1(self) -> (Self, Self) {
        (self.exp(), self.exp_m1())
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        f64::atan2(self, x)
    }
    #[inline(always)]
    fn angle_over_sine(self, x: Self) -> Self {
        let sine = f64::max(self, elementary::LEAST);
        f64::atan2(sine, x) / sine
    }
}
