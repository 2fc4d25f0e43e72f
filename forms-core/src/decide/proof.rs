//! The proof: every difference has the normal form zero, in every case of the signs that matter.

use super::problem::Problem;
use super::region::{Constraint, NoCases, Region};
use super::sign::Facts;
use crate::expression::{Condition, Expr, Pool};
use crate::normal::{Fraction, Obstacle, Sign, SignConstraint, Tower, Trigonometry, normalise};
use crate::syntax::ast::Relation;

/// How often the tower may be refined by what the assumptions bring in.
const MOST_PASSES: usize = 16;

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
    let sides: Vec<Expr> = problem.assumptions.iter().map(|c| pool.subtract(c.left, c.right)).collect();
    let mut tower = Tower::new(Trigonometry::Circle);
    let proof = Proof { pool, problem, differences, sides };
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
    problem: &'a Problem,
    differences: Vec<Expr>,
    sides: Vec<Expr>,
}

impl Proof<'_> {
    fn run(&self, tower: &mut Tower) -> Result<Outcome, Obstacle> {
        let prepared = normalise(tower, self.pool, &self.differences)?;
        let needed = needed_signs(tower);
        if needed.is_empty() && prepared.constraints.is_empty() {
            return self.decide_case(tower);
        }
        let (region, needed) = self.region(tower)?;
        let cases = match region.cases() {
            Ok(cases) => cases,
            Err(NoCases::Empty) => return Ok(Outcome::Empty("no point meets its conditions".into())),
            Err(NoCases::TooMany) => {
                return Ok(Outcome::Outside("too many factors of radicands have an open sign".into()));
            }
        };
        let mut done: Vec<Vec<(usize, Sign)>> = Vec::new();
        for case in cases {
            let relevant: Vec<(usize, Sign)> =
                case.into_iter().filter(|(base, _)| needed.contains(base)).collect();
            if done.contains(&relevant) {
                continue;
            }
            relevant.iter().for_each(|(base, sign)| tower.assume_sign(*base, *sign));
            if self.decide_case(tower)? == Outcome::NotZero {
                return Ok(Outcome::NotZero);
            }
            done.push(relevant);
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

    /// The factors whose signs matter, with all that is known of them; and those the differences need.
    fn region(&self, tower: &mut Tower) -> Result<(Region, Vec<usize>), Obstacle> {
        for _ in 0..MOST_PASSES {
            tower.forget_needs();
            let prepared = normalise(tower, self.pool, &self.differences)?;
            let needed = needed_signs(tower);
            let mut constraints: Vec<Constraint> = prepared
                .constraints
                .into_iter()
                .map(|product| Constraint { product, strict: false })
                .collect();
            let mut facts = Facts::of(tower);
            match self.assume(tower, &mut facts, &mut constraints) {
                Err(Obstacle::Refine) => continue,
                result => result?,
            }
            return Ok((assemble(tower, &facts, needed.clone(), constraints), needed));
        }
        Err(Obstacle::Refine)
    }

    /// Facts and constraints from the assumptions; one without a normal form is left out, which only
    /// leaves more cases.
    fn assume(
        &self,
        tower: &mut Tower,
        facts: &mut Facts,
        constraints: &mut Vec<Constraint>,
    ) -> Result<(), Obstacle> {
        for (condition, &side) in self.problem.assumptions.iter().zip(&self.sides) {
            let before = tower.trigonometry();
            let difference = match normal_form(tower, self.pool, side) {
                Ok(difference) => difference,
                Err(Obstacle::Refine) => return Err(Obstacle::Refine),
                Err(_) => continue,
            };
            if tower.trigonometry() != before {
                return Err(Obstacle::Refine);
            }
            facts.learn(tower, &difference, condition.relation);
            if let Some(constraint) = constraint(tower, &difference, condition)? {
                constraints.push(constraint);
            }
        }
        facts.learn_half_tangents(tower);
        Ok(())
    }
}

/// `difference relation 0` as a constraint on factors.
fn constraint(
    tower: &mut Tower,
    difference: &Fraction,
    condition: &Condition,
) -> Result<Option<Constraint>, Obstacle> {
    if difference.is_zero() {
        return Ok(None);
    }
    let (negative, strict) = match condition.relation {
        Relation::Greater => (false, true),
        Relation::GreaterEqual => (false, false),
        Relation::Less => (true, true),
        Relation::LessEqual => (true, false),
        Relation::NotEqual => return Ok(None),
    };
    if tower.trigonometry() == Trigonometry::Circle && tower.mentions_trigonometry(difference) {
        return Ok(None);
    }
    let product: SignConstraint = tower.sign_constraint(difference)?;
    let product = SignConstraint { negative: product.negative != negative, ..product };
    Ok(Some(Constraint { product, strict }))
}

fn normal_form(tower: &mut Tower, pool: &Pool, expression: Expr) -> Result<Fraction, Obstacle> {
    let prepared = normalise(tower, pool, &[expression])?;
    Ok(prepared.exact(tower, pool)?.remove(0))
}

fn needed_signs(tower: &Tower) -> Vec<usize> {
    tower.bases().filter(|(_, base)| base.sign_needed).map(|(number, _)| number).collect()
}

/// The needed factors and those that share a constraint with one.
fn assemble(tower: &Tower, facts: &Facts, needed: Vec<usize>, constraints: Vec<Constraint>) -> Region {
    let polynomial =
        |number: usize| tower.bases().find(|(n, _)| *n == number).map(|(_, base)| &base.polynomial);
    let is_number = |number: &usize| polynomial(*number).is_none_or(|p| p.as_constant().is_some());
    let mut factors: Vec<usize> = needed;
    let mut kept: Vec<Constraint> = Vec::new();
    for mut constraint in constraints {
        constraint.product.odd.retain(|number| !is_number(number));
        constraint.product.other.retain(|number| !is_number(number));
        let mentioned: Vec<usize> =
            constraint.product.odd.iter().chain(&constraint.product.other).copied().collect();
        let relevant = mentioned.is_empty() || mentioned.iter().any(|number| factors.contains(number));
        if relevant {
            factors
                .extend(mentioned.into_iter().filter(|number| !factors.contains(number)).collect::<Vec<_>>());
            kept.push(constraint);
        }
    }
    let factors = factors
        .into_iter()
        .map(|number| (number, polynomial(number).and_then(|polynomial| facts.sign_of(polynomial))))
        .collect();
    Region { factors, constraints: kept }
}
