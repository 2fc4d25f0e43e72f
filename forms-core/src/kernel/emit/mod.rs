//! Emission: a program as source text of some language, every value as the program computes it.
//!
//! ```text
//! Program ─ blocks ─▶ what each branch alone needs ─ body ─▶ statements ─┬─ rust    ─▶ a function of f64s
//!                                                    dialect             └─ generic ─▶ a function of any Real
//! ```
//! Emission never simplifies. A value used once is written where it is used as long as the line stays short;
//! the others are named `t0`, `t1`, … in the order of their computation.

mod blocks;
mod body;
mod dialect;
mod generic;
mod number;
mod rust;
mod written;

pub use generic::emit_formula;
pub use rust::{RustDocs, emit_rust};
