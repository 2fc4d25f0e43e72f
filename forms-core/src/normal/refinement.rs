//! Known factors that turn out to be products of others.
//!
//! A factor G keeps the number under which it was met. If a sum combines it with a factor F that
//! divides it, both over the field of the tower, G = ±∏ Fᵉ H is recorded, and the sum is taken over
//! F and H instead: N² + D² of a solid angle is the product of the denominators of its edges.
//! Factors are primitive, so the coefficient of the product is ±1; with roots it can be −1, since
//! reduction changes leading terms.

use super::fraction::Fraction;
use super::known_factors::Product;
use super::obstacle::Obstacle;
use super::power::{FactorId, FactorPower, merge_powers};
use super::tower::Tower;
use num_traits::Signed;

impl Tower {
    /// Tries the factors that only one of two fractions has against each other. `None` if no factor
    /// divides another.
    pub(super) fn over_finer_factors(
        &mut self,
        a: &Fraction,
        b: &Fraction,
    ) -> Result<Option<(Fraction, Fraction)>, Obstacle> {
        let only = |of: &Fraction, other: &Fraction| -> Vec<FactorId> {
            let foreign = |factor: FactorId| other.factors.iter().all(|power| power.factor != factor);
            of.factors.iter().map(|power| power.factor).filter(|&factor| foreign(factor)).collect()
        };
        for &left in &only(a, b) {
            for &right in &only(b, a) {
                self.try_division(left, right)?;
            }
        }
        if self.is_finest(a) && self.is_finest(b) {
            return Ok(None);
        }
        Ok(Some((self.refined(a), self.refined(b))))
    }

    fn is_finest(&self, a: &Fraction) -> bool {
        a.factors.iter().all(|power| !self.factors.products.contains_key(&power.factor))
    }

    /// Divides the longer of two factors by the other one, once per pair.
    fn try_division(&mut self, left: FactorId, right: FactorId) -> Result<(), Obstacle> {
        let terms = |factor: FactorId| self.factor_polynomial(factor).term_count();
        let (short, long) = if terms(left) <= terms(right) { (left, right) } else { (right, left) };
        if terms(short) < 2
            || self.factors.products.contains_key(&long)
            || self.factors.products.contains_key(&short)
        {
            return Ok(());
        }
        if !self.factors.divisions_tried.insert((short, long))
            || !self.is_current(short)
            || !self.is_current(long)
        {
            return Ok(());
        }
        let divisor = self.factor_polynomial(short).clone();
        let mut rest = self.factor_polynomial(long).clone();
        let exponent = self.divide_out_factor(&mut rest, &divisor)?;
        if exponent > 0 {
            let negative = rest.leading_coefficient().is_negative();
            let cofactor = if negative { rest.neg() } else { rest };
            let mut powers = vec![FactorPower { factor: short, exponent }];
            if cofactor.as_constant().is_none() {
                powers = merge_powers(&powers, &[FactorPower { factor: self.factor(cofactor), exponent: 1 }]);
            }
            self.factors.products.insert(long, Product { negative, powers });
        }
        Ok(())
    }

    /// Returns the same element with every factor that is known to be a product replaced by that
    /// product.
    fn refined(&self, a: &Fraction) -> Fraction {
        let mut refined = a.clone();
        while let Some(place) =
            refined.factors.iter().position(|p| self.factors.products.contains_key(&p.factor))
        {
            let power = refined.factors.remove(place);
            let product = &self.factors.products[&power.factor];
            let raised: Vec<FactorPower> = product
                .powers
                .iter()
                .map(|part| FactorPower { exponent: part.exponent * power.exponent, ..*part })
                .collect();
            refined.factors = merge_powers(&refined.factors, &raised);
            if product.negative && power.exponent % 2 != 0 {
                refined.numerator = refined.numerator.neg();
            }
        }
        refined
    }
}
