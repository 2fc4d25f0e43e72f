//! Verdicts in the user's notation: the conditions on which a theorem rests, and the remaining
//! difference of a false equation.

use super::problem::Problem;
use super::verdict::{Theorem, Witness};
use super::witness::Difference;
use crate::assume::{Assumptions, Cases, Facts, is_open};
use crate::expression::{Condition, Expr, Nature, Node, Pool, Relation};
use crate::normal::{Fraction, Normalised, Sign, Tower, Trigonometry, normalise};
use num_traits::Zero;

/// Limit on the products of terms in a simplification for display; a proof may cost more.
const SIMPLIFICATION_WORK: u64 = 20_000;

/// Depth of signs within signs (√(|x| − 1)) up to which they are distinguished for display.
const DEEPEST_SIGN: usize = 8;

/// Returns the theorem that the problem's equations state.
pub(super) fn theorem(pool: &mut Pool, problem: &Problem) -> Theorem {
    Theorem { conditions: texts(pool, problem) }
}

/// Returns the point at which one of the equations fails.
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

/// Returns the expression through its normal form, or the expression itself if no normal form reads
/// better.
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

/// Returns the expression simplified where conditions hold, if they leave one case of the signs
/// that matter. The conditions are used only if the expression alone is not simplified, since they
/// cost more.
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

/// Returns the normal form with all signs that the expression depends on fixed, if the conditions
/// determine them.
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

/// Whether an expression is continuous on an open set of points: an expression that equals it
/// outside of exceptional points then equals it at these as well.
fn holds_as_a_limit(pool: &mut Pool, conditions: &[Condition], expression: Expr) -> bool {
    let all: Vec<Condition> = conditions.iter().copied().chain(pool.domain(&[expression])).collect();
    is_open(pool, &all, &[expression])
}

/// Whether the fraction contains no half-angle tangents, which the user did not write.
fn is_readable(tower: &Tower, fraction: &Fraction) -> bool {
    tower.trigonometry() == Trigonometry::Circle || !tower.mentions_trigonometry(fraction)
}

/// Whether every radicand factor whose sign was needed is positive by its form or as the whole
/// radicand.
fn signs_are_known(tower: &Tower) -> bool {
    let facts = Facts::of(tower);
    tower
        .bases()
        .filter(|(_, base)| base.sign_needed && base.polynomial.as_constant().is_none())
        .all(|(_, base)| facts.sign_of(&base.polynomial) == Some(Sign::Positive))
}

/// Returns the conditions that are assumed.
pub(super) fn conditions(pool: &mut Pool, problem: &Problem) -> Vec<Condition> {
    told(pool, problem).into_iter().map(|(condition, _)| condition).collect()
}

fn texts(pool: &mut Pool, problem: &Problem) -> Vec<String> {
    told(pool, problem).into_iter().map(|(_, text)| text).collect()
}

/// Returns every stated condition, then the conditions under which the sides are defined, if they
/// say more; each with its text.
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

/// Returns the expression that a condition restricts, without powers around it, and whether the
/// condition excludes zero.
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

/// Whether the form of an expression shows that it is never negative (or, if `strict`, never zero
/// either).
fn holds_by_nature(pool: &Pool, expression: Expr, strict: bool) -> bool {
    pool.nature(expression) >= if strict { Nature::Positive } else { Nature::NotNegative }
}
