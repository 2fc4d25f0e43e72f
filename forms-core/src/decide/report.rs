//! Verdicts in the user's notation: the conditions a theorem rests on, what is left of a false equation.

use super::problem::Problem;
use super::verdict::{Theorem, Witness};
use super::witness::Difference;
use crate::assume::{Assumptions, Cases, Facts, is_open};
use crate::expression::{Condition, Expr, Nature, Node, Pool};
use crate::normal::{Fraction, Normalised, Sign, Tower, Trigonometry, normalise};
use crate::syntax::ast::Relation;
use num_traits::Zero;

/// Products of terms that a simplification for the eye may cost; a proof may cost more.
const SIMPLIFICATION_WORK: u64 = 20_000;

/// Signs within signs (√(|x| − 1)) deeper than this are not told apart for the eye.
const DEEPEST_SIGN: usize = 8;

/// The theorem that the problem's equations are.
pub(super) fn theorem(pool: &mut Pool, problem: &Problem) -> Theorem {
    Theorem { conditions: texts(pool, problem) }
}

/// The point at which one of them fails.
pub(super) fn witness(pool: &mut Pool, problem: &Problem, difference: &Difference) -> Witness {
    let component = &problem.components[difference.component];
    let simple = simplified(pool, component.difference);
    Witness {
        conditions: texts(pool, problem),
        point: difference.point.clone(),
        component: component.label.clone(),
        left: difference.left.clone(),
        right: difference.right.clone(),
        difference: pool.text(simple),
        ratio: None,
    }
}

/// The expression through its normal form, or itself where it has none that reads better.
pub(crate) fn simplified(pool: &mut Pool, expression: Expr) -> Expr {
    let mut tower = Tower::new(Trigonometry::Circle).with_work_limit(SIMPLIFICATION_WORK);
    let Ok(prepared) = normalise(&mut tower, pool, &[expression]) else { return expression };
    let open_sign =
        tower.bases().any(|(_, base)| base.sign_needed && base.polynomial.as_constant().is_none());
    if tower.trigonometry() != Trigonometry::Circle || (open_sign && !signs_are_known(&tower)) {
        return expression;
    }
    match prepared.exact(&mut tower, pool) {
        Ok(fractions) if tower.holds_everywhere() => tower.raise(pool, &fractions[0]),
        _ => expression,
    }
}

/// The same where conditions hold, as far as they leave one case of the signs that matter. They are asked only where
/// the expression by itself is not simplified, since that costs more.
pub fn simplified_where(pool: &mut Pool, conditions: &[Condition], expression: Expr) -> Expr {
    let simple = simplified(pool, expression);
    if simple != expression {
        return simple;
    }
    let assumptions = Assumptions::new(pool, conditions);
    let mut tower = Tower::new(Trigonometry::Circle).with_work_limit(SIMPLIFICATION_WORK);
    let Some(prepared) = in_only_case(pool, &mut tower, &assumptions, expression) else { return expression };
    match prepared.exact(&mut tower, pool) {
        Ok(fractions)
            if is_readable(&tower, &fractions[0])
                && (tower.holds_everywhere() || holds_as_a_limit(pool, conditions, expression)) =>
        {
            tower.raise(pool, &fractions[0])
        }
        _ => expression,
    }
}

/// The normal form with all signs that the expression depends on fixed, if the conditions leave no choice.
fn in_only_case(
    pool: &Pool,
    tower: &mut Tower,
    assumptions: &Assumptions,
    expression: Expr,
) -> Option<Normalised> {
    let mut signs: Vec<(usize, Sign)> = Vec::new();
    for _ in 0..DEEPEST_SIGN {
        tower.fix_signs(&signs);
        let prepared = normalise(tower, pool, &[expression]).ok()?;
        if prepared.open.is_empty() {
            return Some(prepared);
        }
        match assumptions.cases(tower, pool, &[expression], &signs) {
            Ok(Cases::Signs(mut cases)) if cases.len() == 1 && !cases[0].is_empty() => {
                signs.append(&mut cases[0]);
            }
            _ => return None,
        }
    }
    None
}

/// Whether an expression is continuous on an open set of points, so that what equals it beside some equals it there.
fn holds_as_a_limit(pool: &mut Pool, conditions: &[Condition], expression: Expr) -> bool {
    let all: Vec<Condition> = conditions.iter().copied().chain(pool.domain(&[expression])).collect();
    is_open(pool, &all, &[expression])
}

/// Whether nothing is written by half angles, which nobody wrote.
fn is_readable(tower: &Tower, fraction: &Fraction) -> bool {
    tower.trigonometry() == Trigonometry::Circle || !tower.mentions_trigonometry(fraction)
}

/// Whether every radicand factor whose sign was needed is positive by its nature or as the whole radicand.
fn signs_are_known(tower: &Tower) -> bool {
    let facts = Facts::of(tower);
    tower
        .bases()
        .filter(|(_, base)| base.sign_needed && base.polynomial.as_constant().is_none())
        .all(|(_, base)| facts.sign_of(&base.polynomial) == Some(Sign::Positive))
}

/// What is assumed.
pub(super) fn conditions(pool: &mut Pool, problem: &Problem) -> Vec<Condition> {
    told(pool, problem).into_iter().map(|(condition, _)| condition).collect()
}

fn texts(pool: &mut Pool, problem: &Problem) -> Vec<String> {
    told(pool, problem).into_iter().map(|(_, text)| text).collect()
}

/// Every stated condition, then where the sides are defined as far as that says more; with their texts.
fn told(pool: &mut Pool, problem: &Problem) -> Vec<(Condition, String)> {
    let (stated, domain) = problem.assumptions.split_at(problem.stated);
    let mut told: Vec<(Condition, String)> = Vec::new();
    let known: Vec<(Expr, bool)> = stated.iter().map(|condition| core(pool, condition)).collect();
    let mut tell = |pool: &Pool, condition: Condition| {
        let text = condition.text(pool);
        if told.iter().all(|(_, known)| *known != text) {
            told.push((condition, text));
        }
    };
    for condition in stated {
        tell(pool, *condition);
    }
    let mut positive: Vec<Expr> = Vec::new();
    for condition in domain.iter().filter(|condition| condition.relation == Relation::Greater) {
        positive.push(core(pool, condition).0);
    }
    for condition in domain {
        let (essence, strict) = core(pool, condition);
        let weaker = condition.relation != Relation::Greater && positive.contains(&essence);
        let follows = weaker || known.iter().any(|(known, sharp)| *known == essence && (*sharp || !strict));
        if !follows && !holds_by_nature(pool, essence, strict) {
            let right = pool.integer(0);
            tell(pool, Condition { left: essence, relation: condition.relation, right });
        }
    }
    told
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
