//! Numbers in the lanes of a vector: functions of kernels without branches, calls and tables.
//!
//! ```text
//! Real for Lane64<FMA>, Lane32<FMA> ─▶ exponential, logarithm, trigonometric, … ─▶ pair ─▶ word ─▶ instructions
//!                                                     coefficients ─┘
//! ```
//! A lane is one number. The compiler turns a loop over lanes into vector instructions, for the
//! instructions for which the surrounding function is compiled. With `FMA` the processor must have
//! fused multiply-add; otherwise every fused operation is a function call.
//!
//! A function gives up on rare arguments that would slow down all others; its value is NaN there,
//! and [`batch`](crate::batch) recomputes it with the functions of single numbers. Such arguments
//! are angles beyond 2²⁰ right angles (2¹² in `f32`), exponentials near overflow, points at the
//! origin or near overflow, and powers whose intermediate values leave the range of pairs.
//! Functions that lanes do not have give up everywhere: exponential integrals, the dilogarithm,
//! Clausen's function and quadratures.
//!
//! The largest error of every function is below 2 ulp (erfc: 5), with and without fused multiply-add:
//! `tests/lanes` measures it.

mod bounded;
mod coefficients;
mod error_function;
mod exponential;
mod inverse;
mod logarithm;
mod pair;
mod power;
mod real;
mod trigonometric;
mod word;

pub(crate) use bounded::{Bounded, in_fused_lanes, values_within};
pub use word::{Lane32, Lane64};
