//! Kinds of errors: what an error promises.

use serde::{Deserialize, Serialize};

/// Meaning of an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum ErrorKind {
    /// Rigorous bound. Closed forms leave only rounding.
    Bound,
    /// Extrapolated from the convergence of the values: hardly ever exceeded, and not by much.
    Estimate,
    /// One standard error.
    Sigma,
}

impl ErrorKind {
    /// Returns its name, as in the program's output.
    pub fn name(self) -> &'static str {
        match self {
            Self::Bound => "bound",
            Self::Estimate => "estimate",
            Self::Sigma => "sigma",
        }
    }

    /// Returns its label, printed next to an error.
    pub fn words(self) -> &'static str {
        match self {
            Self::Bound => "bound",
            Self::Estimate => "estimate",
            Self::Sigma => "1 σ",
        }
    }

    /// Returns the kind of the sum of an error of this kind and an estimate.
    pub(crate) fn with_estimate(self) -> Self {
        if self == Self::Bound { Self::Estimate } else { self }
    }
}
