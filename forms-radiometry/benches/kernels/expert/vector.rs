//! What the competitors are written in: an `f64`, four in a register of AVX2, eight in one of AVX-512.
//!
//! Every operation is one instruction or a few, always inlined into a function that has the instruction set. A value
//! of a register's type exists within such functions only, which is what each `unsafe` here rests on.

use std::ops::{Add, Div, Mul, Neg, Sub};

#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(target_arch = "x86_64")]
mod avx512;

#[cfg(target_arch = "x86_64")]
pub(crate) use {avx2::F64x4, avx512::F64x8};

/// Some `f64`, side by side.
pub(crate) trait Vector:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// How many.
    const LANES: usize;
    /// The same number in every place.
    fn splat(value: f64) -> Self;
    /// # Safety
    /// `LANES` numbers stand at `from`.
    unsafe fn load(from: *const f64) -> Self;
    /// # Safety
    /// There is room for `LANES` numbers at `to`.
    unsafe fn store(self, to: *mut f64);
    /// self · factor + summand
    fn mul_add(self, factor: Self, summand: Self) -> Self;
    fn sqrt(self) -> Self;
    fn abs(self) -> Self;
    /// The greater of both.
    fn max(self, other: Self) -> Self;
    /// The lesser of both.
    fn min(self, other: Self) -> Self;
    /// The size of `self` with the sign of `sign`.
    fn copysign(self, sign: Self) -> Self;
    /// `then` where left < right, else `otherwise`.
    fn if_less(left: Self, right: Self, then: Self, otherwise: Self) -> Self;
    /// eˣ and eˣ − 1 of −708 ≤ x ≤ 708, or x there.
    fn exp_and_exp_m1(self) -> (Self, Self);
    /// The angle of the point (x, y) with `self` = y.
    fn atan2(self, x: Self) -> Self;
    /// γ/s with γ the angle in [0, π] of the point (x, s), `self` = s ≥ 0.
    fn angle_over_sine(self, x: Self) -> Self;
}

/// One at a time, by the functions of the system.
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
    /// Two roundings: without the instruction one rounding is a call.
    #[inline(always)]
    fn mul_add(self, factor: Self, summand: Self) -> Self {
        self * factor + summand
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline(always)]
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
        let sine = f64::max(self, super::elementary::LEAST);
        f64::atan2(sine, x) / sine
    }
}
