//! Deciding statements: an exact proof, an exact counterexample, or neither.
//!
//! ```text
//! statement ─▶ differences by component + what may be assumed
//!      │ witness: exact points, values enclosed            ─▶ Refuted
//!      └ normal forms, zero in every case                  ─▶ Proved
//!                                                     else ─▶ Unknown
//! ```
//! A glance in machine words comes first: where it is certain of a point at which the sides may agree, the normal
//! forms are asked before any other point is looked at.
//!
//! A proof never rests on a sample, a refutation never on a normal form: each has an argument of its own. A
//! few points are looked at first, since a false statement is refuted by almost any point; a proved one needs
//! a point as well, to show that it speaks of something.

mod account;
mod empty;
mod problem;
mod proof;
mod ratio;
mod report;
mod sample;
mod verdict;
mod witness;

pub use account::{Account, Bound, Cancellation, Case, account};
pub use ratio::Ratio;
pub use report::simplified_where;
pub use verdict::{Theorem, Verdict, Witness};

use crate::expression::Condition;
use crate::resolve::{Statement, Theory};
use problem::Problem;
use proof::Outcome;
use witness::{Difference, Found, Search};

/// Candidate points looked at before the normal form is computed, and how many good ones are enough.
const FIRST_CANDIDATES: usize = 24;
const FIRST_POINTS: usize = 1;

/// Candidate points looked at before giving up, and how many good ones make it hopeless.
const LAST_CANDIDATES: usize = 600;
const LAST_POINTS: usize = 40;

/// Decides one statement.
///
/// ```
/// use forms_core::{decide::decide, resolve::resolve, syntax::read};
/// let (file, errors) = read("chart R3(x, y, z); prove twice: d(d(x*y**2*dz)) == 0;");
/// assert!(errors.is_empty());
/// let (mut theory, errors) = resolve(&file);
/// assert!(errors.is_empty());
/// let statement = theory.statements[0].clone();
/// assert_eq!(decide(&mut theory, &statement).name(), "proved");
/// ```
pub fn decide(theory: &mut Theory, statement: &Statement) -> Verdict {
    let problem = Problem::new(theory, statement);
    let seems_true = Search::new(&theory.pool, &problem, 0).sees_agreement(FIRST_CANDIDATES);
    let early = seems_true.then(|| proof::outcome(&mut theory.pool, &problem));
    if early == Some(Outcome::Zero) {
        return report::proved(theory, &problem);
    }
    let mut search = Survey::default();
    let position = search.look(theory, &problem, 0, FIRST_CANDIDATES);
    if let Some(difference) = search.difference.take() {
        return report::refuted(theory, &problem, &difference);
    }
    let outcome = early.unwrap_or_else(|| proof::outcome(&mut theory.pool, &problem));
    if outcome == Outcome::Zero && search.points > 0 {
        return report::proved(theory, &problem);
    }
    if search.points == 0 {
        let contradiction = empty::contradiction(&mut theory.pool, &problem);
        let known = if let Outcome::Empty(reason) = &outcome { Some(reason.clone()) } else { None };
        if let Some(reason) = contradiction.or(known) {
            return Verdict::Empty { reason };
        }
    }
    search.enough = if outcome == Outcome::Zero { 1 } else { LAST_POINTS };
    search.look(theory, &problem, position, LAST_CANDIDATES);
    if let Some(difference) = search.difference {
        return report::refuted(theory, &problem, &difference);
    }
    match outcome {
        Outcome::Zero if search.points > 0 => report::proved(theory, &problem),
        Outcome::Zero => Verdict::Unknown {
            reason: "no point was found at which both sides are defined and every condition holds".into(),
        },
        Outcome::NotZero => Verdict::Unknown {
            reason: "the two sides have different normal forms, but no point was found at which they differ"
                .into(),
        },
        Outcome::Outside(reason) | Outcome::Empty(reason) => Verdict::Unknown { reason },
    }
}

/// What a verdict on a statement assumes, the texts of which it carries.
pub fn conditions(theory: &mut Theory, statement: &Statement) -> Vec<Condition> {
    let problem = Problem::new(theory, statement);
    report::conditions(&mut theory.pool, &problem)
}

/// What looking at points has shown so far.
struct Survey {
    points: usize,
    enough: usize,
    difference: Option<Difference>,
}

impl Default for Survey {
    fn default() -> Self {
        Survey { points: 0, enough: FIRST_POINTS, difference: None }
    }
}

impl Survey {
    /// Looks at candidates from one position on; gives the position to go on from.
    fn look(&mut self, theory: &Theory, problem: &Problem, from: u32, candidates: usize) -> u32 {
        let mut search = Search::new(&theory.pool, problem, from);
        for _ in 0..candidates {
            match search.next() {
                Found::NoPoint => {}
                Found::Agrees => self.points += 1,
                Found::Differs(difference) => {
                    self.difference = Some(difference);
                    break;
                }
            }
            if self.points >= self.enough {
                break;
            }
        }
        search.position()
    }
}
