//! Numbers of an axis: round values along a range, with short texts.

/// Superscript digits for exponents.
const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
/// Thin space between groups of three digits.
const THIN: char = '\u{2009}';

/// Values of an axis, in decimal logarithms if the axis is logarithmic.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Ticks {
    /// Values with a text.
    pub(crate) labelled: Vec<(f64, String)>,
    /// Values with a fine line of the grid only.
    pub(crate) fine: Vec<f64>,
}

/// Returns approximately `about` round values in a range, with their texts: multiples of 1, 2 or 5
/// times a power of ten.
pub(crate) fn linear([from, to]: [f64; 2], about: usize) -> Vec<(f64, String)> {
    let wanted = (to - from) / about.max(1) as f64;
    if !wanted.is_finite() || wanted <= 0.0 {
        return Vec::new();
    }
    let power = wanted.log10().floor();
    let unit = 10f64.powf(power);
    let step = [1.0, 2.0, 5.0, 10.0].map(|factor| factor * unit).into_iter().find(|step| *step >= wanted);
    let step = step.unwrap_or(10.0 * unit);
    // Beyond the precision of the numbers, multiples cannot be distinguished.
    if (from.abs().max(to.abs()) / step) > 1e12 {
        return Vec::new();
    }
    let slack = 1e-9 * step;
    let first = ((from - slack) / step).ceil() as i64;
    let multiples = (first..).map(|multiple| multiple as f64 * step).take_while(|value| *value <= to + slack);
    multiples.map(|value| (value, short(value, step))).collect()
}

/// Formats a value with the digits of a step; large and small values with a power of ten.
fn short(value: f64, step: f64) -> String {
    let size = value.abs().max(step);
    if !(1e-4..1e6).contains(&size) {
        let digits = (size.log10().floor() - step.log10().floor()).clamp(0.0, 15.0) as usize;
        let text = format!("{value:.digits$e}");
        return if value == 0.0 { "0".to_owned() } else { text };
    }
    let places = (-(step.log10() + 1e-9).floor()).clamp(0.0, 15.0) as usize;
    let text = format!("{value:.places$}");
    if text.trim_start_matches(['-', '0', '.']).is_empty() { "0".to_owned() } else { text }
}

/// Returns round values of a range of decimal logarithms: 1, 2 and 5 of each decade if their
/// distance is at least `apart`, a fraction of the range, or only the first value of each decade, or
/// of every second one, and so on. The text of a value is a function of its digit and its exponent.
pub(crate) fn logarithmic([from, to]: [f64; 2], apart: f64, text: impl Fn(i32, i32) -> String) -> Ticks {
    let decade = 1.0 / (to - from);
    let digits: &[i32] = if decade * 2_f64.log10() >= apart { &[1, 2, 5] } else { &[1] };
    let every = (apart / decade).ceil().max(1.0) as i32;
    let exponents = || from.floor() as i32..=to.ceil() as i32;
    let value = |digit: i32, exponent: i32| f64::from(digit).log10() + f64::from(exponent);
    let slack = 1e-6 * (to - from);
    let is_inside = |value: f64| (from - slack..=to + slack).contains(&value);
    let labelled = exponents()
        .filter(|exponent| exponent.rem_euclid(every) == 0)
        .flat_map(|exponent| digits.iter().map(move |&digit| (digit, exponent)))
        .map(|(digit, exponent)| (value(digit, exponent), text(digit, exponent)))
        .filter(|(value, _)| is_inside(*value));
    let has_room = decade * (10.0 / 9.0_f64).log10() * 200.0 >= 1.0;
    let all = exponents().flat_map(|exponent| (1..10).map(move |digit| (digit, exponent)));
    let fine = all
        .filter(|(digit, _)| !digits.contains(digit) && has_room)
        .map(|(digit, exponent)| value(digit, exponent))
        .filter(|value| is_inside(*value));
    Ticks { labelled: labelled.collect(), fine: fine.collect() }
}

/// Formats digit · 10^exponent; long numbers are written as powers of ten.
pub(crate) fn power(digit: i32, exponent: i32) -> String {
    match exponent {
        0..=3 => (digit * 10_i32.pow(exponent as u32)).to_string(),
        -3..0 => format!("0.{}{digit}", "0".repeat((-exponent - 1) as usize)),
        4 if digit == 1 => format!("10{THIN}000"),
        _ if digit == 1 => format!("10{}", raised(exponent)),
        _ => format!("{digit}·10{}", raised(exponent)),
    }
}

