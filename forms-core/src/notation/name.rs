//! Names in mathematical typesetting: `theta` is θ, and `sigma_a` and `n2` have subscripts.

const GREEK: &[&str] = &[
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu",
    "nu", "xi", "pi", "rho", "sigma", "tau", "upsilon", "phi", "chi", "psi", "omega", "Gamma", "Delta",
    "Theta", "Lambda", "Xi", "Pi", "Sigma", "Upsilon", "Phi", "Psi", "Omega",
];

/// Writes a name in LaTeX. Trailing digits and the words after an underscore are subscripts.
pub(super) fn latex_name(name: &str) -> String {
    let (head, rest) = name.split_once('_').unwrap_or((name, ""));
    if head.is_empty() {
        return format!("\\mathrm{{{}}}", name.replace('_', "\\_"));
    }
    let letters = head.trim_end_matches(|c: char| c.is_ascii_digit());
    let mut below: Vec<String> = Vec::new();
    if letters.len() < head.len() {
        below.push(head[letters.len()..].to_string());
    }
    below.extend(rest.split('_').filter(|part| !part.is_empty()).map(word));
    if below.is_empty() { word(letters) } else { format!("{}_{{{}}}", word(letters), below.join(",")) }
}

/// Writes one letter as itself, the name of a Greek letter as that letter, and any other word
/// upright.
fn word(letters: &str) -> String {
    if GREEK.contains(&letters) {
        return format!("\\{letters}");
    }
    let plain = letters.chars().count() == 1 || letters.chars().all(|c| c.is_ascii_digit());
    if plain { letters.to_string() } else { format!("\\mathrm{{{letters}}}") }
}

#[cfg(test)]
mod tests {
    use super::latex_name;

    #[test]
    fn names_are_set_as_letters_greek_letters_and_words_with_subscripts() {
        let cases = [
            ("x", "x"),
            ("theta", "\\theta"),
            ("n2", "n_{2}"),
            ("sigma_a", "\\sigma_{a}"),
            ("cos_oh", "\\mathrm{cos}_{\\mathrm{oh}}"),
            ("r2_old", "r_{2,\\mathrm{old}}"),
            ("density", "\\mathrm{density}"),
            ("x_", "x"),
            ("_a", "\\mathrm{\\_a}"),
        ];
        for (name, expected) in cases {
            assert_eq!(latex_name(name), expected, "{name}");
        }
    }
}
