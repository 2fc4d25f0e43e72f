//! Elementary functions of `f32` and `f64`, called by the paths `float::f32::exp` and
//! `float::f64::exp`: those of the standard library, or without it those of the crate `libm`.
//!
//! A method call would not do: without the standard library `x.exp()` is unknown, or a method of
//! [`Real`](crate::Real), and `Real::mul_add` of `f64` rounds twice.

#[cfg(not(feature = "std"))]
pub(crate) mod f32;
#[cfg(not(feature = "std"))]
pub(crate) mod f64;
#[cfg(all(not(feature = "std"), target_arch = "x86_64", target_feature = "sse2"))]
mod x86_64;

#[cfg(feature = "std")]
pub(crate) use core::primitive::{f32, f64};

/// Error bound of `float::f64::atan2` in ulp, as stated by the C library.
#[cfg(feature = "std")]
pub(crate) const ULPS_OF_ANGLE: f64 = 1.0;
/// Error bound of `float::f64::atan2` in ulp: up to one of the arctangent, one half of the quotient
/// y/x, and one half where the result is subtracted from π.
#[cfg(not(feature = "std"))]
pub(crate) const ULPS_OF_ANGLE: f64 = 2.0;
