//! Special functions of any precision: series and continued fractions with the number of terms that
//! the requested bits need.
//!
//! Every function takes the number of bits of its value. A type with more bits uses the spare ones
//! for cancellation and so saves terms: `f64` computes in a wider type and rounds once, except for
//! erf, which is a polynomial there.

mod clausen;
mod dilogarithm;
pub(crate) mod error_function;
mod exponential_integral;
mod zeta;

pub(crate) use clausen::clausen;
pub(crate) use dilogarithm::dilogarithm;
pub(crate) use error_function::{
    complementary_error_function, complementary_error_function_of_double, error_function,
    error_function_of_double,
};
pub(crate) use exponential_integral::exponential_integral;
