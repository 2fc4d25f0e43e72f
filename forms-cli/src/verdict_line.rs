//! A statement with its verdict, formatted for a terminal.

use crate::layout::{duration, wrap};
use crate::palette::Palette;
use forms::core::decide::{Verdict, Witness};
use forms::core::syntax::ast::Claim;
use forms::core::theory::Statement;
use std::time::Duration;

/// Columns for the name of a statement; a longer name moves the verdict to the right.
const NAME: usize = 44;
/// Columns for the verdict.
pub(crate) const WORDS: usize = 16;
/// Indent of the lines below a statement.
pub(crate) const INDENT: usize = 6;
/// Suffix of the names of equations that are wrong in their source.
const AS_PRINTED: &str = "_as_printed";

/// Longest list of conditions, in characters; further conditions are only counted.
const LONGEST_LIST: usize = 240;

/// Decided statement.
pub(crate) struct Decided {
    pub(crate) statement: Statement,
    pub(crate) verdict: Verdict,
    pub(crate) time: Duration,
}

impl Decided {
    /// Whether the verdict agrees with the claim.
    pub(crate) fn ok(&self) -> bool {
        self.verdict.bears_out(self.statement.claim)
    }

    /// Whether this is a printed equation that has been refuted as claimed.
    pub(crate) fn is_wrong_as_printed(&self) -> bool {
        self.ok() && self.statement.claim == Claim::Refute && self.statement.name.ends_with(AS_PRINTED)
    }

    /// Returns the verdict in words.
    pub(crate) fn words(&self) -> &'static str {
        match (&self.verdict, self.statement.claim) {
            (Verdict::Proved(_), Claim::Prove) => "proved",
            (Verdict::Refuted(_), Claim::Refute) if self.is_wrong_as_printed() => "wrong as printed",
            (Verdict::Refuted(_), Claim::Refute) => "refuted",
            (Verdict::Proved(_), Claim::Refute) => "holds after all",
            (Verdict::Refuted(_), Claim::Prove) => "does not hold",
            (Verdict::Unknown { .. }, _) => "unknown",
            (Verdict::Empty { .. }, _) => "vacuous",
        }
    }

    /// Formats mark, name, verdict and time in one line.
    pub(crate) fn line(&self, palette: Palette) -> String {
        let words = format!("{:WORDS$}", self.words());
        let (mark, words) = match (self.ok(), self.statement.claim) {
            (true, Claim::Prove) => (palette.good("✓"), words),
            (true, Claim::Refute) => (palette.good("✓"), palette.notable(&words)),
            (false, _) => (palette.bad("✗"), palette.bad(&words)),
        };
        line(palette, &mark, &self.statement.name, &words, self.time)
    }

    /// Returns the grounds of the verdict: the conditions, the witness, or the reason why there is
    /// no verdict.
    pub(crate) fn grounds(&self, palette: Palette) -> Vec<String> {
        let text = match &self.verdict {
            Verdict::Proved(theorem) if theorem.conditions.is_empty() => return vec![],
            Verdict::Proved(theorem) => format!("where {}", listed(&theorem.conditions)),
            Verdict::Refuted(witness) => refutation(witness),
            Verdict::Unknown { reason } => reason.to_string(),
            Verdict::Empty { reason } => reason.to_string(),
        };
        wrap(&text, INDENT).iter().map(|line| palette.quiet(line)).collect()
    }
}

/// Formats mark, name, verdict and time in one line. Mark and verdict are already coloured.
pub(crate) fn line(palette: Palette, mark: &str, name: &str, words: &str, time: Duration) -> String {
    let time = palette.quiet(&format!("{:>9}", duration(time)));
    format!("  {mark} {name:NAME$}  {words} {time}")
}

/// Formats the witness and, if the sides differ by a simple factor, that factor.
fn refutation(witness: &Witness) -> String {
    let point = in_short(witness).to_string();
    witness.ratio.as_ref().map_or(point.clone(), |ratio| format!("{point}; {ratio}"))
}

/// Returns the witness with the first digits of both sides.
fn in_short(witness: &Witness) -> Witness {
    let [left, right] = witness.few_digits();
    Witness { left, right, ..witness.clone() }
}

/// Lists conditions; those that would make the list too long are only counted.
fn listed(conditions: &[String]) -> String {
    let mut list = String::new();
    for (place, condition) in conditions.iter().enumerate() {
        if list.len() + condition.len() > LONGEST_LIST {
            let rest = conditions.len() - place;
            let more = format!("{rest} {}", if place == 0 { "long conditions hold" } else { "more" });
            return if place == 0 { more } else { format!("{list}, and {more}") };
        }
        if place > 0 {
            list.push_str(", ");
        }
        list.push_str(condition);
    }
    list
}
