//! A checker of certificates, independent of the prover: it shares the file format with it and nothing else.
//!
//! ```text
//! source file ─▶ tokens ─▶ theory, evaluate ─▶ both sides, conditions      (expression, calculus, metric)
//! antiderivatives ─▶ F′ = f, continuity ─▶ values of integrals              (integral, continuity)
//! certificate ─▶ proof   ─▶ bases, units, signs ─▶ is left − right zero?   (field, element, circle, sign, polynomial)
//!             └▶ witness ─▶ a point             ─▶ are left and right apart? (interval)
//! ```
//! A certificate chooses: which polynomials have roots, what angles are multiples of, which signs are told apart
//! and why, at which point sides differ. The checker derives everything else, so a wrong choice is rejected and
//! no choice makes it accept what does not follow from the source.

mod calculus;
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
mod metric;
mod point;
mod polynomial;
mod proof;
mod sign;
mod theory;
mod tokens;
mod witness;

/// What became of one entry of a certificate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// The verdict follows from the source.
    Accepted,
    /// The entry does not show what it claims.
    Rejected(String),
    /// It rests on something that the checker does not know.
    NotCovered(String),
}

/// What a statement is claimed to be, and what an entry shows of it: true, or false.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Claim {
    /// `prove`: it holds at every point it speaks of, and it speaks of some.
    Prove,
    /// `refute`: it fails at one of them.
    Refute,
}

/// One statement of one file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Checked {
    /// The file as the certificate names it.
    pub file: String,
    /// The statement's name.
    pub name: String,
    /// What the file says of it.
    pub claim: Claim,
    /// What an accepted entry shows of it.
    pub shown: Option<Claim>,
    /// What was found.
    pub outcome: Outcome,
}

impl Checked {
    /// Whether it is shown to be as the file says.
    pub fn is_as_stated(&self) -> bool {
        self.shown == Some(self.claim)
    }
}

/// Checks a certificate. `read` gives the text of a file that it names.
///
/// # Errors
/// What is malformed: the certificate, or a file that cannot be read or is not the one that was certified.
pub fn check(
    certificate: &str,
    mut read: impl FnMut(&str) -> Result<String, String>,
) -> Result<Vec<Checked>, String> {
    certificate::check(certificate, &mut read).map_err(Stop::into_text)
}

/// Why a check ends early.
#[derive(Clone, Debug)]
pub(crate) enum Stop {
    Malformed(String),
    Rejected(String),
    Uncovered(String),
    /// Something divides by zero everywhere.
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
