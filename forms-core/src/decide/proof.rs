//! Proof by normal forms: in the frame of the translations that change nothing, under the stated
//! conditions and the signs of sines and cosines that they imply, on every stratum.

use super::cases::Goal;
use super::goal::{Given, Outcome, Task, Turn};
use super::problem::Problem;
use super::trigonometric_signs::trigonometric_signs;
use super::{strata, translation};
use crate::assume::Assumptions;
use crate::expression::{Condition, Expr, Pool};
use crate::normal::{Drift, Tower, Trigonometry};

/// Tries to prove that every component vanishes, by normal forms: the first two tactics that prove.
pub(super) fn by_normal_forms(pool: &mut Pool, problem: &Problem, work: u64) -> Outcome {
    if problem.components.is_empty() {
        return Outcome::Zero;
    }
    prove_zero(pool, problem, problem.differences(), work)
}

/// Tries to prove that every component vanishes, under the stated conditions.
pub(super) fn under_stated_conditions(pool: &mut Pool, problem: &Problem, work: u64) -> Outcome {
    if problem.components.is_empty() {
        return Outcome::Zero;
    }
    prove_under(pool, stated(problem, work), &problem.differences(), None)
}

/// Tries to prove that every component vanishes, also under the signs of sines and cosines that the
/// stated conditions imply.
pub(super) fn under_trigonometric_signs(pool: &mut Pool, problem: &Problem, work: u64) -> Outcome {
    prove_with_signs(pool, stated(problem, work), &problem.differences(), None)
}

fn stated(problem: &Problem, work: u64) -> Given<'_> {
    Given { conditions: &problem.assumptions, work, depth: strata::DEEPEST, prove: prove_under }
}

/// Tries to prove that the expressions vanish wherever the problem's assumptions hold.
pub(super) fn prove_zero(pool: &mut Pool, problem: &Problem, differences: Vec<Expr>, work: u64) -> Outcome {
    prove_in_all_cases(pool, Task { problem, work }, differences, None)
}

/// Tries to prove that the expressions vanish and that an angle stays within a full turn in either
/// direction.
pub(super) fn prove_full_turn(pool: &mut Pool, task: Task, differences: Vec<Expr>, turn: Turn) -> Outcome {
    prove_in_all_cases(pool, task, differences, Some(turn))
}

/// Tries a proof under the stated conditions, then also under the signs of sines and cosines that
/// they imply.
fn prove_in_all_cases(pool: &mut Pool, task: Task, differences: Vec<Expr>, turn: Option<Turn>) -> Outcome {
    let given = stated(task.problem, task.work);
    let outcome = prove_under(pool, given, &differences, turn.as_ref());
    if !outcome.is_open() {
        return outcome;
    }
    match prove_with_signs(pool, given, &differences, turn.as_ref()) {
        Outcome::Zero => Outcome::Zero,
        _ => outcome,
    }
}

/// Tries a proof also under the signs of sines and cosines that the conditions imply, if there are
/// any.
fn prove_with_signs(pool: &mut Pool, given: Given, differences: &[Expr], turn: Option<&Turn>) -> Outcome {
    let signs = trigonometric_signs(pool, differences, given.conditions);
    if signs.is_empty() {
        return Outcome::NotZero;
    }
    let conditions: Vec<Condition> = given.conditions.iter().copied().chain(signs).collect();
    match prove_under(pool, Given { conditions: &conditions, ..given }, differences, turn) {
        Outcome::Zero => Outcome::Zero,
        _ => Outcome::NotZero,
    }
}

/// Tries a proof in the frame of the translations that change no difference. Bounds of single
/// variables say less in that frame: if it leaves several cases and no proof, the expressions are
/// tried as they stand, unless the work limit was exceeded. The last attempt has fewer cases, at
/// the cost of testing whether each one is possible.
fn prove_under(pool: &mut Pool, given: Given, differences: &[Expr], turn: Option<&Turn>) -> Outcome {
    let frame = translation::frame(pool, differences);
    let in_frame = (!frame.is_empty()).then_some((frame, false));
    let mut outcome = Outcome::NotZero;
    for (frame, thorough) in in_frame.into_iter().chain([(vec![], false), (vec![], true)]) {
        let has_frame = !frame.is_empty();
        let explored = explored(pool, given, differences, turn, frame, thorough);
        let is_open = explored.outcome == Outcome::NotZero && explored.several
            || has_frame && explored.in_doubt
            || has_frame && explored.several && matches!(explored.outcome, Outcome::Empty(_));
        outcome = explored.outcome;
        if !is_open {
            break;
        }
    }
    outcome
}

/// Result of the proof in one frame.
struct Explored {
    outcome: Outcome,
    /// Whether several cases were distinguished.
    several: bool,
    /// Whether the normal forms decided the goal except on strata that remain open.
    in_doubt: bool,
}

fn explored(
    pool: &mut Pool,
    given: Given,
    differences: &[Expr],
    turn: Option<&Turn>,
    frame: Vec<Drift>,
    thorough: bool,
) -> Explored {
    let assumptions = Assumptions::new(pool, given.conditions);
    let assumptions = if thorough { assumptions.thorough() } else { assumptions };
    let mut tower = Tower::new(Trigonometry::Circle).with_work_limit(given.work).in_frame(frame);
    let goal = Goal { assumptions: &assumptions, differences, turn };
    let (outcome, several) = goal.explored(pool, &mut tower);
    if outcome.is_open() {
        return Explored { outcome, several, in_doubt: false };
    }
    let outcome = strata::everywhere(pool, &goal, given, &mut tower, outcome);
    Explored { in_doubt: outcome.is_open(), outcome, several }
}
