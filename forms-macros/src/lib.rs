//! The macros of Forms: tokens in, core, tokens out.
//!
//! ```text
//! macro body ─ tokens ──┐
//!                       ├─▶ forms_core ─▶ expand ─▶ functions, tests, values
//! .forms file ─ include ┘         └─────▶ report ─▶ errors on the user's own text
//! ```
//! Use them through the crate `forms`, which re-exports them beside what their expansions refer to.

mod expand;
mod form;
mod include;
mod lattice;
mod proof_tests;
mod report;
mod tiers;
mod tokens;

use proc_macro::TokenStream;

/// Declares, claims and generates: its body is a whole file of the language.
///
/// Every `prove` and `refute` is decided while the crate is compiled. A claim that is false or undecided is a
/// compile error on the claim, with a point at which the two sides differ. Every `kernel` becomes a documented
/// function of `f64`s; everything else leaves no trace.
#[proc_macro]
pub fn forms(body: TokenStream) -> TokenStream {
    expand::file(tokens::read(body.into())).into()
}

/// The same as [`forms!`] with the items in a file: `include_forms!("src/sphere.forms")`.
///
/// The path is relative to the folder of the crate's `Cargo.toml`. Errors name line and column of the file and
/// quote the line. The crate is compiled again when the file changes.
#[proc_macro]
pub fn include_forms(path: TokenStream) -> TokenStream {
    include::items(path.into()).into()
}

/// Turns each statement of a file into a test that decides it: `proof_tests!("src/sphere.forms")`.
///
/// The tests carry the names of the statements; what a kernel claims by `by`, at a seam or of an effect is the test
/// `kernel_NAME`. The path is relative to the folder of the crate's `Cargo.toml`.
/// Only what cannot be read is an error of compilation; what is false or undecided fails its test.
#[proc_macro]
pub fn proof_tests(path: TokenStream) -> TokenStream {
    proof_tests::tests(path.into()).into()
}

/// Proves one equation while the crate is compiled: declarations, then `left == right where …` without a name.
///
/// It leaves nothing behind and stands wherever an item or a statement may.
#[proc_macro]
pub fn prove(body: TokenStream) -> TokenStream {
    expand::equation(tokens::read(body.into())).into()
}

/// Generates one function and the module of its precisions: declarations, then `name(u, v) = … where …`, with `pub`
/// before it if wanted.
#[proc_macro]
pub fn kernel(body: TokenStream) -> TokenStream {
    expand::kernel(tokens::read(body.into())).into()
}

/// Evaluates one scalar or form while the crate is compiled: declarations, then an expression.
///
/// Its value is a constant `forms::Form`: the degree and the simplified coefficients, as text.
#[proc_macro]
pub fn form(body: TokenStream) -> TokenStream {
    form::value(tokens::read(body.into())).into()
}
