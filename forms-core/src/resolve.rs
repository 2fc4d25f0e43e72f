//! Name resolution and evaluation, from the syntax tree to typed objects: charts, maps, forms,
//! statements, kernels.
//!
//! ```text
//! ast::File ─ items ─ evaluation ─▶ Theory
//!                                 │
//!                                 └─ value + domain + variables used
//! ```
//! Every expression is evaluated when it is read: calculus happens here, on structured expressions.
//! Each value carries its domain, the conditions under which the source expression is defined. The
//! domain is therefore kept even where 0·log x becomes 0. All errors of a file are collected. An
//! item that fails is known but poisoned, so that one mistake is reported once.

mod arguments;
mod arithmetic;
mod arrays;
mod bindings;
mod boundary;
mod call;
mod cycles;
mod declarations;
mod definitions;
mod derivatives;
mod elementary;
mod evaluation;
mod integration;
mod items;
mod kernel_forms;
mod kernels;
mod maps;
mod metric;
mod potential;
mod quadratic;
mod scope;
mod statement;
mod sums;
mod warps;

#[cfg(feature = "internals")]
pub use evaluation::Trace;
#[cfg(not(feature = "internals"))]
pub(crate) use evaluation::Trace;
pub use items::resolve;
#[cfg(feature = "internals")]
pub use items::resolve_traced;
#[cfg(not(feature = "internals"))]
pub(crate) use items::resolve_traced;