fn raised(power: i32) -> String {
    let digit = |c: char| c.to_digit(10).map_or('⁻', |digit| RAISED[digit as usize]);
    power.to_string().chars().map(digit).collect()
}

/// Formats digit · 10^exponent with a unit, given the exponent of the first unit and the units, each
/// a thousand of the one before.
pub(crate) fn with_unit(digit: i32, exponent: i32, first: i32, units: &[&str]) -> String {
    let thousand = (exponent - first).div_euclid(3).clamp(0, units.len() as i32 - 1);
    let number = power(digit, exponent - first - 3 * thousand);
    format!("{number} {}", units[thousand as usize])
}

/// Formats digit · 10^exponent as a whole number with groups of thousands: `10 000`.
pub(crate) fn thousands(digit: i32, exponent: i32) -> String {
    if !(0..=9).contains(&exponent) {
        return power(digit, exponent);
    }
    let digits = format!("{digit}{}", "0".repeat(exponent as usize));
    let mut grouped = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            grouped.push(THIN);
        }
        grouped.push(digit);
    }
    grouped
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn linear_values_lie_in_the_range_and_are_short() {
        let cases: [(f64, f64, &[&str]); 6] = [
            (0.0, 1.0, &["0", "0.2", "0.4", "0.6", "0.8", "1.0"]),
            (-1.0, 1.0, &["-1.0", "-0.5", "0", "0.5", "1.0"]),
            (0.0, std::f64::consts::PI, &["0", "1", "2", "3"]),
            (0.0, 4e7, &["0", "1e7", "2e7", "3e7", "4e7"]),
            (1.0, 1.0, &[]),
            (0.0, f64::NAN, &[]),
        ];
        for (from, to, expected) in cases {
            let found = linear([from, to], 5);
            assert!(
                found.iter().all(|(value, _)| (from - 1e-9..=to + 1e-9 * to).contains(value)),
                "{found:?}"
            );
            let texts: Vec<&str> = found.iter().map(|(_, text)| text.as_str()).collect();
            assert_eq!(texts, expected, "from {from} to {to}");
        }
    }

    #[test]
    fn logarithmic_values_are_as_far_apart_as_asked() {
        for (range, apart) in [([-1.3, 0.4], 0.06), ([-16.0, 2.0], 0.08), ([-3.0, 3.0], 0.2)] {
            let ticks = logarithmic(range, apart, power);
            assert!(ticks.labelled.len() >= 3, "{ticks:?}");
            let [from, to] = range;
            let is_inside = |value: f64| (from - 1e-4..=to + 1e-4).contains(&value);
            assert!(ticks.labelled.iter().all(|(value, _)| is_inside(*value)), "{ticks:?}");
            let distance = |two: &[(f64, String)]| (two[1].0 - two[0].0) / (to - from);
            assert!(ticks.labelled.windows(2).all(|two| distance(two) >= apart - 1e-9), "{ticks:?}");
        }
    }

    #[test]
    fn texts_are_short() {
        let cases = [(1, -2), (5, -1), (2, 3), (1, 4), (5, 4), (1, 6), (1, -4), (2, -12)];
        let found = cases.map(|(digit, exponent)| power(digit, exponent));
        assert_eq!(found, ["0.01", "0.5", "2000", "10\u{2009}000", "5·10⁴", "10⁶", "10⁻⁴", "2·10⁻¹²"]);
        let seconds = ["ns", "µs", "ms", "s"];
        let cases = [(1, -9), (2, -8), (1, -6), (5, -1), (1, 1), (1, -10)];
        let found = cases.map(|(digit, exponent)| with_unit(digit, exponent, -9, &seconds));
        assert_eq!(found, ["1 ns", "20 ns", "1 µs", "500 ms", "10 s", "0.1 ns"]);
        assert_eq!(
            [(1, 0), (1, 3), (2, 6)].map(|(digit, exponent)| thousands(digit, exponent)),
            ["1".to_owned(), "1\u{2009}000".to_owned(), "2\u{2009}000\u{2009}000".to_owned()]
        );
    }
}
