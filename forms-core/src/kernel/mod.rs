//! Kernels: structured expressions become instructions, cheaper instructions, and source text or values.
//!
//! ```text
//! expressions ─ lower ─▶ Program ─ optimise ─▶ Program ─┬─ emit_rust ─▶ source
//!       ▲                                               ├─ interpret ─▶ values
//!       └───────────────────── raise ───────────────────┘
//! ```
//! A kernel is lowered from the structure its author wrote, never from an expanded normal form, and emission
//! never simplifies: what is printed is the program as it stands. Raising closes the circle, so that an optimised
//! kernel can be proved equal to the formula it came from.

mod chain;
mod constant;
mod count;
mod evaluate;
mod expand;
mod factor;
mod graph;
mod interpret;
mod linearise;
mod lower;
mod numbering;
mod optimise;
mod products;
mod program;
mod quotients;
mod raise;
mod rust;
mod signs;
mod sums;

pub use constant::Constant;
pub use count::OperationCount;
pub use evaluate::evaluate_f64;
pub use lower::{Condition, KernelSource, LowerError, lower};
pub use program::{Comparison, Instruction, Program, Value};
pub use rust::{RustDocs, emit_rust};

#[cfg(test)]
#[path = "../../tests/kernel/formula.rs"]
mod formula;
