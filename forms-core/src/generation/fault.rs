//! Faults: claims of a kernel about itself that were not proved, each with its verdict and the
//! message to its author.

use crate::decide::{KernelReason, UnknownReason, Verdict, Witness};
use crate::diagnostic::{Diagnostic, Span};

/// Claim of a kernel about itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Claim {
    /// The form given after `by` has the value of the formula wherever the formula has one.
    By,
    /// The branches of an `if` agree where its condition begins to hold.
    Seam,
    /// The kernel has a value where an effect vanishes.
    Effect,
    /// The kernel can be computed at all.
    Kernel,
}

impl Claim {
    /// Returns `by`, `seam`, `effect` or `kernel`.
    pub fn name(self) -> &'static str {
        match self {
            Claim::By => "by",
            Claim::Seam => "seam",
            Claim::Effect => "effect",
            Claim::Kernel => "kernel",
        }
    }
}

/// Claim of a kernel that is false or undecided.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The name of the kernel.
    pub kernel: String,
    /// The claim.
    pub claim: Claim,
    /// Refuted, or unknown.
    pub verdict: Verdict,
    /// Message to the author of the kernel.
    pub diagnostic: Diagnostic,
}

impl Fault {
    pub(super) fn refuted(kernel: &str, claim: Claim, witness: Witness, diagnostic: Diagnostic) -> Self {
        Fault { kernel: kernel.to_string(), claim, verdict: Verdict::Refuted(witness), diagnostic }
    }

    pub(super) fn unknown(kernel: &str, claim: Claim, reason: UnknownReason, diagnostic: Diagnostic) -> Self {
        Fault { kernel: kernel.to_string(), claim, verdict: Verdict::Unknown { reason }, diagnostic }
    }

    /// Builds the fault of a claim that could not be examined, for the reason in the diagnostic.
    pub(super) fn told(kernel: &str, claim: Claim, diagnostic: Diagnostic) -> Self {
        let reason = KernelReason::Reported(diagnostic.message.clone());
        Self::unknown(kernel, claim, reason.into(), diagnostic)
    }

    /// Returns the location of the kernel in its source.
    pub fn span(&self) -> Span {
        self.diagnostic.span
    }
}
