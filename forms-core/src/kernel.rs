//! Kernels: structured expressions become instructions, cheaper instructions, and values.
//!
//! ```text
//! expressions ─ lower ─▶ Program ─ optimise ─▶ Program ─┬─ interpret ─▶ values
//!       ▲                                               ├─ emission ──▶ source text
//!       └───────────────────── raise ───────────────────┘
//! ```
//! A kernel is lowered from the structure its author wrote, never from an expanded normal form, and
//! [`crate::emission`] prints the program as it stands. Raising closes the circle, so that an
//! optimised kernel can be proved equal to its formula.
//!
//! ```
//! use forms_core::expression::{Pool, SymbolKind};
//! use forms_core::kernel::{KernelSource, lower};
//!
//! let mut pool = Pool::new();
//! let x = pool.declare_symbol("x", SymbolKind::Local);
//! let seventh = pool.symbol(x);
//! let seventh = pool.power(seventh, 7.into());
//! let source = KernelSource {
//!     name: "seventh".to_string(),
//!     arguments: vec![x],
//!     outputs: vec![seventh],
//!     ..KernelSource::default()
//! };
//! let kernel = lower(&pool, &source)?.optimise();
//! assert_eq!(kernel.operations().multiplies, 4);
//! assert_eq!(kernel.interpret(&[2.0]), [128.0]);
//! # Ok::<(), forms_core::kernel::LowerError>(())
//! ```

mod chain;
mod common_factor;
mod constant;
mod constant_divisors;
mod count;
mod evaluate;
mod expand;
mod factor;
mod fuse;
mod graph;
mod in_order;
mod interpret;
mod linearise;
mod lower;
pub(crate) mod numbering;
mod optimise;
mod products;
mod program;
mod quotients;
mod raise;
mod rebuild;
mod schedule;
mod shared_divisors;
mod sharing;
mod signs;
mod sums;
mod tally;

pub use constant::Constant;
pub(crate) use constant::{Binary, DOUBLE, SINGLE, nearest, nearest_f64};
pub use count::OperationCount;
#[cfg(feature = "internals")]
pub use evaluate::evaluate_f64;
#[cfg(not(feature = "internals"))]
pub(crate) use evaluate::evaluate_f64;
pub use interpret::Interpreter;
pub use lower::{KernelSource, LowerError, lower};
pub use program::{Comparison, Instruction, ProductSum, Program, Value};
#[cfg(feature = "internals")]
pub use raise::Raised;
#[cfg(not(feature = "internals"))]
pub(crate) use raise::Raised;

#[cfg(test)]
#[allow(dead_code, reason = "integration tests use the rest")]
pub(crate) mod formula;
#[cfg(test)]
mod laws;
