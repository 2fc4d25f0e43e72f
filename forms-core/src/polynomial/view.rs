//! Rearrangements: derivatives, substitution, and the polynomial as a polynomial in some of its
//! variables.

use super::Polynomial;
use super::coefficient::{Coefficient, Coefficients, Rung, on_rung};
use crate::steps;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed};
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// Steps of a gcd for each pair of words of the two numbers.
const STEPS_OF_GCD: u64 = 16;

impl Polynomial {
    /// ∂f/∂x
    pub fn derivative(&self, variable: u32) -> Self {
        let Some((word, shift)) = self.layout.field(variable) else { return Self::zero() };
        let largest = self.union_of_word(word) >> shift & self.layout.mask();
        if largest == 0 {
            return Self::zero();
        }
        let bound = self.coefficients.norms().largest.and_then(|norm| norm.checked_mul(u128::from(largest)));
        on_rung!(Rung::for_bound(bound), C => self.derivative_on_rung::<C>(word, shift))
    }

    fn derivative_on_rung<C: Coefficient>(&self, word: usize, shift: u32) -> Self {
        let numbers = C::view(&self.coefficients);
        let mut monomials = Vec::with_capacity(self.monomials.len());
        let mut derived = Vec::with_capacity(numbers.len());
        for term in 0..numbers.len() {
            let monomial = self.monomial(term);
            let exponent = monomial[word] >> shift & self.layout.mask();
            if exponent != 0 {
                let start = monomials.len();
                monomials.extend_from_slice(monomial);
                monomials[start + word] -= 1 << shift;
                derived.push(numbers[term].times(&C::from(exponent as i64)));
            }
        }
        Self::settle(self.layout, monomials, derived)
    }

    /// Returns the positive greatest common divisor of the coefficients; 0 for 0.
    pub fn content(&self) -> BigInt {
        if let Coefficients::Small(numbers) = &self.coefficients {
            let mut content = 0;
            for number in numbers {
                content = number.unsigned_abs().gcd(&content);
                if content == 1 {
                    break;
                }
            }
            return content.into();
        }
        let mut content = BigInt::ZERO;
        for coefficient in BigInt::view(&self.coefficients).iter() {
            steps::spend(
                STEPS_OF_GCD
                    .saturating_mul(content.bits() / 64 + 1)
                    .saturating_mul(coefficient.bits() / 64 + 1),
            );
            // the remainder first: the number of steps of a gcd of numbers of unequal lengths is
            // the bit length of the longer one
            content = if content == BigInt::ZERO {
                coefficient.abs()
            } else {
                content.gcd(&(coefficient % &content))
            };
            if content.is_one() {
                break;
            }
        }
        content
    }

    /// Returns f divided by its content and by the sign of its leading coefficient; 0 for 0.
    pub fn primitive_part(&self) -> Self {
        if self.is_zero() {
            return Self::zero();
        }
        let positive = Polynomial {
            layout: self.layout,
            monomials: self.monomials.clone(),
            coefficients: self.coefficients.divided_by(&self.content()),
        };
        if positive.is_negative() { positive.neg() } else { positive }
    }

    /// Returns the exponent of the greatest power of a variable that divides every term; 0 for 0.
    pub fn least_exponent(&self, variable: u32) -> u32 {
        let exponents =
            (0..self.term_count()).map(|term| self.layout.exponent(self.monomial(term), variable));
        exponents.min().unwrap_or(0)
    }

    /// Returns the greatest monomial that divides every term; 1 for 0.
    pub fn monomial_content(&self) -> Vec<(u32, u32)> {
        let mut common: Option<Vec<(u32, u32)>> = None;
        for term in 0..self.term_count() {
            let monomial = self.monomial(term);
            let mut content = match common {
                None => self.layout.unpack(monomial),
                Some(content) => content,
            };
            for (variable, exponent) in &mut content {
                *exponent = (*exponent).min(self.layout.exponent(monomial, *variable));
            }
            content.retain(|&(_, exponent)| exponent != 0);
            common = Some(content);
        }
        common.unwrap_or_default()
    }

    /// f·m
    ///
    /// # Panics
    /// If an exponent of the product is beyond 2³¹ − 1.
    pub fn multiply_by_monomial(&self, monomial: &[(u32, u32)]) -> Self {
        self.shifted_in_place(monomial)
            .unwrap_or_else(|| self.mul(&Self::from_terms([(monomial.to_vec(), BigInt::from(1))])))
    }

    /// Returns f·m on the layout of f, if every exponent stays below its guard.
    fn shifted_in_place(&self, monomial: &[(u32, u32)]) -> Option<Self> {
        let mut monomials = self.monomials.clone();
        for &(variable, exponent) in monomial {
            let (word, shift) = self.layout.field(variable)?;
            let (mask, exponent) = (self.layout.mask(), u64::from(exponent));
            for place in monomials.iter_mut().skip(word).step_by(self.layout.words) {
                if 2 * ((*place >> shift & mask) + exponent) > mask {
                    return None;
                }
                *place += exponent << shift;
            }
        }
        Some(Polynomial { layout: self.layout, monomials, coefficients: self.coefficients.clone() })
    }

