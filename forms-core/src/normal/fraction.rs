//! Elements of the tower's field: a reduced polynomial over an integer and a product of known factors.

use super::generator::FactorId;
use super::tower::{Obstacle, Tower};
use crate::expression::Rational;
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed};

/// N / (d ∏ Fᵉ) with d > 0 and known factors F. Zero has neither d nor factors.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Fraction {
    pub(super) numerator: Polynomial,
    pub(super) divisor: BigInt,
    pub(super) factors: Vec<(FactorId, u32)>,
}

impl From<Polynomial> for Fraction {
    fn from(numerator: Polynomial) -> Self {
        Fraction { numerator, divisor: BigInt::one(), factors: Vec::new() }
    }
}

impl Fraction {
    /// 0
    pub fn zero() -> Self {
        Polynomial::zero().into()
    }

    /// 1
    pub fn one() -> Self {
        Polynomial::one().into()
    }

    /// A number.
    pub fn number(value: &Rational) -> Self {
        Fraction {
            numerator: Polynomial::constant(value.numer().clone()),
            divisor: value.denom().clone(),
            factors: Vec::new(),
        }
    }

    /// Whether it is zero; for a reduced fraction this is a proof.
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// The number it is, if it is one.
    pub fn as_number(&self) -> Option<Rational> {
        if !self.factors.is_empty() {
            return None;
        }
        Some(Rational::new(self.numerator.as_constant()?, self.divisor.clone()))
    }

    /// The numerator, if there is no denominator but a number, which is positive.
    pub fn as_polynomial(&self) -> Option<&Polynomial> {
        self.factors.is_empty().then_some(&self.numerator)
    }

    /// The reduced numerator.
    pub fn numerator(&self) -> &Polynomial {
        &self.numerator
    }
}

/// The union of two factor lists with the larger exponents, and what each list lacks of it.
fn common_factors(a: &[(FactorId, u32)], b: &[(FactorId, u32)]) -> [Vec<(FactorId, u32)>; 3] {
    let mut all: Vec<(FactorId, u32)> = a.to_vec();
    for &(factor, exponent) in b {
        match all.binary_search_by_key(&factor, |entry| entry.0) {
            Ok(place) => all[place].1 = all[place].1.max(exponent),
            Err(place) => all.insert(place, (factor, exponent)),
        }
    }
    let lacking = |present: &[(FactorId, u32)]| {
        all.iter()
            .map(|&(factor, exponent)| (factor, exponent - exponent_of(present, factor)))
            .filter(|entry| entry.1 > 0)
            .collect()
    };
    let (for_a, for_b) = (lacking(a), lacking(b));
    [all, for_a, for_b]
}

fn exponent_of(factors: &[(FactorId, u32)], factor: FactorId) -> u32 {
    factors.binary_search_by_key(&factor, |entry| entry.0).map_or(0, |place| factors[place].1)
}

/// The product of two factor lists.
fn merge_factors(a: &[(FactorId, u32)], b: &[(FactorId, u32)]) -> Vec<(FactorId, u32)> {
    let mut all: Vec<(FactorId, u32)> = a.to_vec();
    for &(factor, exponent) in b {
        match all.binary_search_by_key(&factor, |entry| entry.0) {
            Ok(place) => all[place].1 = all[place].1.saturating_add(exponent),
            Err(place) => all.insert(place, (factor, exponent)),
        }
    }
    all
}

impl Tower {
    /// a + b
    pub fn add(&mut self, a: &Fraction, b: &Fraction) -> Result<Fraction, Obstacle> {
        if a.is_zero() {
            return Ok(b.clone());
        }
        if b.is_zero() {
            return Ok(a.clone());
        }
        if a.factors == b.factors && a.divisor == b.divisor {
            let sum = a.numerator.add(&b.numerator);
            return Ok(self.cancel(sum, a.divisor.clone(), a.factors.clone()));
        }
        let divisor = a.divisor.lcm(&b.divisor);
        let [factors, for_a, for_b] = common_factors(&a.factors, &b.factors);
        let left = self.raised(&a.numerator, &(&divisor / &a.divisor), &for_a)?;
        let right = self.raised(&b.numerator, &(&divisor / &b.divisor), &for_b)?;
        let sum = left.add(&right);
        Ok(self.cancel(sum, divisor, factors))
    }

