//! Decimal digits of a binary number, all of them correct.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;

use super::natural::{bit_length, compare, multiply_by_word, quotient_and_remainder, shifted_left};
use super::{Class, Wide};
use crate::float;

/// Number of digits printed.
const DIGITS: usize = 36;
/// Largest exponent of two that is converted to decimal; beyond it the exponent of 2 is printed,
/// since the integers would be too long.
const LARGEST_EXPONENT: i64 = 1 << 16;

/// Formats `number` · 2^`exponent` as d.ddd…e±n, truncated after 36 digits, without trailing zeros.
fn decimal(negative: bool, number: &[u64], exponent: i64) -> String {
    let length = bit_length(number) as i64 + exponent;
    // number 2^exponent = numerator/denominator, and 10^power is at most this value.
    let mut power = float::f64::floor((length - 1) as f64 * core::f64::consts::LOG10_2) as i64;
    let mut numerator = shifted_left(number, exponent.max(0) as usize);
    let mut denominator = shifted_left(&[1], (-exponent).max(0) as usize);
    times_power_of_ten(if power < 0 { &mut numerator } else { &mut denominator }, power.unsigned_abs());
    let mut ten = denominator.clone();
    times_power_of_ten(&mut ten, 1);
    if compare(&numerator, &ten).is_ge() {
        (denominator, power) = (ten, power + 1);
    }
    let mut digits = String::new();
    for place in 0..DIGITS {
        let (quotient, rest) = quotient_and_remainder(&numerator, &denominator);
        if place == 1 {
            digits.push('.');
        }
        digits.push(char::from(b'0' + quotient[0] as u8));
        numerator = rest;
        times_power_of_ten(&mut numerator, 1);
    }
    let digits = digits.trim_end_matches('0').trim_end_matches('.');
    format!("{}{digits}e{power}", if negative { "-" } else { "" })
}

fn times_power_of_ten(number: &mut Vec<u64>, power: u64) {
    for _ in 0..power {
        let carry = multiply_by_word(number, 10);
        if carry != 0 {
            number.push(carry);
        }
    }
}

impl<const LIMBS: usize> fmt::Display for Wide<LIMBS> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = if self.negative { "-" } else { "" };
        match self.class {
            Class::Nan => formatter.write_str("NaN"),
            Class::Zero => formatter.write_str("0"),
            Class::Infinite => write!(formatter, "{sign}inf"),
            Class::Finite if self.exponent.abs() > LARGEST_EXPONENT => {
                let size = Self { exponent: 0, negative: false, ..*self };
                write!(formatter, "{sign}{} * 2^{}", size.nearest_f64(), self.exponent)
            }
            Class::Finite => formatter.write_str(&decimal(
                self.negative,
                &self.mantissa,
                self.exponent - 64 * LIMBS as i64,
            )),
        }
    }
}
