//! Exact division: the quotient where there is one, a quick `None` where there is not.

use super::Polynomial;
use super::coefficient::Coefficient;
use super::monomial::{Layout, compare};
use num_bigint::BigInt;
use num_integer::Integer;

impl Polynomial {
    /// The quotient f/g where g divides f over ℤ. Nothing divides by 0.
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
        if !self.may_be_divisible_by(divisor) {
            return None;
        }
        self.divide_by_leading_terms(divisor)
    }

    fn divide_by_integer(&self, divisor: &BigInt) -> Option<Self> {
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

    /// Degrees, leading and trailing terms: what a factor must satisfy.
    fn may_be_divisible_by(&self, divisor: &Self) -> bool {
        let (mine, theirs) = (self.degrees(), divisor.degrees());
        let fits = |(variable, degree): (usize, &u32)| mine.get(variable).copied().unwrap_or(0) >= *degree;
        if !theirs.iter().enumerate().all(fits) {
            return false;
        }
        let layout = self.layout.join(divisor.layout);
        let (left, right) = (self.monomials_on(layout), divisor.monomials_on(layout));
        let last = |polynomial: &Self| polynomial.term_count() - 1;
        [(0, 0), (last(self), last(divisor))].into_iter().all(|(i, j)| {
            let a = &left[i * layout.words..(i + 1) * layout.words];
            let b = &right[j * layout.words..(j + 1) * layout.words];
            quotient(layout, a, b).is_some()
                && self.coefficients.get(i).is_multiple_of(&divisor.coefficients.get(j))
        })
    }

    /// Long division in the lexicographic order.
    fn divide_by_leading_terms(&self, divisor: &Self) -> Option<Self> {
        let mut rest = self.clone();
        let mut quotients = Vec::new();
        while !rest.is_zero() {
            let layout = rest.layout.join(divisor.layout);
            let (left, right) = (rest.monomials_on(layout), divisor.monomials_on(layout));
            let monomial = quotient(layout, &left[..layout.words], &right[..layout.words])?;
            let (number, remainder) = rest.leading_coefficient().div_rem(&divisor.leading_coefficient());
            if remainder != BigInt::ZERO {
                return None;
            }
            let term = (layout.unpack(&monomial), number);
            let one = Self::one();
            let next = Self::from_terms([term.clone()]);
            rest = Self::sum_of_products(&[(1, &rest, &one), (-1, &next, divisor)]);
            quotients.push(term);
        }
        Some(Self::from_terms(quotients))
    }
}

/// a/b where b divides a: no field of the difference borrows into its guard.
pub(super) fn quotient(layout: Layout, a: &[u64], b: &[u64]) -> Option<Vec<u64>> {
    if compare(a, b).is_lt() {
        return None;
    }
    let guards = layout.guards();
    let mut words = Vec::with_capacity(a.len());
    for index in 0..a.len() {
        let difference = a[index].wrapping_sub(b[index]);
        if difference & guards != 0 || a[index] < b[index] {
            return None;
        }
        words.push(difference);
    }
    Some(words)
}
