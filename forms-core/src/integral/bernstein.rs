//! Signs of polynomials over a box, from known conditions on parameters.
//!
//! A polynomial Σ βᵢ C(n,i) τⁱ(1−τ)ⁿ⁻ⁱ lies between the least and the greatest βᵢ for 0 ≤ τ ≤ 1,
//! and its values at 0 and 1 are β₀ and βₙ. A polynomial in parameters is examined term by term,
//! after known conditions are divided out as factors or subtracted as multiples.

use super::known_sign::{KnownSign, Strictness};
use crate::expression::Relation;
use crate::normal::{Fraction, Generator, Tower};
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_integer::{Integer, binomial};
use num_traits::Signed;
use std::cell::Cell;

/// Number of times that the range of a polynomial is halved.
const MOST_HALVINGS: u32 = 6;

/// Limit on the signs of polynomials that are computed for one query.
const MOST_QUESTIONS: u32 = 1000;

/// Number of times that a known condition is subtracted from a polynomial in the search for terms
/// of one sign.
const MOST_REWRITES: u32 = 3;

/// The variables that run over [0, 1], and the ones among them that stand for sines and cosines.
pub(super) struct UnitBox {
    pub(super) sides: Vec<u32>,
    pub(super) circular: Vec<u32>,
}

/// Polynomials that are known not to be negative.
#[derive(Default)]
pub(super) struct Knowledge {
    facts: Vec<(Polynomial, Strictness)>,
    /// Number of signs of polynomials that were requested.
    questions: Cell<u32>,
}

impl Knowledge {
    /// Learns the condition `difference relation 0`.
    pub(super) fn learn(&mut self, tower: &Tower, difference: &Fraction, relation: Relation) {
        let Some(polynomial) = difference.as_polynomial().filter(|p| p.as_constant().is_none()) else {
            return;
        };
        let (polynomial, strictness) = match relation {
            Relation::Greater => (polynomial.clone(), Strictness::Strict),
            Relation::GreaterEqual => (polynomial.clone(), Strictness::Weak),
            Relation::Less => (polynomial.neg(), Strictness::Strict),
            Relation::LessEqual => (polynomial.neg(), Strictness::Weak),
            // q ≠ 0 and q ≥ 0 give q > 0
            Relation::NotEqual => {
                match self.polynomial_sign(tower, polynomial, &UnitBox { sides: vec![], circular: vec![] }) {
                    Some((true, _)) => (polynomial.clone(), Strictness::Strict),
                    Some((false, _)) => (polynomial.neg(), Strictness::Strict),
                    None => return,
                }
            }
        };
        self.facts.push((polynomial, strictness));
    }

    /// Returns the sign of an element where the sides run over [0, 1].
    pub(super) fn sign_of_fraction(
        &self,
        tower: &Tower,
        value: &Fraction,
        sides: &UnitBox,
    ) -> Option<KnownSign> {
        if value.is_zero() {
            return None;
        }
        let mut sign = self.polynomial_sign(tower, value.numerator(), sides)?;
        for (factor, exponent) in tower.factors_of(value) {
            // a divisor is not zero, or the value is not defined
            let (positive, strictness) = if exponent % 2 == 0 {
                let own = self.polynomial_sign(tower, factor, sides);
                (true, own.map_or(Strictness::Weak, |sign| sign.1))
            } else {
                self.polynomial_sign(tower, factor, sides)?
            };
            sign = (sign.0 == positive, sign.1.min(strictness));
        }
        Some(sign)
    }

    /// Returns the sign of a polynomial where the sides run over [0, 1].
    fn polynomial_sign(&self, tower: &Tower, polynomial: &Polynomial, sides: &UnitBox) -> Option<KnownSign> {
        self.questions.set(self.questions.get() + 1);
        if self.questions.get() > MOST_QUESTIONS {
            return None;
        }
        let plain = self.plain_sign(tower, polynomial, sides);
        if plain.is_some_and(|sign| sign.1 == Strictness::Strict) {
            return plain;
        }
        self.sign_with_root(tower, polynomial, sides).or(plain)
    }

