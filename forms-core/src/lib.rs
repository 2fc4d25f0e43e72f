//! Symbolic exterior calculus, from text to proofs and kernels.
//!
//! ```text
//! text or tokens ─ syntax ─ resolve ─▶ expression (structured, shared)
//!                                          │  calculus
//!                     ┌────────────────────┴───────────┐
//!                     ▼                                ▼
//!              normal ─ decide                       kernel
//!       Proved | Refuted | Unknown             Rust · interpreter
//! ```

pub mod accuracy;
mod assume;
pub mod calculus;
pub mod certificate;
pub mod check;
pub mod compile;
pub mod decide;
pub mod derivation;
pub mod diagnostic;
pub mod emission;
pub mod enclosure;
pub mod expression;
pub mod generation;
mod integral;
pub mod kernel;
pub mod normal;
pub mod notation;
pub mod notebook;
pub mod polynomial;
mod random;
pub mod resolve;
pub mod rounding;
pub mod stability;
mod steps;
pub mod syntax;
pub mod theory;
pub mod topology;
pub mod units;

#[cfg(test)]
extern crate self as forms_core;
