//! Rigorous enclosures of real numbers, which decide signs and check witnesses.
//!
//! ```text
//! a pool's expressions ─┐
//! a value per variable ─┴─ graph ──▶ Enclosure ──▶ sign, zero excluded, certain digits
//!                                     ├ an exact rational, while it stays short
//!                                     └ [lower, upper]·2⁻ᵖ, every operation rounded outward
//! ```
//! Ranges in machine words come first and decide the easy cases.
//!
//! The true value always lies in the enclosure; a higher precision p makes the enclosure narrower.
//! Nothing here is computed in floating point; `f64` appears only where a result leaves the module.

mod arithmetic;
mod bounds;
mod circular;
mod constants;
mod decimal;
mod dilogarithm;
mod expansion;
mod exponential;
mod exponential_integral;
mod graph;
mod inverse;
mod power;
mod quadrature;
mod range;
mod series;
mod taylor;
#[cfg(test)]
mod tests;
mod word;

pub use bounds::{Enclosure, Precision, Undecided};
pub(crate) use expansion::{Place, expansion};
pub use graph::enclose;
pub(crate) use graph::{enclose_number, enclose_of_kernel};
pub(crate) use word::{WordRange, word_ranges};
