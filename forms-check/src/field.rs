//! Fractions over the generators of one proof: polynomials over products of known factors, reduced
//! by relations.
//!
//! A numerator that reduces to zero is a proof wherever no factor of the denominator vanishes, and
//! denominators contain only factors from quotients of the statement. Soundness requires neither
//! complete relations nor irreducible factors.

use crate::expression::{Expr, Operation, rational};
use crate::polynomial::{MOST_GENERATORS, Polynomial};
use crate::{Stop, uncovered};
use num_rational::BigRational;
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// Maximum number of products of terms for one step of a proof.
const MOST_WORK: usize = 5_000_000;

/// Reason why a proof that would cost more is not covered.
const TOO_MANY_TERMS: &str = "polynomials with more terms than the checker multiplies";

/// Maximum number of terms of a factor that is divided out of numerators.
const MOST_TERMS: usize = 40;

/// Largest exponent of a generator.
const LARGEST_EXPONENT: u8 = 120;

/// Largest exponent of a factor: a root of high order occurs in denominators with that order as its
/// exponent.
const LARGEST_FACTOR_EXPONENT: u64 = 1 << 15;

/// Fraction numerator / ∏ factorᵉ; a factor of the numerator (e < 0) is kept factored until a sum
/// requires its expansion.
#[derive(Clone, Debug, Default)]
pub(crate) struct Fraction {
    pub(crate) numerator: Polynomial,
    pub(crate) factors: BTreeMap<usize, i64>,
}

/// Meaning of a generator: a variable, π, an unknown function, a function of which only the
/// arguments are known, or a root that no base provides; `None` for generators that the certificate
/// declares.
pub(crate) type Generator = Option<(Operation, Vec<Fraction>)>;

/// Factor of radicands that the certificate declares.
#[derive(Clone, Debug)]
pub(crate) struct Base {
    pub(crate) polynomial: Polynomial,
    /// Declared order n of its root, and the least common multiple of the orders used.
    pub(crate) order: i64,
    pub(crate) used: i64,
    /// Sign σ with σ·polynomial ≥ 0, once it is shown.
    pub(crate) sign: Option<i64>,
    pub(crate) root: Option<usize>,
    /// Generator of log |g|.
    pub(crate) logarithm: Option<usize>,
}

/// Representation of the functions of a unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// cos u, sin u with sin² = 1 − cos²
    Circle,
    /// tan(u/2)
    Tangent,
    /// exp u
    Exponent,
}

/// Unit of angles or exponents, which are integer multiples of it.
#[derive(Clone, Debug)]
pub(crate) struct Unit {
    pub(crate) kind: Kind,
    pub(crate) value: Fraction,
    /// Its generator; the generator of the sine is the next one.
    pub(crate) generator: usize,
    /// Greatest common divisor of the multiples used.
    pub(crate) used: i64,
}

/// Generators with their relations, and the elements known so far.
#[derive(Clone, Debug, Default)]
pub(crate) struct Field {
    pub(crate) generators: Vec<Generator>,
    relations: Vec<(usize, u8, Polynomial)>,
    factors: Vec<Polynomial>,
    pub(crate) bases: Vec<Base>,
    pub(crate) units: Vec<Unit>,
    pub(crate) elements: HashMap<Expr, Fraction>,
    work: usize,
}

impl From<Polynomial> for Fraction {
    fn from(numerator: Polynomial) -> Self {
        Fraction { numerator, factors: BTreeMap::new() }
    }
}

impl Fraction {
    pub(crate) fn number(value: BigRational) -> Self {
        Polynomial::constant(value).into()
    }

    pub(crate) fn is_generator(&self, generator: usize) -> bool {
        self.factors.is_empty() && self.numerator == Polynomial::generator(generator, 1)
    }

    pub(crate) fn scale(&self, by: &BigRational) -> Self {
        if *by == rational(0, 1) {
            return Fraction::default();
        }
        Fraction { numerator: self.numerator.clone().scale(by), factors: self.factors.clone() }
    }
}

impl Field {
    pub(crate) fn new_generator(&mut self, generator: Generator) -> Result<usize, Stop> {
        if self.generators.len() == MOST_GENERATORS {
            return uncovered(format!("more than {MOST_GENERATORS} generators"));
        }
        self.generators.push(generator);
        Ok(self.generators.len() - 1)
    }

