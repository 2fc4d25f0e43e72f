//! A checker of certificates, independent of the prover: the two share the file format and nothing
//! else.
//!
//! ```text
//! source file ─▶ tokens ─▶ theory, evaluate ─▶ both sides, conditions      (call, expression, calculus, metric)
//! antiderivatives ─▶ F′ = f, continuity ─▶ values of integrals              (integral, continuity)
//! certificate ─▶ proof   ─▶ bases, units, signs ─▶ is left − right zero?   (field, element, circle, sign, polynomial)
//!             └▶ witness ─▶ a point             ─▶ do left and right differ? (interval)
//! ```
//! A certificate makes choices: which polynomials have roots, of which units the angles are
//! multiples, which cases of signs are distinguished and why, and at which point the sides differ.
//! The checker derives everything else, so a wrong choice is rejected and no choice makes it accept
//! a claim that does not follow from the source.

mod calculus;
mod call;
mod certificate;
mod circle;
mod continuity;
mod domain;
mod element;
mod evaluate;
mod expression;
mod field;
mod integral;
mod interval;
mod line;
mod point;
mod polynomial;
mod proof;
mod sign;
mod theory;
mod tokens;
mod witness;

/// Outcome of the check of one entry of a certificate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// The verdict follows from the source.
    Accepted,
    /// The entry does not prove its claim.
    Rejected(String),
    /// The entry depends on something outside the checker's coverage.
    NotCovered(String),
}

/// Claim of a statement, and the result that an entry shows for it: true, or false.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Claim {
    /// `prove`: the equation holds at every point that satisfies the conditions, and there is such
    /// a point.
    Prove,
    /// `refute`: the equation fails at such a point.
    Refute,
}

/// Check result for one statement of one file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Checked {
    /// File name, as in the certificate.
    pub file: String,
    /// Name of the statement.
    pub name: String,
    /// Claim of the file about the statement.
    pub claim: Claim,
    /// Claim that an accepted entry shows.
    pub shown: Option<Claim>,
    /// Outcome of the check.
    pub outcome: Outcome,
}

impl Checked {
    /// Whether the claim of the file is shown.
    pub fn is_as_stated(&self) -> bool {
        self.shown == Some(self.claim)
    }
}

/// Checks a certificate. `read` returns the text of a file that the certificate names.
///
/// # Errors
/// If the certificate is malformed, or if a file cannot be read or is not the certified one.
pub fn check(
    certificate: &str,
    mut read: impl FnMut(&str) -> Result<String, String>,
) -> Result<Vec<Checked>, String> {
    certificate::check(certificate, &mut read).map_err(Stop::into_text)
}

/// Reason why a check ends early.
#[derive(Clone, Debug)]
pub(crate) enum Stop {
    Malformed(String),
    Rejected(String),
    Uncovered(String),
    /// An expression divides by zero everywhere.
    Undefined,
}

impl Stop {
    fn into_text(self) -> String {
        match self {
            Stop::Malformed(what) | Stop::Rejected(what) | Stop::Uncovered(what) => what,
            Stop::Undefined => "division by zero".into(),
        }
    }
}

fn malformed(what: impl Into<String>) -> Stop {
    Stop::Malformed(what.into())
}

fn rejected<T>(why: impl Into<String>) -> Result<T, Stop> {
    Err(Stop::Rejected(why.into()))
}

fn uncovered<T>(what: impl Into<String>) -> Result<T, Stop> {
    Err(Stop::Uncovered(what.into()))
}
