//! Conditions on the strata that normal forms leave out: whether an angle is ever at a half turn,
//! and whether a divisor is ever zero.
//!
//! The answer comes from a tower for the stratum itself, or from conditions whose normal forms hold
//! everywhere; a normal form that leaves the stratum out would be circular.

use super::region::Constraint;
use super::{Assumptions, Knowledge, MOST_PASSES};
use crate::expression::{Expr, Pool};
use crate::normal::{Fraction, Obstacle, Tower, normalise};
use crate::polynomial::Polynomial;

impl Assumptions {
    /// Whether an angle in a tower avoids every odd multiple of π where the conditions hold.
    pub(crate) fn avoids_half_turns(
        &self,
        tower: &mut Tower,
        pool: &Pool,
        angle: &Fraction,
    ) -> Result<bool, Obstacle> {
        for _ in 0..MOST_PASSES {
            let Some((_, knowledge)) = self.learned(tower, pool, &[], &[])? else { continue };
            return Ok(knowledge.facts.range(tower, angle)?.avoids_half_turns());
        }
        Ok(false)
    }

    /// Whether a polynomial of a tower vanishes at no point that meets the conditions. Only
    /// conditions whose normal forms in a clone of the tower hold everywhere are used: the zeros
    /// may lie where the other normal forms do not hold.
    pub(crate) fn keep_from_zero(
        &self,
        tower: &Tower,
        pool: &Pool,
        polynomial: &Polynomial,
    ) -> Result<bool, Obstacle> {
        let is_read_everywhere = |side: &Expr| {
            let mut alone = tower.apart();
            let normal = normalise(&mut alone, pool, &[*side]).and_then(|n| n.exact(&mut alone, pool));
            normal.is_ok() && alone.holds_everywhere()
        };
        let kept = self.conditions.iter().zip(&self.sides).filter(|(_, side)| is_read_everywhere(side));
        let (conditions, sides) = kept.map(|(condition, side)| (*condition, *side)).unzip();
        let read = Assumptions { conditions, sides, thorough: self.thorough };
        let mut apart = tower.apart();
        for _ in 0..MOST_PASSES {
            let Some((_, knowledge)) = read.learned(&mut apart, pool, &[], &[])? else { continue };
            return Ok(knowledge.excludes_zeros(&apart, polynomial));
        }
        Ok(false)
    }
}

impl Knowledge {
    /// Whether no factor of a polynomial can be zero: because it occurs in a strict constraint, or
    /// because a zero contradicts the known facts.
    fn excludes_zeros(&self, tower: &Tower, polynomial: &Polynomial) -> bool {
        let (_, factors) = polynomial.square_free();
        factors.iter().all(|(factor, _)| {
            let occurs = |base: usize| {
                let known = &tower.base(base).polynomial;
                known == factor || *known == factor.neg()
            };
            let strict = |constraint: &Constraint| constraint.strict && constraint.bases().any(occurs);
            self.constraints.iter().any(strict)
                || self.facts.never_zero(factor)
                || self.facts.excludes_zero(tower, factor)
        })
    }
}
