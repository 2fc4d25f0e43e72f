//! Emission: a program as source text of some language, with every value as the program computes
//! it.
//!
//! ```text
//! Program ─ blocks ─▶ values of each branch alone ─── body ─▶ statements ─┬─ rust    ─▶ a function of f32s or f64s
//!                                                     dialect             ├─ c       ─▶ the same in C or CUDA ─┬─ batch
//!                                                     names · docs        ├─ wgsl    ─▶ a function of f32s ─────┘
//!                                                                         └─ generic ─▶ a function of any Real
//! ```
//! Emission never simplifies. A value used once is written where it is used as long as the line
//! stays short; the others are named `t0`, `t1`, … in the order of their computation. A kernel that
//! needs a feature that a language lacks is an error, or is omitted and reported.

mod attributes;
mod batch;
mod blocks;
mod body;
mod c;
mod dialect;
mod docs;
mod features;
mod generic;
mod names;
mod number;
mod parameters;
mod promise;
mod rust;
mod rust_results;
mod shader_functions;
mod shader_values;
mod source_file;
mod target;
mod unordered;
mod vector_library;
mod wgsl;
mod widened;
mod written;

pub use attributes::MANY_ARGUMENTS;
pub use docs::{KernelDocs, comment};
pub use generic::emit_formula;
pub use promise::{broken_promises, promised_by_bound};
pub use rust::{emit_rust, emit_rust_within};
pub use source_file::{Emitted, FileNames, emit, emit_possible};
pub use target::{Approximated, EmitError, Precision, Source, Target};
