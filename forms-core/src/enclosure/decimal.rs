//! Output of enclosures: decimal digits and `f64` bounds.

use super::bounds::Enclosure;
use crate::expression::Rational;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Signed, ToPrimitive, Zero};

impl Enclosure {
    /// Returns the value with all decimal places that are certain after rounding, or the two ends
    /// if no digit is certain.
    pub fn digits(&self) -> String {
        let places = self.precision().0 * 3 / 10;
        if let Some(digits) = (0..=places).rev().find_map(|places| self.rounded(places)) {
            return if self.is_exact() { without_trailing_zeros(digits) } else { digits };
        }
        let end = |value: Rational| format!("{}", value.round().to_integer());
        format!("[{}, {}]", end(self.lower().floor()), end(self.upper().ceil()))
    }

    /// Returns the value rounded to `places` decimal places, if the rounding is certain.
    pub fn rounded(&self, places: u32) -> Option<String> {
        let scale = BigInt::from(10).pow(places);
        let nearest = |value: Rational| (value * &scale).round().to_integer();
        let (lower, upper) = (nearest(self.lower()), nearest(self.upper()));
        (lower == upper).then(|| point_inserted(&lower, places as usize))
    }

    /// Returns the nearest `f64` values below and above, infinite beyond the finite ones.
    pub fn to_f64_range(&self) -> (f64, f64) {
        (float_below(&self.lower()), -float_below(&-self.upper()))
    }
}

fn point_inserted(scaled: &BigInt, places: usize) -> String {
    let sign = if scaled.is_negative() { "-" } else { "" };
    let digits = format!("{:0>width$}", scaled.magnitude().to_string(), width = places + 1);
    let (whole, fraction) = digits.split_at(digits.len() - places);
    if places == 0 { format!("{sign}{whole}") } else { format!("{sign}{whole}.{fraction}") }
}

fn without_trailing_zeros(digits: String) -> String {
    if !digits.contains('.') {
        return digits;
    }
    digits.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Returns the largest `f64` that is not above the value: m·2ᵉ with ⌊|m|⌋ of 53 bits, or fewer for
/// subnormal numbers.
fn float_below(value: &Rational) -> f64 {
    if value.is_zero() {
        return 0.0;
    }
    let (n, d) = (value.numer(), value.denom());
    let mut e = (n.bits() as i64 - d.bits() as i64 - 53).max(-1074);
    let mut m = floor_scaled(n, d, e);
    if m.bits() > 53 {
        e += 1;
        m = floor_scaled(n, d, e);
    }
    if e + m.bits() as i64 > 1024 {
        return if value.is_negative() { f64::NEG_INFINITY } else { f64::MAX };
    }
    m.to_f64().expect("an integer of 53 bits is a float") * power_of_two(e)
}

/// ⌊n/(d·2ᵉ)⌋
fn floor_scaled(n: &BigInt, d: &BigInt, e: i64) -> BigInt {
    if e < 0 { (n << -e).div_floor(d) } else { n.div_floor(&(d << e)) }
}

/// 2ᵉ for −1074 ≤ e ≤ 1023, subnormal below −1022
fn power_of_two(e: i64) -> f64 {
    if e < -1022 { f64::from_bits(1 << (e + 1074)) } else { f64::from_bits(((e + 1023) as u64) << 52) }
}