    /// Returns f/m, if m divides every term.
    pub fn divide_by_monomial(&self, monomial: &[(u32, u32)]) -> Option<Self> {
        let mut monomials = self.monomials.clone();
        for &(variable, exponent) in monomial {
            if exponent == 0 || self.is_zero() {
                continue;
            }
            let (word, shift) = self.layout.field(variable)?;
            for term in 0..self.term_count() {
                let place = &mut monomials[term * self.layout.words + word];
                if (*place >> shift & self.layout.mask()) < u64::from(exponent) {
                    return None;
                }
                *place -= u64::from(exponent) << shift;
            }
        }
        let mut quotient =
            Polynomial { layout: self.layout, monomials, coefficients: self.coefficients.clone() };
        quotient.narrow();
        Some(quotient)
    }

    /// Returns f as a polynomial in one variable: its powers with their coefficients, highest power
    /// first.
    pub fn coefficients_in(&self, variable: u32) -> Vec<(u32, Polynomial)> {
        let parts = self.split_by(&[variable]);
        parts.into_iter().map(|(exponents, part)| (exponents[0], part)).collect()
    }

    /// Returns f as a polynomial in some variables: their exponents (in the given order) with the
    /// coefficients, in decreasing lexicographic order of the exponents.
    pub fn split_by(&self, variables: &[u32]) -> Vec<(Vec<u32>, Polynomial)> {
        on_rung!(self.coefficients.rung(), C => self.split_on_rung::<C>(variables))
    }

    fn split_on_rung<C: Coefficient>(&self, variables: &[u32]) -> Vec<(Vec<u32>, Polynomial)> {
        let numbers = C::view(&self.coefficients);
        let mut groups: BTreeMap<Vec<u32>, (Vec<u64>, Vec<C>)> = BTreeMap::new();
        for term in 0..self.term_count() {
            let monomial = self.monomial(term);
            let exponents =
                variables.iter().map(|&variable| self.layout.exponent(monomial, variable)).collect();
            let (monomials, coefficients) = groups.entry(exponents).or_default();
            let start = monomials.len();
            monomials.extend_from_slice(monomial);
            for &variable in variables {
                if let Some((word, shift)) = self.layout.field(variable) {
                    monomials[start + word] &= !(self.layout.mask() << shift);
                }
            }
            coefficients.push(numbers[term].clone());
        }
        let parts = groups.into_iter().rev();
        parts
            .map(|(exponents, (monomials, coefficients))| {
                (exponents, Self::settle(self.layout, monomials, coefficients))
            })
            .collect()
    }

    /// Returns f as Σ Aₖ ∏ (xᵢ^nᵢ)^kᵢ, where every Aₖ has a degree below nᵢ in xᵢ: each k with its
    /// Aₖ. For one k all terms are divided by the same monomial, so they stay in order.
    pub fn split_by_powers(&self, powers: &[(u32, u32)]) -> Vec<(Vec<u32>, Polynomial)> {
        on_rung!(self.coefficients.rung(), C => self.split_powers_on_rung::<C>(powers))
    }

    fn split_powers_on_rung<C: Coefficient>(&self, powers: &[(u32, u32)]) -> Vec<(Vec<u32>, Polynomial)> {
        let numbers = C::view(&self.coefficients);
        let fields: Vec<_> = powers.iter().map(|&(variable, _)| self.layout.field(variable)).collect();
        let mut places: FxHashMap<Vec<u32>, usize> = FxHashMap::default();
        let mut groups: Vec<(Vec<u32>, Vec<u64>, Vec<C>)> = Vec::new();
        let mut quotients = vec![0; powers.len()];
        for term in 0..self.term_count() {
            let monomial = self.monomial(term);
            for (quotient, &(variable, order)) in quotients.iter_mut().zip(powers) {
                *quotient = self.layout.exponent(monomial, variable) / order;
            }
            let place = places.get(quotients.as_slice()).copied().unwrap_or_else(|| {
                places.insert(quotients.clone(), groups.len());
                groups.push((quotients.clone(), Vec::new(), Vec::new()));
                groups.len() - 1
            });
            let (_, monomials, coefficients) = &mut groups[place];
            let start = monomials.len();
            monomials.extend_from_slice(monomial);
            for ((field, &quotient), &(_, order)) in fields.iter().zip(&quotients).zip(powers) {
                if let Some((word, shift)) = *field {
                    monomials[start + word] -= u64::from(quotient * order) << shift;
                }
            }
            coefficients.push(numbers[term].clone());
        }
        let settled = |(quotients, monomials, coefficients)| {
            (quotients, Self::settle(self.layout, monomials, coefficients))
        };
        groups.into_iter().map(settled).collect()
    }

    /// Substitutes a polynomial for a variable of f, by Horner's rule.
    ///
    /// # Panics
    /// If an exponent of the result is beyond 2³¹ − 1.
    pub fn substitute(&self, variable: u32, value: &Polynomial) -> Self {
        let mut result = Self::zero();
        let mut height = 0;
        for (exponent, coefficient) in self.coefficients_in(variable) {
            if !result.is_zero() {
                result = result.mul(&value.pow(height - exponent));
            }
            result = result.add(&coefficient);
            height = exponent;
        }
        if height == 0 { result } else { result.mul(&value.pow(height)) }
    }
}
