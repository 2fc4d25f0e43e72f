//! Exact values of the decimals in the reference.

use num_rational::BigRational;
use num_traits::pow;

/// Parses a decimal such as `-1.5e-3`.
pub fn exact(text: &str) -> BigRational {
    let (digits, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let integer: BigRational = format!("{whole}{fraction}").parse().expect("digits");
    let exponent = exponent.parse::<i32>().expect("an exponent") - fraction.len() as i32;
    let ten = BigRational::from_integer(10.into());
    integer * pow(if exponent < 0 { ten.recip() } else { ten }, exponent.unsigned_abs() as usize)
}
