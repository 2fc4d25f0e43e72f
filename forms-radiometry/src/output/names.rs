//! File names: converts names of receivers to valid names of files.

use std::collections::HashSet;

/// Number of bytes of a name that are kept.
const LONGEST: usize = 100;
/// Names that denote devices instead of files on Windows. In COM1, LPT1 and similar names a digit
/// follows.
const DEVICES: [&str; 4] = ["con", "prn", "aux", "nul"];
const NUMBERED_DEVICES: [&str; 2] = ["com", "lpt"];

/// Returns a name for each name that every file system accepts. All names are distinct, even where
/// upper and lower case are not distinguished. They have no extension.
///
/// Letters, digits, `-` and `_` are kept, any other character becomes `_`, and a name that is
/// already taken gets `_2`, `_3` and so on.
pub fn file_names<'n>(names: impl IntoIterator<Item = &'n str>) -> Vec<String> {
    let mut taken = HashSet::new();
    names.into_iter().map(|name| unlike(&safe(name), &mut taken)).collect()
}

fn safe(name: &str) -> String {
    let kept = |c: char| if c.is_alphanumeric() || c == '-' || c == '_' { c } else { '_' };
    let mut safe: String = name.chars().map(kept).collect();
    while safe.len() > LONGEST {
        safe.pop();
    }
    if safe.is_empty() || is_device(&safe) {
        safe.push('_');
    }
    safe
}

fn is_device(name: &str) -> bool {
    let name = name.to_lowercase();
    let is_digit = |rest: &str| rest.len() == 1 && rest.as_bytes()[0].is_ascii_digit();
    let is_numbered = |device: &&str| name.strip_prefix(*device).is_some_and(is_digit);
    DEVICES.contains(&name.as_str()) || NUMBERED_DEVICES.iter().any(is_numbered)
}

/// Returns the name, or the first numbered variant that is not taken.
fn unlike(name: &str, taken: &mut HashSet<String>) -> String {
    let others = (2_u64..).map(|number| format!("{name}_{number}"));
    let mut candidates = std::iter::once(name.to_owned()).chain(others);
    let free = candidates.find(|candidate| taken.insert(candidate.to_lowercase()));
    free.expect("there are more numbers than names")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_have_letters_digits_dashes_and_underscores_only() {
        let names = [
            "floor",
            "Fußboden 2",
            "../../etc/passwd",
            "a:b*c?",
            "",
            ".",
            "con",
            "Lpt1",
            "com",
            "lpt\u{661}",
        ];
        let expected = [
            "floor",
            "Fußboden_2",
            "______etc_passwd",
            "a_b_c_",
            "_",
            "__2",
            "con_",
            "Lpt1_",
            "com",
            "lpt\u{661}",
        ];
        assert_eq!(file_names(names), expected);
    }

    #[test]
    fn names_differ_even_without_regard_to_case() {
        assert_eq!(
            file_names(["a b", "a_b", "A.B", "a_b_2", "c"]),
            ["a_b", "a_b_2", "A_B_3", "a_b_2_2", "c"]
        );
    }

    #[test]
    fn long_names_are_cut_between_characters_and_still_differ() {
        let long = ["ä".repeat(200), "ä".repeat(201)];
        let names = file_names(long.iter().map(String::as_str));
        assert_eq!(names, ["ä".repeat(50), format!("{}_2", "ä".repeat(50))]);
    }
}
