//! Several fractions over one denominator, so that a reader sees numerators cancel.

use super::fraction::Fraction;
use super::obstacle::Obstacle;
use super::power::common_powers;
use super::tower::Tower;
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::One;

/// Fractions Nᵢ/D.
#[derive(Clone, Debug)]
pub struct Together {
    /// N₁, N₂, …
    pub numerators: Vec<Fraction>,
    /// 1/D
    pub inverse: Fraction,
}

impl Tower {
    /// Writes fractions over their least common denominator. A factor of the numerator stays
    /// factored if all fractions have it.
    ///
    /// # Errors
    /// [`Obstacle::TooLarge`] if the work exceeds the tower's limit.
    pub fn together(&mut self, fractions: &[Fraction]) -> Result<Together, Obstacle> {
        let mut divisor = BigInt::one();
        let mut factors = fractions.iter().find(|f| !f.is_zero()).map_or(vec![], |f| f.factors.clone());
        for fraction in fractions.iter().filter(|fraction| !fraction.is_zero()) {
            divisor = divisor.lcm(&fraction.divisor);
            factors = common_powers(&factors, &fraction.factors).all;
        }
        let mut numerators = Vec::with_capacity(fractions.len());
        for fraction in fractions {
            let lacking = common_powers(&factors, &fraction.factors).lacking_right;
            let by = &divisor / &fraction.divisor;
            numerators.push(Fraction::from(self.raised(&fraction.numerator, &by, &lacking)?));
        }
        let inverse = Fraction { numerator: Polynomial::one(), divisor, factors };
        Ok(Together { numerators, inverse })
    }

    /// Σ a over one denominator, checked for common factors once.
    ///
    /// # Errors
    /// [`Obstacle::TooLarge`] if the work exceeds the tower's limit.
    pub(super) fn sum(&mut self, fractions: &[Fraction]) -> Result<Fraction, Obstacle> {
        let together = self.together(fractions)?;
        let mut sum = Polynomial::zero();
        for numerator in &together.numerators {
            sum = sum.add(&numerator.numerator);
        }
        Ok(self.cancel(sum, together.inverse.divisor, together.inverse.factors))
    }
}
