//! Tactics of the prover: one list, tried in order until the problem is decided.
//!
//! ```text
//! normal forms ─▶ angles ─▶ principal branches ─▶ numbers ─▶ equations
//! ```
//! A tactic takes the outcome so far and returns a better one or the same. It leaves a decided outcome
//! as it is, and its reason for giving up is the reason of the outcome.

use super::angle_equation;
use super::equation::by_equations;
use super::goal::{Outcome, Task};
use super::principal_branch::with_whole_parts;
use super::problem::Problem;
use super::proof::by_normal_forms;
use super::separation::as_numbers;
use crate::expression::Pool;
use crate::normal::arcs_occur_in;

/// Step of the prover after the normal forms, with the limit on the products of terms in one normal
/// form.
type Tactic = fn(&mut Pool, &Problem, u64, Outcome) -> Outcome;

/// The tactics after the normal forms, in order.
const TACTICS: [Tactic; 4] = [as_angles, on_principal_branches, as_numbers, by_equations];

/// Tries all tactics, from the outcome of the normal forms if it is known.
pub(super) fn prove(pool: &mut Pool, problem: &Problem, work: u64, early: Option<Outcome>) -> Outcome {
    let outcome = early.unwrap_or_else(|| by_normal_forms(pool, problem, work));
    TACTICS.iter().fold(outcome, |outcome, tactic| tactic(pool, problem, work, outcome))
}

/// Tries to prove the problem as equations between angles, if the normal forms do not decide it.
pub(super) fn as_angles(pool: &mut Pool, problem: &Problem, work: u64, outcome: Outcome) -> Outcome {
    let differences = problem.differences();
    if !outcome.is_open() || !arcs_occur_in(pool, &differences) {
        return outcome;
    }
    match angle_equation::prove(pool, Task { problem, work }, &differences, &mut Vec::new()) {
        Outcome::Zero => Outcome::Zero,
        _ => outcome,
    }
}

/// Tries to prove the problem with parts of inverse functions as variables, if there is no proof
/// yet.
pub(super) fn on_principal_branches(
    pool: &mut Pool,
    problem: &Problem,
    work: u64,
    outcome: Outcome,
) -> Outcome {
    if !outcome.is_open() || !arcs_occur_in(pool, &problem.differences()) {
        return outcome;
    }
    let Some(whole) = with_whole_parts(pool, problem) else { return outcome };
    let inner = by_normal_forms(pool, &whole, work);
    match as_angles(pool, &whole, work, inner) {
        Outcome::Zero => Outcome::Zero,
        _ => outcome,
    }
}
