//! Values at points: modulo 2⁶¹ − 1, over the integers, or in any ring that the caller supplies.

use super::{Polynomial, modular};
use num_bigint::BigInt;
use std::ops::{Add, Mul};

impl Polynomial {
    /// Returns the value modulo 2⁶¹ − 1 where variable i has the value `point[i]`; variables beyond
    /// the point are 0.
    pub fn evaluate_modular(&self, point: &[u64]) -> u64 {
        let mut sum = 0;
        for term in 0..self.term_count() {
            let mut product = self.residue(term);
            for (variable, exponent) in self.layout.unpack(self.monomial(term)) {
                let value = point.get(variable as usize).copied().unwrap_or(0);
                product = modular::mul(product, modular::pow(value, u64::from(exponent)));
            }
            sum = modular::add(sum, product);
        }
        sum
    }

    /// Returns the value where variable i has the value `point[i]`; variables beyond the point are
    /// 0.
    pub fn evaluate(&self, point: &[BigInt]) -> BigInt {
        let mut sum = BigInt::ZERO;
        for (monomial, coefficient) in self.terms() {
            let mut product = coefficient;
            for (variable, exponent) in monomial {
                product *= point.get(variable as usize).unwrap_or(&BigInt::ZERO).pow(exponent);
            }
            sum += product;
        }
        sum
    }

    /// Returns the value in any ring: `integer` embeds a coefficient, `value` returns a variable's
    /// value. Powers are built by repeated squaring, and terms are added in order, the leading term
    /// first.
    pub fn evaluate_with<T>(&self, integer: impl Fn(&BigInt) -> T, value: impl Fn(u32) -> T) -> T
    where
        T: Clone + Add<Output = T> + Mul<Output = T>,
    {
        let mut sum: Option<T> = None;
        for (monomial, coefficient) in self.terms() {
            let mut product = integer(&coefficient);
            for (variable, exponent) in monomial {
                product = product * power(value(variable), exponent);
            }
            sum = Some(match sum {
                Some(sum) => sum + product,
                None => product,
            });
        }
        sum.unwrap_or_else(|| integer(&BigInt::ZERO))
    }
}

/// aⁿ for n ≥ 1.
fn power<T: Clone + Mul<Output = T>>(a: T, n: u32) -> T {
    let mut result = a.clone();
    for bit in (0..n.ilog2()).rev() {
        result = result.clone() * result;
        if n >> bit & 1 == 1 {
            result = result * a.clone();
        }
    }
    result
}
