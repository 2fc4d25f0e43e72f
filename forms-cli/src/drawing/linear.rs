//! A linear axis: round values along a range.

/// Returns approximately `about` round values in a range, with their texts: multiples of 1, 2 or 5
/// times a power of ten.
pub(crate) fn round_values(from: f64, to: f64, about: usize) -> Vec<(f64, String)> {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn round_values_lie_in_the_range_and_are_short() {
        let cases: [(f64, f64, &[&str]); 6] = [
            (0.0, 1.0, &["0", "0.2", "0.4", "0.6", "0.8", "1.0"]),
            (-1.0, 1.0, &["-1.0", "-0.5", "0", "0.5", "1.0"]),
            (0.0, std::f64::consts::PI, &["0", "1", "2", "3"]),
            (0.0, 4e7, &["0", "1e7", "2e7", "3e7", "4e7"]),
            (1.0, 1.0, &[]),
            (0.0, f64::NAN, &[]),
        ];
        for (from, to, expected) in cases {
            let found = round_values(from, to, 5);
            assert!(
                found.iter().all(|(value, _)| (from - 1e-9..=to + 1e-9 * to).contains(value)),
                "{found:?}"
            );
            let texts: Vec<&str> = found.iter().map(|(_, text)| text.as_str()).collect();
            assert_eq!(texts, expected, "from {from} to {to}");
        }
    }
}
