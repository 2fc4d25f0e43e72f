//! Polynomials in one generator over the field of the others: the operations that integration
//! needs.

use super::fraction::Fraction;
use super::generator::Generator;
use super::obstacle::Obstacle;
use super::tower::Tower;
use crate::expression::Symbol;
use crate::polynomial::{Polynomial, coprime_basis};
use num_bigint::BigInt;

/// Σ aₖ xᵏ, with the coefficients in ascending order; the last one is not zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Univariate(Vec<Fraction>);

impl Univariate {
    pub(crate) fn new(mut coefficients: Vec<Fraction>) -> Self {
        while coefficients.last().is_some_and(Fraction::is_zero) {
            coefficients.pop();
        }
        Univariate(coefficients)
    }

    pub(crate) fn one() -> Self {
        Univariate(vec![Fraction::one()])
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// Returns the degree; the degree of 0 counts as 0.
    pub(crate) fn degree(&self) -> usize {
        self.0.len().saturating_sub(1)
    }

    pub(crate) fn coefficients(&self) -> &[Fraction] {
        &self.0
    }

    /// Returns the coefficient of xᵏ.
    pub(crate) fn coefficient(&self, k: usize) -> Fraction {
        self.0.get(k).cloned().unwrap_or_else(Fraction::zero)
    }
}

/// N(x) / ∏ pᵢ(x)^mᵢ with pairwise coprime pᵢ.
#[derive(Clone, Debug)]
pub(crate) struct RationalFunction {
    pub(crate) numerator: Univariate,
    pub(crate) denominator: Vec<(Univariate, u32)>,
}

type Computed<T> = Result<T, Obstacle>;

impl Tower {
    pub(crate) fn univariate_sum(&mut self, a: &Univariate, b: &Univariate) -> Computed<Univariate> {
        let length = a.0.len().max(b.0.len());
        let sums = (0..length).map(|k| self.add(&a.coefficient(k), &b.coefficient(k)));
        Ok(Univariate::new(sums.collect::<Computed<_>>()?))
    }

    pub(crate) fn univariate_scaled(&mut self, a: &Univariate, factor: &Fraction) -> Computed<Univariate> {
        let scaled = a.0.iter().map(|coefficient| self.multiply(coefficient, factor));
        Ok(Univariate::new(scaled.collect::<Computed<_>>()?))
    }

    pub(crate) fn univariate_product(&mut self, a: &Univariate, b: &Univariate) -> Computed<Univariate> {
        if a.is_zero() || b.is_zero() {
            return Ok(Univariate::new(vec![]));
        }
        let mut product = vec![Fraction::zero(); a.0.len() + b.0.len() - 1];
        for (i, p) in a.0.iter().enumerate() {
            for (j, q) in b.0.iter().enumerate() {
                let term = self.multiply(p, q)?;
                product[i + j] = self.add(&product[i + j], &term)?;
            }
        }
        Ok(Univariate::new(product))
    }

    pub(crate) fn univariate_power(&mut self, a: &Univariate, exponent: u32) -> Computed<Univariate> {
        let mut power = Univariate::one();
        for _ in 0..exponent {
            power = self.univariate_product(&power, a)?;
        }
        Ok(power)
    }

    /// Returns quotient and remainder.
    pub(crate) fn univariate_division(
        &mut self,
        a: &Univariate,
        b: &Univariate,
    ) -> Computed<(Univariate, Univariate)> {
        let Some(leading) = b.0.last() else { return Err(Obstacle::DivisionByZero) };
        let inverse = self.inverse(leading)?;
        let mut rest = a.0.clone();
        let mut quotient = vec![Fraction::zero(); (a.0.len() + 1).saturating_sub(b.0.len())];
        while rest.len() >= b.0.len() {
            let shift = rest.len() - b.0.len();
            let top = rest.pop().unwrap_or_else(Fraction::zero);
            let share = self.multiply(&top, &inverse)?;
            for (k, coefficient) in b.0[..b.0.len() - 1].iter().enumerate() {
                let term = self.multiply(&share, coefficient)?;
                rest[shift + k] = self.subtract(&rest[shift + k], &term)?;
            }
            quotient[shift] = share;
        }
        Ok((Univariate::new(quotient), Univariate::new(rest)))
    }

    /// Returns the inverse of a modulo m, if they have no common factor.
    pub(crate) fn univariate_inverse(&mut self, a: &Univariate, m: &Univariate) -> Computed<Univariate> {
        let (mut r, mut s) = (m.clone(), self.univariate_division(a, m)?.1);
        let (mut u, mut v) = (Univariate::new(vec![]), Univariate::one());
        while s.degree() > 0 {
            let (quotient, rest) = self.univariate_division(&r, &s)?;
            let product = self.univariate_product(&quotient, &v)?;
            let minus_one = Fraction::from(Polynomial::integer(-1));
            let negated = self.univariate_scaled(&product, &minus_one)?;
            let next = self.univariate_sum(&u, &negated)?;
            (r, s, u, v) = (s, rest, v, next);
        }
        let scale = self.inverse(&s.coefficient(0))?;
        self.univariate_scaled(&v, &scale)
    }

