//! Numbers in the lanes of a vector: the functions of kernels without branches, calls and tables.
//!
//! ```text
//! Real for Lane64<FMA>, Lane32<FMA> ─▶ exponential, logarithm, trigonometric, … ─▶ pair ─▶ word ─▶ instructions
//!                                                     coefficients ─┘
//! ```
//! A lane is one number; a loop over lanes is turned into vector instructions by the compiler, for the instructions that the
//! surrounding function is compiled for. With `FMA` the processor must have fused multiply-add, else each is a call.
//!
//! A function that gives up on an argument, because it is rare and would cost all others, has the value NaN there:
//! [`batch`](crate::batch) computes such values again by the functions of single numbers. These are angles beyond 2²⁰ right
//! angles (2¹² in `f32`), exponentials near overflow, points at the origin or near overflow, powers whose
//! intermediate values leave the range of pairs, and everywhere the functions that
//! lanes do not have: exponential integrals, the dilogarithm, Clausen's function and quadratures.
//!
//! The largest error of every function is below 2 ulp, with fused multiply-add and without: `tests/lanes` measures it.

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

pub(crate) use bounded::Bounded;
pub use word::{Lane32, Lane64};
