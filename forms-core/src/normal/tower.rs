//! Tower of extensions: the generators in use, the relations that bind some of them, and the known
//! factors.

use super::base::{Base, Sign, SignConstraint};
use super::denominators::Denominators;
use super::drift::Drift;
use super::exclusions::Exclusions;
use super::fraction::Fraction;
use super::generator::{Generator, Trigonometry};
use super::generators::{Generators, Relation};
use super::known_factors::KnownFactors;
use super::power::FactorId;
use super::sign_requests::SignRequests;
use super::work::{WORK_LIMIT, Work};
use crate::expression::Expr;
use crate::polynomial::Polynomial;
use rustc_hash::FxHashMap;
use std::collections::BTreeSet;

/// Generators, relations and factors that the fractions of one comparison refer to.
#[derive(Clone, Debug)]
pub struct Tower {
    pub(super) generators: Generators,
    pub(super) factors: KnownFactors,
    pub(super) bases: Vec<Base>,
    pub(super) signs: SignRequests,
    pub(super) denominators: Denominators,
    pub(super) exclusions: Exclusions,
    pub(super) trigonometry: Trigonometry,
    /// Fractions of the expressions that were converted so far.
    pub(super) elements: FxHashMap<Expr, Fraction>,
    /// Variables that are written relative to others.
    pub(super) frame: Vec<Drift>,
    pub(super) work: Work,
}

impl Tower {
    /// Creates a tower without generators.
    pub fn new(trigonometry: Trigonometry) -> Self {
        Tower {
            generators: Generators::default(),
            factors: KnownFactors::default(),
            bases: Vec::new(),
            signs: SignRequests::default(),
            denominators: Denominators::default(),
            exclusions: Exclusions::default(),
            trigonometry,
            elements: FxHashMap::default(),
            frame: Vec::new(),
            work: Work::with_limit(WORK_LIMIT),
        }
    }

    /// Returns the tower with a limit on its work, in products of terms.
    #[must_use]
    pub fn with_work_limit(mut self, limit: u64) -> Self {
        self.work = Work::with_limit(limit);
        self
    }

    /// Returns the number of generators.
    pub fn generator_count(&self) -> u32 {
        self.generators.list().len() as u32
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
        self.signs.ask(base);
    }

    /// Returns the number of signs requested since they were last taken.
    pub(super) fn signs_asked(&self) -> usize {
        self.signs.count()
    }

    /// Takes the signs requested since the last call, and returns the open ones.
    pub(crate) fn open_signs_asked(&mut self) -> Vec<usize> {
        let asked = self.signs.take();
        asked.into_iter().filter(|&base| self.bases[base].sign.is_none()).collect()
    }

    /// Returns the open signs that an expression itself depends on, without the signs that only its
    /// operands depend on.
    pub(super) fn open_signs(&self, expression: Expr) -> Vec<usize> {
        self.signs.of(expression).iter().copied().filter(|&base| self.bases[base].sign.is_none()).collect()
    }

    /// Discards every element because a generator has changed; the next conversion computes them
    /// anew.
    pub fn start_again(&mut self) {
        self.elements.clear();
        self.signs = SignRequests::default();
        self.bases.iter_mut().for_each(|base| base.sign_needed = false);
    }

    /// Returns the constraint under which a radicand is non-negative.
    pub(super) fn constraint_of(&self, radicand: Expr) -> Option<&SignConstraint> {
        self.signs.constraint_of(radicand)
    }

    pub(super) fn constrain(&mut self, radicand: Expr, constraint: SignConstraint) {
        self.signs.constrain(radicand, constraint);
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
        self.generators.get(variable)
    }

    /// Returns the polynomial variable of a generator, which is created if needed.
    pub(super) fn variable_of(&mut self, generator: Generator) -> u32 {
        self.generators.variable_of(generator)
    }

    /// Returns the polynomial variable of π, if π occurs.
    pub(crate) fn pi(&self) -> Option<u32> {
        self.generators.known(&Generator::Pi)
    }

    /// Returns a generator as a fraction.
    pub fn element(&mut self, generator: Generator) -> Fraction {
        let variable = self.variable_of(generator);
        Fraction::from(Polynomial::variable(variable))
    }

    /// Returns the generators in the order of their creation, each with n and f if a relation
    /// ρⁿ = f binds it.
    pub fn generators(&self) -> impl Iterator<Item = (u32, &Generator, Option<(u32, &Polynomial)>)> {
        self.generators.list().iter().enumerate().map(|(number, generator)| {
            let relation = self.relation_of(number as u32);
            (number as u32, generator, relation.map(|relation| (relation.order, &relation.value)))
        })
    }

    /// Binds a generator by ρⁿ = value, once.
    pub(super) fn bind(&mut self, variable: u32, order: u32, value: Polynomial) {
        self.generators.bind(variable, order, value);
    }

    pub(super) fn relation_of(&self, variable: u32) -> Option<&Relation> {
        self.generators.relation_of(variable)
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
        self.factors.intern(polynomial)
    }

    pub(super) fn factor_polynomial(&self, factor: FactorId) -> &Polynomial {
        self.factors.polynomial(factor)
    }

    /// Returns the variable that a factor consists of, if it is a single one.
    pub(super) fn factor_variable(&self, factor: FactorId) -> Option<u32> {
        self.factors.variable(factor)
    }
}
