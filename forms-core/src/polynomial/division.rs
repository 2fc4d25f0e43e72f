//! Exact division: the quotient if there is one, or quickly `None`.
//!
//! ```text
//! degrees, outermost terms, an image in one variable ─ reject cheaply
//! long division: rest in a hash table, its monomials on a heap; on each rung while
//! max|f| + max|q|·‖g‖₁, which bounds every coefficient of every rest, fits it
//! ```

use super::Polynomial;
use super::coefficient::{Coefficient, Coefficients, Rung, on_rung};
use super::image::{coordinate, divides};
use super::monomial::{Layout, compare};
use super::product::Rest;
use crate::steps;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::ToPrimitive;

/// Steps of a division for each term, or each word of the coefficients, of the dividend.
const STEPS_OF_WORD: u64 = 8;

/// Outcome of a division on one rung.
pub(super) enum Outcome {
    /// The division is exact, with this quotient.
    Quotient(Polynomial),
    /// The division is not exact.
    Remainder,
    /// The numbers may not fit the rung.
    Beyond,
}

impl Polynomial {
    /// Returns the quotient f/g if g divides f over ℤ. Division by 0 gives `None`.
    pub fn divide_exact(&self, divisor: &Self) -> Option<Self> {
        if divisor.is_zero() {
            return None;
        }
        if self.is_zero() {
            return Some(Self::zero());
        }
        if let Some(number) = divisor.as_constant() {
            return self.divide_by_integer(&number);
        }
        if divisor.term_count() == 1 {
            let (monomial, number) = divisor.terms().next()?;
            return self.divide_by_monomial(&monomial)?.divide_by_integer(&number);
        }
        if self.term_count() == 1 {
            return None;
        }
        if self.layout == divisor.layout && self.monomial(0) == divisor.monomial(0) {
            return self.divide_by_multiple(divisor);
        }
        if !self.may_be_divisible_by(divisor) {
            return None;
        }
        steps::spend(STEPS_OF_WORD * self.word_count());
        let mut rung = self.coefficients.rung().max(divisor.coefficients.rung());
        loop {
            match on_rung!(rung, C => self.divide_on_rung::<C>(divisor)) {
                Outcome::Quotient(quotient) => return Some(quotient),
                Outcome::Remainder => return None,
                Outcome::Beyond if rung == Rung::Small => rung = Rung::Wide,
                Outcome::Beyond => rung = Rung::Big,
            }
        }
    }

    /// Divides f/g for leading terms with the same monomial: the quotient is a number, or there is
    /// none.
    fn divide_by_multiple(&self, divisor: &Self) -> Option<Self> {
        if self.monomials != divisor.monomials {
            return None;
        }
        let (factor, remainder) = self.leading_coefficient().div_rem(&divisor.leading_coefficient());
        let multiple = remainder == BigInt::ZERO && *self == divisor.scale(&factor);
        multiple.then(|| Self::constant(factor))
    }

    fn divide_by_integer(&self, divisor: &BigInt) -> Option<Self> {
        if divisor.to_i64() == Some(1) {
            return Some(self.clone());
        }
        if let (Coefficients::Small(numbers), Some(divisor)) = (&self.coefficients, divisor.to_i64()) {
            let quotients: Option<Vec<i64>> =
                numbers.iter().map(|number| number.divided_by(&divisor)).collect();
            // The quotient −2⁶³/(−1) needs the next rung.
            if divisor != -1 {
                return Some(Self::settle(self.layout, self.monomials.clone(), quotients?));
            }
        }
        let mut quotients = Vec::with_capacity(self.term_count());
        for number in BigInt::view(&self.coefficients).iter() {
            let (quotient, remainder) = number.div_rem(divisor);
            if remainder != BigInt::ZERO {
                return None;
            }
            quotients.push(quotient);
        }
        Some(Self::settle(self.layout, self.monomials.clone(), quotients))
    }

