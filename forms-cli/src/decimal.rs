//! Numbers as written in tables: exact decimals and quotients, rounded once to `f64`.

use forms::core::kernel::Constant;
use num_rational::BigRational;
use num_traits::{Zero, pow};

/// Largest magnitude of the power of ten of an exact number.
const LARGEST_POWER: i64 = 10_000;

/// Returns the `f64` nearest to `0.1`, `-2.5e-3` or `1/3`; `None` for any other text.
pub(crate) fn nearest(text: &str) -> Option<f64> {
    if text.contains('/') {
        return Some(Constant::rational(exact(text)?).to_f64());
    }
    Decimal::read(text)?;
    text.parse().ok()
}

/// Returns the exact value of `0.1`, `-2.5e-3` or `1/3`, without rounding; `None` for any other
/// text.
pub(crate) fn exact(text: &str) -> Option<BigRational> {
    let Some((above, below)) = text.split_once('/') else { return exact_decimal(text) };
    let (above, below) = (exact_decimal(above.trim())?, exact_decimal(below.trim())?);
    (!below.is_zero()).then(|| above / below)
}

/// Sign, digits before and after the point, and power of ten.
struct Decimal<'t> {
    negative: bool,
    whole: &'t str,
    fraction: &'t str,
    power: &'t str,
}

impl<'t> Decimal<'t> {
    fn read(text: &'t str) -> Option<Self> {
        let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
        let (mantissa, power) = unsigned.split_once(['e', 'E']).unwrap_or((unsigned, "0"));
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
        let power_digits = power.strip_prefix(['-', '+']).unwrap_or(power);
        let sound = digits(whole)
            && digits(fraction)
            && !(whole.is_empty() && fraction.is_empty())
            && digits(power_digits)
            && !power_digits.is_empty();
        sound.then_some(Decimal { negative: text.starts_with('-'), whole, fraction, power })
    }
}

fn exact_decimal(text: &str) -> Option<BigRational> {
    let decimal = Decimal::read(text)?;
    let power: i64 = decimal.power.parse().ok().filter(|power: &i64| power.abs() <= LARGEST_POWER)?;
    let shift = power - i64::try_from(decimal.fraction.len()).ok()?;
    let digits = format!("{}{}", decimal.whole, decimal.fraction);
    let mantissa = BigRational::from_integer(digits.parse().ok()?);
    let ten = pow(BigRational::from_integer(10.into()), usize::try_from(shift.unsigned_abs()).ok()?);
    let magnitude = if shift < 0 { mantissa / ten } else { mantissa * ten };
    Some(if decimal.negative { -magnitude } else { magnitude })
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn decimals_and_quotients_are_rounded_once() {
        let cases = [
            ("0.1", 0.1),
            ("-2.5e-3", -0.0025),
            ("+7", 7.0),
            (".5", 0.5),
            ("1.", 1.0),
            ("1E3", 1000.0),
            ("1/3", 1.0 / 3.0),
            ("-2 / 3", -2.0 / 3.0),
            ("0.1/0.3", 1.0 / 3.0),
            ("1e300/1e-9", f64::INFINITY),
            ("5e-324", 5e-324),
            ("1/1e320", 1e-320),
            ("9007199254740993", 9007199254740992.0),
        ];
        for (text, expected) in cases {
            assert_eq!(nearest(text), Some(expected), "{text}");
        }
    }

    #[test]
    fn what_is_no_number_is_refused() {
        for text in [
            "",
            "inf",
            "NaN",
            "-infinity",
            "0x10",
            "1e",
            "e3",
            ".",
            "1..2",
            "1/0",
            "1/2/3",
            "1_000",
            "²",
            "1 2",
        ] {
            assert_eq!(nearest(text), None, "{text:?}");
        }
    }
}
