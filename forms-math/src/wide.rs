//! Binary floating-point numbers with any number of words, and exponents that practically never
//! overflow.
//!
//! ```text
//! natural (integers of any length) ─ constants ─┐
//! representation ─ sum ─ product ─ quotient ────┴─ exponential, circular ─ elementary ─ special functions
//! ```
//! The last eight bits are guard digits: the functions are within a few units of 2^(8 − 64 LIMBS).

mod circular;
mod constants;
mod display;
mod exponential;
mod natural;
mod product;
mod quotient;
mod real;
mod representation;
mod sum;

pub(crate) use circular::quadrant_of_words;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Class {
    Zero,
    Finite,
    Infinite,
    Nan,
}

/// Number of 64 · `LIMBS` bits, ± 0.m · 2^exponent with the first bit of m set; at least two limbs.
///
/// ```
/// use forms_math::{Real, Wide};
/// let x = Wide::<4>::from_f64(1e-300);
/// assert_eq!((x * x * x / x / x).to_f64(), 1e-300);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Wide<const LIMBS: usize> {
    class: Class,
    negative: bool,
    exponent: i64,
    /// Words of the mantissa, the least significant first.
    mantissa: [u64; LIMBS],
}
