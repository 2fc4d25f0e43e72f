//! From characters or macro tokens to a syntax tree.
//!
//! ```text
//! text ── lexer ──┐
//!                 ├─▶ tokens ── parser ──▶ ast::File + diagnostics
//! macro tokens ───┘
//! ```
//! The parser knows tokens only, so a `.forms` file and a macro body mean the same.

pub mod ast;
pub mod token;
