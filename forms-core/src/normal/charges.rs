//! Charges for arithmetic: products of terms are counted, and exponents checked, before the work is
//! done.

use super::obstacle::{Obstacle, SizeLimit};
use super::power::FactorPower;
use super::tower::Tower;
use super::work::check_exponent;
use crate::polynomial::Polynomial;
use crate::steps;

/// Cost of the division of one term by a factor, in products of terms: it takes the term's image
/// modulo p.
const DIVISION_COST: u64 = 16;

/// Number of terms of a numerator up to which divisions are not counted.
const SMALL_NUMERATOR: u64 = 256;

/// Largest power of a sum that is multiplied out: beyond it, its terms and their numbers exceed the
/// work limit.
const LARGEST_POWER_OF_SUM: u64 = 1 << 14;

impl Tower {
    /// Refuses a·fⁿ if multiplying it out is hopeless: each of its terms takes at least one
    /// product.
    pub(super) fn check_power(&self, a: &Polynomial, f: &Polynomial, n: u64) -> Result<(), Obstacle> {
        if f.term_count() > 1 && n > LARGEST_POWER_OF_SUM {
            return Err(Obstacle::TooLarge(SizeLimit::PowerOfSum(LARGEST_POWER_OF_SUM)));
        }
        if a.most_terms_with_power(f, n) <= self.work.limit {
            return Ok(());
        }
        // With a bound generator, reduction of the power can remove terms.
        let is_free =
            |f: &Polynomial| f.variables().into_iter().all(|variable| self.relation_of(variable).is_none());
        if is_free(a) && is_free(f) && a.least_terms_with_power(f, n) > self.work.limit {
            return Err(self.work.spent());
        }
        Ok(())
    }

    /// Counts the work of a product, and checks its exponents, before it is done.
    pub(super) fn charge(&mut self, a: &Polynomial, b: &Polynomial) -> Result<(), Obstacle> {
        check_exponent(a.exponent_bound().saturating_add(b.exponent_bound()))?;
        let terms = (a.term_count() as u64).saturating_mul(b.term_count() as u64);
        let words = a.coefficient_words().saturating_mul(b.coefficient_words());
        self.work.count(terms.saturating_mul(words))?;
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
        self.work.count(work)?;
        if steps::spend(work) { Ok(()) } else { Err(steps_are_spent()) }
    }
}

fn steps_are_spent() -> Obstacle {
    Obstacle::TooLarge(SizeLimit::Steps)
}