    /// Adds the relation gⁿ = value, where the value contains only earlier generators.
    pub(crate) fn bind(&mut self, generator: usize, order: u8, value: Polynomial) {
        self.relations.push((generator, order, value));
    }

    /// Returns the generators that occur in a polynomial.
    pub(crate) fn generators_of(&self, polynomial: &Polynomial) -> Vec<usize> {
        (0..self.generators.len()).filter(|g| polynomial.degree(Some(*g)) > 0).collect()
    }

    pub(crate) fn factor(&self, number: usize) -> &Polynomial {
        &self.factors[number]
    }

    fn reduce(&mut self, mut polynomial: Polynomial) -> Result<Polynomial, Stop> {
        while let Some((generator, order, value)) =
            self.relations.iter().rev().find(|relation| polynomial.degree(Some(relation.0)) >= relation.1)
        {
            let times = usize::from(polynomial.degree(Some(*generator)) / order);
            let cost = polynomial.0.len().saturating_mul(value.0.len().saturating_pow(times.min(8) as u32));
            self.work = self.work.saturating_add(cost);
            let degree = usize::from(value.degree(None)) * times + usize::from(polynomial.degree(None));
            if self.work > MOST_WORK || degree > 255 {
                return uncovered(TOO_MANY_TERMS);
            }
            let Some(reduced) = polynomial.reduce(*generator, *order, value) else {
                return uncovered(TOO_MANY_TERMS);
            };
            polynomial = reduced;
        }
        Ok(polynomial)
    }

    pub(crate) fn product(&mut self, a: &Polynomial, b: &Polynomial) -> Result<Polynomial, Stop> {
        self.work = self.work.saturating_add(a.0.len().saturating_mul(b.0.len()));
        if self.work > MOST_WORK || a.degree(None).saturating_add(b.degree(None)) > LARGEST_EXPONENT {
            return uncovered(TOO_MANY_TERMS);
        }
        let Some(product) = a.multiply(b) else {
            return uncovered(TOO_MANY_TERMS);
        };
        self.reduce(product)
    }

    /// Returns N / ∏ Fᵉ with every factor that divides N cancelled; for a root also by ρⁿ = f.
    fn cancel(&mut self, mut numerator: Polynomial, mut factors: BTreeMap<usize, i64>) -> Fraction {
        for (number, exponent) in &mut factors {
            while *exponent > 0 && self.factors[*number].0.len() <= MOST_TERMS {
                let factor = &self.factors[*number];
                let relation = self.relations.iter().find(|r| *factor == Polynomial::generator(r.0, 1));
                let by_root = || {
                    let (root, order, value) = relation.filter(|r| numerator.degree(Some(r.0)) == 0)?;
                    numerator.divide(value)?.multiply(&Polynomial::generator(*root, order - 1))
                };
                let Some(quotient) = numerator.divide(factor).or_else(by_root) else { break };
                (numerator, *exponent) = (quotient, *exponent - 1);
            }
        }
        factors.retain(|_, exponent| *exponent != 0 && !numerator.is_zero());
        Fraction { numerator, factors }
    }

    pub(crate) fn add(&mut self, a: &Fraction, b: &Fraction) -> Result<Fraction, Stop> {
        let exponent = |side: &Fraction, factor: &usize| side.factors.get(factor).copied().unwrap_or(0);
        let all: BTreeSet<usize> = a.factors.keys().chain(b.factors.keys()).copied().collect();
        let mut common: Vec<(usize, i64)> =
            all.into_iter().map(|factor| (factor, exponent(a, &factor).max(exponent(b, &factor)))).collect();
        // the longest factors first, while the numerator is short
        common.sort_by_key(|(factor, _)| std::cmp::Reverse(self.factors[*factor].0.len()));
        let mut sum = Polynomial::default();
        for side in [a, b].into_iter().filter(|side| !side.numerator.is_zero()) {
            let mut raised = side.numerator.clone();
            for (factor, larger) in &common {
                for _ in exponent(side, factor)..*larger {
                    raised = self.product(&raised, &self.factors[*factor].clone())?;
                }
            }
            sum = sum.add(&raised);
        }
        Ok(self.cancel(sum, common.into_iter().collect()))
    }

