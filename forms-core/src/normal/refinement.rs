//! Known factors that turn out to be products of others.
//!
//! A factor G keeps the name it was met under. Where a sum brings it together with a factor F that divides it, both
//! over the field of the tower, G = c ∏ Fᵉ H is remembered, and the sum is taken over F and H instead: N² + D² of a
//! solid angle is the product of the denominators of its edges.

use super::factor::{FactorPower, merge_powers};
use super::fraction::Fraction;
use super::generator::FactorId;
use super::tower::{Obstacle, Tower};
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_traits::{Signed, pow};

/// G = c ∏ Fᵉ
#[derive(Clone, Debug)]
pub(super) struct Product {
    constant: BigInt,
    powers: Vec<FactorPower>,
}

impl Tower {
    /// Two fractions whose factors that only one of them has are tried against each other; nothing if none divides
    /// another.
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
        a.factors.iter().all(|power| !self.products.contains_key(&power.factor))
    }

    /// Divides the longer of two factors by the other, once.
    fn try_division(&mut self, left: FactorId, right: FactorId) -> Result<(), Obstacle> {
        let terms = |factor: FactorId| self.factor_polynomial(factor).term_count();
        let (short, long) = if terms(left) <= terms(right) { (left, right) } else { (right, left) };
        if terms(short) < 2 || self.products.contains_key(&long) || self.products.contains_key(&short) {
            return Ok(());
        }
        if !self.divisions_tried.insert((short, long)) || !self.is_current(short) || !self.is_current(long) {
            return Ok(());
        }
        let divisor = self.factor_polynomial(short).clone();
        let mut rest = self.factor_polynomial(long).clone();
        let exponent = self.divide_out_factor(&mut rest, &divisor)?;
        if exponent > 0 {
            let mut powers = vec![FactorPower { factor: short, exponent }];
            let constant = self.constant_and_factor(rest, &mut powers);
            self.products.insert(long, Product { constant, powers });
        }
        Ok(())
    }

    /// The number in front of a polynomial, the rest of which joins the powers.
    fn constant_and_factor(&mut self, rest: Polynomial, powers: &mut Vec<FactorPower>) -> BigInt {
        if let Some(constant) = rest.as_constant() {
            return constant;
        }
        let content = if rest.leading_coefficient().is_negative() { -rest.content() } else { rest.content() };
        let cofactor = FactorPower { factor: self.factor(rest.primitive_part()), exponent: 1 };
        *powers = merge_powers(powers, &[cofactor]);
        content
    }

    /// The same element with every factor that is known to be a product written as one.
    fn refined(&self, a: &Fraction) -> Fraction {
        let mut refined = a.clone();
        while let Some(place) = refined.factors.iter().position(|p| self.products.contains_key(&p.factor)) {
            let power = refined.factors.remove(place);
            let product = &self.products[&power.factor];
            let raised: Vec<FactorPower> = product
                .powers
                .iter()
                .map(|part| FactorPower { exponent: part.exponent * power.exponent, ..*part })
                .collect();
            refined.factors = merge_powers(&refined.factors, &raised);
            let times = power.exponent.unsigned_abs() as usize;
            let number = pow(product.constant.clone(), times);
            if power.exponent < 0 {
                refined.numerator = refined.numerator.scale(&number);
            } else {
                if number.is_negative() {
                    refined.numerator = refined.numerator.neg();
                }
                refined.divisor *= number.abs();
            }
        }
        refined
    }
}
