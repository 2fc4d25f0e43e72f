//! Exact value of a number as written: `12`, `0.5`, `1e-3`.
//!
//! ```text
//! digits . fraction e exponent  =  (digits fraction) · 10^(exponent − length of the fraction)
//! ```

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::Zero;

/// Maximum number of digits of a number.
const MAXIMUM_DIGITS: usize = 10_000;

/// Largest magnitude of the power of ten after `e`.
const MAXIMUM_EXPONENT: i64 = 10_000;

/// Number of decimal digits that always fit a machine word.
const DIGITS_OF_A_WORD: usize = 19;

/// Maximum number of characters of a malformed number that a message quotes.
const LONGEST_QUOTED: usize = 40;

/// Reason why a text is not a number, with a suggestion.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Malformed {
    pub(super) message: String,
    pub(super) help: Option<String>,
}

/// Returns the number of bytes at the start of `text` that were meant as one number, well formed or
/// not. The two dots of a range are never part of it: `0..1` begins with `0`. A name that follows
/// without a space is part of it: `2x` is one error.
pub(super) fn extent(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits = |from: usize| from + bytes[from..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let mut end = digits(0);
    if bytes.get(end) == Some(&b'.') && bytes.get(end + 1) != Some(&b'.') {
        end = digits(end + 1);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        if bytes.get(end + 1 + sign).is_some_and(u8::is_ascii_digit) {
            end = digits(end + 1 + sign);
        }
    }
    let is_name = |byte: &&u8| byte.is_ascii_alphanumeric() || **byte == b'_';
    end + bytes[end..].iter().take_while(is_name).count()
}

/// Checks that a text is a number within the limits.
pub(super) fn check(text: &str) -> Result<(), Malformed> {
    if short(text).is_some() { Ok(()) } else { decimal(text).map(drop) }
}

/// Returns the value of a short run of digits, the most frequent kind of number.
fn short(text: &str) -> Option<u64> {
    let is_short = text.len() <= DIGITS_OF_A_WORD && text.bytes().all(|byte| byte.is_ascii_digit());
    if is_short { text.parse().ok() } else { None }
}

/// Returns the value of a number.
pub(super) fn value(text: &str) -> Result<BigRational, Malformed> {
    if let Some(number) = short(text) {
        return Ok(BigRational::from_integer(number.into()));
    }
    let (parts, exponent) = decimal(text)?;
    let digits = format!("{}{}", parts.whole, parts.fraction);
    let mantissa =
        BigInt::parse_bytes(digits.as_bytes(), 10).expect("the parts of a number are decimal digits");
    Ok(scaled(mantissa, exponent - parts.fraction.len() as i64))
}

/// Returns the parts of a number and its exponent, both within the limits.
fn decimal(text: &str) -> Result<(Parts<'_>, i64), Malformed> {
    let parts = Parts::of(text).ok_or_else(|| malformed(text))?;
    if parts.whole.len() + parts.fraction.len() > MAXIMUM_DIGITS {
        return Err(Malformed {
            message: format!("a number has at most {MAXIMUM_DIGITS} digits"),
            help: None,
        });
    }
    match parts.exponent.map_or(Ok(0), str::parse::<i64>) {
        Ok(exponent) if (-MAXIMUM_EXPONENT..=MAXIMUM_EXPONENT).contains(&exponent) => Ok((parts, exponent)),
        _ => {
            let message = format!("the power of ten of a number is at most {MAXIMUM_EXPONENT} in magnitude");
            Err(Malformed { message, help: Some("write a larger one with `**`".to_owned()) })
        }
    }
}

/// Returns `mantissa · 10^power` in lowest terms. One division precedes the greatest common
/// divisor, `gcd(m, 10^k) = gcd(m, 10^k mod m)`, since the two numbers can differ in length by
/// thousands of digits.
fn scaled(mantissa: BigInt, power: i64) -> BigRational {
    if mantissa.is_zero() {
        return BigRational::zero();
    }
    let size = u32::try_from(power.unsigned_abs()).expect("exponent and fraction are within their limits");
    let scale = BigInt::from(10).pow(size);
    if power >= 0 {
        return BigRational::from_integer(mantissa * scale);
    }
    let divisor = mantissa.gcd(&(&scale % &mantissa));
    BigRational::new_raw(mantissa / &divisor, scale / divisor)
}

/// The three runs of digits of a number.
struct Parts<'a> {
    whole: &'a str,
    fraction: &'a str,
    /// Exponent with its sign.
    exponent: Option<&'a str>,
}

impl<'a> Parts<'a> {
    /// Returns the parts of a well-formed number.
    fn of(text: &'a str) -> Option<Self> {
        let is_decimal = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
        let (mantissa, exponent) = match text.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, Some(exponent)),
            None => (text, None),
        };
        let (whole, fraction) = match mantissa.split_once('.') {
            Some((whole, fraction)) => (whole, Some(fraction)),
            None => (mantissa, None),
        };
        let unsigned = exponent.map(|part| part.strip_prefix(['+', '-']).unwrap_or(part));
        let well_formed =
            is_decimal(whole) && fraction.is_none_or(is_decimal) && unsigned.is_none_or(is_decimal);
        well_formed.then(|| Parts { whole, fraction: fraction.unwrap_or(""), exponent })
    }
}

/// Describes the error in a text that is not a number.
fn malformed(text: &str) -> Malformed {
    if text.len() > LONGEST_QUOTED {
        let message = format!("`{}…` is not a number", text.chars().take(LONGEST_QUOTED).collect::<String>());
        return Malformed { message, help: None };
    }
    let message = format!("`{text}` is not a number");
    let mark = text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len());
    let (digits, rest) = text.split_at(mark);
    let help = if digits.is_empty() {
        format!("write `0{text}`")
    } else if let Some(rest) =
        rest.strip_prefix('.').filter(|rest| !rest.starts_with(|c: char| c.is_ascii_digit()))
    {
        let product = if rest.is_empty() || has_exponent(rest) { "" } else { "*" };
        format!("write `{digits}.0{product}{rest}`")
    } else if text.contains('_') && text.bytes().all(|byte| byte.is_ascii_digit() || byte == b'_') {
        format!("write `{}`", text.replace('_', ""))
    } else if digits == "0" && rest.starts_with(['x', 'b', 'o']) {
        "numbers are decimal".to_owned()
    } else {
        match split_before_name(text) {
            (number, "f" | "F" | "f32" | "f64") => format!("numbers have no type: `{number}`"),
            (number, name) => format!("write `{number}*{name}` for a product"),
        }
    };
    Malformed { message, help: Some(help) }
}

/// Whether a text is an exponent: `e5`, `E-3`.
fn has_exponent(text: &str) -> bool {
    let digits = text.strip_prefix(['e', 'E']).map(|rest| rest.strip_prefix(['+', '-']).unwrap_or(rest));
    digits.is_some_and(|digits| !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit()))
}

/// Splits `2x` and `1e3x` at the start of the name.
fn split_before_name(text: &str) -> (&str, &str) {
    let is_number = |&at: &usize| text.get(..at).and_then(Parts::of).is_some();
    text.split_at((0..text.len()).rev().find(is_number).unwrap_or(0))
}