    /// Returns the same fraction with the factors of the numerator multiplied out.
    pub(crate) fn expanded(&mut self, a: &Fraction) -> Result<Fraction, Stop> {
        let mut numerator = a.numerator.clone();
        for (factor, exponent) in &a.factors {
            for _ in *exponent..0 {
                numerator = self.product(&numerator, &self.factors[*factor].clone())?;
            }
        }
        let below = a.factors.iter().filter(|entry| *entry.1 > 0);
        Ok(self.cancel(numerator, below.map(|(factor, exponent)| (*factor, *exponent)).collect()))
    }

    pub(crate) fn subtract(&mut self, a: &Fraction, b: &Fraction) -> Result<Fraction, Stop> {
        self.add(a, &b.scale(&rational(-1, 1)))
    }

    pub(crate) fn equal(&mut self, a: &Fraction, b: &Fraction) -> Result<bool, Stop> {
        Ok(self.subtract(a, b)?.numerator.is_zero())
    }

    pub(crate) fn multiply(&mut self, a: &Fraction, b: &Fraction) -> Result<Fraction, Stop> {
        let left = self.cancel(a.numerator.clone(), b.factors.clone());
        let right = self.cancel(b.numerator.clone(), a.factors.clone());
        let mut factors = left.factors;
        right
            .factors
            .into_iter()
            .for_each(|(factor, exponent)| *factors.entry(factor).or_default() += exponent);
        if factors.values().any(|exponent| exponent.unsigned_abs() > u64::from(LARGEST_EXPONENT)) {
            return uncovered("exponents this large");
        }
        let product = self.product(&left.numerator, &right.numerator)?;
        Ok(self.cancel(product, factors))
    }

    /// Returns 1/a: generators, radicands and known factors of the numerator become factors of the
    /// denominator, each under one name.
    pub(crate) fn inverse(&mut self, a: &Fraction) -> Result<Fraction, Stop> {
        if a.numerator.is_zero() {
            return Err(Stop::Undefined);
        }
        let (mut rest, mut below) = (a.numerator.clone(), BTreeMap::<usize, i64>::new());
        let generators = (0..self.generators.len()).map(|g| (Polynomial::generator(g, 1), g, 1));
        let radicands = self.relations.iter().map(|(g, order, value)| (value.clone(), *g, *order));
        for (value, generator, order) in generators.chain(radicands).collect::<Vec<_>>() {
            while let Some(quotient) = rest.divide(&value).filter(|_| value.as_constant().is_none()) {
                rest = quotient;
                *below.entry(self.factor_number(&Polynomial::generator(generator, 1))).or_default() +=
                    i64::from(order);
            }
        }
        for number in 0..self.factors.len() {
            while let Some(quotient) =
                rest.divide(&self.factors[number]).filter(|_| rest.as_constant().is_none())
            {
                rest = quotient;
                *below.entry(number).or_default() += 1;
            }
        }
        let content = rational(1, 1) / rest.leading();
        if rest.as_constant().is_none() {
            *below.entry(self.factor_number(&rest.scale(&content))).or_default() += 1;
        }
        for (factor, exponent) in &a.factors {
            *below.entry(*factor).or_default() -= exponent;
        }
        if below.values().any(|exponent| exponent.unsigned_abs() > LARGEST_FACTOR_EXPONENT) {
            return uncovered("exponents this large");
        }
        Ok(self.cancel(Polynomial::constant(content), below))
    }

    fn factor_number(&mut self, factor: &Polynomial) -> usize {
        self.factors.iter().position(|known| known == factor).unwrap_or_else(|| {
            self.factors.push(factor.clone());
            self.factors.len() - 1
        })
    }

    pub(crate) fn quotient(&mut self, a: &Fraction, b: &Fraction) -> Result<Fraction, Stop> {
        let inverse = self.inverse(b)?;
        self.multiply(a, &inverse)
    }

    /// Returns aⁿ.
    pub(crate) fn integer_power(&mut self, a: &Fraction, n: i64) -> Result<Fraction, Stop> {
        let base = if n < 0 { self.inverse(a)? } else { a.clone() };
        if n.unsigned_abs() > u64::from(LARGEST_EXPONENT) {
            return uncovered("exponents this large");
        }
        let mut power = Fraction::number(rational(1, 1));
        for _ in 0..n.unsigned_abs() {
            power = self.multiply(&power, &base)?;
        }
        Ok(power)
    }
}
