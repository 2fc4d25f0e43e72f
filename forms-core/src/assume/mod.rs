//! Assumptions: which signs the factors of radicands have where some conditions hold.
//!
//! ```text
//! conditions ─ normal forms ─▶ facts (bounds of generators) + constraints (signs of products)
//!                                        │
//! expressions ─ whose signs matter ─▶ region ─▶ cases, each a sign for every such factor
//! ```
//! Everything that is said about real expressions under conditions, proofs and integrals alike, goes through
//! the cases found here.

mod region;
mod sign;

pub(crate) use sign::Facts;

use crate::expression::{Condition, Expr, Pool};
use crate::normal::{Fraction, Obstacle, Sign, SignConstraint, Tower, Trigonometry, normalise};
use crate::syntax::ast::Relation;
use region::{Constraint, NoCases, Region};

/// How often the tower may be refined by what the assumptions bring in.
const MOST_PASSES: usize = 16;

/// Conditions with the differences of their sides.
pub(crate) struct Assumptions {
    conditions: Vec<Condition>,
    sides: Vec<Expr>,
}

/// The cases of the signs that some expressions need.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Cases {
    /// Each is a sign for every factor that matters; one of them, perhaps on its border, holds at every point.
    Signs(Vec<Vec<(usize, Sign)>>),
    /// No point meets the conditions.
    Empty,
    /// There are too many.
    TooMany,
}

impl Assumptions {
    pub(crate) fn new(pool: &mut Pool, conditions: &[Condition]) -> Self {
        let sides = conditions.iter().map(|c| pool.subtract(c.left, c.right)).collect();
        Assumptions { conditions: conditions.to_vec(), sides }
    }

    /// The cases that the expressions have to be looked at in. The tower is refined as far as needed.
    pub(crate) fn cases(
        &self,
        tower: &mut Tower,
        pool: &Pool,
        expressions: &[Expr],
    ) -> Result<Cases, Obstacle> {
        normalise(tower, pool, expressions)?;
        if needed_signs(tower).is_empty() && tower.constraints().is_empty() {
            return Ok(Cases::Signs(vec![vec![]]));
        }
        let (region, needed) = self.region(tower, pool, expressions)?;
        let cases = match region.cases() {
            Ok(cases) => cases,
            Err(NoCases::Empty) => return Ok(Cases::Empty),
            Err(NoCases::TooMany) => return Ok(Cases::TooMany),
        };
        let mut distinct: Vec<Vec<(usize, Sign)>> = Vec::new();
        for case in cases {
            let relevant: Vec<(usize, Sign)> =
                case.into_iter().filter(|(base, _)| needed.contains(base)).collect();
            if !distinct.contains(&relevant) {
                distinct.push(relevant);
            }
        }
        Ok(Cases::Signs(distinct))
    }

    /// The factors whose signs matter, with all that is known of them; and those the expressions need.
    fn region(
        &self,
        tower: &mut Tower,
        pool: &Pool,
        expressions: &[Expr],
    ) -> Result<(Region, Vec<usize>), Obstacle> {
        for _ in 0..MOST_PASSES {
            normalise(tower, pool, expressions)?;
            let needed = needed_signs(tower);
            let mut constraints: Vec<Constraint> = Vec::new();
            let mut facts = Facts::of(tower);
            match self.assume(tower, pool, &mut facts, &mut constraints) {
                Err(Obstacle::Refine) => {
                    tower.start_again();
                    continue;
                }
                result => result?,
            }
            let radicands = tower.constraints().iter().cloned();
            constraints.extend(radicands.map(|product| Constraint { product, strict: false }));
            return Ok((assemble(tower, &facts, needed.clone(), constraints), needed));
        }
        Err(Obstacle::Refine)
    }

    /// Facts and constraints from the assumptions; one without a normal form is left out, which only
    /// leaves more cases.
    fn assume(
        &self,
        tower: &mut Tower,
        pool: &Pool,
        facts: &mut Facts,
        constraints: &mut Vec<Constraint>,
    ) -> Result<(), Obstacle> {
        for (condition, &side) in self.conditions.iter().zip(&self.sides) {
            let before = tower.trigonometry();
            let difference = match normal_form(tower, pool, side) {
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
