//! The same kernels emitted by other generators, written by `generate.py`.

#[rustfmt::skip]
#[allow(clippy::all, non_snake_case, unused_parens, unreachable_pub, missing_docs)]
pub(crate) mod by_sympy;
#[rustfmt::skip]
#[allow(clippy::all, non_snake_case, unused_parens, unreachable_pub, missing_docs)]
pub(crate) mod by_wrenfold;
