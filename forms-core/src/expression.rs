//! Structured scalar expressions: a hash-consed graph that keeps the structure its author gave it.
//!
//! ```text
//! syntax ── resolve ──▶ Pool of nodes ──▶ normal form (equality)
//!                        │  derivative        kernel (lowering)
//!                        └─ substitution      text, LaTeX
//! ```
//! Equal nodes are one node, so a subexpression that occurs or arises several times is computed
//! once. Construction folds constants, drops neutral elements and normalises signs and nested
//! powers; simplification belongs to the normal form, and a kernel is lowered from the expression
//! as written. A node's operands always precede it in the pool, so a traversal of the graph is a
//! loop over ascending indices, and deep nesting cannot exhaust the stack.

mod build;
mod condition;
mod derivative;
mod domain;
mod extremum;
mod import;
mod integral_table;
mod integrand;
mod nature;
mod node;
mod operation;
mod partials;
mod pool;
mod primitive;
mod quadrature;
mod relation;
mod shape;
mod substitution;
mod text;

pub use condition::Condition;
pub(crate) use extremum::Extremum;
pub(crate) use integral_table::Quadrature;
pub(crate) use nature::Nature;
pub use node::{Expr, FunctionId, Node, Rational, Seam, Symbol, SymbolKind, Unknown};
pub use operation::Operation;
#[cfg(feature = "internals")]
pub use operation::{Row, Spelling, TABLE};
#[cfg(not(feature = "internals"))]
pub(crate) use operation::{Row, Spelling, TABLE};
pub use pool::Pool;
pub use relation::Relation;
pub use shape::{Parameter, Shape, Signature};
pub use substitution::Substitution;
pub(crate) use text::number_text;
