//! Decision procedure for equations: points first, then the normal form, then more points.

use super::empty;
use super::goal::Outcome;
use super::instance::{FIRST_CHOICE, Instance, MORE_CHOICES, instances};
use super::problem::Problem;
use super::proof;
use super::reasons::{EmptyReason, UnknownReason};
use super::report;
use super::special;
use super::tactics::{self, CANDIDATES, FIRST_CANDIDATES};
use super::verdict::Witness;
use super::witness::{Difference, Found, Search};
use crate::expression::{Condition, Expr, Pool};

/// Number of valid points that are enough before the normal form is computed.
const FIRST_POINTS: usize = 1;

/// Valid points tried after normal forms that are not zero: proofs of equations between angles cost
/// more than points.
const POINTS_BEFORE_ANGLES: usize = 6;

/// Budget for one problem, in steps.
#[derive(Clone, Copy)]
pub(crate) struct Budget {
    /// Limit on the products of terms in the normal forms.
    pub(crate) work: u64,
    /// Candidate points tried before giving up.
    pub(crate) candidates: usize,
    /// Number of valid points after which a difference is no longer expected.
    pub(crate) points: usize,
}

impl Budget {
    /// Budget for a statement that its author wants decided.
    pub(crate) const STATEMENT: Budget =
        Budget { work: crate::normal::WORK_LIMIT, candidates: CANDIDATES, points: 40 };

    /// Multiplies the work limit by a factor.
    pub(crate) fn times(self, factor: u32) -> Budget {
        Budget { work: self.work.saturating_mul(factor.into()), ..self }
    }
}

/// Result of the decision procedure.
pub(crate) enum Finding {
    /// Every equation holds wherever its sides are defined and the conditions hold; `points` is the
    /// number of such points that were seen.
    Equal { points: usize },
    /// One of the equations fails at an exact point.
    Different(Witness),
    /// The equations are vacuous: no point meets their conditions, for the given reason.
    Empty(EmptyReason),
    /// Neither was shown; at `points` points the sides agree, to the digits that are certain.
    Unknown { reason: UnknownReason, points: usize },
}

/// Equations between scalars, under conditions.
pub(crate) struct Equations<'a> {
    /// Left and right sides.
    pub(crate) sides: &'a [(Expr, Expr)],
    /// Conditions on the points at which the equations are to hold.
    pub(crate) conditions: &'a [Condition],
}

impl Equations<'_> {
    /// Decides the equations wherever both sides are defined.
    pub(crate) fn decide(&self, pool: &mut Pool, budget: Budget) -> Finding {
        let problem = Problem::of_scalars(pool, self.sides, self.conditions);
        find(pool, &problem, budget)
    }
}

/// Returns the reason why no point meets these conditions, if that can be shown.
pub(crate) fn contradiction(pool: &mut Pool, conditions: &[Condition]) -> Option<EmptyReason> {
    nowhere_defined(pool, &[], conditions)
}

/// Returns the reason why the sides are defined at no point that meets the conditions, if that can be
/// shown.
pub(crate) fn nowhere_defined(
    pool: &mut Pool,
    sides: &[(Expr, Expr)],
    conditions: &[Condition],
) -> Option<EmptyReason> {
    let problem = Problem::of_scalars(pool, sides, conditions);
    empty::contradiction(pool, &problem)
}

