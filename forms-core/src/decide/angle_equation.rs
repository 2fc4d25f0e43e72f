//! Equations between angles: combinations of inverse trigonometric functions that vanish.
//!
//! ```text
//! difference D = Σ nₖ αₖ + rest, αₖ inverse functions, nₖ integers
//!    sin D = 0 and cos D = 1, algebraically   ─▶ D is a multiple of 2π at every point
//!    −2π < D < 2π, from principal values      ─▶ the multiple is 0
//! ```
//! The sine and cosine of an inverse function are algebraic in its argument, so the first step is
//! an identity between normal forms; the second is exact arithmetic with ends a + bπ. Neither needs
//! continuity, so the argument holds on regions of any shape: atan x + atan 1/x = π/2 is proved for
//! x > 0, but not for x < 0, where cos D = −1. This is the addition theorem with the branch
//! accounted for, as in Abramowitz and Stegun, 4.4.34. If D is not such a combination, relations
//! between its inverse functions are searched for first.

use super::angle::prove_angle;
use super::goal::{Outcome, Task};
use super::problem::Problem;
use super::proof::prove_zero;
use super::relation;
use crate::expression::{Expr, Pool, Rational};
use crate::normal::{Fraction, Obstacle, Tower, Trigonometry, WORK_LIMIT, normalise};
use crate::theory::{Statement, Theory};

/// Returns the angles of a proof: each vanishes because its sine is 0, its cosine is 1, and it lies
/// within (−2π, 2π). Empty if this does not prove the statement, or if normal forms alone prove it.
pub fn vanishing_angles(theory: &mut Theory, statement: &Statement) -> Vec<Expr> {
    let problem = Problem::new(theory, statement);
    let task = Task { problem: &problem, work: WORK_LIMIT };
    let mut shown = Vec::new();
    let outcome = prove(&mut theory.pool, task, &problem.differences(), &mut shown);
    if outcome == Outcome::Zero { shown } else { vec![] }
}

/// Tries to prove that the expressions vanish. Those with inverse functions are proved as angles,
/// which are appended to `shown`.
pub(super) fn prove(pool: &mut Pool, task: Task, differences: &[Expr], shown: &mut Vec<Expr>) -> Outcome {
    for &difference in differences {
        let outcome = prove_difference(pool, task, difference, shown);
        let outcome = match outcome {
            Outcome::NotZero | Outcome::Outside(_) => {
                let reduced = relation::eliminated(pool, task, difference, shown);
                if reduced == difference { outcome } else { prove_difference(pool, task, reduced, shown) }
            }
            outcome => outcome,
        };
        if outcome != Outcome::Zero {
            return outcome;
        }
    }
    Outcome::Zero
}

/// Tries to prove that a difference vanishes, by its normal form or else as an angle.
fn prove_difference(pool: &mut Pool, task: Task, difference: Expr, shown: &mut Vec<Expr>) -> Outcome {
    match prove_zero(pool, task.problem, vec![difference], task.work) {
        Outcome::NotZero | Outcome::Outside(_) => prove_component(pool, task, difference, shown),
        outcome => outcome,
    }
}

fn prove_component(pool: &mut Pool, task: Task, difference: Expr, shown: &mut Vec<Expr>) -> Outcome {
    let Ok(Some(angles)) = angles_in(pool, difference) else { return Outcome::NotZero };
    for angle in angles {
        match prove_angle(pool, task, angle, shown) {
            Outcome::Zero => {}
            outcome => return outcome,
        }
    }
    Outcome::Zero
}

/// Returns combinations of inverse functions with integer coefficients; if they all vanish, the
/// expression vanishes.
fn angles_in(pool: &mut Pool, difference: Expr) -> Result<Option<Vec<Expr>>, Obstacle> {
    let mut tower = Tower::new(Trigonometry::Circle);
    let prepared = normalise(&mut tower, pool, &[difference])?;
    let value = prepared.exact(&mut tower, pool)?.remove(0);
    let Some(combinations) = tower.combinations_of_arcs(&value)? else { return Ok(None) };
    if let [combination] = combinations.as_slice()
        && let Some(factor) = quotient(&mut tower, combination, &value)?
    {
        let factor = pool.number(factor);
        return Ok(Some(vec![pool.multiply(factor, difference)]));
    }
    if !prepared.is_unconditional() || !tower.holds_everywhere() {
        return Ok(None);
    }
    Ok(Some(combinations.iter().map(|combination| tower.raise(pool, combination)).collect()))
}

/// Returns the quotient a/b if it is a number.
fn quotient(tower: &mut Tower, a: &Fraction, b: &Fraction) -> Result<Option<Rational>, Obstacle> {
    let inverse = tower.inverse(b)?;
    Ok(tower.multiply(a, &inverse)?.as_number())
}
