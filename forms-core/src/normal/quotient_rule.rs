//! Quotient rule in one step, for fractions whose generators are variables and roots of polynomials
//! in them.
//!
//! With a = N ∏ Gⱼ^(−eⱼ/nⱼ), the product over the factors that depend on a variable xᵢ,
//! ```text
//! Σᵢ ±∂ᵢaᵢ = (∏G Σᵢ ±∂ᵢNᵢ − Σᵢ ±Nᵢ Lᵢ) ∏ Gⱼ^(−eⱼ/nⱼ−1),    Lᵢ = Σⱼ (eⱼ/nⱼ) ∂ᵢGⱼ ∏_{k≠j} G_k
//! ```
//! for fractions over one denominator, as the coefficients of a form mostly are. Their partial
//! derivatives are summed before they are multiplied by ∏G, and only the sum is checked for common
//! factors.

use super::fraction::Fraction;
use super::frame::derivative_along;
use super::generator::Generator;
use super::obstacle::Obstacle;
use super::power::FactorPower;
use super::tower::Tower;
use crate::expression::Symbol;
use crate::polynomial::Polynomial;

/// Factor Fᵉ, as G^(e/n) with a polynomial G in variables only.
struct Plain {
    polynomial: Polynomial,
    exponent: i32,
    order: u32,
}

/// Variables that a partial derivative acts on, with their rates.
type Motion = Vec<(u32, i64)>;

impl Tower {
    /// Σ ±∂a/∂x by the quotient rule, not checked for common factors. `None` if denominators differ
    /// or a generator needs a chain rule of its own.
    pub(super) fn plain_divergence(
        &mut self,
        terms: &[(i8, &Fraction, Symbol)],
    ) -> Result<Option<Fraction>, Obstacle> {
        let Some(&(_, first, _)) = terms.first() else { return Ok(None) };
        for (_, a, _) in terms {
            if a.factors != first.factors || a.divisor != first.divisor || !self.is_plain(&a.numerator) {
                return Ok(None);
            }
        }
        let motions: Vec<Motion> = terms.iter().map(|term| self.motion(term.2)).collect();
        let Some((dependent, factors)) = self.raised_factors(&first.factors, &motions) else {
            return Ok(None);
        };
        let mut numerators = Vec::with_capacity(terms.len());
        let mut own = Polynomial::zero();
        for (&(sign, a, _), x) in terms.iter().zip(&motions) {
            let partial = derivative_along(&a.numerator, x);
            own = if sign < 0 { own.sub(&partial) } else { own.add(&partial) };
            numerators.push((i64::from(sign), &a.numerator, x));
        }
        let order = dependent.iter().fold(1, |all, plain| num_integer::lcm(all, i64::from(plain.order)));
        let numerator = if dependent.is_empty() {
            own
        } else {
            self.over_one_denominator(&own, &numerators, &dependent, order)?
        };
        if numerator.is_zero() {
            return Ok(Some(Fraction::zero()));
        }
        Ok(Some(Fraction { numerator, divisor: &first.divisor * order, factors }))
    }

    /// Returns the factors that depend on one of the variables, and all factors with the exponents
    /// of a derivative.
    fn raised_factors(
        &self,
        powers: &[FactorPower],
        motions: &[Motion],
    ) -> Option<(Vec<Plain>, Vec<FactorPower>)> {
        let (mut dependent, mut factors) = (Vec::new(), Vec::new());
        for power in powers {
            let plain = self.plain_factor(*power)?;
            let depends = motions.iter().flatten().any(|&(x, _)| plain.polynomial.contains(x));
            let exponent = power.exponent + if depends { plain.order as i32 } else { 0 };
            if exponent != 0 {
                factors.push(FactorPower { exponent, ..*power });
            }
            if depends {
                dependent.push(plain);
            }
        }
        Some((dependent, factors))
    }

    /// n ∏G Σ ±∂ᵢNᵢ − Σ ±Nᵢ n Lᵢ with n the common order.
    fn over_one_denominator(
        &mut self,
        own: &Polynomial,
        numerators: &[(i64, &Polynomial, &Motion)],
        factors: &[Plain],
        order: i64,
    ) -> Result<Polynomial, Obstacle> {
        let mut all = factors[0].polynomial.clone();
        for plain in &factors[1..] {
            self.charge(&all, &plain.polynomial)?;
            all = all.mul(&plain.polynomial);
        }
        let mut logarithmic = Vec::with_capacity(numerators.len());
        for (_, numerator, x) in numerators {
            let sum = self.logarithmic_derivative(factors, order, x)?;
            self.charge(numerator, &sum)?;
            logarithmic.push(sum);
        }
        self.charge(own, &all)?;
        let mut products = vec![(order, own, &all)];
        for ((sign, numerator, _), sum) in numerators.iter().zip(&logarithmic) {
            products.push((-sign, numerator, sum));
        }
        Ok(Polynomial::sum_of_products(&products))
    }

    /// n L = Σⱼ (n eⱼ/nⱼ) ∂Gⱼ ∏_{k≠j} G_k
    fn logarithmic_derivative(
        &mut self,
        factors: &[Plain],
        order: i64,
        x: &Motion,
    ) -> Result<Polynomial, Obstacle> {
        let mut sum = Polynomial::zero();
        let mut before = Polynomial::one();
        for (place, plain) in factors.iter().enumerate() {
            let share = order / i64::from(plain.order) * i64::from(plain.exponent);
            let inner = derivative_along(&plain.polynomial, x).scale(&share.into());
            if place == 0 {
                sum = inner;
            } else {
                self.charge(&sum, &plain.polynomial)?;
                self.charge(&before, &inner)?;
                sum = Polynomial::sum_of_products(&[(1, &sum, &plain.polynomial), (1, &before, &inner)]);
            }
            if place + 1 < factors.len() {
                self.charge(&before, &plain.polynomial)?;
                before = before.mul(&plain.polynomial);
            }
        }
        Ok(sum)
    }

    fn plain_factor(&self, power: FactorPower) -> Option<Plain> {
        let factor = self.factor_polynomial(power.factor);
        let relation = self.factor_variable(power.factor).and_then(|variable| self.relation_of(variable));
        let (polynomial, order) = match relation {
            Some(relation) if matches!(self.generator(relation.variable), Generator::Root { .. }) => {
                (&relation.value, relation.order)
            }
            _ => (factor, 1),
        };
        let plain = Plain { polynomial: polynomial.clone(), exponent: power.exponent, order };
        self.is_plain(polynomial).then_some(plain)
    }

    fn is_plain(&self, polynomial: &Polynomial) -> bool {
        let plain = |v: u32| matches!(self.generator(v), Generator::Variable(_) | Generator::Pi);
        polynomial.variables().into_iter().all(plain)
    }
}
