//! Contradictions: conditions that no point meets, shown by the form of the compared sides or by
//! combining conditions.

use super::{Assumptions, Facts};
use crate::expression::{Condition, Pool, Relation};
use crate::normal::{Fraction, Sign, Tower, Trigonometry, normalise};

/// Reason why no point meets some conditions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Contradiction {
    /// No point meets this condition.
    Alone(Condition),
    /// Bounds leave no value for some generator, or inequalities leave no point.
    Together,
}

impl Assumptions {
    /// Returns a contradiction that is found without a case split, also at the half turns of
    /// angles.
    pub(crate) fn contradiction(&self, pool: &Pool) -> Option<Contradiction> {
        let mut tower = Tower::new(Trigonometry::HalfAngle);
        let found = self.contradiction_in(pool, &mut tower)?;
        let mut same = true;
        for units in tower.choices_of_half_turns()? {
            let mut stratum = tower.at_half_turns(&units);
            same &= self.contradiction_in(pool, &mut stratum)? == found;
            if !stratum.excluded().is_empty()
                || stratum.poles().iter().any(|unit| !tower.poles().contains(unit))
            {
                return None;
            }
        }
        let is_whole = tower.excluded().is_empty() && !tower.has_coarser_poles();
        is_whole.then_some(if same { found } else { Contradiction::Together })
    }

    /// Returns a contradiction that holds where the normal forms of a tower hold.
    fn contradiction_in(&self, pool: &Pool, tower: &mut Tower) -> Option<Contradiction> {
        let known = self.unconditional(pool, tower);
        let mut facts = Facts::of(tower);
        for (condition, difference) in &known {
            facts.learn(tower, difference, condition.relation);
        }
        facts.learn_functions(tower);
        let by_nature = Facts::of(tower);
        for (condition, difference) in &known {
            if is_impossible(tower, &by_nature, difference, condition.relation) {
                return Some(Contradiction::Alone(*condition));
            }
        }
        facts.contradiction().then_some(Contradiction::Together)
    }

    /// Returns the conditions for which the difference of the sides has a normal form without open
    /// signs.
    fn unconditional(&self, pool: &Pool, tower: &mut Tower) -> Vec<(Condition, Fraction)> {
        let mut known = Vec::new();
        for (&condition, &side) in self.conditions.iter().zip(&self.sides) {
            let Ok(prepared) = normalise(tower, pool, &[side]) else { continue };
            if prepared.is_unconditional()
                && let Ok(mut difference) = prepared.exact(tower, pool)
                && let Ok(difference) = tower.expanded(&difference.remove(0))
            {
                known.push((condition, difference));
            }
        }
        known
    }
}

/// Whether `difference relation 0` fails wherever the difference is defined.
fn is_impossible(tower: &mut Tower, by_nature: &Facts, difference: &Fraction, relation: Relation) -> bool {
    let Ok(polynomial) = tower.with_the_sign_of(difference) else { return false };
    let sign = by_nature.sign_of(&polynomial);
    match relation {
        Relation::NotEqual => difference.is_zero(),
        Relation::Greater => difference.is_zero() || sign == Some(Sign::Negative),
        Relation::Less => difference.is_zero() || sign == Some(Sign::Positive),
        Relation::GreaterEqual => sign == Some(Sign::Negative) && by_nature.never_zero(&polynomial),
        Relation::LessEqual => sign == Some(Sign::Positive) && by_nature.never_zero(&polynomial),
    }
}
