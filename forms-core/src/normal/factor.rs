//! Known factors: polynomials that have occurred in denominators, and exact division by them.

use super::fraction::Fraction;
use super::generator::Generator;
use super::obstacle::Obstacle;
use super::power::{FactorId, FactorPower, merge_powers};
use super::tower::Tower;
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed};

/// Largest number of terms of a conjugate that is used for division.
const LARGEST_CONJUGATE: usize = 60;

impl Tower {
    /// Splits a polynomial into content · ∏ factors: generators that divide it, radicands, known
    /// factors, the remainder.
    pub(super) fn split(&mut self, polynomial: &Polynomial) -> Result<(BigInt, Vec<FactorPower>), Obstacle> {
        let mut content = polynomial.content();
        if polynomial.leading_coefficient().is_negative() {
            content = -content;
        }
        let monomial = polynomial.monomial_content();
        let primitive = polynomial.primitive_part();
        let mut rest = primitive.divide_by_monomial(&monomial).unwrap_or(primitive);
        let mut powers = Vec::new();
        for (variable, exponent) in monomial {
            powers.push(FactorPower {
                factor: self.factor(Polynomial::variable(variable)),
                exponent: exponent as i32,
            });
        }
        self.split_radicands(&mut rest, &mut powers);
        self.split_known(&mut rest, &mut powers)?;
        let common = rest.content();
        if !common.is_one() {
            rest = rest.divide_exact(&Polynomial::constant(common.clone())).unwrap_or(rest);
            content *= common;
        }
        if rest.leading_coefficient().is_negative() {
            (content, rest) = (-content, rest.neg());
        }
        if rest.as_constant().is_none() {
            powers.push(FactorPower { factor: self.factor(rest), exponent: 1 });
        }
        Ok((content, powers.into_iter().fold(Vec::new(), |all, power| merge_powers(&all, &[power]))))
    }

    /// Divides out roots ρ, and radicands as their powers ρⁿ. A product of a root and a sum is then
    /// recognised by the sum, wherever the sum occurs without the root.
    fn split_radicands(&mut self, rest: &mut Polynomial, powers: &mut Vec<FactorPower>) {
        for number in 0..self.generators.relations().len() {
            let relation = self.generators.relations()[number].clone();
            if relation.value.term_count() < 2 || !self.is_current_root(relation.variable) {
                continue;
            }
            let exponent = divide_out(rest, |rest| self.divide_by_generator(rest, relation.variable));
            if exponent > 0 {
                let factor = self.factor(Polynomial::variable(relation.variable));
                powers.push(FactorPower { factor, exponent });
            }
        }
    }

    /// Divides out known factors; factors with roots are divided out by their conjugates.
    fn split_known(&mut self, rest: &mut Polynomial, powers: &mut Vec<FactorPower>) -> Result<(), Obstacle> {
        for number in 0..self.factors.len() {
            let factor = FactorId(number as u32);
            let known = self.factor_polynomial(factor).clone();
            if known.term_count() < 2
                || known.term_count() > rest.term_count()
                || self.factors.products.contains_key(&factor)
                || !self.is_current(factor)
            {
                continue;
            }
            let exponent = self.divide_out_factor(rest, &known)?;
            if exponent > 0 {
                powers.push(FactorPower { factor, exponent });
            }
        }
        Ok(())
    }

    /// Whether a factor contains no root of another sign case.
    pub(super) fn is_current(&self, factor: FactorId) -> bool {
        let foreign =
            |v: &u32| matches!(self.generator(*v), Generator::Root { .. }) && !self.is_current_root(*v);
        !self.factor_polynomial(factor).variables().iter().any(foreign)
    }

    /// Divides by a factor as often as possible, by its conjugate if it has roots.
    pub(super) fn divide_out_factor(
        &mut self,
        rest: &mut Polynomial,
        factor: &Polynomial,
    ) -> Result<i32, Obstacle> {
        match self.conjugate(factor)? {
            None => Ok(divide_out(rest, |rest| rest.divide_exact(factor))),
            Some((conjugate, norm)) => self.divide_out_by_norm(rest, &conjugate, &norm),
        }
    }

    /// Divides by F as often as possible, as N/F = N G/n. A unit, which has n = ±1 such as 1 + √2,
    /// divides everything infinitely often and is not divided out.
    fn divide_out_by_norm(
        &mut self,
        rest: &mut Polynomial,
        conjugate: &Polynomial,
        norm: &Polynomial,
    ) -> Result<i32, Obstacle> {
        let mut exponent = 0;
        if norm.as_constant().is_some_and(|number| number.abs().is_one()) {
            return Ok(exponent);
        }
        while rest.as_constant().is_none() {
            self.charge(rest, conjugate)?;
            let Some(quotient) = self.reduce(rest.mul(conjugate))?.divide_exact(norm) else { break };
            *rest = quotient;
            exponent += 1;
        }
        Ok(exponent)
    }