    /// Returns the sign of α + βρ with ρ² = g: where |α| and |β|ρ differ, the sign of the larger
    /// one.
    fn sign_with_root(&self, tower: &Tower, polynomial: &Polynomial, sides: &UnitBox) -> Option<KnownSign> {
        let root =
            polynomial.variables().into_iter().rev().find(|&v| {
                polynomial.degree(v) == 1 && tower.radicand(v).is_some_and(|(_, order)| order == 2)
            })?;
        let (radicand, _) = tower.radicand(root)?;
        let parts = polynomial.coefficients_in(root);
        let part = |power: u32| {
            parts.iter().find(|entry| entry.0 == power).map_or_else(Polynomial::zero, |entry| entry.1.clone())
        };
        let (alpha, beta) = (part(0), part(1));
        let difference = alpha.square().sub(&beta.square().mul(&radicand));
        let difference = without_squares(tower, difference);
        let (first_is_larger, strictness) = self.polynomial_sign(tower, &difference, sides)?;
        let larger = if first_is_larger { &alpha } else { &beta };
        let sign = self.polynomial_sign(tower, larger, sides)?;
        Some((sign.0, strictness))
    }

    fn plain_sign(&self, tower: &Tower, polynomial: &Polynomial, sides: &UnitBox) -> Option<KnownSign> {
        match sides.sides.iter().find(|side| polynomial.contains(**side)) {
            None => self.sign_of_constant(tower, polynomial),
            Some(&side) => {
                let on_unit = if sides.circular.contains(&side) {
                    from_circle(polynomial, side)
                } else {
                    polynomial.clone()
                };
                self.bernstein_sign(tower, &bernstein(&on_unit, side), &sides.after(side), MOST_HALVINGS)
            }
        }
    }

    fn bernstein_sign(
        &self,
        tower: &Tower,
        coefficients: &[Polynomial],
        sides: &UnitBox,
        halvings: u32,
    ) -> Option<KnownSign> {
        let signs: Vec<Option<KnownSign>> = coefficients
            .iter()
            .map(|c| if c.is_zero() { None } else { self.polynomial_sign(tower, c, sides) })
            .collect();
        let unknown = coefficients.iter().zip(&signs).any(|(c, sign)| !c.is_zero() && sign.is_none());
        let positive = signs.iter().flatten().map(|sign| sign.0).collect::<Vec<_>>();
        let agree = positive.windows(2).all(|pair| pair[0] == pair[1]);
        if !unknown && agree && !positive.is_empty() {
            let strict = |sign: &Option<KnownSign>| sign.is_some_and(|s| s.1 == Strictness::Strict);
            let ends = strict(&signs[0]) && strict(&signs[signs.len() - 1]);
            let strictness = if ends { Strictness::Strict } else { Strictness::Weak };
            return Some((positive[0], strictness));
        }
        let ends = [signs[0], signs[signs.len() - 1]].map(|sign| sign.map(|known| known.0));
        let changes = matches!(ends, [Some(first), Some(last)] if first != last);
        if halvings == 0 || changes {
            return None;
        }
        let (left, right) = halves(coefficients);
        let first = self.bernstein_sign(tower, &left, sides, halvings - 1)?;
        let second = self.bernstein_sign(tower, &right, sides, halvings - 1)?;
        (first.0 == second.0).then_some((first.0, first.1.min(second.1)))
    }

    /// Returns the sign of a polynomial in parameters.
    fn sign_of_constant(&self, tower: &Tower, polynomial: &Polynomial) -> Option<KnownSign> {
        if polynomial.is_zero() {
            return None;
        }
        let mut rest = polynomial.clone();
        let mut sign: KnownSign = (true, Strictness::Strict);
        for (fact, strictness) in &self.facts {
            while fact.term_count() > 1
                && let Some(quotient) = rest.divide_exact(fact)
            {
                rest = quotient;
                sign.1 = sign.1.min(*strictness);
            }
        }
        let own = match self.terms_sign(tower, &rest, MOST_REWRITES) {
            Some(strictness) => (true, strictness),
            None => (false, self.terms_sign(tower, &rest.neg(), MOST_REWRITES)?),
        };
        Some((sign.0 == own.0, sign.1.min(own.1)))
    }

