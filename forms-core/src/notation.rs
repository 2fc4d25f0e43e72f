//! Values of the language in mathematical notation: simplified first, then written as text or as
//! LaTeX.
//!
//! ```text
//! Value ── simplify (normal form and back) ──▶ Value ─┬─ text  ──▶ the language itself
//!                                                     └─ latex ──▶ typeset mathematics
//! Theory, name ── named ──▶ the object with that name, in either
//! ast::Expr ─ written ─▶ typeset mathematics, as its author wrote it
//! ```
//! This module only displays: it decides nothing, and no kernel is lowered from a simplified
//! expression.

mod latex;
mod name;
mod named;
mod simplify;
mod sum;
mod text;
mod written;

pub use latex::{latex, latex_of_expression, latex_of_name, latex_of_relation};
pub use named::{latex_of_named, text_of_named};
pub use simplify::{simplify, simplify_expression};
pub use text::{results, text};
pub use written::{latex_as_written, latex_of_condition};
