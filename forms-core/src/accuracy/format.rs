//! Number formats, and the rounding of a real number to them where an enclosure determines the
//! result.

use crate::enclosure::Enclosure;
use crate::expression::Rational;
use crate::kernel::{Binary, DOUBLE, SINGLE, nearest};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Signed, Zero};

/// Requested format of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// The nearest `f32`.
    Single,
    /// The nearest `f64`.
    Double,
    /// The nearest `f64`, and the nearest `f64` to the remainder: about 32 digits.
    DoubleDouble,
    /// This number of significant decimal digits.
    Digits(u32),
}

/// A value rounded to the nearest in a format, ties to even.
#[derive(Clone, Debug, PartialEq)]
pub enum Rounded {
    /// A value in [`Format::Single`].
    Single(f32),
    /// A value in [`Format::Double`].
    Double(f64),
    /// A value in [`Format::DoubleDouble`]: the sum of both numbers.
    DoubleDouble(f64, f64),
    /// A value in [`Format::Digits`], such as `-1.25e-3`.
    Digits(String),
}

impl Format {
    /// Returns a number rounded to this format.
    pub fn of(self, value: &Rational) -> Rounded {
        let (n, d) = (value.numer(), value.denom());
        match self {
            Format::Single => Rounded::Single(nearest(n, d, SINGLE) as f32),
            Format::Double => Rounded::Double(nearest(n, d, DOUBLE)),
            Format::DoubleDouble => {
                let high = nearest(n, d, DOUBLE);
                Rounded::DoubleDouble(high, rest(n, d, high))
            }
            Format::Digits(count) => Rounded::Digits(decimal(n, d, count)),
        }
    }

    /// Returns the rounded value, if every number of the enclosure is rounded to it.
    pub(super) fn round(self, enclosure: &Enclosure) -> Option<Rounded> {
        let (lower, upper, denominator) = enclosure.ends();
        let common = |format: Binary| {
            let value = nearest(&lower, &denominator, format);
            (lower == upper || value == nearest(&upper, &denominator, format)).then_some(value)
        };
        match self {
            Format::Single => common(SINGLE).map(|value| Rounded::Single(value as f32)),
            Format::Double => common(DOUBLE).map(Rounded::Double),
            Format::DoubleDouble => {
                let high = common(DOUBLE)?;
                let low = |end: &BigInt| rest(end, &denominator, high);
                let (below, above) = (low(&lower), low(&upper));
                (below == above).then_some(Rounded::DoubleDouble(high, below))
            }
            Format::Digits(count) => {
                let text = decimal(&lower, &denominator, count);
                let certain = lower == upper || text == decimal(&upper, &denominator, count);
                certain.then_some(Rounded::Digits(text))
            }
        }
    }
}

/// Returns the nearest `f64` to n/d − high.
fn rest(n: &BigInt, d: &BigInt, high: f64) -> f64 {
    let Some((high_n, high_d)) = Rational::from_float(high).map(Rational::into_raw) else { return 0.0 };
    nearest(&(n * &high_d - high_n * d), &(d * high_d), DOUBLE)
}

/// Returns n/d to `count` significant digits, ties to even: `1.2345e-6`.
fn decimal(n: &BigInt, d: &BigInt, count: u32) -> String {
    if n.is_zero() {
        return "0".to_string();
    }
    let (sign, n) = if n.is_negative() { ("-", n.abs()) } else { ("", n.clone()) };
    // 10^(power) ≤ n/d < 10^(power + 1), found from the lengths and corrected
    let mut power = ((n.bits() as i64 - d.bits() as i64) as f64 * std::f64::consts::LOG10_2).floor() as i64;
    let scaled = |power: i64| {
        let ten = BigInt::from(10).pow(power.unsigned_abs() as u32);
        if power < 0 { (&n * ten, d.clone()) } else { (n.clone(), d * ten) }
    };
    let at_least_one = |power: i64| {
        let (n, d) = scaled(power);
        n >= d
    };
    while !at_least_one(power) {
        power -= 1;
    }
    while at_least_one(power + 1) {
        power += 1;
    }
    let (n, d) = scaled(power - i64::from(count) + 1);
    let (mut digits, remainder) = n.div_rem(&d);
    let twice = remainder << 1;
    if twice > d || (twice == d && digits.is_odd()) {
        digits += 1;
    }
    let mut text = digits.to_string();
    if text.len() > count as usize {
        text.pop();
        power += 1;
    }
    let (first, others) = text.split_at(1);
    let point = if others.is_empty() { "" } else { "." };
    format!("{sign}{first}{point}{others}e{power}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::enclosure::Precision;

    fn exact(text: &str) -> Enclosure {
        Enclosure::exact(&text.parse::<Rational>().expect("a fraction"), Precision(64))
    }

    #[test]
    fn decimals_have_the_digits_asked_for() {
        let cases = [
            ("1/3", "3.3333e-1"),
            ("-2/3", "-6.6667e-1"),
            ("99999/1", "9.9999e4"),
            ("999999/1", "1.0000e6"),
            ("1/1024", "9.7656e-4"),
            ("100005/100", "1.0000e3"),
            ("0/1", "0"),
        ];
        for (text, expected) in cases {
            assert_eq!(
                Format::Digits(5).round(&exact(text)),
                Some(Rounded::Digits(expected.into())),
                "{text}"
            );
        }
    }

    #[test]
    fn an_enclosure_of_two_roundings_has_none() {
        let (one, next) = (exact("1/1"), exact("9007199254740993/9007199254740992"));
        let wide = one.hull(&next);
        assert_eq!(Format::Single.round(&wide), Some(Rounded::Single(1.0)));
        assert_eq!(Format::Double.round(&wide), Some(Rounded::Double(1.0)));
        assert_eq!(Format::DoubleDouble.round(&wide), None);
        let low = 2f64.powi(-53);
        assert_eq!(Format::DoubleDouble.round(&next), Some(Rounded::DoubleDouble(1.0, low)));
    }
}
