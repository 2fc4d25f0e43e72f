//! Faults: what a kernel claims of itself and was not shown, each with its verdict and the message to its author.

use crate::decide::{Verdict, Witness};
use crate::diagnostic::{Diagnostic, Span};

/// What a kernel claims of itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Claim {
    /// The form behind `by` has the value of the formula wherever the formula has one.
    By,
    /// The branches of an `if` agree where its condition begins to hold.
    Seam,
    /// The kernel has a value where an effect vanishes.
    Effect,
    /// It can be computed at all.
    Kernel,
}

impl Claim {
    /// `by`, `seam`, `effect` or `kernel`.
    pub fn name(self) -> &'static str {
        match self {
            Claim::By => "by",
            Claim::Seam => "seam",
            Claim::Effect => "effect",
            Claim::Kernel => "kernel",
        }
    }
}

/// A claim of a kernel that is false, or of which nothing is known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The name of the kernel.
    pub kernel: String,
    /// What is claimed.
    pub claim: Claim,
    /// Refuted, or unknown.
    pub verdict: Verdict,
    /// What the author of the kernel is told.
    pub diagnostic: Diagnostic,
}

impl Fault {
    pub(super) fn refuted(kernel: &str, claim: Claim, witness: Witness, diagnostic: Diagnostic) -> Self {
        Fault { kernel: kernel.to_string(), claim, verdict: Verdict::Refuted(witness), diagnostic }
    }

    pub(super) fn unknown(kernel: &str, claim: Claim, reason: String, diagnostic: Diagnostic) -> Self {
        Fault { kernel: kernel.to_string(), claim, verdict: Verdict::Unknown { reason }, diagnostic }
    }

    /// A claim that could not be looked at, for the reason that its author is told.
    pub(super) fn told(kernel: &str, claim: Claim, diagnostic: Diagnostic) -> Self {
        Self::unknown(kernel, claim, diagnostic.message.clone(), diagnostic)
    }

    /// Where the kernel stands.
    pub fn span(&self) -> Span {
        self.diagnostic.span
    }
}
