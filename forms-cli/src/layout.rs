//! Layout of text for a terminal with eighty columns.

use std::time::Duration;

/// Number of columns.
pub(crate) const WIDTH: usize = 80;

/// Breaks a text at spaces into indented lines of at most [`WIDTH`] columns; a longer word gets a
/// line of its own.
pub(crate) fn wrap(text: &str, indent: usize) -> Vec<String> {
    let fits = |line: &str, word: &str| indent + line.chars().count() + 1 + word.chars().count() <= WIDTH;
    let margin = " ".repeat(indent);
    filled(text, fits).into_iter().map(|line| margin.clone() + &line).collect()
}

/// Breaks a text at spaces into lines. Each line takes as many words as fit, and at least one.
pub(crate) fn filled(text: &str, fits: impl Fn(&str, &str) -> bool) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace().map(printable) {
        match lines.last_mut() {
            Some(line) if fits(line, &word) => {
                line.push(' ');
                line.push_str(&word);
            }
            _ => lines.push(word),
        }
    }
    lines
}

/// Formats a duration with about three digits: `85 µs`, `1.2 ms`, `3.40 s`.
pub(crate) fn duration(time: Duration) -> String {
    let micros = time.as_micros();
    match micros {
        0..1_000 => format!("{micros} µs"),
        1_000..1_000_000 => format!("{:.1} ms", micros as f64 / 1e3),
        _ => format!("{:.2} s", time.as_secs_f64()),
    }
}

/// Formats a number of seconds as [`duration`] does.
pub(crate) fn seconds(seconds: f64) -> String {
    duration(Duration::try_from_secs_f64(seconds).unwrap_or_default())
}

/// Returns a text with its control characters as escapes, so that names from files neither break a
/// table nor reach the terminal as commands.
fn printable(text: &str) -> String {
    let escaped = |c: char| if c.is_control() { c.escape_default().to_string() } else { c.to_string() };
    text.chars().map(escaped).collect()
}

/// Aligns rows in columns as wide as their widest entry, two spaces apart. Columns marked in
/// `right` are right-aligned.
pub(crate) fn columns<const N: usize>(rows: &[[String; N]], right: [bool; N]) -> Vec<String> {
    let rows: Vec<[String; N]> =
        rows.iter().map(|row| row.each_ref().map(|entry| printable(entry))).collect();
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: [usize; N] = std::array::from_fn(width);
    let entry = |(column, entry): (usize, &String)| {
        let width = widths[column];
        if right[column] { format!("{entry:>width$}") } else { format!("{entry:<width$}") }
    };
    let line = |row: &[String; N]| row.iter().enumerate().map(entry).collect::<Vec<_>>().join("  ");
    rows.iter().map(|row| line(row).trim_end().to_owned()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_characters_are_printed_as_escapes() {
        let rows = [["a\nb".to_owned(), "\u{1b}[31m".to_owned()]];
        assert_eq!(columns(&rows, [false; 2]), ["a\\nb  \\u{1b}[31m"]);
    }

    #[test]
    fn columns_are_aligned_and_end_with_their_text() {
        let rows = [["a", "b", "c"], ["µW", "1.5", ""]].map(|row| row.map(str::to_owned));
        assert_eq!(columns(&rows, [false, true, false]), ["a     b  c", "µW  1.5"]);
    }

    #[test]
    fn lines_are_broken_at_spaces_and_no_longer_than_the_terminal() {
        let text = "word ".repeat(40);
        let lines = wrap(&text, 6);
        assert!(lines.iter().all(|line| line.starts_with("      word") && line.len() <= WIDTH));
        assert_eq!(lines.join(" ").split_whitespace().count(), 40);
    }

    #[test]
    fn times_have_the_unit_that_suits_them() {
        let cases =
            [(0, "0 µs"), (999, "999 µs"), (1_240, "1.2 ms"), (999_949, "999.9 ms"), (3_400_000, "3.40 s")];
        for (micros, expected) in cases {
            assert_eq!(duration(Duration::from_micros(micros)), expected);
        }
    }
}
