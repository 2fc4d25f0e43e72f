//! Conditions that nothing meets: a statement under them speaks of no point and is an error.

use super::problem::Problem;
use super::proof::{Outcome, prove_zero};
use crate::assume::Facts;
use crate::expression::Pool;
use crate::normal::{Sign, Tower, Trigonometry, WORK_LIMIT, normalise};
use crate::syntax::ast::Relation;

/// Why no point meets the assumptions, if that can be shown: by a condition that fails by its nature, by bounds
/// that leave no value, or since in every case of the open signs some condition fails.
pub(super) fn contradiction(pool: &mut Pool, problem: &Problem) -> Option<String> {
    let mut tower = Tower::new(Trigonometry::HalfAngle);
    let mut known = Vec::new();
    for condition in &problem.assumptions {
        let side = pool.subtract(condition.left, condition.right);
        let Ok(prepared) = normalise(&mut tower, pool, &[side]) else { continue };
        if prepared.is_unconditional()
            && let Ok(mut difference) = prepared.exact(&mut tower, pool)
            && let Ok(difference) = tower.expanded(&difference.remove(0))
        {
            known.push((condition, difference));
        }
    }
    let mut facts = Facts::of(&tower);
    for (condition, difference) in &known {
        facts.learn(&tower, difference, condition.relation);
    }
    facts.learn_functions(&tower);
    let by_nature = Facts::of(&tower);
    for (condition, difference) in &known {
        let Ok(polynomial) = tower.with_the_sign_of(difference) else { continue };
        let sign = by_nature.sign_of(&polynomial);
        let impossible = match condition.relation {
            Relation::NotEqual => difference.is_zero(),
            Relation::Greater => difference.is_zero() || sign == Some(Sign::Negative),
            Relation::Less => difference.is_zero() || sign == Some(Sign::Positive),
            Relation::GreaterEqual => sign == Some(Sign::Negative) && by_nature.never_zero(&polynomial),
            Relation::LessEqual => sign == Some(Sign::Positive) && by_nature.never_zero(&polynomial),
        };
        if impossible {
            return Some(format!("nothing meets `{}`", condition.text(pool)));
        }
    }
    if facts.contradiction() {
        return Some("its conditions contradict each other".to_string());
    }
    let one = pool.integer(1);
    match prove_zero(pool, problem, vec![one], WORK_LIMIT) {
        Outcome::Empty(reason) => Some(reason),
        _ => None,
    }
}
