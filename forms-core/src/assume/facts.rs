//! Facts: bounds and inequalities of generators that follow from conditions and from the properties
//! of functions.

use super::linear::{Inequality, contradict};
use super::range::Ranges;
use crate::expression::{Operation, Relation};
use crate::normal::{Fraction, Generator, Sign, Tower, Unit, chord_bounds};
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use rustc_hash::FxHashMap;

/// Largest number of logarithms that are compared with each other.
const MOST_ORDERED: usize = 6;

/// Number of decimal digits to which the root of a number is enclosed.
const DIGITS_OF_ROOTS: usize = 12;

/// A root ρ with ρⁿ = f.
#[derive(Clone, Debug)]
pub(super) struct Root {
    pub(super) order: u32,
    pub(super) radicand: Polynomial,
}

/// Numeric bounds of generators, inequalities between generators, and the radicands of roots.
#[derive(Clone, Debug, Default)]
pub(crate) struct Facts {
    pub(super) lower: FxHashMap<u32, BigRational>,
    pub(super) upper: FxHashMap<u32, BigRational>,
    pub(super) ranges: Ranges,
    pub(super) inequalities: Vec<Inequality>,
    pub(super) roots: FxHashMap<u32, Root>,
    /// m and d of generators exp(m/d) with a polynomial m.
    pub(super) exponents: FxHashMap<u32, (Polynomial, u32)>,
}

impl Facts {
    /// Returns the facts that hold for every generator by its kind: roots and exponentials are
    /// positive.
    pub(crate) fn of(tower: &Tower) -> Self {
        let mut facts = Facts::default();
        facts.learn_nature(tower);
        facts
    }

    fn learn_nature(&mut self, tower: &Tower) {
        for variable in 0..tower.generator_count() {
            match tower.generator(variable) {
                Generator::Root { base, .. } => {
                    self.at_least(variable, BigRational::zero());
                    let radicand = tower.radicand_of(variable);
                    if let Some((order, radicand)) = radicand
                        && (radicand.as_constant().is_some()
                            || tower.base(*base).sign.is_some()
                            || tower.is_manifestly_not_negative(radicand))
                    {
                        self.learn_root(variable, order, radicand);
                    }
                }
                Generator::Exponential(_) => {
                    self.at_least(variable, BigRational::zero());
                    self.exponents.extend(tower.exponent(variable).map(|exponent| (variable, exponent)));
                }
                Generator::Chord { sides, sine } => {
                    let (lower, upper) = chord_bounds(*sides, *sine);
                    self.at_least(variable, lower);
                    self.at_most(variable, upper);
                }
                Generator::Pi => {
                    self.at_least(variable, BigRational::new(333.into(), 106.into()));
                    self.at_most(variable, BigRational::new(22.into(), 7.into()));
                }
                Generator::Cosine(_) | Generator::Sine(_) => {
                    self.at_least(variable, -BigRational::one());
                    self.at_most(variable, BigRational::one());
                }
                Generator::Opaque { operation, .. } => self.learn_values(variable, *operation),
                _ => {}
            }
        }
    }

    /// Learns the ranges of functions: asin and atan within ±π/2 < 11/7, acos from 0 to π < 22/7,
    /// erf within ±1, Eₙ > 0.
    fn learn_values(&mut self, variable: u32, operation: Operation) {
        let number = |p: i64, q: i64| BigRational::new(p.into(), q.into());
        let (lower, upper) = match operation {
            Operation::Asin | Operation::Atan => (number(-11, 7), Some(number(11, 7))),
            Operation::Acos => (number(0, 1), Some(number(22, 7))),
            Operation::Atan2 => (number(-22, 7), Some(number(22, 7))),
            Operation::Erf => (number(-1, 1), Some(number(1, 1))),
            Operation::Expint1 => (number(0, 1), None),
            _ => return,
        };
        self.at_least(variable, lower);
        upper.into_iter().for_each(|upper| self.at_most(variable, upper));
    }

    /// Learns that asin, atan and erf have the signs of their arguments.
    fn learn_odd_function(&mut self, tower: &Tower, variable: u32, argument: &Fraction) {
        match self.sign_of_fraction(tower, argument) {
            Some(Sign::Positive) => self.at_least(variable, BigRational::zero()),
            Some(Sign::Negative) => self.at_most(variable, BigRational::zero()),
            None => {}
        }
    }

    /// Learns about a root: the root of a number lies between two decimals; every root is related
    /// to its radicand.
    fn learn_root(&mut self, variable: u32, order: u32, radicand: &Polynomial) {
        if let Some(number) = radicand.as_constant() {
            let scale = num_traits::pow(BigInt::from(10), DIGITS_OF_ROOTS);
            let floor = (number * num_traits::pow(scale.clone(), order as usize)).nth_root(order);
            self.at_least(variable, BigRational::new(floor.clone(), scale.clone()));
            self.at_most(variable, BigRational::new(floor + 1, scale));
        }
        self.roots.insert(variable, Root { order, radicand: radicand.clone() });
    }