    /// The numerator brought over a larger denominator.
    fn raised(
        &mut self,
        numerator: &Polynomial,
        by: &BigInt,
        factors: &[(FactorId, u32)],
    ) -> Result<Polynomial, Obstacle> {
        let mut raised = if by.is_one() { numerator.clone() } else { numerator.scale(by) };
        for &(factor, exponent) in factors {
            if let Some(variable) = self.factor_variable(factor) {
                Self::check_exponent(raised.exponent_bound().saturating_add(exponent))?;
                raised = raised.multiply_by_monomial(&[(variable, exponent)]);
                continue;
            }
            let polynomial = self.factor_polynomial(factor).clone();
            Self::check_power(&polynomial, u64::from(exponent))?;
            for _ in 0..exponent {
                self.charge(&raised, &polynomial)?;
                raised = raised.mul(&polynomial);
            }
        }
        self.reduce(raised)
    }

    /// −a
    pub fn negate(&self, a: &Fraction) -> Fraction {
        Fraction { numerator: a.numerator.neg(), ..a.clone() }
    }

    /// a − b
    pub fn subtract(&mut self, a: &Fraction, b: &Fraction) -> Result<Fraction, Obstacle> {
        let negated = self.negate(b);
        self.add(a, &negated)
    }

    /// a b
    pub fn multiply(&mut self, a: &Fraction, b: &Fraction) -> Result<Fraction, Obstacle> {
        if a.is_zero() || b.is_zero() {
            return Ok(Fraction::zero());
        }
        let left = self.cancel(a.numerator.clone(), b.divisor.clone(), b.factors.clone());
        let right = self.cancel(b.numerator.clone(), a.divisor.clone(), a.factors.clone());
        self.charge(&left.numerator, &right.numerator)?;
        let product = left.numerator.mul(&right.numerator);
        let divisor = &left.divisor * &right.divisor;
        let factors = merge_factors(&left.factors, &right.factors);
        for &(_, exponent) in &factors {
            Self::check_exponent(exponent)?;
        }
        let bound = self.relations.iter().any(|relation| product.degree(relation.variable) >= relation.order);
        if bound {
            let reduced = self.reduce(product)?;
            return Ok(self.cancel(reduced, divisor, factors));
        }
        Ok(Fraction { numerator: product, divisor, factors })
    }

    /// 1/a, whose numerator becomes one or more known factors.
    pub fn inverse(&mut self, a: &Fraction) -> Result<Fraction, Obstacle> {
        if a.is_zero() {
            return Err(Obstacle::DivisionByZero);
        }
        let (content, factors) = self.split(&a.numerator);
        let mut numerator = Fraction::from(Polynomial::constant(a.divisor.clone()));
        for &(factor, exponent) in &a.factors {
            let mut power = Fraction::from(self.factor_polynomial(factor).clone());
            power = self.integer_power(&power, i64::from(exponent))?;
            numerator = self.multiply(&numerator, &power)?;
        }
        let signed = if content.is_negative() { numerator.numerator.neg() } else { numerator.numerator };
        Ok(self.cancel(signed, content.abs(), factors))
    }

    /// aⁿ
    pub fn integer_power(&mut self, a: &Fraction, exponent: i64) -> Result<Fraction, Obstacle> {
        if exponent < 0 {
            // The inverse first keeps the denominator factored.
            let inverse = self.inverse(a)?;
            return self.integer_power(&inverse, -exponent);
        }
        Self::check_power(&a.numerator, exponent.unsigned_abs())?;
        let mut result = Fraction::one();
        let mut square = a.clone();
        let mut rest = exponent;
        while rest > 0 {
            if rest % 2 == 1 {
                result = self.multiply(&result, &square)?;
            }
            rest /= 2;
            if rest > 0 {
                square = self.multiply(&square, &square.clone())?;
            }
        }
        Ok(result)
    }

