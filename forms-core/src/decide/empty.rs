//! Contradictory conditions: a statement whose conditions no point meets is vacuous, which is an
//! error.

use super::goal::Outcome;
use super::problem::Problem;
use super::proof::prove_zero;
use super::reasons::EmptyReason;
use crate::assume::{Assumptions, Contradiction};
use crate::expression::Pool;
use crate::normal::WORK_LIMIT;

/// Returns the reason why no point meets the assumptions, if that can be shown: a condition that is
/// false by its form, bounds that leave no value, or a condition that fails in every case of the
/// open signs.
pub(super) fn contradiction(pool: &mut Pool, problem: &Problem) -> Option<EmptyReason> {
    match Assumptions::new(pool, &problem.assumptions).contradiction(pool) {
        Some(Contradiction::Alone(condition)) => {
            return Some(EmptyReason::Condition(condition.text(pool)));
        }
        Some(Contradiction::Together) => return Some(EmptyReason::Contradiction),
        None => {}
    }
    let one = pool.integer(1);
    match prove_zero(pool, problem, vec![one], WORK_LIMIT) {
        Outcome::Empty(reason) => Some(reason),
        _ => None,
    }
}
