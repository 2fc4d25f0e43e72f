//! Known factors: polynomials that have occurred in denominators, by their numbers.

use super::power::{FactorId, FactorPower};
use crate::polynomial::Polynomial;
use num_traits::Signed;
use rustc_hash::{FxHashMap, FxHashSet};

/// G = ±∏ Fᵉ
#[derive(Clone, Debug)]
pub(super) struct Product {
    pub(super) negative: bool,
    pub(super) powers: Vec<FactorPower>,
}

/// Known factors, each under a number of its own.
#[derive(Clone, Debug, Default)]
pub(super) struct KnownFactors {
    list: Vec<Polynomial>,
    numbers: FxHashMap<Polynomial, FactorId>,
    /// Factors that turned out to be products of others.
    pub(super) products: FxHashMap<FactorId, Product>,
    /// Pairs of factors for which division of the second by the first was tried.
    pub(super) divisions_tried: FxHashSet<(FactorId, FactorId)>,
}

impl KnownFactors {
    /// Returns the number of known factors.
    pub(super) fn len(&self) -> usize {
        self.list.len()
    }

    /// Returns the number of a primitive factor with positive leading coefficient.
    pub(super) fn intern(&mut self, polynomial: Polynomial) -> FactorId {
        debug_assert!(polynomial.leading_coefficient().is_positive());
        if let Some(&known) = self.numbers.get(&polynomial) {
            return known;
        }
        let fresh = FactorId(self.list.len() as u32);
        self.list.push(polynomial.clone());
        self.numbers.insert(polynomial, fresh);
        fresh
    }

    /// Returns a factor by its number.
    pub(super) fn polynomial(&self, factor: FactorId) -> &Polynomial {
        &self.list[factor.0 as usize]
    }

    /// Returns the variable that a factor consists of, if it is a single one.
    pub(super) fn variable(&self, factor: FactorId) -> Option<u32> {
        let polynomial = self.polynomial(factor);
        if polynomial.term_count() != 1 {
            return None;
        }
        match polynomial.monomial_content().as_slice() {
            [(variable, 1)] => Some(*variable),
            _ => None,
        }
    }
}
