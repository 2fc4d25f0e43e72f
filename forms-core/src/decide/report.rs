//! Verdicts in the user's notation: the conditions a theorem rests on, what is left of a false equation.

use super::problem::Problem;
use super::verdict::{Theorem, Verdict, Witness};
use super::witness::Difference;
use crate::assume::Facts;
use crate::expression::{Condition, Expr, Nature, Node, Pool};
use crate::normal::{Sign, Tower, Trigonometry, normalise};
use crate::resolve::Theory;
use crate::syntax::ast::Relation;
use num_traits::Zero;

/// Products of terms that a simplification for the eye may cost; a proof may cost more.
const SIMPLIFICATION_WORK: u64 = 20_000;

pub(super) fn proved(theory: &mut Theory, problem: &Problem) -> Verdict {
    Verdict::Proved(Theorem { conditions: conditions(&mut theory.pool, problem) })
}

pub(super) fn refuted(theory: &mut Theory, problem: &Problem, difference: &Difference) -> Verdict {
    let component = &problem.components[difference.component];
    let simple = simplified(&mut theory.pool, component.difference);
    Verdict::Refuted(Witness {
        conditions: conditions(&mut theory.pool, problem),
        point: difference.point.clone(),
        component: component.label.clone(),
        left: difference.left.clone(),
        right: difference.right.clone(),
        difference: theory.pool.text(simple),
    })
}

/// The expression through its normal form, or itself where it has none that reads better.
pub fn simplified(pool: &mut Pool, expression: Expr) -> Expr {
    let mut tower = Tower::new(Trigonometry::Circle).with_work_limit(SIMPLIFICATION_WORK);
    let Ok(prepared) = normalise(&mut tower, pool, &[expression]) else { return expression };
    let open_sign =
        tower.bases().any(|(_, base)| base.sign_needed && base.polynomial.as_constant().is_none());
    if tower.trigonometry() != Trigonometry::Circle || (open_sign && !signs_are_known(&tower)) {
        return expression;
    }
    match prepared.exact(&mut tower, pool) {
        Ok(fractions) => tower.raise(pool, &fractions[0]),
        Err(_) => expression,
    }
}

/// Whether every radicand factor whose sign was needed is positive by its nature or as the whole radicand.
fn signs_are_known(tower: &Tower) -> bool {
    let facts = Facts::of(tower);
    tower
        .bases()
        .filter(|(_, base)| base.sign_needed && base.polynomial.as_constant().is_none())
        .all(|(_, base)| facts.sign_of(&base.polynomial) == Some(Sign::Positive))
}

/// What is assumed: every stated condition, then where the sides are defined as far as that says more.
fn conditions(pool: &mut Pool, problem: &Problem) -> Vec<String> {
    let (stated, domain) = problem.assumptions.split_at(problem.stated);
    let mut texts: Vec<String> = Vec::new();
    let known: Vec<(Expr, bool)> = stated.iter().map(|condition| core(pool, condition)).collect();
    for condition in stated {
        push_new(&mut texts, condition.text(pool));
    }
    for condition in domain {
        let (essence, strict) = core(pool, condition);
        let follows = known.iter().any(|(known, sharp)| *known == essence && (*sharp || !strict));
        if !follows && !holds_by_nature(pool, essence, strict) {
            let zero = pool.integer(0);
            let simple = Condition { left: essence, relation: condition.relation, right: zero };
            push_new(&mut texts, simple.text(pool));
        }
    }
    texts
}

fn push_new(texts: &mut Vec<String>, text: String) {
    if !texts.contains(&text) {
        texts.push(text);
    }
}

/// The expression a condition speaks of, without powers around it, and whether it excludes zero.
fn core(pool: &mut Pool, condition: &Condition) -> (Expr, bool) {
    let strict = !matches!(condition.relation, Relation::GreaterEqual | Relation::LessEqual);
    let difference = if pool.as_number(condition.right).is_some_and(Zero::is_zero) {
        condition.left
    } else {
        pool.subtract(condition.left, condition.right)
    };
    let mut essence = difference;
    if condition.relation == Relation::NotEqual {
        while let Node::Power(base, _) = pool.node(essence) {
            essence = *base;
        }
    }
    (essence, strict)
}

/// Whether an expression is seen to be never negative (or never zero) from how it is written.
fn holds_by_nature(pool: &Pool, expression: Expr, strict: bool) -> bool {
    pool.nature(expression) >= if strict { Nature::Positive } else { Nature::NotNegative }
}
