//! The rules of the repository that no compiler checks: directions of imports, sizes of files and
//! functions, sizes of public surfaces, and the words of comments and pages.
//!
//! ```text
//! workspace ─ crates, files ─┬─ modules ─ imports ─▶ cycles of modules
//!                            ├─ surface ─▶ public items
//!                            ├─ sizes ─▶ long files, functions, lines
//!                            └─ prose ─▶ flagged comments and sentences
//! ```
//! Everything here reads sources as text or tokens; nothing is compiled. The tests of this crate
//! state the rules and hold the exceptions, each with its reason.

pub mod cycles;
pub mod imports;
pub mod modules;
pub mod prose;
pub mod sizes;
pub mod surface;
pub mod workspace;
