//! Functions of `f32` from the crate `libm`, by the names that the standard library gives them.

#[cfg(all(target_arch = "x86_64", target_feature = "fma"))]
pub(crate) use super::x86_64::f32::mul_add;
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
pub(crate) use super::x86_64::f32::sqrt;
#[cfg(not(all(target_arch = "x86_64", target_feature = "fma")))]
pub(crate) use libm::fmaf as mul_add;
#[cfg(not(all(target_arch = "x86_64", target_feature = "sse2")))]
pub(crate) use libm::sqrtf as sqrt;
pub(crate) use libm::{
    acosf as acos, asinf as asin, atan2f as atan2, atanf as atan, cosf as cos, expf as exp, expm1f as exp_m1,
    fabsf as abs, log1pf as ln_1p, logf as ln, sinf as sin, tanf as tan,
};
