//! What can be found out about equations: points first, then the normal form, then more points.

use super::empty;
use super::equation::by_equations;
use super::instance::{FIRST_CHOICE, Instance, MORE_CHOICES, instances};
use super::problem::Problem;
use super::proof::{self, Outcome};
use super::report;
use super::separation;
use super::special;
use super::verdict::Witness;
use super::witness::{Difference, Found, Search};
use crate::expression::{Condition, Expr, Pool};

/// Candidate points looked at before the normal form is computed, and how many good ones are enough.
const FIRST_CANDIDATES: usize = 24;
const FIRST_POINTS: usize = 1;

/// Good points looked at after normal forms that are not zero: to prove equations of angles costs more than points.
const POINTS_BEFORE_ANGLES: usize = 6;

/// How much may be spent on one problem, in steps.
#[derive(Clone, Copy)]
pub(crate) struct Effort {
    /// Products of terms of the normal forms.
    pub(crate) work: u64,
    /// Candidate points looked at before giving up.
    pub(crate) candidates: usize,
    /// How many good points make it hopeless to look for a difference.
    pub(crate) points: usize,
}

impl Effort {
    /// For what its author wants to know.
    pub(crate) const STATEMENT: Effort =
        Effort { work: crate::normal::WORK_LIMIT, candidates: 600, points: 40 };

    /// So many times the work.
    pub(crate) fn times(self, factor: u32) -> Effort {
        Effort { work: self.work.saturating_mul(factor.into()), ..self }
    }
}

/// What was found.
pub(crate) enum Finding {
    /// Every equation holds wherever its sides are defined and the conditions hold; so many such points were seen.
    Equal { points: usize },
    /// One fails at an exact point.
    Different(Witness),
    /// They speak of no point.
    Empty(String),
    /// Neither was shown; the sides agree, as far as they are certain, at so many points.
    Unknown { reason: String, points: usize },
}

/// Equations between scalars, under conditions.
pub(crate) struct Equations<'a> {
    /// Left and right sides.
    pub(crate) sides: &'a [(Expr, Expr)],
    /// The points spoken of satisfy these.
    pub(crate) conditions: &'a [Condition],
}

impl Equations<'_> {
    /// What can be found out wherever both sides are defined.
    pub(crate) fn decide(&self, pool: &mut Pool, effort: Effort) -> Finding {
        let problem = Problem::of_scalars(pool, self.sides, self.conditions);
        find(pool, &problem, effort)
    }
}

/// Why no point meets these conditions, if that can be shown.
pub(crate) fn contradiction(pool: &mut Pool, conditions: &[Condition]) -> Option<String> {
    let problem = Problem::of_scalars(pool, &[], conditions);
    empty::contradiction(pool, &problem)
}

pub(super) fn find(pool: &mut Pool, problem: &Problem, effort: Effort) -> Finding {
    let seems_true = Search::new(pool, problem, 0).sees_agreement(FIRST_CANDIDATES);
    let early = seems_true.then(|| proof::by_normal_forms(pool, problem, effort.work));
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
    let outcome = early.unwrap_or_else(|| proof::by_normal_forms(pool, problem, effort.work));
    let outcome = proof::as_angles(pool, problem, effort.work, outcome);
    let outcome = proof::as_parts(pool, problem, effort.work, outcome);
    let outcome = separation::as_numbers(pool, problem, outcome);
    let outcome = by_equations(pool, problem, effort.work, outcome);
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
    survey.enough = if outcome == Outcome::Zero { 1 } else { effort.points };
    if outcome != Outcome::Zero && survey.instances.is_some() {
        survey.instances = instances(pool, problem, MORE_CHOICES);
    }
    if survey.difference.is_none() {
        survey.look(pool, problem, position, effort.candidates);
    }
    if survey.difference.is_none() && outcome != Outcome::Zero {
        survey.look_at_strata(pool, problem);
    }
    survey.finding(pool, problem, outcome)
}

/// What looking at points has shown so far.
struct Survey {
    points: usize,
    enough: usize,
    difference: Option<Difference>,
    /// What points are looked for of, where it is not the problem itself.
    instances: Option<Vec<Instance>>,
    /// Whether thin strata were looked at.
    saw_strata: bool,
}

impl Default for Survey {
    fn default() -> Self {
        Survey { points: 0, enough: FIRST_POINTS, difference: None, instances: None, saw_strata: false }
    }
}

impl Survey {
    /// What follows from an outcome of normal forms and from the points that were looked at.
    fn finding(self, pool: &mut Pool, problem: &Problem, outcome: Outcome) -> Finding {
        let points = self.points;
        if let Some(difference) = &self.difference {
            return Finding::Different(report::witness(pool, problem, difference));
        }
        match outcome {
            Outcome::Zero => Finding::Equal { points },
            Outcome::NotZero => {
                let reason =
                    "the two sides have different normal forms, but no point was found at which they differ";
                Finding::Unknown { reason: reason.into(), points }
            }
            Outcome::Outside(reason) | Outcome::Empty(reason) => Finding::Unknown { reason, points },
        }
    }

    /// Looks at points on thin strata, once.
    fn look_at_strata(&mut self, pool: &mut Pool, problem: &Problem) {
        if self.instances.is_none() && !std::mem::replace(&mut self.saw_strata, true) {
            let seen = special::look(pool, problem);
            self.points += seen.points;
            self.difference = seen.difference;
        }
    }

    /// Looks at candidates from one position on; gives the position to go on from.
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
