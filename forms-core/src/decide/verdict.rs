//! The three verdicts, and the error of a vacuous statement, whose conditions no point meets.

use super::reasons::{EmptyReason, UnknownReason};
use crate::syntax::ast::Claim;
use std::fmt;

/// Verdict on an equation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The equation holds at every point that meets its conditions.
    Proved(Theorem),
    /// The equation fails at an exact point that meets every condition.
    Refuted(Witness),
    /// Neither was shown.
    Unknown {
        /// The obstacle to a decision.
        reason: UnknownReason,
    },
    /// The statement is vacuous: no point meets its conditions, so it is an error.
    Empty {
        /// Reason why there is no such point.
        reason: EmptyReason,
    },
}

/// A proved equation with its assumptions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Theorem {
    /// The conditions, in the language's notation.
    pub conditions: Vec<String>,
}

/// A point at which two sides differ.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Witness {
    /// The conditions the point meets.
    pub conditions: Vec<String>,
    /// Names and exact values: variables, then unknown functions and their derivatives.
    pub point: Vec<(String, String)>,
    /// The component that differs, such as `dx^dy`; empty for scalars.
    pub component: String,
    /// The value of the left side there, to the digits that are certain.
    pub left: String,
    /// The value of the right side there.
    pub right: String,
    /// The difference left − right, simplified, in the language's notation.
    pub difference: String,
    /// The factor by which the sides differ, if it is a simple one.
    pub ratio: Option<Ratio>,
}

impl Verdict {
    /// Returns `proved`, `refuted`, `unknown` or `empty`.
    pub fn name(&self) -> &'static str {
        match self {
            Verdict::Proved(_) => "proved",
            Verdict::Refuted(_) => "refuted",
            Verdict::Unknown { .. } => "unknown",
            Verdict::Empty { .. } => "empty",
        }
    }

    /// Returns the reason why the statement is undecided or vacuous, in words.
    pub fn reason(&self) -> Option<String> {
        match self {
            Verdict::Proved(_) | Verdict::Refuted(_) => None,
            Verdict::Unknown { reason } => Some(reason.to_string()),
            Verdict::Empty { reason } => Some(reason.to_string()),
        }
    }

    /// Whether the verdict agrees with the claim of the statement.
    pub fn bears_out(&self, claim: Claim) -> bool {
        matches!((claim, self), (Claim::Prove, Verdict::Proved(_)) | (Claim::Refute, Verdict::Refuted(_)))
    }
}

/// Largest number of characters of a value that [`Witness::few_digits`] keeps.
const FIGURES: usize = 12;

impl Witness {
    /// Returns both values cut to their first figures: `0.2182178…`; a shorter value is unchanged.
    pub fn few_digits(&self) -> [String; 2] {
        [&self.left, &self.right].map(|value| match value.char_indices().nth(FIGURES) {
            Some((end, _)) => format!("{}…", &value[..end]),
            None => value.clone(),
        })
    }
}

impl fmt::Display for Witness {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let point: Vec<String> = self.point.iter().map(|(name, value)| format!("{name} = {value}")).collect();
        let point =
            if point.is_empty() { "everywhere".to_string() } else { format!("at {}", point.join(", ")) };
        let component = if self.component.is_empty() {
            String::new()
        } else {
            format!("the coefficient of {}: ", self.component)
        };
        write!(f, "{point}, {component}left = {}, right = {}", self.left, self.right)
    }
}

/// Factor between the sides: left = factor · right.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ratio {
    /// The factor in the language's notation.
    pub factor: String,
    /// The map whose Jacobian, or its reciprocal, is the factor up to a number.
    pub jacobian_of: Option<String>,
}

impl Ratio {
    /// Returns how the sides differ, and the equation between them.
    pub(crate) fn words_and_equation(&self) -> (&'static str, String) {
        let words = "the sides differ by a factor only";
        match (self.factor.as_str(), &self.jacobian_of) {
            ("-1", _) => ("the sides differ in sign only", "left = -right".to_owned()),
            (factor, None) => (words, format!("left/right = {factor}")),
            (factor, Some(map)) => {
                let origin = format!("the Jacobian of `{map}` or its inverse, up to a number");
                (words, format!("left/right = {factor}, which is {origin}"))
            }
        }
    }
}

impl fmt::Display for Ratio {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (words, equation) = self.words_and_equation();
        write!(f, "{words}: {equation}")
    }
}
