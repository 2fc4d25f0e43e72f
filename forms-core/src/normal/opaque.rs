//! Functions that are generators of their own: the same arguments give the same generator.
//!
//! These are inverse trigonometric functions, and functions that are known by their derivatives:
//! ```text
//! erf(−q) = −erf q      E₂(q) = e⁻ᵠ − q E₁(q)      Li₂(0) = 0, Li₂(1) = π²/6      Cl₂(−q) = −Cl₂(q)
//!                       E₃(q) = (e⁻ᵠ − q E₂(q))/2                                  Cl₂(q + 2πk) = Cl₂(q), Cl₂(πk) = 0
//! ```
//! The relations of E₂ and E₃ also hold at q = 0, for any value assigned to E₁ there.

use super::fraction::Fraction;
use super::generator::Generator;
use super::obstacle::Obstacle;
use super::tower::Tower;
use crate::expression::{Operation, Rational};
use crate::polynomial::Polynomial;

/// Whether a function is, or consists of, generators for which a tower has no derivatives.
pub(super) fn is_opaque(operation: Operation) -> bool {
    matches!(
        operation,
        Operation::Asin
            | Operation::Acos
            | Operation::Atan2
            | Operation::Erf
            | Operation::Expint1
            | Operation::Expint2
            | Operation::Expint3
            | Operation::Dilog
            | Operation::Clausen
            | Operation::Erfc
    )
}

impl Tower {
    /// Returns a function as a generator of its own.
    pub(super) fn opaque(
        &mut self,
        operation: Operation,
        arguments: &[Fraction],
    ) -> Result<Fraction, Obstacle> {
        let arguments = arguments.to_vec();
        let fresh = Generator::Opaque { operation, arguments: arguments.clone() };
        let generator = self.with_same_arguments(&arguments, fresh, |generator| match generator {
            Generator::Opaque { operation: other, arguments } if *other == operation => Some(arguments),
            _ => None,
        })?;
        Ok(self.element(generator))
    }

    /// Returns a known generator of the same kind whose arguments differ by zero, or else the fresh
    /// one.
    pub(super) fn with_same_arguments(
        &mut self,
        arguments: &[Fraction],
        fresh: Generator,
        alike: impl Fn(&Generator) -> Option<&Vec<Fraction>>,
    ) -> Result<Generator, Obstacle> {
        for number in 0..self.generators.list().len() {
            let Some(known) = alike(&self.generators.list()[number]).cloned() else { continue };
            let mut equal = true;
            for (a, b) in arguments.iter().zip(&known) {
                equal = equal && self.subtract(a, b)?.is_zero();
            }
            if equal {
                return Ok(self.generators.list()[number].clone());
            }
        }
        Ok(fresh)
    }

    /// erf q
    pub(super) fn error_function(&mut self, q: &Fraction) -> Result<Fraction, Obstacle> {
        if q.is_zero() {
            return Ok(Fraction::zero());
        }
        self.odd(Operation::Erf, q, |_, difference| difference.is_zero())
    }

    /// Cl₂(q)
    pub(super) fn clausen(&mut self, q: &Fraction) -> Result<Fraction, Obstacle> {
        if self.half_turns(q).is_some() {
            return Ok(Fraction::zero());
        }
        let is_period = |tower: &Self, difference: &Fraction| {
            tower.half_turns(difference).is_some_and(|turns| (turns.numer() % 2_i64) == 0.into())
        };
        self.odd(Operation::Clausen, q, is_period)
    }

    /// Returns the value of an odd function that has equal values at arguments whose difference
    /// satisfies `agree`.
    fn odd(
        &mut self,
        operation: Operation,
        q: &Fraction,
        agree: impl Fn(&Self, &Fraction) -> bool,
    ) -> Result<Fraction, Obstacle> {
        for number in 0..self.generators.list().len() {
            let known = match &self.generators.list()[number] {
                Generator::Opaque { operation: other, arguments } if *other == operation => {
                    arguments[0].clone()
                }
                _ => continue,
            };
            let difference = self.subtract(q, &known)?;
            let sum = self.add(q, &known)?;
            let value = Fraction::from(Polynomial::variable(number as u32));
            if agree(self, &difference) {
                return Ok(value);
            }
            if agree(self, &sum) {
                return Ok(self.negate(&value));
            }
        }
        Ok(self.element(Generator::Opaque { operation, arguments: vec![q.clone()] }))
    }

    /// Returns k for an argument kπ with an integer k.
    fn half_turns(&self, q: &Fraction) -> Option<Rational> {
        if q.is_zero() {
            return Some(Rational::from_integer(0.into()));
        }
        let turns = q.is_polynomial().then(|| q.numerator.terms().next()).flatten()?;
        let is_multiple = q.numerator.term_count() == 1 && turns.0 == [(self.pi()?, 1)];
        let turns = Rational::new(turns.1, q.divisor.clone());
        (is_multiple && turns.is_integer()).then_some(turns)
    }

    /// Eₙ(q) for n = 1, 2, 3, by n Eₙ₊₁(q) = e⁻ᵠ − q Eₙ(q)
    pub(super) fn exponential_integral(&mut self, order: i64, q: &Fraction) -> Result<Fraction, Obstacle> {
        if order == 1 {
            return self.opaque(Operation::Expint1, std::slice::from_ref(q));
        }
        let part = Fraction::number(&Rational::new(1.into(), (order - 1).into()));
        if q.is_zero() {
            return Ok(part);
        }
        let lower = self.exponential_integral(order - 1, q)?;
        let negated = self.negate(q);
        let (decay, product) = (self.exponential(&negated)?, self.multiply(q, &lower)?);
        let difference = self.subtract(&decay, &product)?;
        self.multiply(&difference, &part)
    }

    /// Li₂(q)
    pub(super) fn dilogarithm(&mut self, q: &Fraction) -> Result<Fraction, Obstacle> {
        if q.is_zero() {
            return Ok(Fraction::zero());
        }
        if self.subtract(q, &Fraction::one())?.is_zero() {
            let pi = self.element(Generator::Pi);
            let square = self.multiply(&pi, &pi)?;
            return self.multiply(&square, &Fraction::number(&Rational::new(1.into(), 6.into())));
        }
        self.opaque(Operation::Dilog, std::slice::from_ref(q))
    }
}
