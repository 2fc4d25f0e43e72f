//! Verdicts in words and formulas.

use super::print_markdown;
use crate::decide::{Ratio, Verdict, Witness};
use crate::derivation::{assignment, digits};

impl Verdict {
    /// Returns the verdict in Markdown: the conditions of a proof, or the point of a counterexample
    /// in LaTeX with both values.
    pub fn markdown(&self) -> String {
        match self {
            Verdict::Proved(theorem) if theorem.conditions.is_empty() => "**proved**".to_owned(),
            Verdict::Proved(theorem) => format!("**proved** where {}", codes(&theorem.conditions)),
            Verdict::Refuted(witness) => format!("**refuted** {}", contradiction(witness)),
            Verdict::Unknown { reason } => format!("**unknown**: {}", super::escaped(&reason.to_string())),
            Verdict::Empty { reason } => format!("**empty**: {}", super::escaped(&reason.to_string())),
        }
    }

    /// Shows the verdict in a cell of a notebook.
    pub fn evcxr_display(&self) {
        let plain = match self {
            Verdict::Proved(theorem) if theorem.conditions.is_empty() => "proved".to_owned(),
            Verdict::Proved(theorem) => format!("proved where {}", theorem.conditions.join(", ")),
            Verdict::Refuted(witness) => format!("refuted {witness}"),
            Verdict::Unknown { reason } => format!("unknown: {reason}"),
            Verdict::Empty { reason } => format!("empty: {reason}"),
        };
        print_markdown(&self.markdown(), &plain);
    }
}

/// Writes a counterexample: at u = 2, v = 1: left = −0.188…, right = 2.449… in the coefficient of
/// du^dv
fn contradiction(witness: &Witness) -> String {
    let point: Vec<String> =
        witness.point.iter().map(|(name, value)| assignment(name, value).latex).collect();
    let place =
        if point.is_empty() { "everywhere".to_owned() } else { format!("at ${}$", point.join(",\\; ")) };
    let component = match witness.component.as_str() {
        "" => String::new(),
        component => format!(" in the coefficient of `{component}`"),
    };
    let [left, right] = witness.few_digits().map(|value| digits(&value));
    let ratio = witness.ratio.as_ref().map(Ratio::words_and_equation);
    let ratio = ratio.map_or(String::new(), |(words, equation)| format!("; {words}: `{equation}`"));
    format!("{place}: left $= {left}$, right $= {right}${component}{ratio}")
}

/// Number of conditions that are shown; the others are only counted.
const SHOWN: usize = 3;

/// Returns texts of the language as a list of code spans.
fn codes(texts: &[String]) -> String {
    let mut codes: Vec<String> = texts.iter().take(SHOWN).map(|text| format!("`{text}`")).collect();
    if texts.len() > SHOWN {
        codes.push(format!("and {} more", texts.len() - SHOWN));
    }
    codes.join(", ")
}
