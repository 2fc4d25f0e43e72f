//! Special functions of any precision: series and continued fractions with as many terms as the bits asked for.
//!
//! Every function takes the number of bits that its value shall have. A type that has more bits than that spends the
//! spare ones on cancellation and so saves terms: `f64` computes in a wider type and rounds once.

mod clausen;
mod dilogarithm;
mod error_function;
mod exponential_integral;
mod zeta;

pub(crate) use clausen::clausen;
pub(crate) use dilogarithm::dilogarithm;
pub(crate) use error_function::error_function;
pub(crate) use exponential_integral::exponential_integral;
