//! Assumptions: the possible signs of the factors of radicands under given conditions.
//!
//! ```text
//! conditions ─ normal forms ─▶ facts (bounds of generators) + constraints (signs of products)
//!                                        │
//! expressions ─ whose signs matter ─▶ region ─▶ cases, each a sign for every such factor
//! ```
//! All reasoning about real expressions under conditions, in proofs and integrals alike, uses the
//! cases found here.

mod arc;
mod contradiction;
mod dense;
mod facts;
mod half_turn;
mod linear;
mod magnitude;
mod open;
mod range;
mod region;
mod sign;
mod strata;

pub(crate) use contradiction::Contradiction;
pub(crate) use dense::is_not_zero_densely;
pub(crate) use facts::Facts;
pub(crate) use open::is_open;
pub(crate) use range::Range;

use crate::expression::{Condition, Expr, Pool, Relation};
use crate::normal::{Fraction, Normalised, Obstacle, Sign, SignConstraint, Tower, Trigonometry, normalise};
use region::{Constraint, MOST_FACTORS, NoCases, Region};

/// Number of times that the assumptions can refine the tower.
const MOST_PASSES: usize = 16;

/// Limit on the products of terms for a query whose answer may be left open.
const CHEAP_WORK: u64 = 1_000_000;

/// Conditions with the differences of their sides.
#[derive(Clone)]
pub(crate) struct Assumptions {
    conditions: Vec<Condition>,
    sides: Vec<Expr>,
    /// Whether every choice of signs is tested for a contradiction, not only the choices on
    /// boundaries.
    thorough: bool,
}

/// The cases of the signs that some expressions need.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Cases {
    /// Each case is a sign for every factor that matters; every point lies in one of the cases,
    /// perhaps on its boundary.
    Signs(Vec<Vec<(usize, Sign)>>),
    /// No point meets the conditions.
    Empty,
    /// There are too many cases.
    TooMany,
}

impl Assumptions {
    pub(crate) fn new(pool: &mut Pool, conditions: &[Condition]) -> Self {
        let mut conditions = conditions.to_vec();
        conditions.extend(magnitude::consequences(pool, &conditions));
        let sides = conditions.iter().map(|c| pool.subtract(c.left, c.right)).collect();
        Assumptions { conditions, sides, thorough: false }
    }

    /// Returns the same assumptions with fewer cases, for more work: the cases that linear
    /// certificates exclude are dropped.
    pub(crate) fn thorough(self) -> Self {
        Assumptions { thorough: true, ..self }
    }

    /// Returns the next cases to distinguish, under the given signs: cases of the open signs on
    /// which the expressions depend or, if there are none, on which the conditions depend. A single
    /// case without signs means that nothing remains to be distinguished. A sign within a sign
    /// (√(|x| − 1)) is open only after the inner sign is given, so the caller has to ask again for
    /// each case.
    pub(crate) fn cases(
        &self,
        tower: &mut Tower,
        pool: &Pool,
        expressions: &[Expr],
        given: &[(usize, Sign)],
    ) -> Result<Cases, Obstacle> {
        let Some((region, wanted, facts)) = self.region(tower, pool, expressions, given)? else {
            return Ok(Cases::Empty);
        };
        let cases = match region.cases(|signs| facts.allow(tower, signs), self.thorough) {
            Ok(cases) => cases,
            Err(NoCases::Empty) => return Ok(Cases::Empty),
            Err(NoCases::TooMany) => return Ok(Cases::TooMany),
        };
        let mut distinct: Vec<Vec<(usize, Sign)>> = Vec::new();
        for case in cases {
            let relevant: Vec<(usize, Sign)> =
                case.into_iter().filter(|(base, _)| wanted.contains(base)).collect();
            if !distinct.contains(&relevant) {
                distinct.push(relevant);
            }
        }
        Ok(Cases::Signs(distinct))
    }

    /// Returns the factors on which the cases rest, first those to distinguish, and the known facts
    /// about generators. `None` if the conditions contradict each other.
    pub(crate) fn grounds(
        &self,
        tower: &mut Tower,
        pool: &Pool,
        expressions: &[Expr],
        given: &[(usize, Sign)],
    ) -> Result<Option<(Vec<usize>, Facts)>, Obstacle> {
        let found = self.region(tower, pool, expressions, given)?;
        Ok(found.map(|(region, mut wanted, facts)| {
            let others =
                region.factors.iter().map(|factor| factor.0).filter(|factor| !wanted.contains(factor));
            wanted.extend(others.collect::<Vec<_>>());
            (wanted, facts)
        }))
    }

