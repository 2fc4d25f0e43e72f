//! The proof: every difference has the normal form zero, in every case of the signs that matter.

use super::problem::Problem;
use super::translation;
use crate::assume::{Assumptions, Cases};
use crate::expression::{Expr, Pool};
use crate::normal::{Fraction, Obstacle, Sign, Tower, Trigonometry, normalise};

/// What the normal forms say.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Outcome {
    /// Every difference is zero in every case.
    Zero,
    /// Some difference is not zero in some case; that case may still hold no point.
    NotZero,
    /// No normal form.
    Outside(String),
    /// No point meets the assumptions.
    Empty(String),
}

/// More cases than this are not gone through.
const MOST_CASES: usize = 512;

/// Tries to prove that every component vanishes.
pub(super) fn outcome(pool: &mut Pool, problem: &Problem, work: u64) -> Outcome {
    if problem.components.is_empty() {
        return Outcome::Zero;
    }
    prove_zero(pool, problem, problem.differences(), work)
}

/// Tries to prove that the expressions vanish wherever the problem's assumptions hold, first in the frame of their
/// translations. Bounds of single variables say less in it: where it left several cases and no proof, the expressions
/// are looked at as they stand, unless the work was too much already.
pub(super) fn prove_zero(pool: &mut Pool, problem: &Problem, differences: Vec<Expr>, work: u64) -> Outcome {
    let frame = translation::frame(pool, &differences);
    let is_moving = !frame.is_empty();
    let tower = Tower::new(Trigonometry::Circle).with_work_limit(work);
    let (mut result, several) = explored(pool, problem, &differences, tower.clone().in_frame(frame));
    if is_moving && several && !matches!(result, Ok(Outcome::Zero) | Err(Obstacle::TooLarge(_))) {
        result = explored(pool, problem, &differences, tower).0;
    }
    match result {
        Ok(outcome) => outcome,
        Err(Obstacle::DivisionByZero) => Outcome::Empty(DIVIDES_BY_ZERO.into()),
        Err(Obstacle::Outside(part)) => {
            Outcome::Outside(format!("outside the class that is decided: {part}"))
        }
        Err(Obstacle::TooLarge(limit)) => Outcome::Outside(format!("the normal form is too large: {limit}")),
        Err(Obstacle::Refine) => Outcome::Outside("its radicands could not be factored".into()),
    }
}

/// The outcome over a tower, and whether several cases were told apart.
fn explored(
    pool: &mut Pool,
    problem: &Problem,
    differences: &[Expr],
    mut tower: Tower,
) -> (Result<Outcome, Obstacle>, bool) {
    let assumptions = Assumptions::new(pool, &problem.assumptions);
    let differences = differences.to_vec();
    let mut proof = Proof {
        pool,
        tower: &mut tower,
        differences,
        assumptions,
        cases: 0,
        settled: Vec::new(),
        several: false,
    };
    let result = proof.explore(&[]);
    (result, proof.several)
}

/// The cases in which the normal forms are zero, by the signs that tell them apart; nothing if that is no proof.
pub(super) fn settled_cases(
    pool: &mut Pool,
    problem: &Problem,
    tower: &mut Tower,
) -> Option<Vec<Vec<(usize, Sign)>>> {
    let assumptions = Assumptions::new(pool, &problem.assumptions);
    let differences = problem.differences();
    let mut proof =
        Proof { pool, tower, differences, assumptions, cases: 0, settled: Vec::new(), several: false };
    let outcome = proof.explore(&[]);
    (outcome == Ok(Outcome::Zero)).then_some(proof.settled)
}

const DIVIDES_BY_ZERO: &str = "it divides by zero everywhere";

struct Proof<'a> {
    pool: &'a Pool,
    tower: &'a mut Tower,
    differences: Vec<Expr>,
    assumptions: Assumptions,
    cases: usize,
    /// The signs of the cases in which everything is zero.
    settled: Vec<Vec<(usize, Sign)>>,
    /// Whether there was more than one case to tell apart at a time.
    several: bool,
}

impl Proof<'_> {
    /// Decides where the given signs hold, going through the cases of those that are open.
    fn explore(&mut self, given: &[(usize, Sign)]) -> Result<Outcome, Obstacle> {
        self.cases += 1;
        match self.settle(given) {
            Ok(Some(Outcome::Zero)) => {
                self.settled.push(given.to_vec());
                return Ok(Outcome::Zero);
            }
            Ok(_) => {}
            Err(Obstacle::DivisionByZero) => return Ok(Outcome::Empty(DIVIDES_BY_ZERO.into())),
            Err(obstacle) => return Err(obstacle),
        }
        let cases = match self.assumptions.cases(self.tower, self.pool, &self.differences, given)? {
            Cases::Empty => return Ok(Outcome::Empty("no point meets its conditions".into())),
            Cases::Signs(cases) if cases.iter().all(Vec::is_empty) => return Ok(Outcome::NotZero),
            Cases::Signs(cases) if self.cases + cases.len() <= MOST_CASES => cases,
            Cases::Signs(_) | Cases::TooMany => {
                return Ok(Outcome::Outside("too many factors of radicands have an open sign".into()));
            }
        };
        self.several |= cases.len() > 1;
        let mut together: Option<Outcome> = None;
        for case in cases {
            let signs: Vec<(usize, Sign)> = given.iter().copied().chain(case).collect();
            together = match (self.explore(&signs)?, together) {
                (failure @ (Outcome::NotZero | Outcome::Outside(_)), _) => return Ok(failure),
                (Outcome::Empty(reason), None) => Some(Outcome::Empty(reason)),
                (Outcome::Empty(_), known) => known,
                (Outcome::Zero, _) => Some(Outcome::Zero),
            };
        }
        Ok(together.unwrap_or(Outcome::NotZero))
    }

    /// The filter first, then the exact normal forms; nothing where they depend on an open sign.
    fn settle(&mut self, given: &[(usize, Sign)]) -> Result<Option<Outcome>, Obstacle> {
        self.tower.fix_signs(given);
        let prepared = normalise(self.tower, self.pool, &self.differences)?;
        if !prepared.open.is_empty() {
            return Ok(None);
        }
        if prepared.certainly_not_zero(self.tower, self.pool).contains(&true) {
            return Ok(Some(Outcome::NotZero));
        }
        let zero = prepared.exact(self.tower, self.pool)?.iter().all(Fraction::is_zero);
        Ok(Some(if zero { Outcome::Zero } else { Outcome::NotZero }))
    }
}
