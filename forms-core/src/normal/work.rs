//! Work limits of normal forms: products of terms, and exponents, are checked before the work is
//! done.

use super::factor::FactorPower;
use super::tower::{Obstacle, Tower};
use crate::polynomial::Polynomial;
use crate::steps;

/// Largest number of products of terms, weighted by the words of their coefficients, that one
/// statement can cost before its normal form is given up: a few seconds of work.
pub(crate) const WORK_LIMIT: u64 = 100_000_000;

/// Cost of the division of one term by a factor, in products of terms: it takes the term's image
/// modulo p.
const DIVISION_COST: u64 = 16;

/// Number of terms of a numerator up to which divisions are not counted.
const SMALL_NUMERATOR: u64 = 256;

/// Largest exponent of a generator or a known factor.
const LARGEST_EXPONENT: u32 = 1 << 20;

/// Largest power of a sum that is multiplied out: beyond it, its terms and their numbers exceed the
/// work limit.
const LARGEST_POWER_OF_SUM: u64 = 1 << 14;

impl Tower {
    /// Refuses exponents beyond the limit.
    pub(super) fn check_exponent(exponent: u32) -> Result<(), Obstacle> {
        if exponent > LARGEST_EXPONENT {
            return Err(Obstacle::TooLarge(format!("an exponent is beyond {LARGEST_EXPONENT}")));
        }
        Ok(())
    }

    /// Refuses a·fⁿ if multiplying it out is hopeless: each of its terms takes at least one
    /// product.
    pub(super) fn check_power(&self, a: &Polynomial, f: &Polynomial, n: u64) -> Result<(), Obstacle> {
        if f.term_count() > 1 && n > LARGEST_POWER_OF_SUM {
            return Err(Obstacle::TooLarge(format!("a power of a sum is beyond {LARGEST_POWER_OF_SUM}")));
        }
        if a.most_terms_with_power(f, n) <= self.work_limit {
            return Ok(());
        }
        // With a bound generator, reduction of the power can remove terms.
        let is_free =
            |f: &Polynomial| f.variables().into_iter().all(|variable| self.relation_of(variable).is_none());
        if is_free(a) && is_free(f) && a.least_terms_with_power(f, n) > self.work_limit {
            return Err(self.work_is_spent());
        }
        Ok(())
    }

    /// Counts the work of a product, and checks its exponents, before it is done.
    pub(super) fn charge(&mut self, a: &Polynomial, b: &Polynomial) -> Result<(), Obstacle> {
        Self::check_exponent(a.exponent_bound().saturating_add(b.exponent_bound()))?;
        let terms = (a.term_count() as u64).saturating_mul(b.term_count() as u64);
        let words = a.coefficient_words().saturating_mul(b.coefficient_words());
        self.count(terms.saturating_mul(words))?;
        // the product itself spends these steps
        if steps::are_left(a.steps_of_product(b)) { Ok(()) } else { Err(steps_are_spent()) }
    }

    /// Counts the work of trial division by the factors of the denominator, before it is done.
    pub(super) fn charge_divisions(
        &mut self,
        numerator: &Polynomial,
        factors: &[FactorPower],
    ) -> Result<(), Obstacle> {
        let tried = factors.iter().filter(|power| power.exponent > 0).count();
        let terms = (numerator.term_count() as u64).saturating_sub(SMALL_NUMERATOR);
        let work = terms.saturating_mul(tried as u64).saturating_mul(DIVISION_COST);
        self.count(work)?;
        if steps::spend(work) { Ok(()) } else { Err(steps_are_spent()) }
    }

    fn count(&mut self, work: u64) -> Result<(), Obstacle> {
        self.work = self.work.saturating_add(work);
        if self.work > self.work_limit { Err(self.work_is_spent()) } else { Ok(()) }
    }

    fn work_is_spent(&self) -> Obstacle {
        Obstacle::TooLarge(format!("it takes more than {} products of terms", self.work_limit))
    }
}

fn steps_are_spent() -> Obstacle {
    Obstacle::TooLarge("it takes more steps than one statement is granted".into())
}
