//! Structured scalar expressions: a hash-consed graph that keeps the structure its author gave it.
//!
//! ```text
//! syntax ── resolve ──▶ Pool of nodes ──▶ normal form (equality)
//!                        │  derivative        kernel (lowering)
//!                        └─ substitution      text, LaTeX
//! ```
//! Equal nodes are one node, so a subexpression written once or arrived at twice is computed once. Building
//! folds constants and drops neutral elements and nothing else: simplification belongs to the normal form,
//! and a kernel is lowered from what was written. A node's operands always come before it in the pool, so
//! every walk is a loop over ascending indices and no depth of nesting can exhaust the stack.

mod build;
mod condition;
mod derivative;
mod domain;
mod import;
mod kernel;
mod nature;
mod node;
mod operation;
mod primitive;
mod quadrature;
mod relation;
mod substitution;
mod text;

pub use condition::Condition;
pub(crate) use nature::Nature;
pub use node::{Expr, FunctionId, Node, Pool, Rational, Seam, Symbol, SymbolKind, Unknown};
pub use operation::{Operation, Row, Spelling, TABLE};
pub(crate) use quadrature::Quadrature;
pub use substitution::Substitution;
