//! The strata at which normal forms say nothing, each decided by itself.
//!
//! ```text
//! normal forms ─▶ zero, or no point, wherever they hold ─┬─ they hold everywhere ──────────────────▶ the same
//!                                                        ├─ the points form an open set ───────────▶ the same, as a limit
//!                                                        └─ else: cos u = −1 ─ sin u = 0 in its place ─┐ zero, or no
//!                                                                 N = 0 ─── kept from zero, or solved ─┴ point, in each
//! ```
//! **Lemma** (limits). Let the points that meet all conditions, those under which the differences are defined among them,
//! be an open set, on which the differences are continuous. If they vanish off a set without interior points, they vanish.
//!
//! Openness is needed: of `(1 + cos(x))*y <= 0` the points with cos x = −1 and y > 0 are limits of no others, and there
//! |y| = −y fails, which holds at all others. Where it is not known, the angles of every choice of units are put at a half
//! turn; the variable itself stays free, so that more is shown than is needed.

use super::proof::{Goal, Outcome, Turn, prove_under};
use crate::assume::is_open;
use crate::enclosure::{Precision, enclose_number};
use crate::expression::{Condition, Expr, Operation, Pool, Rational, Substitution};
use crate::normal::{Fraction, Generator, Tower, Unit};
use crate::polynomial::Polynomial;

/// Equations N = 0 are solved within each other at most so often.
pub(super) const DEEPEST: u32 = 3;

const PRECISION: Precision = Precision(128);

/// How a proof may go on: its conditions, its work, and how many equations were solved already.
#[derive(Clone, Copy)]
pub(super) struct Given<'a> {
    pub(super) conditions: &'a [Condition],
    pub(super) work: u64,
    pub(super) depth: u32,
}

/// The outcome at every point, from one that holds wherever the normal forms of a tower do.
pub(super) fn everywhere(
    pool: &mut Pool,
    goal: &Goal,
    given: Given,
    tower: &mut Tower,
    outcome: Outcome,
) -> Outcome {
    if tower.holds_everywhere() || holds_as_a_limit(pool, goal, given.conditions, tower) {
        return outcome;
    }
    if tower.has_coarser_poles() {
        *tower = tower.apart();
        let (again, _) = goal.explored(pool, tower);
        if again.is_open() || tower.has_coarser_poles() {
            return again;
        }
    }
    let outcome = with_zeros(pool, goal, given, tower, outcome);
    at_half_turns(pool, goal, given, tower, outcome)
}

/// Whether the points form an open set, and what the normal forms leave out is thin.
fn holds_as_a_limit(pool: &mut Pool, goal: &Goal, conditions: &[Condition], tower: &Tower) -> bool {
    let is_thin = tower.poles().iter().all(|unit| tower.is_never_constant(unit))
        && tower.excluded().iter().all(|polynomial| tower.vanishes_on_a_thin_set(polynomial));
    if !is_thin {
        return false;
    }
    let mut spoken_of: Vec<Expr> = goal.differences.to_vec();
    spoken_of.extend(goal.turn.iter().map(|turn| turn.angle));
    let mut all = conditions.to_vec();
    all.extend(pool.domain(&spoken_of));
    is_open(pool, &all, &spoken_of)
}

/// The outcome with the points at which some units are at a half turn.
fn at_half_turns(
    pool: &mut Pool,
    goal: &Goal,
    given: Given,
    tower: &Tower,
    mut outcome: Outcome,
) -> Outcome {
    if outcome.is_open() {
        return outcome;
    }
    let Some(choices) = tower.choices_of_half_turns() else {
        return Outcome::Outside("too many angles may be odd multiples of pi".into());
    };
    for units in choices {
        if units.iter().any(|unit| is_no_half_turn(pool, tower, unit)) {
            continue;
        }
        let mut stratum = tower.at_half_turns(&units);
        if is_avoided(pool, goal, &mut stratum, &units) {
            continue;
        }
        let (found, _) = goal.explored(pool, &mut stratum);
        if stratum.poles().iter().any(|unit| !tower.poles().contains(unit)) {
            return Outcome::Outside("an angle of its own at a half turn".into());
        }
        let found = with_zeros(pool, goal, given, &stratum, found);
        outcome = together(outcome, found);
        if outcome.is_open() {
            return outcome;
        }
    }
    outcome
}