    /// Returns the region of the factors whose signs matter, the factors to distinguish, and the
    /// known facts. `None` if the conditions contradict each other.
    fn region(
        &self,
        tower: &mut Tower,
        pool: &Pool,
        expressions: &[Expr],
        given: &[(usize, Sign)],
    ) -> Result<Option<(Region, Vec<usize>, Facts)>, Obstacle> {
        for _ in 0..MOST_PASSES {
            let Some((prepared, mut knowledge)) = self.learned(tower, pool, expressions, given)? else {
                continue;
            };
            if knowledge.facts.contradiction() {
                return Ok(None);
            }
            let radicands = prepared.constraints.into_iter();
            knowledge.constraints.extend(radicands.map(|product| Constraint { product, strict: false }));
            if knowledge.constraints.iter().any(|constraint| constraint.speaks_of_retired(tower)) {
                tower.start_again();
                continue;
            }
            let open = if prepared.open.is_empty() { knowledge.open.clone() } else { prepared.open };
            let wanted = simplest(tower, open);
            let factors = if wanted.is_empty() { knowledge.factors(given) } else { wanted.clone() };
            let facts = knowledge.facts.clone();
            return Ok(Some((assemble(tower, knowledge, given, factors), wanted, facts)));
        }
        Err(Obstacle::Refine)
    }

    /// Returns the range of an angle under the given signs; unbounded where it is not known.
    pub(crate) fn range(
        &self,
        tower: &mut Tower,
        pool: &Pool,
        angle: Expr,
        given: &[(usize, Sign)],
    ) -> Result<Range, Obstacle> {
        for _ in 0..MOST_PASSES {
            let Some((prepared, knowledge)) = self.learned(tower, pool, &[angle], given)? else { continue };
            if !prepared.is_unconditional() {
                break;
            }
            let value = prepared.exact(tower, pool)?.remove(0);
            return knowledge.facts.range(tower, &value);
        }
        Ok(Range::default())
    }

    /// Returns the normal forms of the expressions under the given signs, and the consequences of
    /// the conditions together with these signs. `None` if the conditions refine the tower, which
    /// then starts again.
    fn learned(
        &self,
        tower: &mut Tower,
        pool: &Pool,
        expressions: &[Expr],
        given: &[(usize, Sign)],
    ) -> Result<Option<(Normalised, Knowledge)>, Obstacle> {
        tower.fix_signs(given);
        let prepared = normalise(tower, pool, expressions)?;
        let mut knowledge = Knowledge::of(tower, given);
        match self.assume(tower, pool, &mut knowledge) {
            Err(Obstacle::Refine) => {
                tower.start_again();
                Ok(None)
            }
            result => result.map(|()| Some((prepared, knowledge))),
        }
    }

    /// Adds the consequences of the conditions. A condition without a normal form, or whose normal
    /// form depends on an open sign, is left out; this only leaves more cases.
    fn assume(&self, tower: &mut Tower, pool: &Pool, knowledge: &mut Knowledge) -> Result<(), Obstacle> {
        for (condition, &side) in self.conditions.iter().zip(&self.sides) {
            let before = tower.trigonometry();
            let Ok(prepared) = normalise(tower, pool, &[side]) else { continue };
            if tower.trigonometry() != before {
                return Err(Obstacle::Refine);
            }
            if !prepared.is_unconditional() {
                knowledge.open.extend(prepared.open);
                continue;
            }
            let difference = match prepared.exact(tower, pool) {
                Ok(mut fractions) => fractions.remove(0),
                Err(Obstacle::Refine) => return Err(Obstacle::Refine),
                Err(_) => continue,
            };
            knowledge.facts.learn(tower, &difference, condition.relation);
            let constraint = constraint(tower, &difference, condition)?;
            let open = tower.open_signs_asked();
            if open.is_empty() {
                knowledge.constraints.extend(constraint);
            }
            knowledge.open.extend(open);
        }
        knowledge.facts.learn_functions(tower);
        knowledge.open.sort_unstable();
        knowledge.open.dedup();
        Ok(())
    }
}

/// Returns the factors that bound one generator by a number, if there are any: after their signs
/// are given, more is known about the others.
fn simplest(tower: &Tower, open: Vec<usize>) -> Vec<usize> {
    let is_bound = |&base: &usize| {
        let polynomial = &tower.base(base).polynomial;
        polynomial.total_degree() == 1 && polynomial.variables().len() == 1
    };
    let simple: Vec<usize> = open.iter().copied().filter(is_bound).collect();
    if simple.is_empty() { open } else { simple }
}

/// Whether a ≤ b is known to hold wherever the conditions do.
pub(crate) fn is_at_most(pool: &mut Pool, a: Expr, b: Expr, conditions: &[Condition]) -> bool {
    let difference = pool.subtract(b, a);
    let assumptions = Assumptions::new(pool, conditions);
    let mut tower = Tower::new(Trigonometry::Circle);
    let Ok(prepared) = normalise(&mut tower, pool, &[difference]) else { return false };
    let mut knowledge = Knowledge::of(&tower, &[]);
    if !prepared.is_unconditional() || assumptions.assume(&mut tower, pool, &mut knowledge).is_err() {
        return false;
    }
    let known = prepared.exact(&mut tower, pool).and_then(|fractions| tower.expanded(&fractions[0]));
    let Ok(difference) = known else { return false };
    let sign = difference.as_polynomial().map(|polynomial| knowledge.facts.sign_of(polynomial));
    (difference.is_zero() || sign.flatten() == Some(Sign::Positive)) && tower.holds_everywhere()
}

