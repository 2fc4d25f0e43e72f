//! Proof by cases: every difference has the normal form zero in every case of the signs that matter.

use super::goal::{Outcome, Turn};
use super::observer::Observer;
use super::problem::Problem;
use super::reasons::{EmptyReason, UnknownReason};
use crate::assume::{Assumptions, Cases};
use crate::expression::{Expr, Pool};
use crate::normal::{Fraction, Obstacle, OutsidePart, Sign, Tower, normalise};

/// Limit on the number of cases.
const MOST_CASES: usize = 512;

/// Goal of a proof: all differences vanish wherever the assumptions hold, and an angle stays within
/// a full turn.
pub(super) struct Goal<'a> {
    pub(super) assumptions: &'a Assumptions,
    pub(super) differences: &'a [Expr],
    pub(super) turn: Option<&'a Turn>,
}

impl Goal<'_> {
    /// Returns the outcome in one tower, which holds wherever the normal forms of the tower do, and
    /// whether several cases were distinguished.
    pub(super) fn explored(&self, pool: &mut Pool, tower: &mut Tower) -> (Outcome, bool) {
        let differences = self.differences.to_vec();
        let mut proof = Proof::new(pool, tower, self.assumptions.clone(), differences, self.turn.cloned());
        let explored = proof.explore(&[]);
        let several = proof.several;
        (outcome_of(pool, explored, tower), several)
    }
}

fn outcome_of(pool: &mut Pool, explored: Result<Outcome, Obstacle>, tower: &Tower) -> Outcome {
    match explored {
        Ok(Outcome::NotZero) => match tower.nested_radical() {
            Some(radical) => {
                let radical = tower.raise(pool, &radical);
                Outcome::Outside(UnknownReason::Outside(OutsidePart::NestedRadical(pool.text(radical))))
            }
            None => Outcome::NotZero,
        },
        Ok(outcome) => outcome,
        Err(Obstacle::DivisionByZero) => Outcome::Empty(EmptyReason::DivisionByZero),
        Err(Obstacle::Outside(part)) => Outcome::Outside(UnknownReason::Outside(part)),
        Err(Obstacle::TooLarge(limit)) => Outcome::Outside(UnknownReason::TooLarge(limit)),
        Err(Obstacle::Refine) => Outcome::Outside(UnknownReason::UnfactoredRadicands),
    }
}

/// Returns the cases in which the normal forms are zero, each given by its signs; `None` if they
/// are not a proof. The steps are reported to an observer.
pub(super) fn settled_cases<'a>(
    pool: &'a mut Pool,
    problem: &Problem,
    tower: &'a mut Tower,
    observer: Option<&'a mut (dyn Observer + 'a)>,
) -> Option<Vec<Vec<(usize, Sign)>>> {
    let assumptions = Assumptions::new(pool, &problem.assumptions);
    let differences = problem.differences();
    let mut proof = Proof::new(pool, tower, assumptions, differences, None);
    proof.observer = observer;
    let outcome = proof.explore(&[]);
    (outcome == Ok(Outcome::Zero)).then_some(proof.settled)
}

struct Proof<'a> {
    pool: &'a Pool,
    tower: &'a mut Tower,
    differences: Vec<Expr>,
    turn: Option<Turn>,
    assumptions: Assumptions,
    cases: usize,
    /// Signs of the cases in which everything is zero.
    settled: Vec<Vec<(usize, Sign)>>,
    observer: Option<&'a mut (dyn Observer + 'a)>,
    /// Whether a split had more than one case.
    several: bool,
}

impl<'a> Proof<'a> {
    fn new(
        pool: &'a Pool,
        tower: &'a mut Tower,
        assumptions: Assumptions,
        differences: Vec<Expr>,
        turn: Option<Turn>,
    ) -> Self {
        let (cases, settled, observer, several) = (0, Vec::new(), None, false);
        Proof { pool, tower, differences, turn, assumptions, cases, settled, observer, several }
    }

