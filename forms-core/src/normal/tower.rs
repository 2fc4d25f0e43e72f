//! Tower of extensions: the generators in use, the relations that bind some of them, and the known
//! factors.

use super::factor::FactorPower;
use super::fraction::Fraction;
use super::frame::Drift;
use super::generator::{FactorId, Generator, Quantity, Unit};
use super::refinement::Product;
use super::root::{Base, Sign, SignConstraint};
use super::work::WORK_LIMIT;
use crate::expression::Expr;
use crate::polynomial::Polynomial;
use num_traits::Signed;
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeSet;

/// Reason why an expression has no normal form here.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Obstacle {
    /// A finer generator is needed (a half angle, a factor of a radicand); the conversion starts
    /// again.
    Refine,
    /// The expression divides by zero everywhere.
    DivisionByZero,
    /// A part lies outside the class that is decided; the text says which.
    Outside(String),
    /// The normal form is too large; the text names the limit.
    TooLarge(String),
}

/// Representation of sines and cosines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trigonometry {
    /// By c and s with s² = 1 − c²: small and readable, but not a ring with unique factorisation.
    Circle,
    /// By t = tan(u/2), in which radicands can be factored.
    HalfAngle,
}

/// ρⁿ = value
#[derive(Clone, Debug)]
pub(super) struct Relation {
    pub(super) variable: u32,
    pub(super) order: u32,
    pub(super) value: Polynomial,
}

/// Generators, relations and factors that the fractions of one comparison refer to.
#[derive(Clone, Debug)]
pub struct Tower {
    pub(super) generators: Vec<Generator>,
    numbers: FxHashMap<Generator, u32>,
    pub(super) factors: Vec<Polynomial>,
    factor_numbers: FxHashMap<Polynomial, FactorId>,
    /// Factors that turned out to be products of others.
    pub(super) products: FxHashMap<FactorId, Product>,
    /// Pairs of factors for which division of the second by the first was tried.
    pub(super) divisions_tried: FxHashSet<(FactorId, FactorId)>,
    pub(super) relations: Vec<Relation>,
    pub(super) bases: Vec<Base>,
    /// Bases whose signs the element being computed needs.
    asked: Vec<usize>,
    asked_by: FxHashMap<Expr, Vec<usize>>,
    /// Bases that the element being computed is factored over, and the bases of each known element.
    pub(super) met: Vec<usize>,
    pub(super) met_by: FxHashMap<Expr, Vec<usize>>,
    pub(super) divisors: FxHashMap<Quantity, u32>,
    /// Number of parts that each exponent is divided into.
    pub(super) exponent_divisors: FxHashMap<Quantity, u32>,
    /// Common denominator of all exponents.
    pub(super) exponent_denominator: Vec<FactorPower>,
    /// Units at an odd multiple of π here: cos u = −1, sin u = 0.
    pub(super) half_turns: Vec<Unit>,
    /// Units whose half-angle tangents were used, and polynomials that were divisors.
    pub(super) poles: Vec<Unit>,
    pub(super) excluded: Vec<Polynomial>,
    pub(super) trigonometry: Trigonometry,
    pub(super) elements: FxHashMap<Expr, Fraction>,
    constraints: FxHashMap<Expr, SignConstraint>,
    /// Variables that are written relative to others.
    pub(super) frame: Vec<Drift>,
    pub(super) work: u64,
    pub(super) work_limit: u64,
}

impl Tower {
    /// Creates a tower without generators.
    pub fn new(trigonometry: Trigonometry) -> Self {
        Tower {
            generators: Vec::new(),
            numbers: FxHashMap::default(),
            factors: Vec::new(),
            factor_numbers: FxHashMap::default(),
            products: FxHashMap::default(),
            divisions_tried: FxHashSet::default(),
            relations: Vec::new(),
            bases: Vec::new(),
            asked: Vec::new(),
            asked_by: FxHashMap::default(),
            met: Vec::new(),
            met_by: FxHashMap::default(),
            divisors: FxHashMap::default(),
            exponent_divisors: FxHashMap::default(),
            exponent_denominator: Vec::new(),
            half_turns: Vec::new(),
            poles: Vec::new(),
            excluded: Vec::new(),
            trigonometry,
            elements: FxHashMap::default(),
            constraints: FxHashMap::default(),
            frame: Vec::new(),
            work: 0,
            work_limit: WORK_LIMIT,
        }
    }