/// Returns the range of an angle wherever the conditions hold; unbounded where it is not known.
pub(crate) fn range_of(pool: &mut Pool, angle: Expr, conditions: &[Condition]) -> Range {
    let assumptions = Assumptions::new(pool, conditions);
    let mut tower = Tower::new(Trigonometry::Circle).with_work_limit(CHEAP_WORK);
    let range = assumptions.range(&mut tower, pool, angle, &[]).unwrap_or_default();
    if tower.holds_everywhere() { range } else { Range::default() }
}

/// Whether an expression is known to be zero wherever it is defined. The test is cheap: `false`
/// decides nothing.
pub(crate) fn vanishes(pool: &Pool, expression: Expr) -> bool {
    let mut tower = Tower::new(Trigonometry::Circle).with_work_limit(CHEAP_WORK);
    let Ok(prepared) = normalise(&mut tower, pool, &[expression]) else { return false };
    prepared.is_unconditional()
        && prepared.exact(&mut tower, pool).is_ok_and(|fractions| fractions[0].is_zero())
        && tower.holds_everywhere()
}

/// Consequences of conditions under given signs.
struct Knowledge {
    facts: Facts,
    constraints: Vec<Constraint>,
    /// The open signs on which conditions depend.
    open: Vec<usize>,
}

impl Knowledge {
    fn of(tower: &Tower, given: &[(usize, Sign)]) -> Self {
        let mut facts = Facts::of(tower);
        for &(base, sign) in given {
            let relation = match sign {
                Sign::Positive => Relation::GreaterEqual,
                Sign::Negative => Relation::LessEqual,
            };
            facts.learn(tower, &tower.base(base).polynomial.clone().into(), relation);
        }
        Knowledge { facts, constraints: Vec::new(), open: Vec::new() }
    }

    /// Returns the given factors and, unless there are too many, the factors in the constraints.
    fn factors(&self, given: &[(usize, Sign)]) -> Vec<usize> {
        let given: Vec<usize> = given.iter().map(|entry| entry.0).collect();
        let mut all = given.clone();
        for base in self.constraints.iter().flat_map(Constraint::bases) {
            if !all.contains(&base) {
                all.push(base);
            }
        }
        if all.len() > MOST_FACTORS { given } else { all }
    }
}

impl Constraint {
    fn bases(&self) -> impl Iterator<Item = usize> {
        self.product.odd.iter().chain(&self.product.other).copied()
    }

    /// Whether one of its factors has been replaced by finer ones, which makes the constraint
    /// meaningless.
    fn speaks_of_retired(&self, tower: &Tower) -> bool {
        self.bases().any(|base| tower.base(base).is_retired())
    }
}

/// Returns `difference relation 0` as a constraint on factors.
fn constraint(
    tower: &mut Tower,
    difference: &Fraction,
    condition: &Condition,
) -> Result<Option<Constraint>, Obstacle> {
    if difference.is_zero() {
        let holds = matches!(condition.relation, Relation::GreaterEqual | Relation::LessEqual);
        return Ok((!holds).then(Constraint::impossible));
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

/// Returns the region of the factors that matter and of all factors that share a constraint with
/// one of these.
fn assemble(tower: &Tower, knowledge: Knowledge, given: &[(usize, Sign)], factors: Vec<usize>) -> Region {
    let is_number = |number: &usize| tower.base(*number).polynomial.as_constant().is_some();
    let mut factors: Vec<usize> = factors;
    let mut kept: Vec<Constraint> = Vec::new();
    for mut constraint in knowledge.constraints {
        constraint.product.odd.retain(|number| !is_number(number));
        constraint.product.other.retain(|number| !is_number(number));
        let mentioned: Vec<usize> = constraint.bases().collect();
        let relevant = mentioned.is_empty() || mentioned.iter().any(|number| factors.contains(number));
        if relevant {
            factors
                .extend(mentioned.into_iter().filter(|number| !factors.contains(number)).collect::<Vec<_>>());
            kept.push(constraint);
        }
    }
    factors.retain(|number| !is_number(number));
    let never_zero = |number: &&usize| knowledge.facts.never_zero(&tower.base(**number).polynomial);
    kept.extend(factors.iter().filter(never_zero).map(|&number| Constraint::not_zero(number)));
    let sign_of = |number: usize| {
        let known = given.iter().find(|entry| entry.0 == number).map(|entry| entry.1);
        known.or_else(|| knowledge.facts.sign_of(&tower.base(number).polynomial))
    };
    let factors = factors.into_iter().map(|number| (number, sign_of(number))).collect();
    Region { factors, constraints: kept }
}