    /// Learns `difference relation 0` as an inequality, as a numeric bound of one generator, and as
    /// a range of an angle.
    pub(crate) fn learn(&mut self, tower: &Tower, difference: &Fraction, relation: Relation) {
        self.ranges.learn(tower.pi(), difference, relation);
        let Some(difference) = difference.as_polynomial() else { return };
        let up = matches!(relation, Relation::Greater | Relation::GreaterEqual);
        if relation == Relation::NotEqual {
            return;
        }
        let polynomial = if up { difference.clone() } else { difference.neg() };
        let strict = matches!(relation, Relation::Greater | Relation::Less);
        self.inequalities.push(Inequality { polynomial, strict });
        let mut linear: Vec<(u32, BigInt)> = Vec::new();
        let mut constant = BigInt::zero();
        for (monomial, coefficient) in difference.terms() {
            match monomial.as_slice() {
                [] => constant = coefficient,
                [(variable, 1)] => linear.push((*variable, coefficient)),
                _ => return,
            }
        }
        // a v + c > 0
        if let [(variable, slope)] = linear.as_slice() {
            let bound = BigRational::new(-&constant, slope.clone());
            self.bound(*variable, up == slope.is_positive(), bound);
        }
    }

    /// Learns the facts about functions that follow from the signs of their arguments.
    pub(crate) fn learn_functions(&mut self, tower: &Tower) {
        self.learn_nature(tower);
        for variable in 0..tower.generator_count() {
            match tower.generator(variable) {
                Generator::HalfTangent(unit) => self.learn_half_tangent(tower, variable, unit),
                Generator::Exponential(_) => self.learn_exponential(tower, variable),
                Generator::Opaque {
                    operation: Operation::Asin | Operation::Atan | Operation::Erf,
                    arguments,
                } => {
                    self.learn_odd_function(tower, variable, &arguments[0]);
                }
                Generator::Logarithm { base } => {
                    self.learn_logarithm(variable, &tower.base(*base).polynomial);
                }
                _ => {}
            }
        }
        self.learn_order(tower);
    }

    /// Learns log g ≥ log h where g ≥ h ≥ 0.
    fn learn_order(&mut self, tower: &Tower) {
        let logarithms: Vec<(u32, &Polynomial)> = (0..tower.generator_count())
            .filter_map(|v| match tower.generator(v) {
                Generator::Logarithm { base } => Some((v, &tower.base(*base).polynomial)),
                _ => None,
            })
            .collect();
        if logarithms.len() > MOST_ORDERED {
            return;
        }
        let mut ordered: Vec<(u32, u32)> = Vec::new();
        for (v, g) in &logarithms {
            for (w, h) in logarithms.iter().filter(|(w, h)| w != v && self.never_negative(h)) {
                ordered.extend(self.never_negative(&g.sub(h)).then_some((*v, *w)));
            }
        }
        for (larger, smaller) in ordered {
            let polynomial = Polynomial::variable(larger).sub(&Polynomial::variable(smaller));
            self.inequalities.push(Inequality { polynomial, strict: false });
        }
    }

    /// Learns that a half-angle tangent lies between the tangents of the ends of its angle, if
    /// these lie between two poles; where the angle is nearer to a pole than to a zero, t² ≥ 1.
    fn learn_half_tangent(&mut self, tower: &Tower, variable: u32, unit: &Unit) {
        let Some(monomial) = unit.as_monomial() else { return };
        let part = BigRational::new(1.into(), (2 * unit.divisor()).into());
        let range = self.ranges.of(tower.pi(), [(monomial.to_vec(), part)]);
        if range.modulo_pi((1, 2)).is_within(1, 4) {
            let polynomial = Polynomial::variable(variable).square().sub(&Polynomial::one());
            self.inequalities.push(Inequality { polynomial, strict: false });
        }
        let (lower, upper) = range.modulo_pi((0, 1)).tangents();
        lower.into_iter().for_each(|lower| self.at_least(variable, lower));
        upper.into_iter().for_each(|upper| self.at_most(variable, upper));
    }

    /// Learns exp u ≥ 1 where u ≥ 0, and exp u ≤ 1 where u ≤ 0.
    fn learn_exponential(&mut self, tower: &Tower, variable: u32) {
        match tower.sign_of_exponent(variable).and_then(|exponent| self.sign_of(&exponent)) {
            Some(Sign::Positive) => self.at_least(variable, BigRational::one()),
            Some(Sign::Negative) => self.at_most(variable, BigRational::one()),
            None => {}
        }
    }

    /// Learns log g ≥ 0 where g ≥ 1, and log |g| ≤ 0 where 0 ≤ g ≤ 1.
    fn learn_logarithm(&mut self, variable: u32, argument: &Polynomial) {
        let above_one = argument.sub(&Polynomial::one());
        if self.never_negative(&above_one) {
            self.at_least(variable, BigRational::zero());
        } else if self.never_negative(argument) && self.never_negative(&above_one.neg()) {
            self.at_most(variable, BigRational::zero());
        }
    }

