//! Deciding statements: an exact proof, an exact counterexample, or neither.
//!
//! ```text
//! statement ─▶ differences by component + what may be assumed
//!      │ witness: exact points, values enclosed            ─▶ Refuted
//!      │ region:  signs of radicand factors, case by case
//!      └ normal forms, zero in every case                  ─▶ Proved
//!                                                     else ─▶ Unknown
//! ```
//! A proof never rests on a sample, a refutation never on a normal form: each has an argument of its own.

mod verdict;

pub use verdict::{Theorem, Verdict, Witness};

use crate::resolve::{Statement, Theory};

/// Decides one statement.
pub fn decide(theory: &mut Theory, statement: &Statement) -> Verdict {
    let _ = (theory, statement);
    Verdict::Unknown { reason: "not decided".into() }
}
