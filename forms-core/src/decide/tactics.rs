//! Tactics of the prover: one table, whose rows are tried in order until the statement is decided.
//!
//! ```text
//! first points ─▶ normal form ─▶ trigonometric signs ─▶ angles ─▶ principal branches ─▶ numbers ─▶ equations ─▶ points
//! ```
//! A proof never rests on the points. They refute a false statement, and show that a proved one is
//! not vacuous. A tactic leaves a decided statement as it is. The reason for an undecided statement
//! is that of the normal form, or of the points if the normal forms of the sides differ.

use super::angle_equation;
use super::equation::equations_prove;
use super::goal::{Outcome, Task};
use super::principal_branch::with_whole_parts;
use super::problem::Problem;
use super::proof::{by_normal_forms, under_stated_conditions, under_trigonometric_signs};
use super::reasons::UnknownReason;
use super::separation::{MOST_PLACES, numbers_vanish};
use crate::expression::Pool;
use crate::normal::{WORK_LIMIT, arcs_occur_in};
use crate::theory::{Statement, Theory};

/// Candidates of the first search for points, which is repeated before the tactics that cost more
/// than points.
pub(super) const FIRST_CANDIDATES: usize = 24;

/// Candidates tried before giving up on a statement.
pub(super) const CANDIDATES: usize = 600;

/// The tactics, in the order in which a statement is tried.
const TACTICS: [Tactic; 8] = [
    Tactic {
        name: "first points",
        summary: "evaluates both sides at a few exact points, since almost any refutes a false statement",
        limit: Limit::Candidates(FIRST_CANDIDATES),
        gives_up: UnknownReason::NoPoint,
        proof: None,
    },
    Tactic {
        name: "normal form",
        summary: "the normal form of every difference is zero in every case of the signs that matter",
        limit: Limit::Products,
        gives_up: UnknownReason::DifferentNormalForms,
        proof: Some(under_stated_conditions),
    },
    Tactic {
        name: "trigonometric signs",
        summary: "normal forms, under the signs of sines and cosines that follow from the conditions too",
        limit: Limit::Products,
        gives_up: UnknownReason::NoTrigonometricSigns,
        proof: Some(under_trigonometric_signs),
    },
    Tactic {
        name: "angles",
        summary: "a sum of inverse functions has sine 0 and cosine 1 and stays within a full turn",
        limit: Limit::Products,
        gives_up: UnknownReason::NoAngles,
        proof: Some(angles),
    },
    Tactic {
        name: "principal branches",
        summary: "thirds, fifths and other parts of inverse functions become variables",
        limit: Limit::Products,
        gives_up: UnknownReason::NoPrincipalBranches,
        proof: Some(principal_branches),
    },
    Tactic {
        name: "numbers",
        summary: "an algebraic number smaller than its separation bound is zero",
        limit: Limit::Places(MOST_PLACES),
        gives_up: UnknownReason::NoNumbers,
        proof: Some(numbers),
    },
    Tactic {
        name: "equations",
        summary: "conditions that amount to equations are solved and substituted",
        limit: Limit::Products,
        gives_up: UnknownReason::NoEquations,
        proof: Some(equations),
    },
    Tactic {
        name: "points",
        summary: "evaluates both sides at further points, and at points of thin strata",
        limit: Limit::Candidates(CANDIDATES),
        gives_up: UnknownReason::NoPoint,
        proof: None,
    },
];

/// Number of rows up to the normal forms, which are tried before any further point where the first
/// points do not refute the statement.
const AFTER_NORMAL_FORMS: usize = 3;

/// Row of the table.
struct Tactic {
    name: &'static str,
    /// What it does, in one line.
    summary: &'static str,
    /// Its budget for a statement.
    limit: Limit,
    /// Its reason for giving up, where it has none that is more specific.
    gives_up: UnknownReason,
    /// Its proof within a limit; `None` for the searches for points of `super::finding`.
    proof: Option<Proof>,
}

/// Proof of a problem within a limit.
type Proof = fn(&mut Pool, &Problem, u64) -> Outcome;