    /// Returns the tower with a limit on its work, in products of terms.
    #[must_use]
    pub fn with_work_limit(mut self, limit: u64) -> Self {
        self.work_limit = limit;
        self
    }

    /// Returns the number of generators.
    pub fn generator_count(&self) -> u32 {
        self.generators.len() as u32
    }

    /// Returns the bases of radicands in use, with their numbers.
    pub fn bases(&self) -> impl Iterator<Item = (usize, &Base)> {
        self.bases.iter().enumerate().filter(|(_, base)| !base.retired)
    }

    /// Returns the base of radicands with this number.
    pub fn base(&self, number: usize) -> &Base {
        &self.bases[number]
    }

    /// Returns the representation of sines and cosines so far.
    pub fn trigonometry(&self) -> Trigonometry {
        self.trigonometry
    }

    /// Returns the generators that occur in a fraction.
    pub fn variables_of(&self, fraction: &Fraction) -> BTreeSet<u32> {
        let factors = fraction.factors.iter().map(|power| self.factor_polynomial(power.factor));
        std::iter::once(&fraction.numerator).chain(factors).flat_map(Polynomial::variables).collect()
    }

    /// Whether a sine, cosine or half-angle tangent occurs in a fraction.
    pub fn mentions_trigonometry(&self, fraction: &Fraction) -> bool {
        self.variables_of(fraction).into_iter().any(|variable| self.is_trigonometric(variable))
    }

    /// Fixes the signs of bases of radicands in the region considered. All other signs are open,
    /// and provisionally assumed to be positive.
    pub fn fix_signs(&mut self, signs: &[(usize, Sign)]) {
        let mut changed = false;
        for (number, base) in self.bases.iter_mut().enumerate() {
            let sign = signs.iter().find(|entry| entry.0 == number).map(|entry| entry.1);
            changed |= (base.sign == Some(Sign::Negative)) != (sign == Some(Sign::Negative));
            base.sign = sign;
        }
        if changed {
            self.start_again();
        }
    }

    /// Records that the sign of a base matters.
    pub(super) fn ask_for_sign(&mut self, base: usize) {
        self.bases[base].sign_needed = true;
        self.asked.push(base);
    }

    /// Returns the number of signs requested since they were last taken.
    pub(super) fn signs_asked(&self) -> usize {
        self.asked.len()
    }

    /// Takes the signs requested since the last call.
    pub(super) fn take_signs_asked(&mut self) -> Vec<usize> {
        std::mem::take(&mut self.asked)
    }

    /// Takes the signs requested since the last call, and returns the open ones.
    pub(crate) fn open_signs_asked(&mut self) -> Vec<usize> {
        let asked = self.take_signs_asked();
        asked.into_iter().filter(|&base| self.bases[base].sign.is_none()).collect()
    }

    /// Records the signs that an expression itself depends on, and the bases it is factored over.
    pub(super) fn note_signs_asked(&mut self, expression: Expr) {
        let met = std::mem::take(&mut self.met);
        if !met.is_empty() {
            self.met_by.insert(expression, met);
        }
        let mut asked = self.take_signs_asked();
        if !asked.is_empty() {
            asked.sort_unstable();
            asked.dedup();
            self.asked_by.insert(expression, asked);
        }
    }

    /// Returns the open signs that an expression itself depends on, without the signs that only its
    /// operands depend on.
    pub(super) fn open_signs(&self, expression: Expr) -> Vec<usize> {
        let asked = self.asked_by.get(&expression).into_iter().flatten();
        asked.copied().filter(|&base| self.bases[base].sign.is_none()).collect()
    }

    /// Discards every element because a generator has changed; the next conversion computes them
    /// anew.
    pub fn start_again(&mut self) {
        self.elements.clear();
        self.constraints.clear();
        self.asked.clear();
        self.asked_by.clear();
        self.met.clear();
        self.met_by.clear();
        self.bases.iter_mut().for_each(|base| base.sign_needed = false);
    }

    /// Returns the constraint under which a radicand is non-negative.
    pub(super) fn constraint_of(&self, radicand: Expr) -> Option<&SignConstraint> {
        self.constraints.get(&radicand)
    }

    pub(super) fn constrain(&mut self, radicand: Expr, constraint: SignConstraint) {
        self.constraints.insert(radicand, constraint);
    }