    /// For a factor F that contains square roots, returns G with F G = n free of roots, so that
    /// N/F = N G/n. The roots are removed one after the other: (A + Bρ)(A − Bρ) = A² − B² f.
    pub(super) fn conjugate(
        &mut self,
        factor: &Polynomial,
    ) -> Result<Option<(Polynomial, Polynomial)>, Obstacle> {
        let (mut conjugate, mut norm) = (Polynomial::one(), factor.clone());
        let mut found = false;
        while let Some(relation) =
            self.generators.relations().iter().rev().find(|r| norm.contains(r.variable)).cloned()
        {
            if relation.order != 2 || self.is_trigonometric(relation.variable) {
                return Ok(None);
            }
            let root = Polynomial::variable(relation.variable);
            let mirrored = norm.substitute(relation.variable, &root.neg());
            conjugate = self.reduce(conjugate.mul(&mirrored))?;
            norm = self.reduce(norm.mul(&mirrored))?;
            found = true;
            if conjugate.term_count() > LARGEST_CONJUGATE || norm.is_zero() {
                return Ok(None);
            }
        }
        Ok(found.then_some((conjugate, norm)))
    }

    /// N / (d ∏ Fᵉ) with every factor cancelled that divides N, and free generators of the
    /// numerator multiplied in.
    pub(super) fn cancel(
        &self,
        mut numerator: Polynomial,
        mut divisor: BigInt,
        mut powers: Vec<FactorPower>,
    ) -> Fraction {
        if numerator.is_zero() {
            return Fraction::zero();
        }
        for power in &mut powers {
            if power.exponent < 0
                && let Some(variable) = self.factor_variable(power.factor)
                && self.relation_of(variable).is_none()
            {
                numerator = numerator.multiply_by_monomial(&[(variable, power.exponent.unsigned_abs())]);
                power.exponent = 0;
            }
            if let Some(variable) = self.factor_variable(power.factor) {
                let shared = numerator.least_exponent(variable).min(power.exponent.max(0).unsigned_abs());
                if shared > 0 {
                    numerator = numerator.divide_by_monomial(&[(variable, shared)]).unwrap_or(numerator);
                    power.exponent -= shared as i32;
                }
            }
            while power.exponent > 0 {
                match self.divide_by_factor(&numerator, power.factor) {
                    Some(quotient) => numerator = quotient,
                    None => break,
                }
                power.exponent -= 1;
            }
        }
        powers.retain(|power| power.exponent != 0);
        if !divisor.is_one() {
            let common = numerator.content().gcd(&divisor);
            if !common.is_one() {
                numerator =
                    numerator.divide_exact(&Polynomial::constant(common.clone())).unwrap_or(numerator);
                divisor /= common;
            }
        }
        Fraction { numerator, divisor, factors: powers }
    }

    fn divide_by_factor(&self, numerator: &Polynomial, factor: FactorId) -> Option<Polynomial> {
        match self.factor_variable(factor) {
            Some(variable) => self.divide_by_generator(numerator, variable),
            None => numerator.divide_exact(self.factor_polynomial(factor)),
        }
    }

    /// N/ρ; for a bound ρ with ρⁿ = f: (Σ A_k ρᵏ)/ρ = Σ_{k≥1} A_k ρᵏ⁻¹ + (A₀/f) ρⁿ⁻¹ if f divides
    /// A₀.
    pub(super) fn divide_by_generator(&self, numerator: &Polynomial, variable: u32) -> Option<Polynomial> {
        if let Some(quotient) = numerator.divide_by_monomial(&[(variable, 1)]) {
            return Some(quotient);
        }
        let relation = self.relation_of(variable)?;
        if numerator.term_count() == 1 && relation.value.term_count() > 1 {
            return None;
        }
        if !numerator.contains(variable) {
            let quotient = numerator.divide_exact(&relation.value)?;
            return Some(quotient.multiply_by_monomial(&[(variable, relation.order - 1)]));
        }
        let mut quotient = Polynomial::zero();
        for (exponent, coefficient) in numerator.coefficients_in(variable) {
            let (lowered, coefficient) = match exponent {
                0 => (relation.order - 1, coefficient.divide_exact(&relation.value)?),
                _ => (exponent - 1, coefficient),
            };
            quotient = quotient.add(&coefficient.multiply_by_monomial(&[(variable, lowered)]));
        }
        Some(quotient)
    }
}

/// Divides as often as possible.
fn divide_out(rest: &mut Polynomial, divide: impl Fn(&Polynomial) -> Option<Polynomial>) -> i32 {
    let mut exponent = 0;
    while rest.as_constant().is_none()
        && let Some(quotient) = divide(rest)
    {
        *rest = quotient;
        exponent += 1;
    }
    exponent
}