    /// Decides the goal under the given signs by splitting into the cases of the open signs.
    fn explore(&mut self, given: &[(usize, Sign)]) -> Result<Outcome, Obstacle> {
        self.cases += 1;
        match self.settle(given) {
            Ok(Some(Outcome::Zero)) => {
                if let Some(observer) = &mut self.observer {
                    observer.zero(self.pool, self.tower, &self.differences);
                }
                self.settled.push(given.to_vec());
                return Ok(Outcome::Zero);
            }
            Ok(_) => {}
            Err(Obstacle::DivisionByZero) => {
                self.observe(|observer| observer.undefined());
                return Ok(Outcome::Empty(EmptyReason::DivisionByZero));
            }
            Err(obstacle) => return Err(obstacle),
        }
        let cases = match self.assumptions.cases(self.tower, self.pool, &self.expressions(), given)? {
            Cases::Empty => {
                self.observe_split(given, &[])?;
                self.observe(|observer| observer.end());
                return Ok(Outcome::Empty(EmptyReason::NoCase));
            }
            Cases::Signs(cases) if cases.iter().all(Vec::is_empty) => return Ok(Outcome::NotZero),
            Cases::Signs(cases) if self.cases + cases.len() <= MOST_CASES => cases,
            Cases::Signs(_) | Cases::TooMany => {
                return Ok(Outcome::Outside(UnknownReason::OpenSigns));
            }
        };
        self.several |= cases.len() > 1;
        let mut together: Option<Outcome> = None;
        self.observe_split(given, &cases)?;
        for case in cases {
            self.observe(|observer| observer.case(&case));
            let signs: Vec<(usize, Sign)> = given.iter().copied().chain(case).collect();
            together = match (self.explore(&signs)?, together) {
                (failure @ (Outcome::NotZero | Outcome::Outside(_)), _) => return Ok(failure),
                (Outcome::Empty(reason), None) => Some(Outcome::Empty(reason)),
                (Outcome::Empty(_), known) => known,
                (Outcome::Zero, _) => Some(Outcome::Zero),
            };
        }
        self.observe(|observer| observer.end());
        Ok(together.unwrap_or(Outcome::NotZero))
    }

    fn observe(&mut self, tell: impl FnOnce(&mut dyn Observer)) {
        if let Some(observer) = &mut self.observer {
            tell(*observer);
        }
    }

    /// Reports to the observer the facts on which the cases rest.
    fn observe_split(
        &mut self,
        given: &[(usize, Sign)],
        cases: &[Vec<(usize, Sign)>],
    ) -> Result<(), Obstacle> {
        let Some(observer) = &mut self.observer else { return Ok(()) };
        let (factors, facts) =
            self.assumptions.grounds(self.tower, self.pool, &self.differences, given)?.unwrap_or_default();
        observer.split(self.tower, &factors, &facts, cases);
        Ok(())
    }

    /// Applies the filter first, then the exact normal forms; `None` if they depend on an open
    /// sign.
    fn settle(&mut self, given: &[(usize, Sign)]) -> Result<Option<Outcome>, Obstacle> {
        self.tower.fix_signs(given);
        let prepared = normalise(self.tower, self.pool, &self.expressions())?;
        if !prepared.open.is_empty() {
            return Ok(None);
        }
        let count = self.differences.len();
        if prepared.certainly_not_zero(self.tower, self.pool)[..count].contains(&true) {
            return Ok(Some(Outcome::NotZero));
        }
        let zero = prepared.exact(self.tower, self.pool)?[..count].iter().all(Fraction::is_zero);
        let proved = zero && self.angle_keeps_within_a_turn(given)?;
        Ok(Some(if proved { Outcome::Zero } else { Outcome::NotZero }))
    }

    fn angle_keeps_within_a_turn(&mut self, given: &[(usize, Sign)]) -> Result<bool, Obstacle> {
        let Some(turn) = &self.turn else { return Ok(true) };
        let range = self.assumptions.range(self.tower, self.pool, turn.angle, given)?;
        Ok(range.is_within(2, 1))
    }

    /// Returns the differences, then the other expressions whose signs must be known.
    fn expressions(&self) -> Vec<Expr> {
        let signs = self.turn.iter().flat_map(|turn| &turn.signs);
        self.differences.iter().chain(signs).copied().collect()
    }
}
