//! Significant digits: formats a value and its error with two digits of the error, and the value up
//! to the same decimal place.

/// The largest number of significant digits of an `f64`.
const MOST: i32 = 17;
/// Powers of ten of the first digit for which a number is written without an exponent: from −4 to
/// 6.
const LEAST_POWER: i32 = -4;
const MOST_POWER: i32 = 6;
/// Digits of a value with an unknown error.
const UNCERTAIN: usize = 6;

/// Formats a value and its error.
pub fn measured(value: f64, error: f64) -> [String; 2] {
    // removes the sign of a zero
    let value = value + 0.0;
    if !(value.is_finite() && error.is_finite()) {
        return [format!("{value:.UNCERTAIN$e}"), error.to_string()];
    }
    if error == 0.0 {
        return [plain_or_scientific(value), "0".to_owned()];
    }
    let size = power(value).max(power(error));
    // the decimal place of the last digit, as a power of ten
    let last = (power(error) - 1).max(size - MOST + 1);
    let value = match size {
        LEAST_POWER..=MOST_POWER if last <= 0 => fixed(value, last.unsigned_abs() as usize),
        _ => scientific(value, last),
    };
    let error = match power(error) {
        LEAST_POWER..=0 => format!("{error:.*}", (1 - power(error)) as usize),
        1..=MOST_POWER => format!("{error:.0}"),
        _ => format!("{error:.1e}"),
    };
    [value, error]
}

/// Formats a number of which only the order of magnitude matters.
pub fn rough(number: f64) -> String {
    match number {
        0.0 => "0".to_owned(),
        _ if number.is_finite() => format!("{number:.1e}"),
        _ => "unknown".to_owned(),
    }
}

/// Returns the power of ten of the first digit; for zero, a large negative number.
fn power(number: f64) -> i32 {
    if number == 0.0 { i32::MIN / 2 } else { number.abs().log10().floor() as i32 }
}

/// Formats a value with this many digits after the point, without a sign if all digits are zero.
fn fixed(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    let is_zero = !text.contains(|letter: char| matches!(letter, '1'..='9'));
    text.strip_prefix('-').filter(|_| is_zero).map_or_else(|| text.clone(), str::to_owned)
}

/// Formats a value in scientific notation with digits up to a decimal place; "0" for a value far
/// below it.
fn scientific(value: f64, last: i32) -> String {
    let digits = power(value) - last;
    if digits < 0 { "0".to_owned() } else { format!("{value:.*e}", digits as usize) }
}

fn plain_or_scientific(value: f64) -> String {
    match power(value) {
        LEAST_POWER..=MOST_POWER => value.to_string(),
        _ if value == 0.0 => "0".to_owned(),
        _ => format!("{value:e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_ends_where_its_error_does() {
        let cases = [
            (11.468_003_217, 1.234e-4, "11.46800", "0.00012"),
            (0.117_402_5, 3.4e-3, "0.1174", "0.0034"),
            (1_234.567, 12.3, "1235", "12"),
            (11.468_003_217, 2.3e-7, "11.46800322", "2.3e-7"),
            (-2.5, 0.5, "-2.50", "0.50"),
            (0.0, 1e-3, "0.0000", "0.0010"),
            (1.234_567e-9, 1.2e-13, "1.23457e-9", "1.2e-13"),
            (1.234_567e12, 3.0e5, "1.23456700e12", "300000"),
            (1.0e-12, 1.0e-9, "0", "1.0e-9"),
        ];
        for (value, error, shown, accuracy) in cases {
            assert_eq!(measured(value, error), [shown, accuracy], "{value} ± {error}");
        }
    }

    #[test]
    fn no_more_digits_are_shown_than_a_number_has() {
        let [value, error] = measured(1.0 / 3.0, 1e-30);
        assert_eq!((value.as_str(), error.as_str()), ("0.33333333333333331", "1.0e-30"));
    }

    #[test]
    fn a_zero_has_no_sign() {
        let cases = [
            (-0.0, 1e-3, "0.0000"),
            (-1e-9, 1e-3, "0.0000"),
            (-0.000_04, 1e-3, "0.0000"),
            (-0.000_06, 1e-3, "-0.0001"),
            (-0.0, 0.0, "0"),
            (-0.0, f64::INFINITY, "0.000000e0"),
            (-1.0e-12, 1.0e-9, "0"),
        ];
        for (value, error, shown) in cases {
            assert_eq!(measured(value, error)[0], shown, "{value} ± {error}");
        }
    }

    #[test]
    fn exact_and_unknown_values_are_shown_too() {
        assert_eq!(measured(0.5, 0.0), ["0.5", "0"]);
        assert_eq!(measured(0.0, 0.0), ["0", "0"]);
        assert_eq!(measured(2.5e-20, 0.0), ["2.5e-20", "0"]);
        assert_eq!(measured(1.0, f64::INFINITY), ["1.000000e0", "inf"]);
    }
}
