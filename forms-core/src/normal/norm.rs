//! Norms and square roots of elements A + Bρ with a root ρ, ρ² = f.
//!
//! ```text
//! n = A² − B² f                                  the product with the conjugate A − Bρ, free of ρ
//! √(A + Bρ) = a + Bρ/(2a),  a² = (A ± m)/2       where n = m²
//! ```
//! A square root is searched for in the field of the element and the available roots, and is
//! accepted only by its square.

use super::fraction::Fraction;
use super::generator::Generator;
use super::generators::Relation;
use super::obstacle::Obstacle;
use super::root::prime_powers;
use super::tower::Tower;
use crate::expression::Rational;
use crate::polynomial::Polynomial;
use num_traits::Signed;

/// Largest number of terms of a factor that is searched for relations.
pub(super) const MOST_TERMS: usize = 40;

/// Largest depth of norms within norms in the search for a square root.
pub(super) const DEEPEST_ROOT: u32 = 8;

/// A + Bρᵏ with ρ²ᵏ = f
#[derive(Clone)]
pub(super) struct Split {
    pub(super) variable: u32,
    pub(super) half: u32,
    pub(super) radicand: Polynomial,
    pub(super) rational: Polynomial,
    pub(super) slope: Polynomial,
}

impl Split {
    /// Bρᵏ
    pub(super) fn irrational(&self) -> Polynomial {
        self.slope.multiply_by_monomial(&[(self.variable, self.half)])
    }

    pub(super) fn conjugate(&self) -> Polynomial {
        self.rational.sub(&self.irrational())
    }
}

impl Tower {
    /// Returns s with s² = q in the field of q and the available roots, if it is found there.
    ///
    /// The root of a norm can reintroduce the root that the norm was free of, so the depth is
    /// bounded.
    pub(super) fn square_root(
        &mut self,
        q: &Polynomial,
        available: &[u32],
        depth: u32,
    ) -> Result<Option<Fraction>, Obstacle> {
        if q.is_zero() || q.term_count() > MOST_TERMS || depth == 0 {
            return Ok(None);
        }
        let Some(variable) = self.roots_in(q).pop() else { return self.root_free_square_root(q, available) };
        let Some(split) = self.split_at(q, variable) else { return Ok(None) };
        let norm = self.norm(&split)?;
        let Some(m) = self.square_root(&norm, available, depth - 1)? else { return Ok(None) };
        let half = Fraction::number(&Rational::new(1.into(), 2.into()));
        for m in [self.negate(&m), m] {
            let sum = self.add(&split.rational.clone().into(), &m)?;
            let square = self.multiply(&half, &sum)?;
            let Some(a) = self.square_root_of_fraction(&square, available, depth - 1)? else { continue };
            let twice = self.add(&a, &a)?;
            let inverse = self.inverse(&twice)?;
            let b = self.multiply(&split.irrational().into(), &inverse)?;
            let root = self.add(&a, &b)?;
            let square = self.multiply(&root, &root)?;
            if self.subtract(&square, &q.clone().into())?.is_zero() {
                return Ok(Some(root));
            }
        }
        Ok(None)
    }

    /// √(N/(d D)) = √(N d D)/(d D)
    fn square_root_of_fraction(
        &mut self,
        q: &Fraction,
        available: &[u32],
        depth: u32,
    ) -> Result<Option<Fraction>, Obstacle> {
        let q = self.expanded(q)?;
        if q.is_zero() {
            return Ok(None);
        }
        let mut denominator = Polynomial::constant(q.divisor.clone());
        for power in &q.factors {
            let factor = self.factor_polynomial(power.factor).clone();
            for _ in 0..power.exponent {
                self.charge(&denominator, &factor)?;
                denominator = self.reduce(denominator.mul(&factor))?;
            }
        }
        self.charge(&denominator, &q.numerator)?;
        let product = self.reduce(denominator.mul(&q.numerator))?;
        let Some(root) = self.square_root(&product, available, depth)? else { return Ok(None) };
        let inverse = self.inverse(&denominator.into())?;
        Ok(Some(self.multiply(&root, &inverse)?))
    }

    /// √(c ∏ pᵢ^eᵢ): the factors with odd powers have to form a product of available radicands.
    fn root_free_square_root(
        &mut self,
        q: &Polynomial,
        available: &[u32],
    ) -> Result<Option<Fraction>, Obstacle> {
        if q.variables().into_iter().any(|v| self.relation_of(v).is_some()) {
            return Ok(None);
        }
        let (content, parts) = q.square_free();
        if content.is_negative() {
            return Ok(None);
        }
        let (mut root, mut odd) = (Polynomial::one(), Polynomial::one());
        let numbers = prime_powers(&content).into_iter().map(|(p, n)| (Polynomial::constant(p), n));
        for (part, exponent) in numbers.chain(parts) {
            root = root.mul(&part.pow(exponent / 2));
            if exponent % 2 == 1 {
                odd = odd.mul(&part);
            }
        }
        for &variable in available {
            let Some(relation) = self.relation_of(variable).cloned().filter(|r| r.order % 2 == 0) else {
                continue;
            };
            if let Some(rest) = odd.divide_exact(&relation.value) {
                odd = rest;
                root = root.multiply_by_monomial(&[(variable, relation.order / 2)]);
            }
        }
        Ok(odd.is_one().then(|| root.into()))
    }

    /// A² − B² f
    pub(super) fn norm(&mut self, split: &Split) -> Result<Polynomial, Obstacle> {
        self.charge(&split.rational, &split.rational)?;
        self.charge(&split.slope, &split.slope)?;
        let slope = self.reduce(split.slope.square())?;
        self.charge(&slope, &split.radicand)?;
        let irrational = slope.mul(&split.radicand);
        self.reduce(split.rational.square().sub(&irrational))
    }

    /// Returns the product of all conjugates, free of roots; `None` if there is none or it is zero.
    pub(super) fn full_norm(&mut self, polynomial: &Polynomial) -> Result<Option<Polynomial>, Obstacle> {
        let mut norm = polynomial.clone();
        while let Some(variable) = self.roots_in(&norm).pop() {
            let Some(split) = self.split_at(&norm, variable) else { return Ok(None) };
            norm = self.norm(&split)?;
            if norm.term_count() > MOST_TERMS {
                return Ok(None);
            }
        }
        Ok((!norm.is_zero()).then_some(norm))
    }

    /// Splits the polynomial into A + Bρᵏ with ρ²ᵏ = f, if no other powers of ρ occur.
    pub(super) fn split_at(&self, polynomial: &Polynomial, variable: u32) -> Option<Split> {
        let Relation { order, value, .. } = self.relation_of(variable)?.clone();
        let half = order / 2;
        let mut split = Split {
            variable,
            half,
            radicand: value,
            rational: Polynomial::zero(),
            slope: Polynomial::zero(),
        };
        for (exponent, coefficient) in polynomial.coefficients_in(variable) {
            match exponent {
                0 => split.rational = coefficient,
                _ if order % 2 == 0 && exponent == half => split.slope = coefficient,
                _ => return None,
            }
        }
        Some(split)
    }

    /// Returns the roots that occur, roots of simpler radicands first.
    pub(super) fn roots_in(&self, polynomial: &Polynomial) -> Vec<u32> {
        let is_root = |variable: &u32| matches!(self.generator(*variable), Generator::Root { .. });
        polynomial.variables().into_iter().filter(is_root).collect()
    }
}
