//! The book of Forms: pages of Markdown in, checked pages and HTML out.
//!
//! ```text
//! Markdown ─ page ─▶ blocks ─┬─ check ─▶ statements, exercises, quoted errors
//!                            ├─ links ─▶ files and headings they lead to
//!                            └─ console ─▶ calls of the program and what they print
//! ```

mod check;
mod console;
mod links;
mod page;
mod theory;

pub use check::{Problem, Report, check_kinds, check_theories, with_errors_quoted};
pub use console::{Call, calls, with_outputs};
pub use links::check_links;
pub use page::{Block, Link, Page};
pub use theory::{Counted, common_text};