    /// Tests necessary conditions for a divisor: its degrees, its leading and last terms, and an
    /// image.
    fn may_be_divisible_by(&self, divisor: &Self) -> bool {
        let layout = self.layout.join(divisor.layout);
        let (left, right) = (self.monomials_on(layout), divisor.monomials_on(layout));
        let last = |polynomial: &Self| polynomial.term_count() - 1;
        for (i, j) in [(0, 0), (last(self), last(divisor))] {
            let a = &left[i * layout.words..(i + 1) * layout.words];
            let b = &right[j * layout.words..(j + 1) * layout.words];
            if !is_multiple(layout, a, b) || !self.coefficients.is_multiple(i, &divisor.coefficients, j) {
                return false;
            }
        }
        let (mine, theirs) = (self.degrees(), divisor.degrees());
        let mut main = None;
        for (variable, &degree) in theirs.iter().enumerate() {
            if mine.get(variable).copied().unwrap_or(0) < degree {
                return false;
            }
            if degree != 0 && main.is_none_or(|(_, least)| mine[variable] < least) {
                main = Some((variable as u32, mine[variable]));
            }
        }
        let Some((main, degree)) = main else { return true };
        // Quotients of a few terms are computed as quickly as images, unless they may have many
        // terms after all.
        let few = self.term_count() < 2 * divisor.term_count() && degree <= LONGEST_QUOTIENT;
        if few || u64::from(degree) * u64::from(theirs[main as usize]) > LONGEST_IMAGE {
            return true;
        }
        let value = |variable| coordinate(u64::from(variable));
        divides(&divisor.image(main, value), self.image(main, value))
    }

    fn divide_on_rung<C: Coefficient>(&self, divisor: &Self) -> Outcome {
        let layout = self.layout.join(divisor.layout);
        let dividend = (self.monomials_on(layout), C::view(&self.coefficients));
        let monomials = divisor.monomials_on(layout);
        let numbers = C::view(&divisor.coefficients);
        let (largest, sum) = (self.coefficients.norms().largest, divisor.coefficients.norms().sum);
        if !C::holds(largest) && largest.is_some() {
            return Outcome::Beyond;
        }
        let mut reach = 0;
        let mut rest = Rest::new(layout, &dividend.0, &dividend.1);
        let (mut quotient, mut quotients) = (Vec::new(), Vec::new());
        while let Some(number) = rest.pop() {
            if !is_multiple(layout, rest.leading(), &monomials[..layout.words]) {
                return Outcome::Remainder;
            }
            let Some(factor) = number.divided_by(&numbers[0]) else { return Outcome::Remainder };
            // max|f| + max|q|·‖g‖₁
            if let Some(size) = factor.size() {
                reach = size.max(reach);
                let bound = sum.and_then(|sum| sum.checked_mul(reach));
                let bound = bound.zip(largest).and_then(|(bound, largest)| bound.checked_add(largest));
                if !C::holds(bound) {
                    return Outcome::Beyond;
                }
            }
            let start = quotient.len();
            for word in 0..layout.words {
                quotient.push(rest.leading()[word] - monomials[word]);
            }
            if !rest.subtract(&quotient[start..], &factor, &monomials, &numbers) {
                return Outcome::Remainder;
            }
            quotients.push(factor);
        }
        Outcome::Quotient(Self::settle(layout, quotient, quotients))
    }
}

/// Limit on the products in a division of images; longer ones cost more than they save.
const LONGEST_IMAGE: u64 = 1 << 22;

/// Sparse polynomials of a higher degree may have quotients with many terms.
const LONGEST_QUOTIENT: u32 = 1 << 6;

/// Whether the monomial b divides a: no field of the difference borrows into its guard.
pub(super) fn is_multiple(layout: Layout, a: &[u64], b: &[u64]) -> bool {
    let guards = layout.guards();
    for word in 0..layout.words {
        if a[word] < b[word] || (a[word] - b[word]) & guards != 0 {
            return false;
        }
    }
    compare(a, b).is_ge()
}
