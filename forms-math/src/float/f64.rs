//! Functions of `f64` from the crate `libm`, by the names that the standard library gives them.

#[cfg(all(target_arch = "x86_64", target_feature = "fma"))]
pub(crate) use super::x86_64::f64::mul_add;
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
pub(crate) use super::x86_64::f64::sqrt;
#[cfg(not(all(target_arch = "x86_64", target_feature = "fma")))]
pub(crate) use libm::fma as mul_add;
#[cfg(not(all(target_arch = "x86_64", target_feature = "sse2")))]
pub(crate) use libm::sqrt;
pub(crate) use libm::{
    acos, asin, atan, atan2, cbrt, ceil, cos, cosh, exp, expm1 as exp_m1, fabs as abs, floor, log as ln,
    log1p as ln_1p, log2, pow as powf, round, sin, sincos as sin_cos, sinh, tan, tanh,
};

/// Returns the remainder of `dividend`/`divisor` that is not negative.
pub(crate) fn rem_euclid(dividend: f64, divisor: f64) -> f64 {
    let rest = dividend % divisor;
    if rest < 0.0 { rest + divisor.abs() } else { rest }
}