    /// content · ∏ factors of a polynomial: generators that divide it, then known factors, then the rest.
    fn split(&mut self, polynomial: &Polynomial) -> (BigInt, Vec<(FactorId, u32)>) {
        let mut content = polynomial.content();
        if polynomial.leading_coefficient().is_negative() {
            content = -content;
        }
        let monomial = polynomial.monomial_content();
        let primitive = polynomial.primitive_part();
        let mut rest = primitive.divide_by_monomial(&monomial).unwrap_or(primitive);
        let mut factors = Vec::new();
        for (variable, exponent) in monomial {
            factors.push((self.factor(Polynomial::variable(variable)), exponent));
        }
        self.split_radicands(&mut rest, &mut factors);
        self.split_known(&mut rest, &mut factors);
        if rest.leading_coefficient().is_negative() {
            (content, rest) = (-content, rest.neg());
        }
        if rest.as_constant().is_none() {
            factors.push((self.factor(rest), 1));
        }
        let merged = factors.into_iter().fold(Vec::new(), |all, entry| merge_factors(&all, &[entry]));
        (content, merged)
    }

    /// Divides out radicands, each as the power ρⁿ of its root, so that it has one name only.
    fn split_radicands(&mut self, rest: &mut Polynomial, factors: &mut Vec<(FactorId, u32)>) {
        for number in 0..self.relations.len() {
            let relation = self.relations[number].clone();
            if relation.value.term_count() < 2 || self.is_trigonometric(relation.variable) {
                continue;
            }
            let exponent = divide_out(rest, &relation.value);
            if exponent > 0 {
                let root = self.factor(Polynomial::variable(relation.variable));
                factors.push((root, relation.order * exponent));
            }
        }
    }

    /// Divides out known factors.
    fn split_known(&mut self, rest: &mut Polynomial, factors: &mut Vec<(FactorId, u32)>) {
        for number in 0..self.factors.len() {
            let known = self.factors[number].clone();
            if known.term_count() < 2 {
                continue;
            }
            let exponent = divide_out(rest, &known);
            if exponent > 0 {
                factors.push((FactorId(number as u32), exponent));
            }
        }
    }

    /// N / (d ∏ Fᵉ) with every factor divided out of N that divides it.
    pub(super) fn cancel(
        &self,
        mut numerator: Polynomial,
        mut divisor: BigInt,
        mut factors: Vec<(FactorId, u32)>,
    ) -> Fraction {
        if numerator.is_zero() {
            return Fraction::zero();
        }
        for (factor, exponent) in &mut factors {
            if let Some(variable) = self.factor_variable(*factor) {
                let shared = numerator.least_exponent(variable).min(*exponent);
                numerator = numerator.divide_by_monomial(&[(variable, shared)]).unwrap_or(numerator);
                *exponent -= shared;
            }
            while *exponent > 0 {
                match self.divide_by_factor(&numerator, *factor) {
                    Some(quotient) => numerator = quotient,
                    None => break,
                }
                *exponent -= 1;
            }
        }
        factors.retain(|entry| entry.1 > 0);
        if !divisor.is_one() {
            let common = numerator.content().gcd(&divisor);
            if !common.is_one() {
                numerator =
                    numerator.divide_exact(&Polynomial::constant(common.clone())).unwrap_or(numerator);
                divisor /= common;
            }
        }
        Fraction { numerator, divisor, factors }
    }

    fn divide_by_factor(&self, numerator: &Polynomial, factor: FactorId) -> Option<Polynomial> {
        match self.factor_variable(factor) {
            Some(variable) => self.divide_by_generator(numerator, variable),
            None => numerator.divide_exact(self.factor_polynomial(factor)),
        }
    }

    /// N/ρ; for a bound ρ with ρⁿ = f: (Σ A_k ρᵏ)/ρ = Σ_{k≥1} A_k ρᵏ⁻¹ + (A₀/f) ρⁿ⁻¹ where f divides A₀.
    fn divide_by_generator(&self, numerator: &Polynomial, variable: u32) -> Option<Polynomial> {
        if let Some(quotient) = numerator.divide_by_monomial(&[(variable, 1)]) {
            return Some(quotient);
        }
        let relation = self.relation_of(variable)?;
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

/// Divides by a factor as often as it goes.
fn divide_out(rest: &mut Polynomial, factor: &Polynomial) -> u32 {
    let mut exponent = 0;
    while let Some(quotient) = rest.divide_exact(factor) {
        *rest = quotient;
        exponent += 1;
    }
    exponent
}

impl Fraction {
    /// Whether there is no denominator.
    pub(super) fn is_polynomial(&self) -> bool {
        self.divisor.is_one() && self.factors.is_empty()
    }
}
