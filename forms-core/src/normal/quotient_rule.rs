//! The quotient rule in one step, for fractions whose generators are variables and roots of their polynomials.
//!
//! D(N ∏ Gⱼ^(−eⱼ/nⱼ)) = (DN ∏G − N Σ (eⱼ/nⱼ) DGⱼ ∏_{i≠j} Gᵢ) ∏ Gⱼ^(−eⱼ/nⱼ−1), the product over the factors that
//! depend on the variable. All partial derivatives of one fraction get the same denominator, so that their sum
//! in a divergence is a sum of numerators, and only the sum is looked at for common factors.

use super::factor::FactorPower;
use super::fraction::Fraction;
use super::generator::Generator;
use super::tower::{Obstacle, Tower};
use crate::expression::Symbol;
use crate::polynomial::Polynomial;

/// A factor Fᵉ, as G^(e/n) with a polynomial G in variables only.
struct Plain {
    polynomial: Polynomial,
    derivative: Polynomial,
    power: FactorPower,
    order: u32,
}

impl Tower {
    /// The derivative by the quotient rule, or nothing if a generator needs a chain rule of its own.
    pub(super) fn plain_derivative(
        &mut self,
        a: &Fraction,
        by: Symbol,
    ) -> Result<Option<Fraction>, Obstacle> {
        if !self.is_plain(&a.numerator) {
            return Ok(None);
        }
        let x = self.variable_of(Generator::Variable(by));
        let (mut dependent, mut factors) = (Vec::new(), Vec::new());
        for power in &a.factors {
            let Some(plain) = self.plain_factor(*power, x) else { return Ok(None) };
            let raised = power.exponent + plain.order as i32;
            let exponent = if plain.derivative.is_zero() { power.exponent } else { raised };
            if exponent != 0 {
                factors.push(FactorPower { exponent, ..*power });
            }
            if !plain.derivative.is_zero() {
                dependent.push(plain);
            }
        }
        let own = a.numerator.derivative(x);
        let order = dependent.iter().fold(1, |all, plain| num_integer::lcm(all, i64::from(plain.order)));
        let numerator = match dependent.as_slice() {
            [] => own,
            [plain] => self.one_factor(&a.numerator, &own, plain)?,
            several => self.several_factors(&a.numerator, &own, several, order)?,
        };
        if numerator.is_zero() {
            return Ok(Some(Fraction::zero()));
        }
        Ok(Some(Fraction { numerator, divisor: &a.divisor * order, factors }))
    }

    /// n DN G − e N DG
    fn one_factor(
        &mut self,
        n: &Polynomial,
        own: &Polynomial,
        plain: &Plain,
    ) -> Result<Polynomial, Obstacle> {
        self.charge(own, &plain.polynomial)?;
        self.charge(n, &plain.derivative)?;
        let (order, exponent) = (i64::from(plain.order), i64::from(plain.power.exponent));
        Ok(Polynomial::sum_of_products(&[(order, own, &plain.polynomial), (-exponent, n, &plain.derivative)]))
    }

    fn several_factors(
        &mut self,
        n: &Polynomial,
        own: &Polynomial,
        factors: &[Plain],
        order: i64,
    ) -> Result<Polynomial, Obstacle> {
        let mut all = Polynomial::one();
        let mut logarithmic = Polynomial::zero();
        for plain in factors {
            let share = order / i64::from(plain.order) * i64::from(plain.power.exponent);
            let term = all.mul(&plain.derivative).scale(&share.into());
            self.charge(&logarithmic, &plain.polynomial)?;
            logarithmic = logarithmic.mul(&plain.polynomial).add(&term);
            self.charge(&all, &plain.polynomial)?;
            all = all.mul(&plain.polynomial);
        }
        self.charge(own, &all)?;
        self.charge(n, &logarithmic)?;
        Ok(Polynomial::sum_of_products(&[(order, own, &all), (-1, n, &logarithmic)]))
    }

    fn plain_factor(&self, power: FactorPower, x: u32) -> Option<Plain> {
        let factor = self.factor_polynomial(power.factor);
        let relation = self.factor_variable(power.factor).and_then(|variable| self.relation_of(variable));
        let (polynomial, order) = match relation {
            Some(relation) if matches!(self.generator(relation.variable), Generator::Root { .. }) => {
                (&relation.value, relation.order)
            }
            _ => (factor, 1),
        };
        self.is_plain(polynomial).then(|| Plain {
            polynomial: polynomial.clone(),
            derivative: polynomial.derivative(x),
            power,
            order,
        })
    }

    fn is_plain(&self, polynomial: &Polynomial) -> bool {
        let plain = |v: u32| matches!(self.generator(v), Generator::Variable(_) | Generator::Pi);
        polynomial.variables().into_iter().all(plain)
    }
}
