//! Goals of proofs by normal forms: their parts, their context and their outcome.

use super::problem::Problem;
use super::reasons::{EmptyReason, UnknownReason};
use crate::expression::{Condition, Expr, Pool};

/// Outcome of a proof by normal forms.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Outcome {
    /// Every difference is zero in every case.
    Zero,
    /// Some difference is not zero in some case; that case may still contain no point.
    NotZero,
    /// The normal forms decide nothing, for the given reason.
    Outside(UnknownReason),
    /// No point meets the assumptions, for the given reason.
    Empty(EmptyReason),
}

impl Outcome {
    /// Whether another method may still prove the problem.
    pub(super) fn is_open(&self) -> bool {
        matches!(self, Outcome::NotZero | Outcome::Outside(_))
    }
}

/// A problem to prove, and the limit on the products of terms in one normal form.
#[derive(Clone, Copy)]
pub(super) struct Task<'a> {
    pub(super) problem: &'a Problem,
    pub(super) work: u64,
}

/// An angle that has to stay within (−2π, 2π), and expressions whose signs are distinguished for
/// that.
#[derive(Clone)]
pub(super) struct Turn {
    pub(super) angle: Expr,
    pub(super) signs: Vec<Expr>,
}

/// Context of a proof: its conditions, its work limit, and the number of nested equations it can
/// still solve.
#[derive(Clone, Copy)]
pub(super) struct Given<'a> {
    pub(super) conditions: &'a [Condition],
    pub(super) work: u64,
    pub(super) depth: u32,
    /// Decides the goals of nested equations.
    pub(super) prove: Prove,
}

/// Decision of whether differences vanish, and an angle stays within a full turn, in a context.
pub(super) type Prove = fn(&mut Pool, Given, &[Expr], Option<&Turn>) -> Outcome;