/// Whether one of the units is known to keep away from its half turns.
fn is_avoided(pool: &Pool, goal: &Goal, stratum: &mut Tower, units: &[Unit]) -> bool {
    units.iter().any(|unit| {
        let angle = stratum.angle_of(unit);
        goal.assumptions.avoids_half_turns(stratum, pool, &angle) == Ok(true)
    })
}

/// Whether a unit is a number that is no odd multiple of π for certain.
fn is_no_half_turn(pool: &mut Pool, tower: &Tower, unit: &Unit) -> bool {
    let angle = tower.raise_unit(pool, unit);
    let cosine = pool.apply(Operation::Cos, &[angle]);
    let one = pool.integer(1);
    let sum = pool.add(one, cosine);
    is_certainly_not_zero(pool, sum)
}

fn is_certainly_not_zero(pool: &Pool, number: Expr) -> bool {
    enclose_number(pool, number, PRECISION).is_ok_and(|value| value.is_positive() || value.is_negative())
}

/// The outcome with the zeros of what a tower divided by.
fn with_zeros(pool: &mut Pool, goal: &Goal, given: Given, tower: &Tower, mut outcome: Outcome) -> Outcome {
    for polynomial in tower.excluded() {
        let (_, factors) = polynomial.square_free();
        for (factor, _) in factors {
            if outcome.is_open() {
                return outcome;
            }
            let number = tower.raise(pool, &factor.clone().into());
            let is_kept = is_certainly_not_zero(pool, number)
                || goal.assumptions.keep_from_zero(tower, pool, &factor) == Ok(true);
            if !is_kept {
                let found = at_zeros(pool, goal, given, tower, &factor);
                outcome = together(outcome, found);
            }
        }
    }
    outcome
}

/// The outcome where a polynomial vanishes, by solving it for a variable.
fn at_zeros(pool: &mut Pool, goal: &Goal, given: Given, tower: &Tower, factor: &Polynomial) -> Outcome {
    let unsolved = || Outcome::Outside("nested radicals at points that lie apart".into());
    let Some(depth) = given.depth.checked_sub(1) else { return unsolved() };
    let Some(values) = solution(pool, tower, factor) else { return unsolved() };
    let conditions: Vec<Condition> =
        given.conditions.iter().map(|condition| condition.substitute(pool, &values)).collect();
    let differences = pool.substitute_all(goal.differences, &values);
    let turn = goal.turn.map(|turn| Turn {
        angle: pool.substitute(turn.angle, &values),
        signs: pool.substitute_all(&turn.signs, &values),
    });
    prove_under(pool, Given { conditions: &conditions, depth, ..given }, &differences, turn.as_ref())
}

/// v = −r/a for a polynomial a v + r with a number a.
fn solution(pool: &mut Pool, tower: &Tower, factor: &Polynomial) -> Option<Substitution> {
    if tower.has_frame() {
        return None;
    }
    factor.variables().into_iter().find_map(|variable| {
        let Generator::Variable(symbol) = *tower.generator(variable) else { return None };
        let (mut rest, mut slope) = (Polynomial::zero(), None);
        for (exponent, coefficient) in factor.coefficients_in(variable) {
            match exponent {
                0 => rest = coefficient,
                1 => slope = coefficient.as_constant(),
                _ => return None,
            }
        }
        let is_plain = |v: u32| matches!(tower.generator(v), Generator::Variable(_) | Generator::Pi);
        if !rest.variables().into_iter().all(is_plain) {
            return None;
        }
        let above = tower.raise(pool, &Fraction::from(rest.neg()));
        let below = pool.number(Rational::from_integer(slope?));
        Some([(symbol, pool.divide(above, below))].into_iter().collect())
    })
}

/// The outcome on two sets of points together.
fn together(a: Outcome, b: Outcome) -> Outcome {
    match (a, b) {
        (failure, _) if failure.is_open() => failure,
        (_, failure) if failure.is_open() => failure,
        (Outcome::Empty(reason), Outcome::Empty(_)) => Outcome::Empty(reason),
        _ => Outcome::Zero,
    }
}