    /// Whether the bounds leave no value for a generator, or the inequalities leave no point.
    pub(crate) fn contradiction(&self) -> bool {
        let empty = |(variable, lower): (&u32, &BigRational)| {
            self.upper.get(variable).is_some_and(|upper| lower > upper)
        };
        self.lower.iter().any(empty)
            || (!self.inequalities.is_empty()
                && contradict(&self.known(), |monomial| self.sign_of_monomial(monomial)))
    }

    /// Whether a point may exist at which bases have the given signs −, 0, +.
    pub(crate) fn allow(&self, tower: &Tower, signs: &[(usize, i8)]) -> bool {
        let mut facts = self.clone();
        for &(base, sign) in signs {
            let factor: Fraction = tower.base(base).polynomial.clone().into();
            let relations: &[Relation] = match sign {
                1 => &[Relation::Greater],
                -1 => &[Relation::Less],
                _ => &[Relation::GreaterEqual, Relation::LessEqual],
            };
            relations.iter().for_each(|&relation| facts.learn(tower, &factor, relation));
        }
        !facts.contradiction() && !facts.fixed_values_contradict()
    }

    /// Whether the facts exclude every point at which a polynomial is zero.
    pub(crate) fn excludes_zero(&self, tower: &Tower, polynomial: &Polynomial) -> bool {
        let mut facts = self.clone();
        for relation in [Relation::GreaterEqual, Relation::LessEqual] {
            facts.learn(tower, &polynomial.clone().into(), relation);
        }
        facts.contradiction() || facts.fixed_values_contradict()
    }

    /// Whether an inequality fails after the substitution of generators that have only one possible
    /// value.
    fn fixed_values_contradict(&self) -> bool {
        let fixed = |variable: u32| {
            let value = self.lower.get(&variable)?;
            (self.upper.get(&variable) == Some(value)).then_some(value)
        };
        self.inequalities.iter().any(|inequality| {
            let mut polynomial = inequality.polynomial.clone();
            for variable in inequality.polynomial.variables() {
                let Some(value) = fixed(variable) else { return false };
                let degree = polynomial.degree(variable);
                polynomial = polynomial.coefficients_in(variable).into_iter().fold(
                    Polynomial::zero(),
                    |sum, (exponent, coefficient)| {
                        let above = num_traits::pow(value.numer().clone(), exponent as usize);
                        let below = num_traits::pow(value.denom().clone(), (degree - exponent) as usize);
                        sum.add(&coefficient.scale(&(above * below)))
                    },
                );
            }
            let value = polynomial.as_constant();
            value.is_some_and(|value| value.is_negative() || (inequality.strict && value.is_zero()))
        })
    }

    /// Returns the inequalities, including the bounds of the generators that occur in them.
    pub(super) fn known(&self) -> Vec<Inequality> {
        let mut known = self.inequalities.clone();
        let mut variables: Vec<u32> =
            self.inequalities.iter().flat_map(|inequality| inequality.polynomial.variables()).collect();
        variables.sort_unstable();
        variables.dedup();
        for variable in variables {
            let times = |bound: &BigRational| Polynomial::variable(variable).scale(bound.denom());
            let number = |bound: &BigRational| Polynomial::constant(bound.numer().clone());
            let above = self.lower.get(&variable).map(|lower| times(lower).sub(&number(lower)));
            let below = self.upper.get(&variable).map(|upper| number(upper).sub(&times(upper)));
            let bounds = above.into_iter().chain(below);
            known.extend(bounds.map(|polynomial| Inequality { polynomial, strict: false }));
        }
        known
    }

    /// Returns the sign of a monomial of squares and of variables whose bounds determine their
    /// signs.
    pub(super) fn sign_of_monomial(&self, monomial: &[(u32, u32)]) -> Option<Sign> {
        let mut negative = false;
        for (variable, _) in monomial.iter().filter(|(_, exponent)| exponent % 2 == 1) {
            if self.upper.get(variable).is_some_and(|upper| !upper.is_positive()) {
                negative = !negative;
            } else if self.lower.get(variable).is_none_or(|lower| lower.is_negative()) {
                return None;
            }
        }
        Some(if negative { Sign::Negative } else { Sign::Positive })
    }

    /// Returns the known bounds of a generator, from below and from above.
    pub(crate) fn bounds(&self, variable: u32) -> (Option<&BigRational>, Option<&BigRational>) {
        (self.lower.get(&variable), self.upper.get(&variable))
    }

    fn bound(&mut self, variable: u32, from_below: bool, bound: BigRational) {
        if from_below {
            self.at_least(variable, bound);
        } else {
            self.at_most(variable, bound);
        }
    }

    pub(super) fn at_least(&mut self, variable: u32, bound: BigRational) {
        let entry = self.lower.entry(variable).or_insert_with(|| bound.clone());
        if bound > *entry {
            *entry = bound;
        }
    }

    pub(super) fn at_most(&mut self, variable: u32, bound: BigRational) {
        let entry = self.upper.entry(variable).or_insert_with(|| bound.clone());
        if bound < *entry {
            *entry = bound;
        }
    }
}