    /// Whether every term is not negative, if necessary after multiples of known conditions are
    /// subtracted.
    fn terms_sign(&self, tower: &Tower, polynomial: &Polynomial, rewrites: u32) -> Option<Strictness> {
        let mut best = Strictness::Weak;
        let mut negative = None;
        for (monomial, coefficient) in polynomial.terms() {
            match self.monomial_sign(tower, &monomial) {
                Some((positive, strictness)) if positive == coefficient.is_positive() => {
                    best = best.max(strictness);
                }
                _ => negative = negative.or(Some((monomial, coefficient))),
            }
        }
        let Some((monomial, coefficient)) = negative else { return Some(best) };
        if rewrites == 0 {
            return None;
        }
        self.facts.iter().find_map(|(fact, strictness)| {
            let (multiple, own) = self.multiple_with(tower, fact, &monomial, &coefficient)?;
            let scale = multiple.0;
            let rest = polynomial.scale(&scale).sub(&multiple.1);
            let rest = self.terms_sign(tower, &rest, rewrites - 1)?;
            Some(rest.max(own.min(*strictness)))
        })
    }

    /// Returns a number s > 0 and a multiple of a fact, by a monomial that is not negative, that
    /// contains s times the given term.
    fn multiple_with(
        &self,
        tower: &Tower,
        fact: &Polynomial,
        monomial: &[(u32, u32)],
        coefficient: &BigInt,
    ) -> Option<((BigInt, Polynomial), Strictness)> {
        for (own, number) in fact.terms() {
            if number.is_positive() != coefficient.is_positive() || own.is_empty() {
                continue;
            }
            let Some(quotient) = monomial_quotient(monomial, &own) else { continue };
            let Some((true, strictness)) = self.monomial_sign(tower, &quotient) else { continue };
            let multiple = fact.multiply_by_monomial(&quotient).scale(&coefficient.abs());
            return Some(((number.abs(), multiple), strictness));
        }
        None
    }

    fn monomial_sign(&self, tower: &Tower, monomial: &[(u32, u32)]) -> Option<KnownSign> {
        let mut sign = (true, Strictness::Strict);
        for &(variable, exponent) in monomial {
            let own = self.generator_sign(tower, variable);
            if exponent % 2 == 0 {
                sign.1 = sign.1.min(own.map_or(Strictness::Weak, |known| known.1));
            } else {
                let own = own?;
                sign = (sign.0 == own.0, sign.1.min(own.1));
            }
        }
        Some(sign)
    }

    fn generator_sign(&self, tower: &Tower, variable: u32) -> Option<KnownSign> {
        let itself = Polynomial::variable(variable);
        match tower.generator(variable) {
            Generator::Pi | Generator::Exponential(_) => return Some((true, Strictness::Strict)),
            Generator::Root { .. } => {
                let radicand = tower.radicand(variable).map(|(radicand, _)| radicand);
                let strict = radicand.and_then(|p| self.terms_sign(tower, &p, 0));
                return Some((true, strict.unwrap_or(Strictness::Weak)));
            }
            _ => {}
        }
        let bounds = self.facts.iter().filter_map(|(fact, strictness)| {
            let linear = fact.total_degree() == 1 && fact.variables() == [variable];
            let mut parts = fact.coefficients_in(variable).into_iter().filter(|_| linear);
            let slope = parts.find(|part| part.0 == 1)?.1.as_constant()?;
            let constant = fact.sub(&itself.scale(&slope)).as_constant()?;
            // s v + c ≥ 0 gives v ≥ −c/s for s > 0, so v ≥ 0 if c ≤ 0; for s < 0 in the same way v
            // ≤ c/|s|, so v ≤ 0 if c ≤ 0
            match constant.sign() {
                num_bigint::Sign::Plus => None,
                num_bigint::Sign::NoSign => Some((slope.is_positive(), *strictness)),
                num_bigint::Sign::Minus => Some((slope.is_positive(), Strictness::Strict)),
            }
        });
        bounds.max_by_key(|sign| sign.1)
    }
}