    /// p(a) for an element a.
    pub(crate) fn univariate_at(&mut self, p: &Univariate, a: &Fraction) -> Computed<Fraction> {
        let mut value = Fraction::zero();
        for coefficient in p.0.iter().rev() {
            let product = self.multiply(&value, a)?;
            value = self.add(&product, coefficient)?;
        }
        Ok(value)
    }

    /// Returns the generators that depend on a real variable and occur in an element.
    pub(crate) fn generators_in(&self, a: &Fraction, symbol: Symbol) -> Vec<u32> {
        let mut found: Vec<u32> = a.numerator.variables();
        found.extend(a.factors.iter().flat_map(|power| self.factor_polynomial(power.factor).variables()));
        found.sort_unstable();
        found.dedup();
        found.retain(|&variable| self.depends(variable, symbol));
        found
    }

    /// Returns the element as a rational function of a generator on which no other generator in the
    /// element depends.
    pub(crate) fn rational_function(&mut self, a: &Fraction, variable: u32) -> Computed<RationalFunction> {
        let a = self.expanded(a)?;
        let mut constant = Fraction { numerator: Polynomial::one(), ..a.clone() };
        constant.factors.retain(|power| !self.factor_polynomial(power.factor).contains(variable));
        let below: Vec<(Polynomial, u32)> = a
            .factors
            .iter()
            .map(|power| (self.factor_polynomial(power.factor).clone(), power.exponent.unsigned_abs()))
            .filter(|(polynomial, _)| polynomial.contains(variable))
            .collect();
        let polynomials: Vec<Polynomial> = below.iter().map(|entry| entry.0.clone()).collect();
        let basis = coprime_basis(&polynomials);
        let mut exponents = vec![0; basis.len()];
        for (polynomial, times) in &below {
            let (content, own) = polynomial.factor_over(&basis).unwrap_or((BigInt::from(1), vec![]));
            let inverse = self.inverse(&Polynomial::constant(content).into())?;
            for _ in 0..*times {
                constant = self.multiply(&constant, &inverse)?;
            }
            exponents.iter_mut().zip(own).for_each(|(sum, exponent)| *sum += exponent * times);
        }
        let mut denominator = Vec::new();
        for (factor, exponent) in basis.into_iter().zip(exponents) {
            if factor.contains(variable) {
                denominator.push((self.univariate(&factor, variable), exponent));
                continue;
            }
            let inverse = self.inverse(&factor.into())?;
            let power = self.integer_power(&inverse, i64::from(exponent))?;
            constant = self.multiply(&constant, &power)?;
        }
        let numerator = self.univariate(&a.numerator, variable);
        Ok(RationalFunction { numerator: self.univariate_scaled(&numerator, &constant)?, denominator })
    }

    /// Returns a polynomial by the powers of one generator.
    pub(crate) fn univariate(&self, polynomial: &Polynomial, variable: u32) -> Univariate {
        let mut coefficients = vec![Fraction::zero(); polynomial.degree(variable) as usize + 1];
        for (exponent, coefficient) in polynomial.coefficients_in(variable) {
            coefficients[exponent as usize] = coefficient.into();
        }
        Univariate::new(coefficients)
    }

    /// Substitutes values for some generators of the element.
    pub(crate) fn replaced(&mut self, a: &Fraction, values: &[(u32, Fraction)]) -> Computed<Fraction> {
        let mut result = self.replaced_in(&a.numerator, values)?;
        for power in &a.factors {
            let factor = self.factor_polynomial(power.factor).clone();
            let value = self.replaced_in(&factor, values)?;
            let raised = self.integer_power(&value, -i64::from(power.exponent))?;
            result = self.multiply(&result, &raised)?;
        }
        let divisor = self.inverse(&Polynomial::constant(a.divisor.clone()).into())?;
        self.multiply(&result, &divisor)
    }

    fn replaced_in(&mut self, polynomial: &Polynomial, values: &[(u32, Fraction)]) -> Computed<Fraction> {
        let Some(((variable, value), rest)) = values.split_first() else {
            return Ok(polynomial.clone().into());
        };
        let mut sum = Fraction::zero();
        for (exponent, coefficient) in polynomial.coefficients_in(*variable) {
            let inner = self.replaced_in(&coefficient, rest)?;
            let power = self.integer_power(value, i64::from(exponent))?;
            let term = self.multiply(&inner, &power)?;
            sum = self.add(&sum, &term)?;
        }
        Ok(sum)
    }

