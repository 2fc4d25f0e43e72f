//! Strata on which normal forms say nothing, each decided separately.
//!
//! ```text
//! normal forms ─▶ zero, or no point, where they hold ─┬─ they hold everywhere ──────────────────▶ the same
//!                                                     ├─ the points form an open set ───────────▶ the same, as a limit
//!                                                     └─ else: cos u = −1 ─ sin u = 0 in its place ─┐ zero, or no
//!                                                              N = 0 ─── kept from zero, or solved ─┴ point, in each
//! ```
//! **Lemma** (limits). Let the points that meet all conditions, including those under which the
//! differences are defined, form an open set on which the differences are continuous. If the
//! differences vanish outside of a set without interior points, they vanish.
//!
//! Openness is needed: with `(1 + cos(x))*y <= 0` the points with cos x = −1 and y > 0 are not
//! limits of other points, and |y| = −y fails there, but holds at all others. If openness is not
//! known, the angles of every choice of units are put at a half turn; the variable itself stays
//! free, so that more is shown than is needed.

use super::cases::Goal;
use super::goal::{Given, Outcome, Turn};
use super::reasons::{EmptyReason, UnknownReason};
use crate::assume::is_open;
use crate::enclosure::{Precision, enclose_number};
use crate::expression::{Condition, Expr, Operation, Pool, Rational, Substitution};
use crate::normal::{Fraction, Generator, Tower, Unit};
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_traits::Signed;

/// Nesting depth up to which equations N = 0 are solved within each other.
pub(super) const DEEPEST: u32 = 3;

const PRECISION: Precision = Precision(128);

/// Returns the outcome at every point, from an outcome that holds wherever the normal forms of a
/// tower do.
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

/// Whether the points form an open set, and the set that the normal forms leave out is thin.
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

/// Extends the outcome to the points at which some units are at a half turn.
fn at_half_turns(pool: &mut Pool, goal: &Goal, given: Given, tower: &Tower, mut outcome: Outcome) -> Outcome {
    if outcome.is_open() {
        return outcome;
    }
    let Some(choices) = tower.choices_of_half_turns() else {
        return Outcome::Outside(UnknownReason::HalfTurns);
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
            return Outcome::Outside(UnknownReason::FurtherHalfTurn);
        }
        let found = with_zeros(pool, goal, given, &stratum, found);
        outcome = together(outcome, found);
        if outcome.is_open() {
            return outcome;
        }
    }
    outcome
}

/// Whether one of the units is known to avoid its half turns.
fn is_avoided(pool: &Pool, goal: &Goal, stratum: &mut Tower, units: &[Unit]) -> bool {
    units.iter().any(|unit| {
        let angle = stratum.angle_of(unit);
        goal.assumptions.avoids_half_turns(stratum, pool, &angle) == Ok(true)
    })
}

/// Whether a unit is a number that is certainly not an odd multiple of π.
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

/// Extends the outcome to the zeros of the divisors of a tower.
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

/// Returns the outcome where a polynomial vanishes, by solving the polynomial for a variable.
fn at_zeros(pool: &mut Pool, goal: &Goal, given: Given, tower: &Tower, factor: &Polynomial) -> Outcome {
    let unsolved = || Outcome::Outside(UnknownReason::DivisorZeros);
    let Some(depth) = given.depth.checked_sub(1) else { return unsolved() };
    let Some(solutions) = solutions(pool, tower, factor) else { return unsolved() };
    let mut outcome = Outcome::Empty(EmptyReason::NoZeros);
    for values in solutions {
        let conditions: Vec<Condition> =
            given.conditions.iter().map(|condition| condition.substitute(pool, &values)).collect();
        let differences = pool.substitute_all(goal.differences, &values);
        let turn = goal.turn.map(|turn| Turn {
            angle: pool.substitute(turn.angle, &values),
            signs: pool.substitute_all(&turn.signs, &values),
        });
        let given = Given { conditions: &conditions, depth, ..given };
        let found = (given.prove)(pool, given, &differences, turn.as_ref());
        outcome = together(outcome, found);
    }
    outcome
}

/// Returns all solutions of a polynomial equation for one variable: a v + r = 0 with a number a, or
/// a v² + b v + c = 0 with numbers.
fn solutions(pool: &mut Pool, tower: &Tower, factor: &Polynomial) -> Option<Vec<Substitution>> {
    if tower.has_frame() {
        return None;
    }
    let is_plain = |v: u32| matches!(tower.generator(v), Generator::Variable(_) | Generator::Pi);
    let variables = factor.variables();
    if !variables.iter().copied().all(is_plain) {
        return None;
    }
    variables.into_iter().find_map(|variable| {
        let Generator::Variable(symbol) = *tower.generator(variable) else { return None };
        let mut parts = [Polynomial::zero(), Polynomial::zero(), Polynomial::zero()];
        for (exponent, coefficient) in factor.coefficients_in(variable) {
            *parts.get_mut(exponent as usize)? = coefficient;
        }
        let [c, b, a] = parts;
        let values = match (a.as_constant(), b.as_constant(), c.as_constant()) {
            _ if a.is_zero() => {
                let above = tower.raise(pool, &Fraction::from(c.neg()));
                let below = pool.number(Rational::from_integer(b.as_constant()?));
                vec![pool.divide(above, below)]
            }
            (Some(a), b, c) => roots_of_quadratic(pool, &a, &b.unwrap_or_default(), &c.unwrap_or_default()),
            _ => return None,
        };
        let is_number = |polynomial: &Polynomial| polynomial.is_zero() || polynomial.as_constant().is_some();
        (a.is_zero() || is_number(&b) && is_number(&c))
            .then(|| values.into_iter().map(|value| [(symbol, value)].into_iter().collect()).collect())
    })
}

/// Returns the roots (−b ± √(b² − 4ac))/(2a) if they are real.
fn roots_of_quadratic(pool: &mut Pool, a: &BigInt, b: &BigInt, c: &BigInt) -> Vec<Expr> {
    let discriminant: BigInt = b * b - a * c * 4;
    if discriminant.is_negative() {
        return Vec::new();
    }
    let below = Rational::from_integer(a * 2);
    let square = pool.number(Rational::from_integer(discriminant) / (&below * &below));
    let (middle, reach) = (pool.number(Rational::from_integer(-b) / below), pool.sqrt(square));
    vec![pool.add(middle, reach), pool.subtract(middle, reach)]
}

/// Combines the outcomes on two sets of points.
fn together(a: Outcome, b: Outcome) -> Outcome {
    match (a, b) {
        (failure, _) if failure.is_open() => failure,
        (_, failure) if failure.is_open() => failure,
        (Outcome::Empty(reason), Outcome::Empty(_)) => Outcome::Empty(reason),
        _ => Outcome::Zero,
    }
}