impl UnitBox {
    /// Returns the box without one side.
    fn after(&self, side: u32) -> UnitBox {
        let sides = self.sides.iter().copied().filter(|other| *other != side).collect();
        UnitBox { sides, circular: self.circular.clone() }
    }
}

/// Rewrites a polynomial in c with −1 ≤ c ≤ 1 as a polynomial in σ over [0, 1]: c² = σ if only even
/// powers occur, otherwise c = 2σ − 1.
fn from_circle(polynomial: &Polynomial, variable: u32) -> Polynomial {
    let parts = polynomial.coefficients_in(variable);
    let is_even = parts.iter().all(|(exponent, _)| exponent % 2 == 0);
    let sigma = Polynomial::variable(variable);
    let line = sigma.scale(&2.into()).sub(&Polynomial::one());
    parts.into_iter().fold(Polynomial::zero(), |sum, (exponent, coefficient)| {
        let power = if is_even { sigma.pow(exponent / 2) } else { line.pow(exponent) };
        sum.add(&coefficient.mul(&power))
    })
}

/// Replaces ρ² in the polynomial by its radicand, for every square root ρ.
fn without_squares(tower: &Tower, polynomial: Polynomial) -> Polynomial {
    let mut rest = polynomial;
    for variable in rest.variables().into_iter().rev() {
        let Some((radicand, 2)) = tower.radicand(variable) else { continue };
        let parts = rest.coefficients_in(variable);
        rest = parts.into_iter().fold(Polynomial::zero(), |sum, (exponent, coefficient)| {
            let square = coefficient.mul(&radicand.pow(exponent / 2));
            sum.add(&square.multiply_by_monomial(&[(variable, exponent % 2)]))
        });
    }
    rest
}

/// m / n for monomials, if n divides m.
fn monomial_quotient(m: &[(u32, u32)], n: &[(u32, u32)]) -> Option<Vec<(u32, u32)>> {
    let mut quotient = m.to_vec();
    for &(variable, exponent) in n {
        let entry = quotient.iter_mut().find(|entry| entry.0 == variable)?;
        entry.1 = entry.1.checked_sub(exponent)?;
    }
    quotient.retain(|entry| entry.1 > 0);
    Some(quotient)
}

/// Returns the coefficients in the Bernstein basis times a positive number: βᵢ = Σⱼ C(i,j)/C(n,j)
/// cⱼ.
fn bernstein(polynomial: &Polynomial, variable: u32) -> Vec<Polynomial> {
    let n = polynomial.degree(variable);
    let parts = polynomial.coefficients_in(variable);
    let big = |a: u32, b: u32| binomial(BigInt::from(a), BigInt::from(b));
    let common = (0..=n).fold(BigInt::from(1), |all, j| all.lcm(&big(n, j)));
    (0..=n)
        .map(|i| {
            let terms = parts.iter().filter(|(j, _)| *j <= i);
            terms.fold(Polynomial::zero(), |sum, (j, c)| {
                sum.add(&c.scale(&(&common / big(n, *j) * big(i, *j))))
            })
        })
        .collect()
}

/// De Casteljau's algorithm: the coefficients on both halves, times 2ⁿ.
fn halves(coefficients: &[Polynomial]) -> (Vec<Polynomial>, Vec<Polynomial>) {
    let n = coefficients.len() - 1;
    let (mut left, mut right) = (Vec::new(), Vec::new());
    let mut row = coefficients.to_vec();
    for step in 0..=n {
        let scale = BigInt::from(1) << (n - step);
        left.push(row[0].scale(&scale));
        right.push(row[row.len() - 1].scale(&scale));
        row = row.windows(2).map(|pair| pair[0].add(&pair[1])).collect();
    }
    right.reverse();
    (left, right)
}
