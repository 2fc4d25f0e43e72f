//! The book of Forms: pages of Markdown in, checked pages and HTML out.
//!
//! ```text
//! Markdown ─ page ─▶ blocks ─┬─ check ─▶ statements, exercises, quoted errors
//!                            ├─ links ─▶ target files and headings
//!                            ├─ console ─▶ calls of the program and their outputs
//!                            └─ expand (mathml, verdicts) ─▶ Markdown ─┬─ html, book ─▶ pages
//!                                                                      └─ preprocess ─▶ mdBook
//! ```
//! The sources of the book are part of the crate: a program that links the crate needs no other
//! file to show the book.

mod book;
mod check;
mod console;
mod escape;
mod expand;
mod highlight;
mod html;
mod links;
mod mathml;
mod page;
mod preprocess;
mod theory;
mod verdicts;

pub use book::{Book, Chapter, book};
pub use check::{Problem, Report, check_kinds, check_theories, with_errors_quoted};
pub use console::{Call, agrees, calls, with_outputs};
pub use escape::escaped;
pub use links::check_links;
pub use mathml::{LONGEST_FORMULA, display, inline};
pub use page::{Block, Link, Page, pages};
pub use preprocess::{PreprocessError, preprocess};
pub use theory::{Counted, common_text};
pub use verdicts::steps;