    /// Splits the element by exponents of some generators, which can be negative, if its
    /// denominator contains these generators in no other way.
    pub(crate) fn laurent_terms(
        &mut self,
        a: &Fraction,
        generators: &[u32],
    ) -> Option<Vec<(Vec<i32>, Fraction)>> {
        let a = self.expanded(a).ok()?;
        let mut shift = vec![0; generators.len()];
        let mut rest = Vec::new();
        for power in &a.factors {
            let own = self.factor_variable(power.factor);
            match generators.iter().position(|generator| Some(*generator) == own) {
                Some(place) => shift[place] = power.exponent,
                None => {
                    let polynomial = self.factor_polynomial(power.factor);
                    if generators.iter().any(|&generator| polynomial.contains(generator)) {
                        return None;
                    }
                    rest.push(*power);
                }
            }
        }
        let terms = a.numerator.split_by(generators).into_iter().map(|(exponents, numerator)| {
            let exponents = exponents.iter().zip(&shift).map(|(&e, &s)| e as i32 - s).collect();
            (exponents, self.cancel(numerator, a.divisor.clone(), rest.clone()))
        });
        Some(terms.collect())
    }

    /// Splits the element into a sum of products of two factors. The first is free of a real
    /// variable; the second is a monomial of the generators that depend on it, over the part of the
    /// denominator that depends on it.
    pub(crate) fn products(&mut self, a: &Fraction, symbol: Symbol) -> Computed<Vec<(Fraction, Fraction)>> {
        let a = self.expanded(a)?;
        let generators = self.generators_in(&a, symbol);
        let (moving, still): (Vec<_>, Vec<_>) = a.factors.iter().copied().partition(|power| {
            let polynomial = self.factor_polynomial(power.factor);
            generators.iter().any(|&generator| polynomial.contains(generator))
        });
        let terms = a.numerator.split_by(&generators).into_iter().map(|(exponents, numerator)| {
            let powers = generators.iter().copied().zip(exponents).filter(|power| power.1 > 0);
            let monomial = Polynomial::one().multiply_by_monomial(&powers.collect::<Vec<_>>());
            let coefficient = self.cancel(numerator, a.divisor.clone(), still.clone());
            (coefficient, self.cancel(monomial, 1.into(), moving.clone()))
        });
        Ok(terms.collect())
    }

    /// Returns the known factors of an element and their exponents, positive in the denominator.
    pub(crate) fn factors_of(&self, a: &Fraction) -> Vec<(&Polynomial, i32)> {
        a.factors.iter().map(|power| (self.factor_polynomial(power.factor), power.exponent)).collect()
    }

    /// Returns the generator of a real variable.
    pub(crate) fn variable_number(&mut self, symbol: Symbol) -> u32 {
        self.variable_of(Generator::Variable(symbol))
    }

    /// Returns the radicand of a root generator, with its sign, and the order.
    pub(crate) fn radicand(&self, variable: u32) -> Option<(Polynomial, u32)> {
        let Generator::Root { base, order, negated } = *self.generator(variable) else { return None };
        let polynomial = &self.bases[base].polynomial;
        Some((if negated { polynomial.neg() } else { polynomial.clone() }, order))
    }

    /// Returns the argument of a sine, cosine or exponential generator.
    pub(crate) fn argument(&mut self, variable: u32) -> Option<Fraction> {
        let (Generator::Cosine(unit) | Generator::Sine(unit) | Generator::Exponential(unit)) =
            self.generator(variable).clone()
        else {
            return None;
        };
        let quantity = self.quantity(&unit.quantity);
        Some(self.cancel(quantity.numerator, quantity.divisor * unit.divisor, quantity.factors))
    }

    /// Returns √a for an element whose numerator and denominator are squares.
    pub(crate) fn exact_root(&mut self, a: &Fraction) -> Option<Fraction> {
        let mut root = Fraction::one();
        let (content, parts) = a.numerator.square_free();
        for (number, below) in [(content, false), (a.divisor.clone(), true)] {
            if number.sign() == num_bigint::Sign::Minus {
                return None;
            }
            let square = number.sqrt();
            if &square * &square != number {
                return None;
            }
            let value = Fraction::from(Polynomial::constant(square));
            let value = if below { self.inverse(&value).ok()? } else { value };
            root = self.multiply(&root, &value).ok()?;
        }
        let below = a.factors.iter().map(|p| (self.factor_polynomial(p.factor).clone(), -p.exponent));
        let above = parts.into_iter().map(|(part, exponent)| (part, exponent as i32));
        for (part, exponent) in above.chain(below.collect::<Vec<_>>()) {
            if exponent % 2 != 0 {
                return None;
            }
            let power = self.integer_power(&part.into(), i64::from(exponent / 2)).ok()?;
            root = self.multiply(&root, &power).ok()?;
        }
        Some(root)
    }
}
