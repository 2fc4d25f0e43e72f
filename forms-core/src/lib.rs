#![cfg_attr(not(feature = "internals"), allow(dead_code, unreachable_pub, unused_imports))]
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
//! A program passes a text to [`compile`](compile::compile) and gets its diagnostics, its decided
//! statements and its kernels:
//!
//! ```
//! use forms_core::compile::{Options, compile};
//! use forms_core::decide::Verdict;
//! use forms_core::emission::{KernelDocs, emit_rust};
//!
//! let text = "
//!     chart Plane(x, y);
//!     prove product: d(x*y) == x*dy + y*dx;
//!     prove wrong: d(x*y) == x*dy - y*dx;
//!     kernel growth(x) = exp(x) - 1;
//! ";
//! let compiled = compile(text, &Options::default());
//!
//! // the verdicts; a false claim is an error of the text
//! let verdicts: Vec<&str> = compiled.statements.iter().map(|(_, verdict)| verdict.name()).collect();
//! assert_eq!(verdicts, ["proved", "refuted"]);
//! assert_eq!(compiled.diagnostics.len(), 1);
//!
//! // the exact counterexample: a point, the component that differs, and both values
//! let Verdict::Refuted(witness) = &compiled.statements[1].1 else { panic!("it is false") };
//! assert_eq!(witness.component, "dx");
//! assert_ne!(witness.left, witness.right);
//!
//! // the kernel, computed by an equal form that loses no digits near 0
//! let growth = compiled.kernel("growth").expect("it has no faults");
//! assert_eq!(growth.values(&[1e-17]), [1e-17]);
//!
//! // the kernel as a Rust function
//! let code = emit_rust(growth.program(), &KernelDocs::default(), "forms_math");
//! assert!(code.contains("fn growth(x: f64) -> f64 {"));
//! ```
//!
//! | step | modules |
//! |---|---|
//! | the whole | [`compile`], or its steps for one statement or kernel: [`check`] |
//! | the text | [`syntax`], [`diagnostic`]; its declarations as values: [`resolve`], [`theory`], [`expression`], [`units`] |
//! | the verdict | [`decide`]; as steps for a reader: [`derivation`]; as lines for a checker: [`certificate`] |
//! | closed forms | [`topology`] |
//! | the kernel | [`generation`], [`kernel`]; its stable form: [`stability`]; its error: [`rounding`], [`accuracy`] |
//! | the code | [`emission`] |
//! | for display | [`notation`], [`notebook`] |
//!
//! The other modules are private. The feature `internals` makes them public for the tests and
//! benchmarks of this repository; nothing else should rely on them.

pub mod accuracy;
mod approximation;
mod assume;
#[cfg(not(feature = "internals"))]
mod calculus;
#[cfg(feature = "internals")]
pub mod calculus;
pub mod certificate;
pub mod check;
pub mod compile;
pub mod decide;
pub mod derivation;
pub mod diagnostic;
pub mod emission;
#[cfg(not(feature = "internals"))]
mod enclosure;
#[cfg(feature = "internals")]
pub mod enclosure;
pub mod expression;
pub mod generation;
mod integral;
pub mod kernel;
#[cfg(not(feature = "internals"))]
mod normal;
#[cfg(feature = "internals")]
pub mod normal;
pub mod notation;
pub mod notebook;
#[cfg(not(feature = "internals"))]
mod polynomial;
#[cfg(feature = "internals")]
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
