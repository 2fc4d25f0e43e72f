//! Entries of a certificate: the lines that prove a verdict, or the reason why there are none.

use std::fmt;

/// Entry of one statement; its text begins with an empty line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Name of the statement.
    pub statement: String,
    /// Lines from which the verdict can be checked.
    pub lines: Result<String, Uncovered>,
}

impl fmt::Display for Entry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.lines {
            Ok(lines) => write!(f, "\n{lines}"),
            Err(reason) => writeln!(f, "\nuncovered {} {reason}", self.statement),
        }
    }
}

/// Reason why a certificate does not cover a statement.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Uncovered {
    /// The statement is not decided.
    Undecided,
    /// The proof needs tactics that leave no trace.
    NotReproduced,
    /// A base or unit is too long to be written.
    LongPart,
    /// The proof uses the sine or cosine of a rational multiple of π.
    Chord,
    /// The checker refused the entry, for the given reason.
    Refused(String),
}

impl fmt::Display for Uncovered {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Uncovered::Undecided => write!(f, "the statement is not decided"),
            Uncovered::NotReproduced => write!(f, "the proof could not be reproduced"),
            Uncovered::LongPart => write!(f, "a base or unit of the proof is too long to be written"),
            Uncovered::Chord => write!(f, "the sine or cosine of a rational multiple of pi"),
            // Line breaks are removed: each line of a certificate is an entry of its own.
            Uncovered::Refused(reason) => write!(f, "{}", reason.replace(['\r', '\n'], " ")),
        }
    }
}
