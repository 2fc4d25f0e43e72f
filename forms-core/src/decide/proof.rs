//! The proof: every difference has the normal form zero, in every case of the signs that matter.

use super::problem::Problem;
use crate::assume::{Assumptions, Cases};
use crate::expression::{Expr, Pool};
use crate::normal::{Fraction, Obstacle, Tower, Trigonometry, normalise};

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

/// Tries to prove that every component vanishes.
pub(super) fn prove(pool: &mut Pool, problem: &Problem) -> Outcome {
    let differences = problem.differences();
    let assumptions = Assumptions::new(pool, &problem.assumptions);
    let mut tower = Tower::new(Trigonometry::Circle);
    let proof = Proof { pool, differences, assumptions };
    match proof.run(&mut tower) {
        Ok(outcome) => outcome,
        Err(Obstacle::DivisionByZero) => Outcome::Empty("it divides by zero everywhere".into()),
        Err(Obstacle::Outside(part)) => {
            Outcome::Outside(format!("outside the class that is decided: {part}"))
        }
        Err(Obstacle::TooLarge(limit)) => Outcome::Outside(format!("the normal form is too large: {limit}")),
        Err(Obstacle::Refine) => Outcome::Outside("its radicands could not be factored".into()),
    }
}

struct Proof<'a> {
    pool: &'a Pool,
    differences: Vec<Expr>,
    assumptions: Assumptions,
}

impl Proof<'_> {
    fn run(&self, tower: &mut Tower) -> Result<Outcome, Obstacle> {
        let cases = match self.assumptions.cases(tower, self.pool, &self.differences)? {
            Cases::Signs(cases) => cases,
            Cases::Empty => return Ok(Outcome::Empty("no point meets its conditions".into())),
            Cases::TooMany => {
                return Ok(Outcome::Outside("too many factors of radicands have an open sign".into()));
            }
        };
        for case in cases {
            case.iter().for_each(|(base, sign)| tower.assume_sign(*base, *sign));
            if self.decide_case(tower)? == Outcome::NotZero {
                return Ok(Outcome::NotZero);
            }
        }
        Ok(Outcome::Zero)
    }

    /// The filter first, then the exact normal forms.
    fn decide_case(&self, tower: &mut Tower) -> Result<Outcome, Obstacle> {
        let prepared = normalise(tower, self.pool, &self.differences)?;
        if prepared.certainly_not_zero(tower, self.pool).contains(&true) {
            return Ok(Outcome::NotZero);
        }
        let zero = prepared.exact(tower, self.pool)?.iter().all(Fraction::is_zero);
        Ok(if zero { Outcome::Zero } else { Outcome::NotZero })
    }
}
