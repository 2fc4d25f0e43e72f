//! Conversion of terms: from exponents and integers to packed, sorted polynomials on their
//! narrowest layout, and back.

use super::coefficient::{Coefficient, Coefficients};
use super::monomial::{Layout, compare};
use super::{Polynomial, modular};
use num_bigint::BigInt;

impl Polynomial {
    /// Returns the sum of terms, each a list of (variable, exponent) and a coefficient, in any
    /// order.
    ///
    /// # Panics
    /// If an exponent is beyond 2³¹ − 1.
    pub fn from_terms(terms: impl IntoIterator<Item = (Vec<(u32, u32)>, BigInt)>) -> Self {
        let terms: Vec<_> = terms.into_iter().collect();
        let mut variables = 0;
        let mut largest = 0;
        for (monomial, _) in &terms {
            for &(variable, exponent) in monomial {
                let total = monomial.iter().filter(|&&(other, _)| other == variable);
                largest = largest.max(total.map(|&(_, exponent)| u64::from(exponent)).sum());
                if exponent != 0 {
                    variables = variables.max(u64::from(variable) + 1);
                }
            }
        }
        let layout = Layout::fitting(variables, largest);
        let mut monomials = Vec::with_capacity(terms.len() * layout.words);
        let mut coefficients = Vec::with_capacity(terms.len());
        for (monomial, coefficient) in terms {
            layout.pack(&monomial, &mut monomials);
            coefficients.push(coefficient);
        }
        Self::from_unsorted(layout, &monomials, &coefficients)
    }

    /// Returns the terms, leading term first: (variable, exponent) in increasing order of
    /// variables, and the coefficient.
    pub fn terms(&self) -> impl Iterator<Item = (Vec<(u32, u32)>, BigInt)> + '_ {
        (0..self.term_count())
            .map(|term| (self.layout.unpack(self.monomial(term)), self.coefficients.get(term)))
    }

    /// Returns the sum of packed terms in any order.
    pub(super) fn from_unsorted<C: Coefficient>(
        layout: Layout,
        monomials: &[u64],
        coefficients: &[C],
    ) -> Self {
        let words = layout.words;
        let at = |index: u32| &monomials[index as usize * words..(index as usize + 1) * words];
        let mut order: Vec<u32> = (0..coefficients.len() as u32).collect();
        order.sort_unstable_by(|&left, &right| compare(at(right), at(left)));
        let mut sorted = Vec::with_capacity(monomials.len());
        let mut sums: Vec<C> = Vec::with_capacity(coefficients.len());
        let mut next = 0;
        while next < order.len() {
            let first = order[next];
            let mut sum = coefficients[first as usize].clone();
            next += 1;
            while next < order.len() && at(order[next]) == at(first) {
                sum = sum.plus(&coefficients[order[next] as usize]);
                next += 1;
            }
            if !sum.is_zero() {
                sorted.extend_from_slice(at(first));
                sums.push(sum);
            }
        }
        Self::settle(layout, sorted, sums)
    }

    /// Creates the polynomial of packed terms in decreasing order without zeros, on its narrowest
    /// layout.
    pub(super) fn settle<C: Coefficient>(layout: Layout, monomials: Vec<u64>, coefficients: Vec<C>) -> Self {
        let mut polynomial = Polynomial { layout, monomials, coefficients: C::settle(coefficients) };
        polynomial.narrow();
        polynomial
    }

    /// Repacks the polynomial to its narrowest layout.
    pub(super) fn narrow(&mut self) {
        while self.layout.bits > 4 && self.fits_half_fields() {
            let words = self.layout.words.div_ceil(2);
            self.monomials = self.layout.halve(&self.monomials, self.term_count(), words);
            self.layout = Layout { bits: self.layout.bits / 2, words };
        }
        let words = self.used_words();
        if words < self.layout.words {
            let narrower = Layout { words, ..self.layout };
            self.monomials = self.layout.crop(&self.monomials, self.term_count(), words);
            self.layout = narrower;
        }
    }

    /// Whether every exponent fits a field of half the bits, including its guard.
    fn fits_half_fields(&self) -> bool {
        let fields = u64::MAX / self.layout.mask();
        let low = fields * ((1 << (self.layout.bits / 2 - 1)) - 1);
        self.monomials.iter().all(|word| word & !low == 0)
    }

    /// Returns the bitwise union of one word of every monomial: a bound on the exponents in each
    /// field. It is 0 beyond the layout's words.
    pub(super) fn union_of_word(&self, word: usize) -> u64 {
        let mut union = 0;
        let mut index = if word < self.layout.words { word } else { self.monomials.len() };
        while index < self.monomials.len() {
            union |= self.monomials[index];
            index += self.layout.words;
        }
        union
    }

    /// Returns the bitwise union of the monomials on a layout at least as wide.
    pub(super) fn union_on(&self, layout: Layout) -> Vec<u64> {
        let union: Vec<u64> = (0..self.layout.words).map(|word| self.union_of_word(word)).collect();
        self.layout.widen(&union, 1, layout)
    }

    /// Returns the number of words up to the last one that is not zero everywhere.
    fn used_words(&self) -> usize {
        let mut words = self.layout.words;
        while words > 0 && (0..self.term_count()).all(|term| self.monomial(term)[words - 1] == 0) {
            words -= 1;
        }
        words
    }

    /// Returns the packed monomials on a layout at least as wide.
    pub(super) fn monomials_on(&self, layout: Layout) -> std::borrow::Cow<'_, [u64]> {
        if layout == self.layout {
            std::borrow::Cow::Borrowed(&self.monomials)
        } else {
            std::borrow::Cow::Owned(self.layout.widen(&self.monomials, self.term_count(), layout))
        }
    }

    /// Returns the coefficient of a term modulo 2⁶¹ − 1.
    pub(super) fn residue(&self, term: usize) -> u64 {
        match &self.coefficients {
            Coefficients::Small(numbers) => modular::from_i64(numbers[term]),
            Coefficients::Wide(numbers) => modular::from_i128(numbers[term]),
            Coefficients::Big(numbers) => modular::from_integer(&numbers[term]),
        }
    }
}
