//! From the syntax tree to typed objects: charts, maps, forms, statements, kernels.
//!
//! ```text
//! ast::File ─ names ─▶ items ─ evaluation ─▶ Theory
//!                                 │
//!                                 └─ value + where it is defined + what it uses
//! ```
//! Every expression is evaluated as it is met: calculus happens here, on structured expressions. Beside each
//! value travels its domain, the conditions under which what was written is defined, so that nothing is lost
//! when 0·log x becomes 0. All errors of a file are collected; an item that fails is known but poisoned, so
//! that one mistake is reported once.

mod arithmetic;
mod boundary;
mod call;
mod evaluation;
mod integration;
mod items;
mod kernels;
mod maps;
mod metric;
mod names;
mod potential;
mod quadratic;
mod scope;
mod statement;
mod theory;
mod value;
mod warps;

pub use evaluation::Trace;
pub use items::{resolve, resolve_traced};
pub(crate) use metric::METRIC_OPERATIONS;
pub(crate) use theory::Integration;
pub use theory::{
    Chart, Effect, Kernel, KernelUnits, Map, Named, NamedMetric, Object, Statement, Theory, Warp,
};
pub use value::Value;