    /// Returns n and f for a root ρⁿ = f of the current sign case.
    pub fn radicand_of(&self, variable: u32) -> Option<(u32, &Polynomial)> {
        let relation = self.relation_of(variable).filter(|_| self.is_current_root(variable))?;
        Some((relation.order, &relation.value))
    }

    /// Returns a polynomial with the sign of the exponent u of the generator exp u.
    pub fn sign_of_exponent(&self, variable: u32) -> Option<Polynomial> {
        let Generator::Exponential(unit) = self.generator(variable) else { return None };
        let quantity = self.quantity(&unit.quantity);
        let below = quantity.factors.iter().filter(|power| power.exponent % 2 != 0);
        Some(below.fold(quantity.numerator.clone(), |product, power| {
            product.mul(self.factor_polynomial(power.factor))
        }))
    }

    /// Returns m and d of the generator exp(m/d), if m is a polynomial.
    pub fn exponent(&self, variable: u32) -> Option<(Polynomial, u32)> {
        let Generator::Exponential(unit) = self.generator(variable) else { return None };
        let quantity = self.quantity(&unit.quantity);
        quantity.is_polynomial().then_some((quantity.numerator, unit.divisor))
    }

    /// Returns the generator that a polynomial variable represents.
    pub fn generator(&self, variable: u32) -> &Generator {
        &self.generators[variable as usize]
    }

    /// Returns the polynomial variable of a generator, which is created if needed.
    pub(super) fn variable_of(&mut self, generator: Generator) -> u32 {
        if let Some(&known) = self.numbers.get(&generator) {
            return known;
        }
        let fresh = self.generators.len() as u32;
        self.generators.push(generator.clone());
        self.numbers.insert(generator, fresh);
        fresh
    }

    /// Returns the polynomial variable of π, if π occurs.
    pub(crate) fn pi(&self) -> Option<u32> {
        self.numbers.get(&Generator::Pi).copied()
    }

    /// Returns a generator as a fraction.
    pub fn element(&mut self, generator: Generator) -> Fraction {
        let variable = self.variable_of(generator);
        Fraction::from(Polynomial::variable(variable))
    }

    /// Returns the generators in the order of their creation, each with n and f if a relation
    /// ρⁿ = f binds it.
    pub fn generators(&self) -> impl Iterator<Item = (u32, &Generator, Option<(u32, &Polynomial)>)> {
        self.generators.iter().enumerate().map(|(number, generator)| {
            let relation = self.relation_of(number as u32);
            (number as u32, generator, relation.map(|relation| (relation.order, &relation.value)))
        })
    }

    /// Binds a generator by ρⁿ = value, once.
    pub(super) fn bind(&mut self, variable: u32, order: u32, value: Polynomial) {
        if self.relation_of(variable).is_none() {
            self.relations.push(Relation { variable, order, value });
        }
    }

    pub(super) fn relation_of(&self, variable: u32) -> Option<&Relation> {
        self.relations.iter().find(|relation| relation.variable == variable)
    }

    /// Whether a generator is a sine, cosine or half-angle tangent.
    pub(super) fn is_trigonometric(&self, variable: u32) -> bool {
        matches!(
            self.generator(variable),
            Generator::Cosine(_) | Generator::Sine(_) | Generator::HalfTangent(_)
        )
    }

    /// Returns the number of a primitive factor with positive leading coefficient.
    pub(super) fn factor(&mut self, polynomial: Polynomial) -> FactorId {
        debug_assert!(polynomial.leading_coefficient().is_positive());
        if let Some(&known) = self.factor_numbers.get(&polynomial) {
            return known;
        }
        let fresh = FactorId(self.factors.len() as u32);
        self.factors.push(polynomial.clone());
        self.factor_numbers.insert(polynomial, fresh);
        fresh
    }

    pub(super) fn factor_polynomial(&self, factor: FactorId) -> &Polynomial {
        &self.factors[factor.0 as usize]
    }

    /// Returns the variable that a factor consists of, if it is a single one.
    pub(super) fn factor_variable(&self, factor: FactorId) -> Option<u32> {
        let polynomial = self.factor_polynomial(factor);
        if polynomial.term_count() != 1 {
            return None;
        }
        match polynomial.monomial_content().as_slice() {
            [(variable, 1)] => Some(*variable),
            _ => None,
        }
    }
}