/// Budget of a tactic.
#[derive(Clone, Copy)]
enum Limit {
    /// Candidates for points.
    Candidates(usize),
    /// Products of terms in one normal form, as many as are granted to the statement.
    Products,
    /// Binary places of a separation bound.
    Places(u64),
}

impl Tactic {
    /// Returns the outcome of its proof, where this number of products of terms is granted; `None`
    /// for a search for points.
    fn outcome(&self, pool: &mut Pool, problem: &Problem, products: u64) -> Option<Outcome> {
        let limit = match self.limit {
            Limit::Candidates(most) => most as u64,
            Limit::Products => products,
            Limit::Places(most) => most,
        };
        self.proof.map(|proof| proof(pool, problem, limit))
    }
}

/// Tries the tactics that prove, from the outcome of the normal forms if it is known.
pub(super) fn prove(pool: &mut Pool, problem: &Problem, products: u64, early: Option<Outcome>) -> Outcome {
    let outcome = early.unwrap_or_else(|| by_normal_forms(pool, problem, products));
    let mut rest = TACTICS[AFTER_NORMAL_FORMS..].iter();
    let is_proved = outcome.is_open()
        && rest.any(|tactic| tactic.outcome(pool, problem, products) == Some(Outcome::Zero));
    if is_proved { Outcome::Zero } else { outcome }
}

/// Attempt of one tactic.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Attempt {
    /// Name of the tactic.
    pub tactic: &'static str,
    /// What the tactic does, in one line.
    pub summary: &'static str,
    /// Its reason for giving up; `None` where it decides the statement.
    pub gives_up: Option<UnknownReason>,
}

/// Returns the attempts to prove a statement, in order, up to the tactic that decides it.
pub fn attempts(theory: &mut Theory, statement: &Statement) -> Vec<Attempt> {
    let problem = Problem::new(theory, statement);
    let mut tried = Vec::new();
    for tactic in &TACTICS {
        let Some(outcome) = tactic.outcome(&mut theory.pool, &problem, WORK_LIMIT) else { continue };
        let gives_up = match outcome {
            Outcome::NotZero => Some(tactic.gives_up.clone()),
            Outcome::Outside(reason) => Some(reason),
            Outcome::Zero | Outcome::Empty(_) => None,
        };
        let is_last = gives_up.is_none();
        tried.push(Attempt { tactic: tactic.name, summary: tactic.summary, gives_up });
        if is_last {
            break;
        }
    }
    tried
}

/// Returns the outcome of a method that proves or else shows nothing.
fn proved_if(is_proved: bool) -> Outcome {
    if is_proved { Outcome::Zero } else { Outcome::NotZero }
}

/// Tries to prove the problem as equations between angles.
pub(super) fn angles(pool: &mut Pool, problem: &Problem, work: u64) -> Outcome {
    let differences = problem.differences();
    let is_proved = arcs_occur_in(pool, &differences)
        && angle_equation::prove(pool, Task { problem, work }, &differences, &mut Vec::new())
            == Outcome::Zero;
    proved_if(is_proved)
}

/// Tries to prove the problem with parts of inverse functions as variables.
fn principal_branches(pool: &mut Pool, problem: &Problem, work: u64) -> Outcome {
    if !arcs_occur_in(pool, &problem.differences()) {
        return Outcome::NotZero;
    }
    let Some(whole) = with_whole_parts(pool, problem) else { return Outcome::NotZero };
    let inner = by_normal_forms(pool, &whole, work);
    let is_proved = inner == Outcome::Zero || inner.is_open() && angles(pool, &whole, work) == Outcome::Zero;
    proved_if(is_proved)
}

/// Tries to prove the problem by separation bounds of numbers.
fn numbers(pool: &mut Pool, problem: &Problem, places: u64) -> Outcome {
    proved_if(numbers_vanish(pool, problem, places))
}

/// Tries to prove the problem through the equations among its conditions.
fn equations(pool: &mut Pool, problem: &Problem, work: u64) -> Outcome {
    proved_if(equations_prove(pool, problem, work))
}
