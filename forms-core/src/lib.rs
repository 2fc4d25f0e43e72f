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

pub mod diagnostic;
pub mod expression;
pub mod kernel;
pub mod polynomial;
pub mod syntax;

#[cfg(test)]
extern crate self as forms_core;
