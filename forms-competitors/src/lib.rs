//! The kernels of the bench `kernels`, each by several authors: this project's generator, an
//! expert, and two other generators.
//!
//! ```text
//! kernels/*.forms ─ forms! ────────────────▶ generated ─┐
//! generate.py ─ SymPy, wrenfold ─▶ generated/*.rs ──────┼─▶ catalogue ─▶ functions over columns
//! expert: hand-written vectors ─────────────────────────┘       inputs ─▶ columns
//! ```
//! The code of other generators is not part of the repository: `generate.py` writes it into the
//! folder `generated`, and the build script includes it if it is there.

pub mod catalogue;
pub mod expert;
pub mod generated;
pub mod inputs;
mod other_generators;

pub use other_generators::missing;
