//! Account of a proof by normal forms, for a reader to check: its cases, the tower of extensions of
//! each case, and the cancellation in each component.
//!
//! A component is a sum of the terms that the calculus produced. Over a common denominator its
//! summands are numerators in the generators of the tower, and the proof is that the numerators add
//! up to the zero polynomial.

use super::cases::settled_cases;
use super::problem::{Component, Problem};
use super::translation;
use crate::expression::{Expr, Pool};
use crate::normal::{Fraction, Generator, Obstacle, Sign, Tower, Trigonometry, normalise};
use crate::theory::{Statement, Theory};
use std::collections::BTreeSet;

/// Components with more summands are shown as their two sides.
const MOST_SUMMANDS: usize = 12;

/// A proof by normal forms, case by case.
#[derive(Clone, Debug)]
pub struct Account {
    /// Sign cases that together cover every point of the statement.
    pub cases: Vec<Case>,
}

/// Cancellation under given signs of some factors of radicands.
#[derive(Clone, Debug)]
pub struct Case {
    /// The factors with their signs; empty if no sign mattered.
    pub signs: Vec<(Expr, Sign)>,
    /// The generators that occur.
    pub generators: Vec<Bound>,
    /// The components of the equation.
    pub components: Vec<Cancellation>,
}

/// A generator ρ and, where a relation ρⁿ = f defines it, n and f.
#[derive(Clone, Debug)]
pub struct Bound {
    /// ρ
    pub generator: Expr,
    /// n and f
    pub relation: Option<(u32, Expr)>,
    /// u, for ρ = tan(u/2), in which sin u and cos u are rational.
    pub half_angle: Option<Expr>,
}

/// The summands of left − right of one component, over one denominator.
#[derive(Clone, Debug)]
pub struct Cancellation {
    /// Name of the component: `dx^dy`, `@x`, or empty for a scalar.
    pub component: String,
    /// The summands as the calculus produced them.
    pub summands: Vec<Expr>,
    /// The numerators of the summands; their sum is zero.
    pub numerators: Vec<Expr>,
    /// The common denominator.
    pub denominator: Expr,
}

/// Returns the account of a proof by normal forms; `None` if normal forms do not prove the
/// statement.
pub fn account(theory: &mut Theory, statement: &Statement) -> Option<Account> {
    let problem = Problem::new(theory, statement);
    let frame = translation::frame(&theory.pool, &problem.differences());
    let mut tower = Tower::new(Trigonometry::Circle).in_frame(frame);
    let settled = settled_cases(&mut theory.pool, &problem, &mut tower, None)?;
    let cases = settled
        .iter()
        .map(|signs| case(&mut theory.pool, &mut tower, &problem, signs))
        .collect::<Result<Vec<Case>, Obstacle>>();
    Some(Account { cases: cases.ok()? })
}

fn case(
    pool: &mut Pool,
    tower: &mut Tower,
    problem: &Problem,
    signs: &[(usize, Sign)],
) -> Result<Case, Obstacle> {
    let mut used: BTreeSet<u32> = BTreeSet::new();
    let mut components = Vec::new();
    for component in &problem.components {
        tower.fix_signs(signs);
        if let Some(found) = cancellation(pool, tower, component, &mut used)? {
            components.push(found);
        }
    }
    let signs = signs
        .iter()
        .map(|&(base, sign)| (tower.raise(pool, &Fraction::from(tower.base(base).polynomial.clone())), sign))
        .collect();
    let used: Vec<u32> = used.into_iter().collect();
    let generators = used.into_iter().filter_map(|variable| bound(pool, tower, variable)).collect();
    Ok(Case { signs, generators, components })
}

/// Returns `None` if a single summand depends on a sign on which the sum does not depend.
fn cancellation(
    pool: &mut Pool,
    tower: &mut Tower,
    component: &Component,
    used: &mut BTreeSet<u32>,
) -> Result<Option<Cancellation>, Obstacle> {
    let signed = pool.summands(component.difference);
    let mut summands = if signed.len() > MOST_SUMMANDS {
        vec![component.left, pool.negate(component.right)]
    } else {
        signed.into_iter().map(|(part, negative)| if negative { pool.negate(part) } else { part }).collect()
    };
    summands.retain(|&summand| !pool.is_zero(summand));
    let prepared = normalise(tower, pool, &summands)?;
    if !prepared.open.is_empty() {
        return Ok(None);
    }
    let fractions = prepared.exact(tower, pool)?;
    let together = tower.together(&fractions)?;
    for fraction in together.numerators.iter().chain([&together.inverse]) {
        used.extend(tower.variables_of(fraction));
    }
    let numerators = together.numerators.iter().map(|numerator| tower.raise(pool, numerator)).collect();
    let denominator = tower.inverse(&together.inverse)?;
    let denominator = tower.raise(pool, &denominator);
    Ok(Some(Cancellation { component: component.label.clone(), summands, numerators, denominator }))
}

/// Describes a generator for the reader; `None` for a variable, an unknown function or π, which
/// need no explanation.
fn bound(pool: &mut Pool, tower: &Tower, variable: u32) -> Option<Bound> {
    let (_, generator, relation) = tower.generators().nth(variable as usize)?;
    let relation = relation.map(|(order, value)| (order, value.clone()));
    let half_angle = match generator {
        Generator::Variable(_) | Generator::Pi | Generator::Jet { .. } => return None,
        Generator::HalfTangent(unit) => Some(tower.raise_unit(pool, &unit.clone())),
        _ => None,
    };
    let generator = tower.raise(pool, &Fraction::from(crate::polynomial::Polynomial::variable(variable)));
    let relation = relation.map(|(order, value)| (order, tower.raise(pool, &Fraction::from(value))));
    Some(Bound { generator, relation, half_angle })
}