pub(super) fn find(pool: &mut Pool, problem: &Problem, budget: Budget) -> Finding {
    let seems_true = Search::new(pool, problem, 0).sees_agreement(FIRST_CANDIDATES);
    let early = seems_true.then(|| proof::by_normal_forms(pool, problem, budget.work));
    if early == Some(Outcome::Zero) {
        return Finding::Equal { points: FIRST_POINTS };
    }
    let mut survey = Survey { instances: instances(pool, problem, FIRST_CHOICE), ..Survey::default() };
    if early.is_some() {
        survey.enough = POINTS_BEFORE_ANGLES;
    }
    let position = survey.look(pool, problem, 0, FIRST_CANDIDATES);
    if let Some(difference) = survey.difference.take() {
        return Finding::Different(report::witness(pool, problem, &difference));
    }
    let outcome = tactics::prove(pool, problem, budget.work, early);
    if outcome == Outcome::Zero && survey.points > 0 {
        return Finding::Equal { points: survey.points };
    }
    if survey.points == 0 {
        survey.look_at_strata(pool, problem);
        if survey.points == 0 && survey.difference.is_none() {
            let contradiction = empty::contradiction(pool, problem);
            let known = if let Outcome::Empty(reason) = &outcome { Some(reason.clone()) } else { None };
            if let Some(reason) = contradiction.or(known) {
                return Finding::Empty(reason);
            }
        }
    }
    survey.enough = if outcome == Outcome::Zero { 1 } else { budget.points };
    if outcome != Outcome::Zero && survey.instances.is_some() {
        survey.instances = instances(pool, problem, MORE_CHOICES);
    }
    if survey.difference.is_none() {
        survey.look(pool, problem, position, budget.candidates);
    }
    if survey.difference.is_none() && outcome != Outcome::Zero {
        survey.look_at_strata(pool, problem);
    }
    survey.finding(pool, problem, outcome)
}

/// State of the search for points.
struct Survey {
    points: usize,
    enough: usize,
    difference: Option<Difference>,
    /// Instances that are searched for points instead of the problem itself.
    instances: Option<Vec<Instance>>,
    /// Whether thin strata were searched.
    saw_strata: bool,
}

impl Default for Survey {
    fn default() -> Self {
        Survey { points: 0, enough: FIRST_POINTS, difference: None, instances: None, saw_strata: false }
    }
}

impl Survey {
    /// Returns the finding that follows from the outcome of the normal forms and from the points
    /// that were tried.
    fn finding(self, pool: &mut Pool, problem: &Problem, outcome: Outcome) -> Finding {
        let points = self.points;
        if let Some(difference) = &self.difference {
            return Finding::Different(report::witness(pool, problem, difference));
        }
        match outcome {
            Outcome::Zero => Finding::Equal { points },
            Outcome::NotZero => Finding::Unknown { reason: UnknownReason::DifferentNormalForms, points },
            Outcome::Outside(reason) => Finding::Unknown { reason, points },
            Outcome::Empty(reason) => Finding::Unknown { reason: UnknownReason::Vacuous(reason), points },
        }
    }

    /// Tries points on thin strata, once.
    fn look_at_strata(&mut self, pool: &mut Pool, problem: &Problem) {
        if self.instances.is_none() && !std::mem::replace(&mut self.saw_strata, true) {
            let seen = special::look(pool, problem);
            self.points += seen.points;
            self.difference = seen.difference;
        }
    }

    /// Tries candidates from a position on and returns the position at which to continue.
    fn look(&mut self, pool: &Pool, problem: &Problem, from: u32, candidates: usize) -> u32 {
        let Some(instances) = self.instances.take() else {
            return self.look_at(pool, (problem, true), from, candidates);
        };
        let (mut position, enough) = (from, self.enough);
        for (number, instance) in instances.iter().enumerate() {
            self.enough = (enough * (number + 1)).div_ceil(instances.len());
            let problem = (&instance.problem, instance.refutes);
            position = self.look_at(pool, problem, from, candidates).max(position);
            if let Some(difference) = &mut self.difference {
                difference.point.extend(instance.functions.iter().cloned());
                break;
            }
        }
        self.enough = enough;
        self.instances = Some(instances);
        position
    }

    fn look_at(
        &mut self,
        pool: &Pool,
        (problem, refutes): (&Problem, bool),
        from: u32,
        candidates: usize,
    ) -> u32 {
        let mut search = Search::new(pool, problem, from);
        for _ in 0..candidates {
            match search.next() {
                Found::NoPoint => {}
                Found::Differs(difference) if refutes => {
                    self.difference = Some(difference);
                    break;
                }
                Found::Agrees | Found::Differs(_) => self.points += 1,
            }
            if self.points >= self.enough {
                break;
            }
        }
        search.position()
    }
}
